# SPDX-License-Identifier: BSL-1.0
"""The block `<!-- from costs: table ... -->`: a table of figures, from the rows of docs/costs, by clauses between semicolons:

    paths crowd                             the module and the axis
    rows key walkers                        a line for each key, below this heading; or for each choice, problem, policy, which is a
                                            choice whatever its parameter, or step, which is a policy and its work
    only rooms; without Reopening           of the rows whose problem or choice begins with, or has, these words
    keys 0.1 0.025                          of these keys, or works
    rooms: a search each = time ms of a search each in 128 x 128 tiles, rooms
                                            a column: its heading, and what of which rows: time, work or error, in a unit or in the one
                                            that suits; several with commas; of several rows all stand in the cell

advice_blocks.py writes it.
"""

from __future__ import annotations

import re
from typing import Callable, NamedTuple, Optional

from workshop.cost_rows import Row, different

UNITS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
COLUMN = re.compile(r"(?P<what>(?:time|work|error)(?: (?:ns|us|ms|s|%|mm))?(?:, (?:time|work|error)(?: (?:ns|us|ms|s|%|mm))?)*)"
                    r"(?: of (?P<choice>.*?))?(?: in (?P<problem>.*))?$")


class Column(NamedTuple):
    """What it shows of which rows."""
    heading: str
    what: list[str]
    choice: Optional[str]
    problem: str


def digits(number: float) -> str:
    """Two of them; a small number by powers of ten."""
    if number == 0:
        return "0"
    if abs(number) < 1e-3:
        return f"{number:.1e}".replace("e-0", "e-")
    text = f"{number:.2g}"
    return f"{float(text):.0f}" if "e" in text else text


def time_in(nanoseconds: float, unit: str) -> str:
    """In a unit that the heading says, or in the one that suits, which then stands behind."""
    if unit:
        return digits(nanoseconds / UNITS[unit])
    suits = next((name for name in ("s", "ms", "us") if nanoseconds >= 0.995 * UNITS[name]), "ns")
    return f"{digits(nanoseconds / UNITS[suits])} {suits}"


def shown(row: Row, what: str) -> str:
    """One figure of a row; nothing where it has none."""
    kind, _, unit = what.partition(" ")
    value = {"time": row.time, "work": row.work, "error": row.error}[kind]
    if value is None:
        return "diverged" if kind == "error" else ""
    if kind == "time":
        return time_in(value, unit)
    if kind == "work":
        return f"{value:.0f}"
    scale = {"": 1.0, "%": 100.0, "mm": 1000.0}[unit]
    if unit and value < 1e-12:    # rounding, of what is one
        return "0"
    return digits(value * scale) + (f" {unit}" if unit else "")


def label_of(choice: str, parameter: str = "") -> str:
    """A policy in the letters of code, what it is told behind it."""
    name = choice[:choice.rfind(">") + 1] if "<" in choice.partition(", ")[0] else choice.partition(", ")[0]
    named = f"`{name}`" if re.search(r"[A-Z]|::|_", name) else name
    return named + choice[len(name):] + (f", {parameter}" if parameter else "")


def is_among(number: Optional[float], text: str) -> bool:
    """Whether a row's number is one of those of a clause."""
    return number is not None and number in [float(word) for word in text.split()]


def column_of(clause: str) -> Column:
    """From "heading = time ms of Heap in rooms"."""
    heading, _, asked = clause.rpartition(" = ")
    found = COLUMN.match(asked)
    if not heading or not found:
        raise ValueError(f"'{clause}' is no column: heading = time us of Choice in problem")
    return Column(heading, found["what"].split(", "), found["choice"], found["problem"] or "")


def table(rows: list[Row], clauses: list[str]) -> list[str]:
    """Its lines."""
    columns: list[Column] = []
    by, heading = "choice", ""
    for clause in clauses:
        word, _, rest = clause.partition(" ")
        if word == "rows":
            by, _, heading = rest.partition(" ")
        elif word == "only":
            rows = [row for row in rows if row.problem.startswith(rest) or row.choice.startswith(rest)]
        elif word == "without":
            rows = [row for row in rows if rest not in row.choice and rest not in row.problem]
        elif word == "works":
            rows = [row for row in rows if is_among(row.work, rest)]
        elif word == "keys":
            rows = [row for row in rows if is_among(row.key, rest)]
        else:
            columns.append(column_of(clause))
    named: dict[str, Callable[[Row], str]] = {
        "choice": lambda row: label_of(row.choice, row.parameter), "policy": lambda row: label_of(row.choice),
        "step": lambda row: f"{label_of(row.choice)}, {row.work or 0:.0f}",
        "key": lambda row: "" if row.key is None else f"{row.key:.0f}" if row.key == round(row.key) else f"{row.key:g}", "problem": lambda row: row.problem}
    if by not in named or not columns or not rows:
        raise ValueError("a table has rows by choice, policy, step, key or problem, columns, and figures in them")
    lines = [f"| {heading} | " + " | ".join(column.heading for column in columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for name in different(named[by](row) for row in rows):
        here = [row for row in rows if named[by](row) == name]
        cells: list[str] = []
        for column in columns:
            found = [row for row in here if column.choice in (None, row.choice) and row.problem.startswith(column.problem)]
            cells.append(", ".join(text for row in found for what in column.what if (text := shown(row, what))))
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    for column, place in zip(columns, range(len(columns))):
        if not any(line.split(" | ")[place + 1].strip(" |") for line in lines[2:]):
            raise ValueError(f"no row has anything for the column '{column.heading}'")
    return lines
