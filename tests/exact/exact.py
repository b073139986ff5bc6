"""Generated systems, solved by the programs and held against exact algebra.

  scripts/exact [N] [--seeds K] [--classes a,b] [--first-seed S] [--programs DIR]
  scripts/exact --scale N [--files DIR]    the same systems in other units: counts must be the same

N systems (default 400), as many of each class as of any other, each solved with K seeds of the programs (default 1). What they say
is compared with what Singular and PARI/gp compute. A system of which something false is said, with the truth, what was said and a
line of cause, is kept in build/exact/failures. The number given by --first-seed chooses the systems: the same number, the same systems.
"""

import argparse
import json
import math
import multiprocessing
import random
import shutil
import sys
import tempfile
import time
from pathlib import Path

import compare
import parameters
import systems
from oracle import Oracle, Slow, trigonometric_system, turning_truth

CLASSES = [*systems.CLASSES, *parameters.CLASSES]
ROOT = Path(__file__).resolve().parents[2]


def truth_of(oracle, system):
    if not system.model:
        y = oracle.truth(system.equations, system.n_coordinates, system.scale)
    elif system.turns and system.n_angles > 2:
        y = turning_truth()
    else:
        n = 2 * system.n_angles + system.n_coordinates
        scale = [1] * (2 * system.n_angles) + system.scale if system.scale else None
        y = oracle.truth(trigonometric_system(system.sums(), system.n_angles, system.n_coordinates), n, scale)
    if not y.turns:
        oracle.find_places(y)
    return y


def ask(system, path, o, seed):
    """What the programs say of a system in a file."""
    if not system.model:
        return compare.said_of_polynomials(o.solve, path, seed, o.time, o.prove, system.coordinates)
    return compare.said_of_model(o.equilibria, path, seed, o.time, o.command, system.n_angles)


def one(task):
    """One system: the class, the verdict of each seed of the programs, the causes."""
    name, k = task
    o = one.options
    if name in parameters.CLASSES:
        return one_family(name, k)
    system = systems.draw(name, random.Random(f"{o.first_seed}/{name}/{k}"), k)
    label = f"{name}-{o.first_seed}-{k}"
    try:
        truth = truth_of(one.oracle, system)
    except Slow as error:
        return name, [("unknown", 0.0)], [f"{label}: {error}"]
    path = Path(one.folder) / f"{label}.{system.extension()}"
    path.write_text(system.text())
    verdicts, causes = [], []
    for seed in range(1, o.seeds + 1):
        said = ask(system, path, o, seed)
        try:
            sentences = compare.wrong(system, truth, said)
        except Exception as error:  # a fault of the comparison must name its system
            sentences = [f"the comparison itself failed: {error!r}"]
        if sentences:
            verdict = "wrong"
            keep(o, path, label, seed, truth, said, sentences)
            causes += [f"{label}, seed {seed}: {s}" for s in sentences]
        else:
            verdict = "refused" if said.status == 2 else "complete" if said.complete else "explained" if said.explained else "undecided"
        verdicts.append((verdict, said.seconds))
    path.unlink()
    return name, verdicts, causes


def one_family(name, k):
    """One model with parameters."""
    o = one.options
    f = parameters.CLASSES[name](random.Random(f"{o.first_seed}/{name}/{k}"))
    label = f"{name}-{o.first_seed}-{k}"
    path = Path(one.folder) / f"{label}.json"
    path.write_text(f.text())
    verdicts, causes = [], []
    for seed in range(1, o.seeds + 1):
        said = parameters.ask(o, f, path, seed)
        try:
            sentences, complete = parameters.wrong(one.oracle, truth_of, f, said, random.Random(f"{label}/{seed}"))
        except Slow as error:
            return name, [("unknown", 0.0)], [f"{label}: {error}"]
        if sentences:
            keep(o, path, label, seed, None, said, [" ".join(f.options())] + sentences)
            causes += [f"{label} ({' '.join(f.options())}), seed {seed}: {s}" for s in sentences]
        verdict = "wrong" if sentences else "refused" if said.status == 2 else "complete" if complete else "undecided"
        verdicts.append((verdict, said.seconds))
    path.unlink()
    return name, verdicts, causes


def keep(o, path, label, seed, truth, said, sentences):
    folder = Path(o.failures)
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, folder / path.name)
    if truth:
        (folder / f"{label}.truth.json").write_text(json.dumps(truth.document(), indent=1) + "\n")
    (folder / f"{label}.{seed}.said.json").write_text(json.dumps(said.document, indent=1) + "\n")
    (folder / f"{label}.{seed}.cause.txt").write_text("\n".join(sentences) + "\n")


