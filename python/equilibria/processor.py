"""Whether this machine's processor has what the compiled part was built with: without this, a package that was built
natively on another machine would end the interpreter where it first computes."""

from __future__ import annotations

from typing import FrozenSet, Iterable, Optional

#: Instructions that a native build may use, by their names in /proc/cpuinfo.
instructions = ("avx", "avx2", "fma", "f16c", "bmi1", "bmi2", "avx512f", "avx512cd", "avx512bw", "avx512dq", "avx512vl")


def present() -> Optional[FrozenSet[str]]:
    """Those of this machine; None where they are not known."""
    try:
        with open("/proc/cpuinfo") as text:
            for line in text:
                if line.startswith("flags"):
                    return frozenset(line.split(":", 1)[1].split()) & frozenset(instructions)
    except OSError:
        pass
    return None


def require(needed: Iterable[str]) -> None:
    """Raises ImportError where some are known to be missing."""
    there = present()
    missing = [name for name in needed if there is not None and name not in there]
    if missing:
        raise ImportError(
            f"equilibria was built for a processor with {', '.join(missing)}, which this one has not: "
            "build it here, or with EQUILIBRIA_NATIVE=0"
        )
