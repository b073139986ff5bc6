"""Systems of the literature, of known.py, of files, and the models of examples/ in other units: what is counted must not change.

Unknowns and equations are multiplied by powers of ten from 1e-9 to 1e9, in rational numbers that are rounded to doubles only at the end.
Rounding would take multiple roots, roots close together and roots at infinity apart: the systems of known.py and of files are multiplied
by powers of two, exactly.
"""

import ast
import json
import random
import re
import time
from fractions import Fraction
from math import prod
from pathlib import Path

import compare
import known
import systems
from polynomials import add, constant, scaled, times, variable

MODELS = Path(__file__).resolve().parents[2] / "examples/models"


def product(n, *of):
    y = constant(n, 1)
    for k in of:
        y = times(y, variable(n, k))
    return y


def cyclic(n):
    y = [add(*[product(n, *[(i + j) % n for j in range(k)]) for i in range(n)]) for k in range(1, n)]
    return y + [add(product(n, *range(n)), constant(n, -1))]


def katsura(m):
    n = m + 1
    y = [add(variable(n, 0), constant(n, -1), *[scaled(variable(n, k), 2) for k in range(1, n)])]
    for k in range(m):
        terms = [product(n, abs(j), abs(k - j)) for j in range(-m, m + 1) if abs(k - j) <= m]
        y.append(add(scaled(variable(n, k), -1), *terms))
    return y


def noon(n):
    y = []
    for i in range(n):
        terms = [product(n, i, j, j) for j in range(n) if j != i]
        y.append(add(scaled(variable(n, i), Fraction(-11, 10)), constant(n, 1), *terms))
    return y


def eco(n):
    y = []
    for k in range(1, n):
        terms = [product(n, i - 1, i + k - 1, n - 1) for i in range(1, n - k)]
        y.append(add(product(n, k - 1, n - 1), constant(n, -k), *terms))
    return y + [add(constant(n, 1), *[variable(n, i) for i in range(n - 1)])]


def chandra(n):
    c = Fraction(51234, 100000)
    y = []
    for k in range(1, n + 1):
        terms = [scaled(product(n, k - 1, i - 1), -c * k / (i + k)) for i in range(1, n)]
        y.append(add(scaled(variable(n, k - 1), 2 * n - c), constant(n, -2 * n), *terms))
    return y


FAMILIES = {
    "katsura-3": katsura(3), "katsura-4": katsura(4), "katsura-5": katsura(5), "cyclic-3": cyclic(3), "cyclic-5": cyclic(5),
    "noon-3": noon(3), "noon-4": noon(4), "eco-4": eco(4), "eco-6": eco(6), "chandra-3": chandra(3), "chandra-5": chandra(5),
}


def powers(r, n, base):
    return [Fraction(base) ** r.randint(*((-9, 9) if base == 10 else (-30, 30))) for _ in range(n)]


def in_units(equations, r, base=10):
    """Polynomials with each unknown and each equation in another unit."""
    n = len(equations)
    unknowns, factors = (powers(r, n, base), powers(r, n, base)) if r else ([1] * n, [1] * n)
    changed = []
    for f, factor in zip(equations, factors):
        changed.append({e: c * factor / prod(s**k for s, k in zip(unknowns, e)) for e, c in f.items()})
    return systems.polynomials(changed, n, most=10**9)


def sums_in_units(system, r):
    """A model of known.py with each coordinate and its potential, or each equation, in another unit."""

    def changed(f):
        factor = powers(r, 1, 2)[0] if r else 1
        return {(kind, k, e): c * factor / prod(s**m for s, m in zip(unknowns, e)) for (kind, k, e), c in f.items()}

    unknowns = powers(r, system.n_coordinates, 2) if r else [1] * system.n_coordinates
    if system.potential is not None:
        return systems.model(system.n_angles, system.n_coordinates, potential=changed(system.potential))
    return systems.model(system.n_angles, system.n_coordinates, equations=[changed(f) for f in system.equations])


def read(path):
    """The equations of a file in PHCpack's format, of sums of products."""
    body = path.read_text().split("\n", 1)[1]
    unknowns = list(dict.fromkeys(re.findall(r"(?<![\w.])[A-Za-z_]\w*", body)))
    texts = [" ".join(t.split()).replace("^", "**") for t in body.split(";") if t.strip()]
    return [known._value(ast.parse(t, mode="eval").body, len(unknowns), unknowns) for t in texts]


