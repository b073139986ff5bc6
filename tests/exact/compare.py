"""What a program says of a system, held against the truth."""

import json
import subprocess
import time
from pathlib import Path

import mpmath

from polynomials import sum_derivative

mpmath.mp.dps = 60


class Said:
    """What a program said, whichever it was: the same names for polynomials and models."""

    def __init__(self):
        self.status, self.seconds, self.error, self.document = None, 0.0, "", {}
        self.complete, self.reason, self.missing, self.clean, self.explained = False, "", "absent", False, False
        self.roots = []  # dictionaries: point, real, singular, multiplicity, stated, exists, reality, radius
        self.counts = {}  # proved: distinct, real, non_real
        self.families, self.equilibria, self.by_index = [], [], None


def run(program, arguments, seconds):
    y = Said()
    begin = time.monotonic()
    try:
        p = subprocess.run([str(program), *arguments], capture_output=True, text=True, timeout=seconds, errors="replace")
        y.status, y.error = p.returncode, p.stderr.strip()
        if p.returncode == 0:
            try:
                y.document = json.loads(p.stdout)
            except ValueError:
                y.status, y.error = -1, "what it wrote is no JSON"
    except subprocess.TimeoutExpired:
        y.error = f"no end within {seconds} s"
    y.seconds = time.monotonic() - begin
    return y


def _root(point, r):
    certificate = r.get("certificate") or {}
    singular = bool(r.get("singular", r.get("multiplicity", 1) > 1))
    return {
        "point": point,
        "real": bool(r.get("real", False)),
        "singular": singular,
        "multiplicity": r.get("multiplicity", 1),
        "stated": bool(r.get("multiplicity_proved", "multiplicity_proved" not in r)) and not r.get("undecided", False),
        "exists": bool(certificate.get("exists", False)),
        "distinct": bool(certificate.get("distinct", False)),
        "reality": certificate.get("reality", "undecided"),
        "radius": certificate.get("radius") or 0.0,
    }


def _common(y, d, proof, prefix):
    y.complete = bool(d.get("complete", proof.get("complete", False)))
    y.reason = d.get("reason", proof.get("reason", "")) or ""
    y.missing = d.get("missing_at_most", "absent")
    y.explained = d.get("completeness") == "explained"
    for key in ("distinct", "real", "non_real"):
        if prefix + key in proof:
            y.counts[key] = proof[prefix + key]
    y.families = [f for f in d.get("families", []) if isinstance(f, dict)]


def said_of_polynomials(solve, path, seed, seconds, prove, unknowns):
    y = run(solve, [str(path), *(["--prove"] if prove else []), "--seed", str(seed), "--json", "-"], seconds)
    if y.status != 0 or not y.document:
        return y
    d = y.document
    _common(y, d, d, "proved_")
    for r in d["roots"]:
        y.roots.append(_root([mpmath.mpc(*r["unknowns"][name]) for name in unknowns], r))
    return y


def said_of_model(equilibria, path, seed, seconds, command, n_angles):
    y = run(equilibria, [command, str(path), "--seed", str(seed), "--json", "-"], seconds)
    if y.status != 0 or not y.document:
        return y
    d = y.document
    proof = d.get("proof") or {}
    if proof:
        _common(y, d, proof, "")
    else:
        _common(y, d, d, "proved_")
    y.clean = bool(d.get("clean", False))
    y.by_index = d.get("by_index")
    y.equilibria = d["equilibria"]
    multiplicities = d.get("multiplicities", [])
    certificates = d.get("root_certificates", [])
    undecided = d.get("multiplicities_proved")
    for k, point in enumerate(d["roots"]):
        if isinstance(point, dict):
            r, point = point, point["unknowns"]
            if isinstance(point, dict):
                point = list(point.values())
        else:
            r = {"multiplicity": multiplicities[k] if k < len(multiplicities) else 1}
            if k < len(certificates):
                r["certificate"] = certificates[k]
            if undecided:
                r["multiplicity_proved"] = undecided[k]
        place = []
        for u, z in enumerate(point):
            z = mpmath.mpc(*z)
            place += [mpmath.cos(z), mpmath.sin(z)] if u < n_angles else [z]
        y.roots.append(_root(place, r))
    return y


