"""Tables of results, as text and as HTML."""

from __future__ import annotations

from html import escape
from typing import Any, List, Sequence

most_rows = 60


def number(value: float, digits: int = 8) -> str:
    return f"{value:.{digits}g}"


def fixed(value: float) -> str:
    """8 decimals, and no sign of a zero."""
    text = f"{value:.8f}"
    return text[1:] if text == "-0.00000000" else text


def by_index(counts: Any) -> str:
    return " + ".join(str(int(count)) for count in counts)


class Printed:
    """What prints as a line, as a table, and as HTML in a notebook: `_line()`, `_columns()` and `_rows()` say what."""

    def _line(self) -> str:
        raise NotImplementedError

    def _columns(self) -> Sequence[str]:
        return ()

    def _rows(self) -> List[List[str]]:
        return []

    def _foot(self) -> str:
        return ""

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self._line()}>"

    def __str__(self) -> str:
        rows = self._rows()
        shown = [list(self._columns())] + [list(row) for row in rows[:most_rows]]
        lines = [self._line()]
        if rows:
            widths = [max(len(row[k]) for row in shown) for k in range(len(shown[0]))]
            lines += ["  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in shown]
        if len(rows) > most_rows:
            lines.append(f".. and {len(rows) - most_rows} more")
        return "\n".join(filter(None, lines + [self._foot()]))

    def _repr_html_(self) -> str:
        def row(cells: Sequence[str], tag: str) -> str:
            return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

        rows = self._rows()
        html = f"<p>{escape(self._line())}</p>"
        if rows:
            body = "".join(row(cells, "td") for cells in rows[:most_rows])
            html += f"<table><thead>{row(self._columns(), 'th')}</thead><tbody>{body}</tbody></table>"
        if len(rows) > most_rows:
            html += f"<p>.. and {len(rows) - most_rows} more</p>"
        if self._foot():
            html += f"<p>{escape(self._foot())}</p>"
        return html