def model_text(path, r):
    """The model with each coordinate x written as a number times a new one, and its potential or equations times numbers."""
    d = json.loads(path.read_text())
    number = (lambda: f"1e{r.randint(-9, 9)}") if r else (lambda: "1")
    d = {k: v for k, v in d.items() if k in ("name", "angles", "coordinates", "parameters", "definitions", "potential", "equations")}
    used = json.dumps([d.get("potential"), d.get("equations")])
    coordinates = d.get("coordinates", [])
    # the definitions that the potential needs: others may speak of rates
    needed, texts = {}, d.get("definitions", {})
    for name in reversed(list(texts)):
        if name in used or any(name in t for t in needed.values()):
            needed = {name: texts[name], **needed}
    d["definitions"] = {**{x: f"{number()}*{x}_new" for x in coordinates}, **needed}
    d["coordinates"] = [f"{x}_new" for x in coordinates]
    if "potential" in d:
        d["potential"] = f"{number()}*({d['potential']})"
    else:
        d["equations"] = [f"{number()}*({f})" for f in d["equations"]]
    # where equations come from no potential, their units change the signs of eigenvalues
    return json.dumps({k: v for k, v in d.items() if v}, indent=1) + "\n", len(d.get("angles", [])), "potential" in d


def counts(said, by_index):
    d = said.document
    y = {"roots": len(said.roots), "complete": said.complete, "status": said.status}
    if said.status == 0:
        y["real"] = d["real"]
        if by_index and "by_index" in d:
            y["by_index"] = d["by_index"]
    return y


def ask(o, path, angles, unknowns):
    if path.suffix == ".txt":
        return compare.said_of_polynomials(o.solve, path, 1, o.time, o.prove, unknowns)
    return compare.said_of_model(o.equilibria, path, 1, o.time, o.command, angles)


def all_systems(o):
    """Name to what makes the system's text in the units that a random.Random chooses: text, suffix, angles, unknowns, by index."""
    y = {}

    def put_polynomials(name, equations, base):
        def make(r):
            while not (system := in_units(equations, r, base)):
                pass  # numbers beyond 1e250: drawn again
            return system.text(), "txt", 0, system.coordinates, False

        y[name] = make

    def put_known(name, system):
        def make(r):
            changed = sums_in_units(system, r)
            return changed.text(), "json", system.n_angles, None, system.potential is not None

        y[name] = make

    def put_model(path):
        def make(r):
            text, angles, by_index = model_text(path, r)
            return text, "json", angles, None, by_index

        y[path.stem] = make

    for name, equations in FAMILIES.items():
        put_polynomials(name, equations, 10)
    for path in sorted(MODELS.glob("*.json")):
        put_model(path)
    for k in range(len(known.POLYNOMIALS) + len(known.MODELS)):
        system = known.known(k)
        if system.model:
            put_known(f"known-{k}", system)
        else:
            put_polynomials(f"known-{k}", system.equations, 2)
    for path in sorted(Path(o.files).glob("*")) if o.files else []:
        put_polynomials(path.stem, read(path), 2)
    return y


def main(o, folder):
    makers = all_systems(o)
    names = list(makers)
    results = {name: [] for name in names}
    first = {}
    begin = time.monotonic()
    kept = Path(o.failures)
    for j in range(o.systems + len(names)):
        name, k = names[j % len(names)], j // len(names)
        r = random.Random(f"{o.first_seed}/{name}/{k}") if k else None  # the first time in its own units
        text, suffix, angles, unknowns, by_index = makers[name](r)
        path = Path(folder) / f"{name}-{k}.{suffix}"
        path.write_text(text)
        said = ask(o, path, angles, unknowns)
        now = counts(said, by_index)
        if not k:
            first[name] = now
            print(f"{name}: {now}")
            continue
        verdict = "same"
        if now != first[name]:
            silent = now["complete"] or said.clean or said.status != 0 or not said.reason
            verdict = "wrong" if silent else "undecided"
            kept.mkdir(parents=True, exist_ok=True)
            (kept / path.name).write_text(text)
            print(f"{name}-{k}: {verdict}: {now} {said.error}{said.reason}", flush=True)
        results[name].append([(verdict, said.seconds)])
    print()
    from exact import table

    total = table(results, ["same", "undecided", "wrong"])
    print(f"\n{o.systems} systems in other units, {total['wrong']} wrong, {time.monotonic() - begin:.0f} s")
    return 0 if total["wrong"] <= o.allow else 1