class Places:
    """The true isolated roots by a linear form of the unknowns, each divided by its size."""

    def __init__(self, truth, sizes):
        self.form, self.sizes = truth.form, sizes
        self.at = [(m, mpmath.mpc(mpmath.mpf(re), mpmath.mpf(im))) for m, re, im in truth.places]

    def value(self, point):
        return sum(c * z / s for c, z, s in zip(self.form, point, self.sizes))

    def near(self, point):
        """The nearest root, its distance, and the multiplicities of all that are hardly farther."""
        t = self.value(point)
        order = sorted((abs(t - z), k) for k, (_, z) in enumerate(self.at))
        if not order:
            return None, mpmath.inf, []
        d, k = order[0]
        # what double precision of the unknowns leaves open
        d0 = max(d, 1e-14 * sum(c * abs(z) / s for c, z, s in zip(self.form, point, self.sizes)))
        return k, d, [self.at[j][0] for e, j in order if e <= 10 * d0]

    def reach(self, radius, point):
        """How far the form may be from its value at a point, if each unknown is that near."""
        return sum(c * (2 * radius / s + 1e-12 * (abs(z) / s + 1)) for c, z, s in zip(self.form, point, self.sizes))


class Hessian:
    """Equilibria of a potential, and their index, to many digits."""

    def __init__(self, system):
        n = system.n_angles + system.n_coordinates
        self.n_angles, self.n = system.n_angles, n
        first = system.sums()
        self.first = first
        self.second = [[sum_derivative(f, k, system.n_angles) for k in range(n)] for f in first]
        self.sizes = [mpmath.mpf(1)] * system.n_angles + [
            mpmath.mpf(s.numerator) / s.denominator for s in (system.scale or [1] * system.n_coordinates)
        ]

    def value(self, f, q):
        total = mpmath.mpf(0)
        for (kind, k, e), c in f.items():
            t = mpmath.mpf(c.numerator) / c.denominator
            if any(k):
                inner = sum(a * z for a, z in zip(k, q))
                t *= mpmath.cos(inner) if kind == "cos" else mpmath.sin(inner)
            for j, z in zip(e, q[self.n_angles:]):
                t *= z**j
            total += t
        return total

    def matrix(self, q):
        s = self.sizes
        return mpmath.matrix([[self.value(f, q) * s[i] * s[j] for j, f in enumerate(row)] for i, row in enumerate(self.second)])

    def index(self, q):
        """The index of the equilibrium that Newton's method finds from q, or None if it finds none."""
        q = [mpmath.mpf(z) for z in q]
        try:
            for _ in range(40):
                f = mpmath.matrix([self.value(g, q) * s for g, s in zip(self.first, self.sizes)])
                step = mpmath.lu_solve(self.matrix(q), f)
                q = [z - d * s for z, d, s in zip(q, step, self.sizes)]
                if max(abs(d) for d in step) < mpmath.mpf(10) ** -45:
                    values = mpmath.eigsy(self.matrix(q), eigvals_only=True)
                    return sum(1 for v in values if v < 0)
        except ZeroDivisionError:
            pass
        return None


