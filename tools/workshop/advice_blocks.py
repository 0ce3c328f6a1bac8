# SPDX-License-Identifier: BSL-1.0
"""The generated blocks of pages, `<!-- from costs: KIND WHAT -->` to `<!-- end of costs -->`, from the rows of docs/costs.

advice.py is the program; it says which kinds there are.
"""

from __future__ import annotations

import math
import re
from typing import Callable

from workshop import advice_tables, cost_rows
from workshop.cost_rows import NOISE, Row, Table

BEGIN = re.compile(r" *<!-- from costs: ([a-z]+) ([^>]*?) *-->")
END = "<!-- end of costs -->"


class Fault(Exception):
    """What is wrong with a block or a claim."""


def table_of(module: str) -> Table:
    """The run that is kept."""
    table = cost_rows.load(module)
    if table is None:
        raise Fault(f"there is no docs/costs/{module}.json; ./workbook costs {module} and tools/docs/costs make it")
    return table


def rounded(number: float) -> str:
    """Two digits: 98, 140, 5200."""
    digits = 1 - math.floor(math.log10(number)) if number > 0 else 0
    value = round(number, digits)
    return f"{value:.0f}" if value >= 10 else f"{value:g}"


def time_text(nanoseconds: float) -> str:
    """Two digits."""
    return rounded(nanoseconds)


def told_apart(problems: list[str]) -> list[str]:
    """Their short names, or whole ones where the short ones are the same."""
    names = [short(problem) for problem in problems]
    return names if len(set(names)) == len(names) else problems


def short(problem: str) -> str:
    """A problem's name before its first comma."""
    return problem.partition(",")[0]


# ---------------------------------------------------------------- what blocks say
def run_block(words: str) -> list[str]:
    """What it was measured on."""
    machine = table_of(words).machine
    compiler = str(machine["compiler"]).partition(" (")[0]
    return [f"*One run of `./workbook costs {words}` on {str(machine['date']).partition('T')[0]}: {machine['cpu']}, "
            f"{compiler}, `{machine['flags']}`, the least of {machine['repeats']} repeats. "
            f"Yours may differ; the command is the same.*"]


def leaders(rows: list[Row]) -> list[tuple[float, str]]:
    """From which key on who is the fastest. A leader stays one until somebody is faster by more than noise."""
    curves = {choice: points for choice in cost_rows.different(row.choice for row in rows)
              if (points := cost_rows.curve(rows, choice))}
    low, high = min(p[0][0] for p in curves.values()), max(p[-1][0] for p in curves.values())
    grid = [low + (high - low) * i / 400 for i in range(400)] + [high]
    found: list[tuple[float, str]] = []
    for x in grid:
        times = {choice: y for choice, points in curves.items() if (y := cost_rows.value_at(points, x)) is not None}
        best = min(times, key=lambda choice: times[choice])
        if not found or (best != found[-1][1]
                         and times.get(found[-1][1], math.inf) > times[best] + math.log(NOISE)):
            found.append((math.exp(x), best))
    return found


def first_block(words: str) -> list[str]:
    """Who is the fastest where, problem by problem."""
    module, axis = words.split(" ", 1)
    rows = table_of(module).of(axis)
    lines = ["| | the fastest, by the number of bodies | of a thousand bodies, ns for each: the fastest, the next, the slowest |",
             "|---|---|---|"]
    for problem in cost_rows.different(row.problem for row in rows):
        here = [row for row in rows if row.problem == problem]
        line = leaders(here)
        told = [f"`{line[0][1]}`"] if len(line) == 1 else (
            [f"`{line[0][1]}` up to {rounded(line[1][0])}"]
            + [f"`{choice}` from {rounded(at)}" for at, choice in line[1:]])
        at_1000 = sorted((y, choice) for choice in cost_rows.different(row.choice for row in here)
                         if (y := cost_rows.value_at(cost_rows.curve(here, choice), math.log(1000))) is not None)
        shown = at_1000[:2] + at_1000[-1:]
        lines.append(f"| {problem} | {', '.join(told)} | "
                     + ", ".join(f"`{choice}` {time_text(math.exp(y))}" for y, choice in shown) + " |")
    return lines


