# SPDX-License-Identifier: BSL-1.0
"""What came of the hard cases: the logs of ctest read, and a verdict for each row from those of its tests.

cases.py is the program; it says where the logs lie.
"""

from __future__ import annotations

import glob
import itertools
import os
import re
from typing import NamedTuple

from workshop.hard_cases import REASONS, ROW, Case, Row, read

# The verdicts of a test, and of a row that has tests: that of its worst one.
WORST_FIRST = ("failed", "not built", "not run", "passed", "skipped")


class Measured(NamedTuple):
    """What a test said by tests/measured.hpp."""
    row: str
    what: str
    value: str
    bound: str
    unit: str
    held: bool


class Outcome(NamedTuple):
    """Of one test in one run."""
    verdict: str
    said: str                       # where it failed: why
    measured: tuple[Measured, ...]
    when: float


class Verdict(NamedTuple):
    """Of a row."""
    row: Row
    verdict: str
    reason: str
    cases: tuple[tuple[Case, str, str, Outcome | None], ...]    # with the test's name and verdict
    measured: tuple[Measured, ...]


def measured_in(output: str) -> tuple[Measured, ...]:
    """The lines of tests/measured.hpp."""
    found = re.findall(rf"^measured \| ({ROW}) \| (.*?) \| (.*?) \| (.*?) \| (.*?) \| (held|broken)\r?$", output, re.MULTILINE)
    return tuple(Measured(row, what, value, bound, unit, end == "held") for row, what, value, bound, unit, end in found)


def why_it_failed(output: str) -> str:
    """What Catch2 says of the first check that failed, else the last line."""
    lines = [line.strip() for line in output.split("\n")]
    for number, line in enumerate(lines):
        if line.endswith("FAILED:"):
            told = list(itertools.takewhile(lambda part: not re.fullmatch("[-=.]{9,}", part), lines[number + 1:number + 9]))
            place = re.sub(r"^.*?(tests/\S+:[0-9]+).*$", r"\1", line.removesuffix("FAILED:").rstrip(": "))
            return f"{place}: " + " ".join(" ".join(told).split())[:300]
    said = [line for line in lines if line]
    return said[-1][:300] if said else "it said nothing: it crashed, or was ended because it hung"


def read_log(text: str, when: float) -> dict[str, Outcome]:
    """A LastTest.log, by the tests' names. A program that is not there is called passed in it: its command is empty."""
    outcomes: dict[str, Outcome] = {}
    for part in re.split(r"^[0-9]+/[0-9]+ Testing: ", text, flags=re.MULTILINE)[1:]:
        name = part.partition("\n")[0]
        told = re.search(r"^Output:\n-{9,}\n(.*?)<end of output>\n(.*)", part, re.MULTILINE | re.DOTALL)
        if not told:
            continue
        output, end = told[1], told[2]
        measured = measured_in(output)
        if re.search(r'^Command: ""$', part, re.MULTILINE):
            verdict = "not built"
        elif "\nSkip regular expression found" in end:
            verdict = "skipped"
        elif re.search("^Test Passed", end, re.MULTILINE) and all(one.held for one in measured):
            verdict = "passed"
        else:
            verdict = "failed"
        outcomes[name] = Outcome(verdict, why_it_failed(output) if verdict == "failed" else "", measured, when)
    return outcomes


def logs_of(build: str) -> list[str]:
    """The runs that are known, the last one last."""
    logs = glob.glob(glob.escape(build) + "/cases/*.log") + [f"{build}/Testing/Temporary/LastTest.log"]
    return sorted((log for log in logs if os.path.exists(log)), key=os.path.getmtime)


def outcomes_of(build: str) -> dict[str, Outcome]:
    """The last of each test."""
    outcomes: dict[str, Outcome] = {}
    for log in logs_of(build):
        outcomes.update(read_log(read(log), os.path.getmtime(log)))
    return outcomes


def is_of(test: str, case: Case) -> bool:
    """Whether ctest's name is that of a case, with any type."""
    return test == case.test or (case.template and test.startswith(case.test + " - "))


def worst(verdicts: list[str]) -> str:
    """Of the tests of a row; one that is skipped where others pass takes nothing away."""
    return next((verdict for verdict in WORST_FIRST if verdict in verdicts), "not run")


def judge(rows: list[Row], cases: list[Case], outcomes: dict[str, Outcome]) -> list[Verdict]:
    """A verdict for each row; those of rows that hold by others come from these."""
    verdicts: dict[str, Verdict] = {}
    for row in rows:
        tests: list[tuple[Case, str, str, Outcome | None]] = []
        for case in (case for case in cases if row.name in case.rows):
            names = sorted(test for test in outcomes if is_of(test, case))
            tests += [(case, name, outcomes[name].verdict, outcomes[name]) for name in names]
            if not names:
                tests.append((case, case.test, "not run", None))
        verdict = row.verdict or worst([test[2] for test in tests])
        reasons = [f"{name}: {outcome.said}" for _, name, told, outcome in tests if outcome and told == "failed"]
        measured = tuple(one for _, _, _, outcome in tests if outcome for one in outcome.measured if one.row == row.name)
        verdicts[row.name] = Verdict(row, verdict, row.reason or "; ".join(reasons), tuple(tests), measured)
    for row in rows:
        if row.by:
            own = [verdicts[row.name].verdict] if verdicts[row.name].cases else []
            verdict = worst(own + [verdicts[other].verdict for other in row.by])
            bad = [f"{other} {verdicts[other].verdict}" for other in row.by if verdicts[other].verdict == "failed"]
            reason = "; ".join(filter(None, [verdicts[row.name].reason, *bad]))
            verdicts[row.name] = verdicts[row.name]._replace(verdict=verdict, reason=reason)
    return list(verdicts.values())


def summary_of(measured: tuple[Measured, ...]) -> list[Measured]:
    """What was measured several times under one name is told once, by the value that comes next to its bound."""
    groups: dict[tuple[str, str, str], list[Measured]] = {}
    for one in measured:
        groups.setdefault((one.what, one.bound, one.unit), []).append(one)
    told: list[Measured] = []
    for group in groups.values():
        values = sorted((one.value for one in group), key=float)
        low, high = values[0], values[-1]
        bound = group[0].bound
        value = high if bound.startswith("<=") else low if bound.startswith(">=") else f"{low} to {high}"
        if low == high:
            value = low
        broken = [one for one in group if not one.held]
        if broken:
            value = broken[0].value
        many = f" (of {len(group)})" if len(group) > 1 else ""
        told.append(group[0]._replace(value=value, what=group[0].what + many, held=not broken))
    return told


def counts(verdicts: list[Verdict]) -> str:
    """How many of each."""
    told = [verdict.verdict for verdict in verdicts]
    kinds = (*WORST_FIRST, *REASONS)
    return f"{len(told)} rows: " + ", ".join(f"{told.count(kind)} {kind}" for kind in kinds if kind in told)
