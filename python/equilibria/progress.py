"""How far a long call is: a bar of tqdm's where that is installed, a line on stderr otherwise, or a function's own."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import Callable, Iterator, Optional, Tuple, Union

Report = Callable[[int, int], object]  #: of how much is done, and how much there is
Progress = Union[bool, Report]


@contextmanager
def reporting(progress: Progress, what: str) -> Iterator[Optional[Report]]:
    """What a call is handed for `progress`: nothing, the caller's function, or one that draws."""
    if not progress:
        yield None
    elif callable(progress):
        yield progress
    else:
        report, close = _tqdm_bar(what) or _line(what)
        try:
            yield report
        finally:
            close()


def _tqdm_bar(what: str) -> Optional[Tuple[Report, Callable[[], object]]]:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    bar = tqdm(desc=what, unit="point" if what in ("sweep", "motion") else "path", leave=False)

    def report(done: int, all: int) -> None:
        if bar.total != all or done < bar.n:
            bar.reset(total=all)
        bar.update(done - bar.n)

    return report, bar.close


def _line(what: str) -> Tuple[Report, Callable[[], object]]:
    def report(done: int, all: int) -> None:
        sys.stderr.write(f"\r{what}: {done} of {all}   ")
        sys.stderr.flush()

    def close() -> None:
        sys.stderr.write("\n")

    return report, close