def clear(folder):
    """Removes what an earlier run kept."""
    for pattern in ("*.truth.json", "*.said.json", "*.cause.txt"):
        for path in folder.glob(pattern):
            path.unlink()
            for extension in ("txt", "json"):
                (folder / f"{path.name.split('.')[0]}.{extension}").unlink(missing_ok=True)


def begin(options, folder):
    one.options, one.folder, one.oracle = options, folder, Oracle(options.oracle_time)
    import atexit

    atexit.register(one.oracle.stop)


def table(results, columns):
    print(f"{'class':<30}{'systems':>8}" + "".join(f"{c:>11}" for c in columns) + f"{'slow':>7}{'worst s':>9}")
    total = dict.fromkeys(columns, 0)
    for name, rows in results.items():
        counts = {c: sum(v == c for vs in rows for v, _ in vs) for c in columns}
        seconds = [s for vs in rows for _, s in vs]
        for c in columns:
            total[c] += counts[c]
        print(
            f"{name:<30}{len(rows):>8}" + "".join(f"{counts[c]:>11}" for c in columns)
            + f"{sum(s > 10 for s in seconds):>7}{max(seconds, default=0):>9.2f}"
        )
    print(f"{'all':<30}{sum(len(r) for r in results.values()):>8}" + "".join(f"{total[c]:>11}" for c in columns))
    return total


def find_programs(asked):
    if asked:
        return Path(asked)
    for preset in ("release", "dev"):
        if (ROOT / "build" / preset / "bin" / "solve").exists():
            return ROOT / "build" / preset / "bin"
    raise SystemExit("scripts/exact: no programs in build/release/bin or build/dev/bin: give --programs DIR")


def main():
    p = argparse.ArgumentParser(prog="scripts/exact", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("systems", nargs="?", type=int, default=400, metavar="N")
    p.add_argument("--seeds", type=int, default=1, metavar="K", help="of the programs, from 1 to K")
    p.add_argument("--classes", default="", help="names, separated by commas; all: " + ", ".join(CLASSES))
    p.add_argument("--first-seed", type=int, default=1, metavar="S", help="chooses the systems")
    p.add_argument("--programs", default="", metavar="DIR", help="where solve and equilibria are")
    p.add_argument("--failures", default=str(ROOT / "build/exact/failures"), metavar="DIR", help="where failing systems are kept")
    p.add_argument("--processes", type=int, default=2)
    p.add_argument("--time", type=float, default=60, help="seconds that a program may take")
    p.add_argument("--limit", type=float, default=math.inf, metavar="SECONDS", help="when to stop; the table has what was done until then")
    p.add_argument("--oracle-time", type=float, default=20, help="seconds that an exact computation may take")
    p.add_argument("--allow", type=int, default=0, metavar="W", help="so many wrong answers are no failure")
    p.add_argument("--scale", action="store_true", help="compare systems with themselves in other units")
    p.add_argument("--files", default="", metavar="DIR", help="with --scale: systems in PHCpack's format as well")
    o = p.parse_args()
    for tool in ("Singular", "gp"):
        if not shutil.which(tool):
            raise SystemExit(f"scripts/exact: {tool} is missing (Debian packages singular, pari-gp)")
    o.solve, o.equilibria, o.prove = compare.programs(find_programs(o.programs))

    with tempfile.TemporaryDirectory() as folder:
        o.command = "solve" if compare.speaks_of_completeness(o.equilibria, folder) else "prove"
        if o.scale:
            import scale

            return scale.main(o, folder)
        names = o.classes.split(",") if o.classes else list(CLASSES)
        for name in names:
            if name not in CLASSES:
                raise SystemExit(f"scripts/exact: --classes {name}: must be of " + ", ".join(CLASSES))
        clear(Path(o.failures))
        tasks = [(names[j % len(names)], j // len(names)) for j in range(o.systems)]
        results = {name: [] for name in names}
        all_causes = []
        start = time.monotonic()
        with multiprocessing.get_context("fork").Pool(o.processes, begin, (o, folder)) as pool:
            for name, verdicts, causes in pool.imap(one, tasks):
                results[name].append(verdicts)
                all_causes += causes
                for c in causes:
                    print(c, flush=True)
                if time.monotonic() - start > o.limit:
                    pool.terminate()
                    break
            pool.close()
            pool.join()
    print()
    total = table(results, ["complete", "explained", "undecided", "refused", "wrong", "unknown"])
    done = sum(len(rows) for rows in results.values())
    print(f"\n{done} systems, {o.seeds} seeds each, {total['wrong']} wrong answers, {time.monotonic() - start:.0f} s", end="")
    print(f"; stopped by --limit before {o.systems}" if done < o.systems else "", end="")
    print(f"; what failed is in {o.failures}" if total["wrong"] else "")
    return 0 if total["wrong"] <= o.allow else 1


if __name__ == "__main__":
    sys.exit(main())
