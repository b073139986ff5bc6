"""Models with parameters: events on a line, and loci in a plane, held against exact counts at random values of the parameters.

Wrong: said to be complete, and in an interval or a region the number of real equilibria, or of those by index, is not the one said.
"""

import random
from fractions import Fraction

import compare
from polynomials import sum_derivative, sum_text
from systems import System, coefficient, exponents, names, put

NAMES = ["a", "b"]


class Family:
    """A potential whose last coordinates are parameters."""

    def __init__(self, n_angles, n_coordinates, n_parameters, potential, ranges):
        self.shape = n_angles, n_coordinates
        self.parameters = NAMES[:n_parameters]
        self.potential, self.ranges = potential, ranges
        self.model, self.scale = True, None

    def at(self, values):
        """The model where the parameters have values."""
        n_angles, n = self.shape
        f = {}
        for (kind, k, e), c in self.potential.items():
            for j, v in zip(e[n:], values):
                c *= Fraction(v) ** j
            put(f, kind, k, e[:n], c)
        y = System(n_angles, n)
        y.model, y.potential = True, f
        return y

    def extension(self):
        return "json"

    def text(self):
        shape = System(*self.shape)
        keys = []
        if shape.angles:
            keys.append(f'"angles": {names(shape.angles)}')
        if shape.coordinates:
            keys.append(f'"coordinates": {names(shape.coordinates)}')
        keys.append('"parameters": {' + ", ".join(f'"{p}": 1' for p in self.parameters) + "}")
        keys.append(f'"potential": "{sum_text(self.potential, shape.angles, shape.coordinates + self.parameters)}"')
        return "{" + ",\n ".join(keys) + "}\n"

    def options(self):
        words = [f"{p}={low}:{high}" for p, (low, high) in zip(self.parameters, self.ranges)]
        if len(words) == 1:
            return ["events", "--vary", words[0]]
        return ["locus", "--x", words[0], "--y", words[1]]


def family(r, n_parameters):
    n_angles, n = r.choice([(0, 1), (0, 1), (1, 0), (1, 0), (1, 1), (0, 2)] if n_parameters == 1 else [(0, 1), (1, 0)])
    while True:
        f = {}
        for j in range(r.randint(3, 5)):
            k = tuple(r.choice([0, 1, 1, 2]) for _ in range(n_angles))
            e = exponents(r, n, {1: 5, 2: 3}[n]) if n and not n_angles else exponents(r, n, 2) if n else ()
            powers = [0] * n_parameters
            if j < n_parameters or r.random() < 0.3:
                powers[j % n_parameters] = r.choice([1, 1, 1, 2])
            put(f, r.choice(["cos", "sin"]) if any(k) else "cos", k, tuple(e) + tuple(powers), coefficient(r))
        for u in range(n):
            if r.random() < 0.7:
                e = [0] * (n + n_parameters)
                e[u] = r.choice([2, 4])
                put(f, "cos", (0,) * n_angles, tuple(e), coefficient(r))
        low = [r.randint(-3, 0) for _ in range(n_parameters)]
        y = Family(n_angles, n, n_parameters, f, [(v, v + r.randint(1, 4)) for v in low])
        # every unknown and parameter is there
        terms = [key for u in range(n_angles + n) for key in sum_derivative(f, u, n_angles)]
        if all(any(tuple(k + e)[v] for _, k, e in terms) for v in range(n_angles + n + n_parameters)):
            if all(sum_derivative(f, u, n_angles) for u in range(n_angles + n)):
                return y


def events(r):
    return family(r, 1)


def loci(r):
    return family(r, 2)


CLASSES = {"events": events, "loci": loci}


def real_equilibria(oracle, truth_of, system):
    """How many there are, or None where they are not isolated, or one is degenerate."""
    if any(not f for f in system.sums()):
        return None
    truth = truth_of(oracle, system)
    if truth.dimension > 0 or any(m > 1 and r for m, _, r in truth.roots):
        return None
    return truth.real


def inside(polygons, p):
    """Whether a point is in the union of the polygons, and how near the nearest edge is."""
    within, near = False, float("inf")
    for polygon in polygons:
        for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
            if (y0 > p[1]) != (y1 > p[1]) and p[0] < (x1 - x0) * (p[1] - y0) / (y1 - y0) + x0:
                within = not within
            dx, dy = x1 - x0, y1 - y0
            length = dx * dx + dy * dy
            t = 0 if length == 0 else min(1, max(0, ((p[0] - x0) * dx + (p[1] - y0) * dy) / length))
            near = min(near, ((p[0] - x0 - t * dx) ** 2 + (p[1] - y0 - t * dy) ** 2) ** 0.5)
    return within, near


def between(r, low, high):
    """A dyadic number strictly between, not too near the ends."""
    t = Fraction(r.randint(60, 964), 1024)
    y = Fraction(low) + (Fraction(high) - Fraction(low)) * t
    return Fraction(round(y * 2**40), 2**40)


def wrong(oracle, truth_of, f, said, r):
    """Sentences about what is false, and whether it was said to be complete."""
    if said.status is None:
        return [said.error], False
    if said.status == 2:
        return ([] if said.error else ["refused without a sentence"]), False
    if said.status != 0:
        return [f"exit status {said.status}: {said.error[-200:]}"], False
    d = said.document
    y = []
    if len(f.parameters) == 1:
        complete, argument = d["complete"], d["argument"]
        for k, interval in enumerate(d["intervals"]):
            for _ in range(3):
                a = between(r, interval["low"], interval["high"])
                count = real_equilibria(oracle, truth_of, f.at([a]))
                if count is not None and count != interval["count"]:
                    y.append(f"interval {k}, {f.parameters[0]} = {float(a)!r}: {interval['count']} equilibria, there are {count}")
                    break
    else:
        complete, argument = d["evidence"]["complete"], d["argument"]
        size = min(high - low for low, high in f.ranges)
        for _ in range(25):
            p = [between(r, low, high) for low, high in f.ranges]
            found = []
            for k, region in enumerate(d["regions"]):
                within, near = inside(region["polygons"], [float(v) for v in p])
                if near < 0.01 * size:
                    break
                if within:
                    found.append((k, region["count"]))
            else:
                count = real_equilibria(oracle, truth_of, f.at(p))
                where = ", ".join(f"{n} = {float(v)!r}" for n, v in zip(f.parameters, p))
                if not found:
                    y.append(f"{where}: in no region")
                elif count is not None and any(c != count for _, c in found):
                    y.append(f"region {found[0][0]}, {where}: {found[0][1]} equilibria, there are {count}")
    if not complete:
        y = []
        if not argument:
            y.append("not complete, and no reason")
        elif "evidence" in d and not any(v for key, v in d["evidence"].items() if key not in ("lines", "seeds", "checked_points", "complete", "seconds")):
            y.append("not complete, and all numbers of the reason are 0")
    return y[:5], complete


def ask(o, f, path, seed):
    return compare.run(o.equilibria, [f.options()[0], str(path), *f.options()[1:], "--seed", str(seed), "--json", "-"], o.time)
