# SPDX-License-Identifier: BSL-1.0
"""The rows of a cost table, as pages read them: docs/costs/<module>.json, one run of `./workbook costs` each.

A row has an axis (broadphase), a problem (how the bodies lie), a choice (a policy), a key (the number of bodies, or the
parameter that a ladder runs through), and what was measured: time, work, error.
"""

from __future__ import annotations

import dataclasses
import json
import math
import os
from typing import Iterable, Optional

KEPT = ("axis", "choice", "problem", "parameter", "n", "error", "error_norm", "work", "work_unit", "time", "time_unit",
        "spread", "diverged")
NOISE = 1.05    # two times that differ by less are alike


@dataclasses.dataclass(frozen=True)
class Row:
    """One line of the table."""

    axis: str
    problem: str
    choice: str
    key: Optional[float]
    n: Optional[float]
    time: Optional[float]
    work: Optional[float]
    error: Optional[float]
    time_unit: str
    error_norm: str
    parameter: str = ""


def parameter_of(text: Optional[str]) -> Optional[float]:
    """64 of "threshold = 64", nothing of nothing."""
    try:
        return float(text.partition("= ")[2].partition(" ")[0]) if text else None
    except ValueError:
        return None


class Table:
    """A module's run."""

    def __init__(self, text: str) -> None:
        whole = json.loads(text)
        self.machine: dict[str, object] = whole["machine"]
        self.rows = [self.row(one) for one in whole["rows"]]

    @staticmethod
    def row(one: dict[str, object]) -> Row:
        """From its object; what diverged has neither time nor error to speak of."""
        def number(name: str) -> Optional[float]:
            value = one.get(name)
            return float(value) if isinstance(value, (int, float)) else None
        parameter = one.get("parameter")
        key = parameter_of(parameter if isinstance(parameter, str) else None)
        lost = bool(one.get("diverged"))
        return Row(str(one["axis"]), str(one.get("problem") or ""), str(one["choice"]),
                   number("n") if key is None else key, number("n"), None if lost else number("time"), number("work"),
                   None if lost else number("error"), str(one.get("time_unit") or ""), str(one.get("error_norm") or ""),
                   parameter if isinstance(parameter, str) else "")

    def choices(self) -> set[str]:
        """All of them."""
        return {row.choice for row in self.rows}

    def of(self, axis: str, problem: str = "") -> list[Row]:
        """The rows of an axis, and of the problems that begin so; "*" is every problem."""
        return [row for row in self.rows
                if row.axis == axis and (problem in ("", "*") or row.problem.startswith(problem))]


def load(module: str) -> Optional[Table]:
    """The run of a module, from the project's folder; nothing where none is kept."""
    file = f"docs/costs/{module}.json"
    if not os.path.isfile(file):
        return None
    with open(file, encoding="utf-8") as stream:
        return Table(stream.read())


def shortened(text: str) -> str:
    """A run as it is kept: a row a line, so that a new run can be compared with the last."""
    whole = json.loads(text)
    rows = ",\n".join(json.dumps({name: row[name] for name in KEPT if row.get(name) is not None}) for row in whole["rows"])
    return f'{{"machine": {json.dumps(whole["machine"])},\n"rows": [\n{rows}\n]}}\n'


def different(values: Iterable[str]) -> list[str]:
    """Each once, in their order."""
    return list(dict.fromkeys(values))


def curve(rows: list[Row], choice: str, against: str = "key") -> list[tuple[float, float]]:
    """The times of a choice against its keys or its errors, sorted, as logarithms."""
    points: list[tuple[float, float]] = []
    for row in rows:
        at = row.error if against == "error" else row.key
        if row.choice == choice and at is not None and at > 0 and row.time is not None and row.time > 0:
            points.append((math.log(at), math.log(row.time)))
    return sorted(points)


def value_at(points: list[tuple[float, float]], x: float) -> Optional[float]:
    """Between two points by powers; beyond the ends there is nothing."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1 and x1 > x0:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return next((y for at, y in points if at == x), None)


def time_for(rows: list[Row], choice: str, error: float) -> Optional[float]:
    """The least time by which a choice comes at least so near: its cheapest row of a smaller error, or what lies
    between two neighbours."""
    points = curve(rows, choice, "error")
    x = math.log(error)
    below = [y for at, y in points if at <= x]
    between = value_at(points, x)
    known = below + ([between] if between is not None and below else [])
    return math.exp(min(known)) if known else None