def crossing(rows: list[Row], a: str, b: str) -> str:
    """From how many bodies on a is faster than b by more than noise."""
    of_b = dict(cost_rows.curve(rows, b))
    points = [(x, of_b[x] - y - math.log(NOISE)) for x, y in cost_rows.curve(rows, a) if x in of_b]
    if not points:
        return ""
    if points[-1][1] <= 0:
        return "never"
    last = max((i for i, (_, gain) in enumerate(points) if gain <= 0), default=-1)
    if last < 0:
        return "always"
    (x0, y0), (x1, y1) = points[last], points[last + 1]
    return rounded(math.exp(x0 - y0 * (x1 - x0) / (y1 - y0)))


def crossings_block(words: str) -> list[str]:
    """The table of who overtakes whom."""
    place, _, contests = words.partition(": ")
    module, axis = place.split(" ", 1)
    rows = table_of(module).of(axis)
    problems = cost_rows.different(row.problem for row in rows)
    lines = ["| the first is faster than the second from | " + " | ".join(told_apart(problems)) + " |",
             "|---" * (len(problems) + 1) + "|"]
    for contest in contests.split(", "):
        a, b = contest.split(" : ")
        for name in (a, b):
            if not any(row.choice == name for row in rows):
                raise Fault(f"{module} {axis} has no {name}")
        cells = [crossing([row for row in rows if row.problem == problem], a, b) for problem in problems]
        lines.append(f"| `{a}` : `{b}` | " + " | ".join(cells) + " |")
    return lines


def errors_block(words: str) -> list[str]:
    """For each problem, who comes so near in the least time."""
    place, _, errors = words.partition(": ")
    module, axis = place.split(" ", 1)
    table = table_of(module)
    unit = cost_rows.different(row.time_unit for row in table.of(axis))[0]
    lines = [f"| | error at most | the cheapest, {unit} | the next | the dearest that gets there |", "|---" * 5 + "|"]
    for problem in cost_rows.different(row.problem for row in table.of(axis)):
        here = [row for row in table.of(axis) if row.problem == problem]
        first = f"{problem}; {here[0].error_norm}".replace("|", "\\|")
        for error in errors.split():
            times = sorted((time, choice) for choice in cost_rows.different(row.choice for row in here)
                           if (time := cost_rows.time_for(here, choice, float(error))) is not None)
            if times:
                shown = [f"`{choice}`, " + (time_text(time) if i == 0 else "alike" if time < NOISE * times[0][0] else
                                            f"{rounded(time / times[0][0])} times as long")
                         for i, (time, choice) in enumerate(times[:2] + (times[-1:] if len(times) > 2 else []))]
                lines.append(f"| {first} | {error} | " + " | ".join(shown + [""] * (3 - len(shown))) + " |")
                first = ""
    return lines


def table_block(words: str) -> list[str]:
    """A table of figures (advice_tables.py)."""
    place, *clauses = [clause.strip() for clause in words.split(";")]
    module, axis = place.split(" ", 1)
    try:
        return advice_tables.table(table_of(module).of(axis), clauses)
    except ValueError as fault:
        raise Fault(f"table {place}: {fault}") from fault


BLOCKS: dict[str, Callable[[str], list[str]]] = {
    "run": run_block, "first": first_block, "crossings": crossings_block, "errors": errors_block, "table": table_block}


def generated(text: str) -> str:
    """The page with its blocks as the rows of today have them."""
    out: list[str] = []
    skipping = False
    for number, line in enumerate(text.split("\n"), start=1):
        if not skipping:
            out.append(line)
        if begin := BEGIN.fullmatch(line):
            if begin[1] not in BLOCKS:
                raise Fault(f"line {number}: there is no block '{begin[1]}', but {', '.join(BLOCKS)}")
            out += BLOCKS[begin[1]](begin[2])
            skipping = True
        elif skipping and line.strip() == END:
            out.append(line)
            skipping = False
    if skipping:
        raise Fault(f"a block has no {END}")
    return "\n".join(out)