def wrong(system, truth, said):
    """Sentences, one for each thing that the program said and that is false."""
    y = []
    if said.status is None:
        return [said.error]
    if said.status == 2:
        return [] if said.error else ["refused without a sentence"]
    if said.status != 0:
        return [f"exit status {said.status}: {said.error[-200:]}"]
    sizes = [mpmath.mpf(1)] * (2 * system.n_angles)
    sizes += [mpmath.mpf(s.numerator) / s.denominator for s in (system.scale or [1] * system.n_coordinates)]
    places = Places(truth, sizes)
    claimed = said.complete or said.clean or said.explained
    claim = "complete" if said.complete else "clean" if said.clean else "explained"

    if not said.complete and not said.reason:
        y.append("not complete, and no reason")
    found = len(said.roots)
    if claimed and found != truth.distinct:
        y.append(f"{claim}: {found} isolated roots, there are {truth.distinct}")
    undecided = any(r["reality"] == "undecided" for r in said.roots)
    if system.model:
        real = said.document.get("real", len(said.equilibria))
    else:
        real = sum(r["real"] for r in said.roots)
    if claimed and not (said.complete and not system.model and undecided) and found == truth.distinct and real != truth.real:
        y.append(f"{claim}: {real} real roots, there are {truth.real}")
    most = {"distinct": truth.distinct, "real": truth.real, "non_real": truth.distinct - truth.real}
    for key, n in said.counts.items():
        if n > most[key]:
            y.append(f"{n} roots proved {key.replace('_', '-')}, there are {most[key]}")
    if isinstance(said.missing, int) and found + said.missing < truth.distinct:
        y.append(f"{found} found, at most {said.missing} missing: there are {truth.distinct}")

    degrees = {}
    for f in said.families:
        if f.get("degree") is not None:
            degrees[f["dimension"]] = degrees.get(f["dimension"], 0) + f["degree"]
        if f["dimension"] not in truth.families:
            y.append(f"a family of dimension {f['dimension']}, which does not exist")
    for d, k in degrees.items():
        if d in truth.families and (k > truth.families[d] or (said.complete and k != truth.families[d])):
            y.append(f"families of dimension {d} have degree {k} in sum: true is {truth.families[d]}")
    if said.complete and truth.families and not said.families and "families" in said.document and not system.model:
        y.append("complete, and families of solutions are not named")
    if system.model:
        named = said.document.get("families", [])
        if named and not truth.families and not truth.turns:
            y.append(f"families are named that do not exist: {named[0]}")
        if claimed and (truth.families or truth.turns) and not named and "isolated" not in said.reason:
            y.append(f"{claim}: families of solutions are neither named nor excepted")

    for r in said.roots:
        k, d, multiplicities = places.near(r["point"])
        where = ", ".join(mpmath.nstr(z, 10) for z in r["point"])
        if r["exists"] and d > places.reach(r["radius"], r["point"]):
            y.append(f"proved to exist, and no root: {where}")
        elif r["singular"] and r["stated"] and truth.dimension <= 0:
            if not multiplicities:
                y.append(f"a singular root that does not exist: {where}")
            elif r["multiplicity"] not in multiplicities:
                y.append(f"multiplicity {r['multiplicity']} at {where}: true is {multiplicities[0]}")
        elif not r["singular"] and (r["exists"] or said.complete) and multiplicities and 1 not in multiplicities:
            y.append(f"called regular, of multiplicity {multiplicities[0]}: {where}")
    if system.potential is not None:
        hessian = Hessian(system)
        for e in said.equilibria:
            certificate = e.get("certificate") or {}
            q = e.get("angles", []) + e.get("coordinates", [])
            if certificate.get("index_proved") or (claimed and not e.get("degenerate")):
                index = hessian.index(q)
                told = certificate["index"] if certificate.get("index_proved") else e["index"]
                if index is not None and index != told:
                    y.append(f"index {told} at {q}: true is {index}")
            if claimed and e.get("degenerate"):
                point = []
                for u, z in enumerate(q):
                    point += [mpmath.cos(z), mpmath.sin(z)] if u < system.n_angles else [mpmath.mpf(z)]
                multiplicities = places.near(point)[2]
                if multiplicities and max(multiplicities) == 1:
                    y.append(f"{claim}: called degenerate, and is regular: {q}")
    return y


def programs(folder):
    """The programs' paths, whether solve has --prove, and which subcommand of equilibria speaks of completeness."""
    solve, equilibria = Path(folder) / "solve", Path(folder) / "equilibria"
    for p in (solve, equilibria):
        if not p.exists():
            raise SystemExit(f"scripts/exact: {p}: must be built: ninja -C build/release solve equilibria")
    help_text = subprocess.run([str(solve), "--help"], capture_output=True, text=True).stdout
    return solve, equilibria, "--prove" in help_text


def speaks_of_completeness(equilibria, folder):
    path = Path(folder) / "probe.json"
    path.write_text('{"angles": ["t"], "potential": "cos(t)"}\n')
    return "complete" in run(equilibria, ["solve", str(path), "--json", "-"], 60).document
