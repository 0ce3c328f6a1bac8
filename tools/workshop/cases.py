# SPDX-License-Identifier: BSL-1.0
"""The hard cases: the list tests/hard_cases.txt, the tests that name its rows, and what their last runs said.

    cases.py check                              the holes of the list; ends with 1 where there is one
    cases.py select [--all] [row or group]...   from `ctest --show-only=json-v1`: what ctest -I takes to run their tests
    cases.py table <build> [row or group]...    for a terminal; ends with 1 where a row failed
    cases.py json <build>
    cases.py page <build>                       the part of docs/hard_cases.md that follows from the tests
    cases.py sources <html>                     the tests' files, where that part links to them

from the project's folder. Verdicts and what was measured come from the logs of ctest alone: <build>/cases/*.log, which
`./workbook cases` keeps, and <build>/Testing/Temporary/LastTest.log; of two runs of one test the later counts.
"""

from __future__ import annotations

import argparse
import glob
import html
import itertools
import json
import os
import re
import shutil
import sys
import textwrap
import time
from typing import NamedTuple

LIST = "tests/hard_cases.txt"
ROW = r"[A-Z][0-9]{1,2}"
# A name of a row stands alone: neither "2H2" nor "C3PO" is one.
NAMED = re.compile(rf"(?<![A-Za-z0-9_.]){ROW}(?![A-Za-z0-9_])")
STRING = r'"((?:[^"\\\n]|\\.)*)"'
CASE = re.compile(
    rf"^(TEST_CASE|TEST_CASE_METHOD|TEMPLATE_[A-Z_]*TEST_CASE[A-Z_]*|SCENARIO)\(\s*((?:{STRING}\s*)+)"
    rf"(?:,\s*((?:{STRING}\s*)+))?", re.MULTILINE)
REASONS = ("does not apply yet", "no test yet")

# The verdicts of a test, and of a row that has tests: that of its worst one.
WORST_FIRST = ("failed", "not built", "not run", "passed", "skipped")


class Row(NamedTuple):
    """A line of the list."""
    name: str
    group: str               # "C Contact and response"
    asks: str
    verdict: str = ""        # one of REASONS, where no test can decide
    reason: str = ""
    by: tuple[str, ...] = ()


class Case(NamedTuple):
    """A test case or a script that names rows."""
    rows: frozenset[str]
    test: str                # its name for ctest; a template's goes on with " - " and the type
    file: str
    line: int
    template: bool = False
    script: bool = False


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


def read(file: str) -> str:
    """A text."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def read_list(text: str) -> list[Row]:
    """The rows; ValueError with the line that is none."""
    rows: list[Row] = []
    group = ""
    for number, line in enumerate(text.split("\n"), 1):
        place = f"{LIST}:{number}"
        if not line.strip() or line.startswith("#"):
            continue
        if heading := re.fullmatch(r"== ([A-Z] .*)", line):
            group = heading[1]
        elif row := re.fullmatch(rf"({ROW}) (.+)", line):
            if row[1][0] != group[:1]:
                raise ValueError(f"{place}: {row[1]} does not belong to the group '{group}'")
            if any(row[1] == other.name for other in rows):
                raise ValueError(f"{place}: {row[1]} stands there twice")
            rows.append(Row(row[1], group, row[2]))
        elif rows and (by := re.fullmatch(rf" +by: ({ROW}(?: {ROW})*)", line)):
            rows[-1] = rows[-1]._replace(by=tuple(by[1].split(" ")))
        elif rows and (why := re.fullmatch(rf" +({'|'.join(REASONS)}): (.+)", line)):
            rows[-1] = rows[-1]._replace(verdict=why[1], reason=why[2])
        else:
            raise ValueError(f"{place}: neither a group, a row, a reason nor 'by: ...': {line}")
    names = {one.name: one for one in rows}
    for one in rows:
        for other in one.by:
            if other not in names or names[other].by:
                raise ValueError(f"{LIST}: {one.name} holds by {other}, which is no row that is tested")
    return rows


def string_of(literals: str | None) -> str:
    """What adjacent string literals of C++ hold."""
    return "".join(re.sub(r"\\(.)", r"\1", part) for part in re.findall(STRING, literals or ""))


def cases_in(file: str, text: str) -> list[Case]:
    """The tests of a file that name rows: in a test case's name or tags, or in a script's first comment."""
    module = file.split("/")[1]
    if file.endswith(".sh"):
        comment = re.match(r"(?:#.*\n|\n)*", text)
        rows = frozenset(re.findall(rf"\(hard case ({ROW})\)", comment[0] if comment else ""))
        stem = file.rpartition("/")[2].removesuffix(".sh")
        return [Case(rows, f"{module}.{stem}", file, 1, script=True)] if rows else []
    cases: list[Case] = []
    for found in CASE.finditer(text):
        name, tags = string_of(found[2]), string_of(found[4])
        rows = frozenset(NAMED.findall(name)) | frozenset(re.findall(rf"\[({ROW})\]", tags))
        test = f"{module}.counted" if file.endswith(".perf.cpp") else f"{module}.{name}"
        if rows:
            line = text.count("\n", 0, found.start()) + 1
            cases.append(Case(rows, test, file, line, template=found[1].startswith("TEMPLATE")))
    return cases


def all_cases() -> list[Case]:
    """Of the project; not what scripts compile."""
    files = [file for pattern in ("tests/*/**/*.cpp", "tests/*/*.sh") for file in glob.glob(pattern, recursive=True)]
    return [case for file in sorted(files) if not re.search("/(planted|programs)/", file)
            for case in cases_in(file, read(file))]


def holes(rows: list[Row], cases: list[Case]) -> list[str]:
    """A row that nothing decides, a reason that has been overtaken, a test of a row that is not there."""
    faults: list[str] = []
    listed = {row.name for row in rows}
    tested = {name for case in cases for name in case.rows}
    for row in rows:
        if row.name in tested and row.verdict:
            faults.append(f"{LIST}: {row.name} has a test, and the list says '{row.verdict}': take that line out")
        elif row.name not in tested and not row.verdict and not row.by:
            faults.append(f"{LIST}: {row.name} has neither a test nor a reason: name it in a test, or say why there is none")
    for case in cases:
        for name in sorted(case.rows - listed):
            faults.append(f"{case.file}:{case.line}: there is no row {name} in {LIST}: {case.test}")
    return faults


# ---------------------------------------------------------------- what ctest said

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


# ---------------------------------------------------------------- what people and programs read

def wished(name: str, words: list[str]) -> bool:
    """Whether a row is among those that were asked for: all, a group by its letter, or by name."""
    return not words or name in words or name[0] in words


def refuse_unknown(rows: list[Row], words: list[str]) -> None:
    """ValueError with a word that is neither a row nor a group."""
    known = {row.name for row in rows} | {row.name[0] for row in rows}
    for word in words:
        if word not in known:
            groups = ", ".join(dict.fromkeys(row.group for row in rows))
            raise ValueError(f"there is no row and no group '{word}'; the groups: {groups}")


def date(when: float) -> str:
    """For people."""
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(when))


def sources_of_verdicts(build: str) -> str:
    """Which run was the last, and when."""
    logs = logs_of(build)
    if not logs:
        return f"No run of these tests is known in {build}."
    before = f", and from {len(logs) - 1} before it" if len(logs) > 1 else ""
    return f"From {logs[-1]}, {date(os.path.getmtime(logs[-1]))}{before}; of two runs of a test the later counts."


def changed_since(verdicts: list[Verdict]) -> list[str]:
    """The tests' files that are newer than the run that is told of."""
    files = {case.file for verdict in verdicts for case, _, _, outcome in verdict.cases
             if outcome and os.path.exists(case.file) and os.path.getmtime(case.file) > outcome.when}
    return sorted(files)


def counts(verdicts: list[Verdict]) -> str:
    """How many of each."""
    told = [verdict.verdict for verdict in verdicts]
    kinds = (*WORST_FIRST, *REASONS)
    return f"{len(told)} rows: " + ", ".join(f"{told.count(kind)} {kind}" for kind in kinds if kind in told)


def table(verdicts: list[Verdict], width: int, colours: dict[str, str]) -> str:
    """A line for each row, what was measured below it; where few rows are asked for, their tests too."""
    paint = {"passed": colours["GREEN"], "failed": colours["RED"], "does not apply yet": colours["DIM"]}
    detail = len(verdicts) <= 8
    text, group = "", ""

    def below(said: str, colour: str) -> str:
        return "".join(f"       {colour}{line}{colours['PLAIN']}\n"
                       for line in textwrap.wrap(said, max(width - 7, 30), break_on_hyphens=False))

    for verdict in verdicts:
        row = verdict.row
        if row.group != group:
            group = row.group
            text += f"{colours['BOLD']}{group}{colours['PLAIN']}\n"
        asks = row.asks
        if not detail and len(asks) > width - 27:
            asks = asks[:max(width - 28, 10)] + "…"
        colour = paint.get(verdict.verdict, colours["YELLOW"])
        text += f"  {row.name:<4} {colour}{verdict.verdict:<18}{colours['PLAIN']} {asks}\n"
        if verdict.reason and (detail or verdict.verdict in ("failed", "no test yet")):
            text += below(verdict.reason, colour)
        for one in summary_of(verdict.measured):
            text += below(f"{one.what}: {one.value} {one.unit}".rstrip() + f", bound {one.bound}",
                          colours["DIM"] if one.held else colours["RED"])
        if detail:
            if row.by:
                text += below("holds by " + ", ".join(row.by), colours["DIM"])
            for case, name, told, _ in verdict.cases:
                text += below(f"{told}: {name} ({case.file}:{case.line})", colours["RED"] if told == "failed" else colours["DIM"])
    return text


def as_json(verdicts: list[Verdict], build: str) -> str:
    """The same for programs; every single value that was measured."""
    rows = [{"row": one.row.name, "group": one.row.group, "asks": one.row.asks, "verdict": one.verdict,
             "reason": one.reason, "by": list(one.row.by),
             "tests": [{"name": name, "file": case.file, "line": case.line, "verdict": told,
                        "when": date(outcome.when) if outcome else None} for case, name, told, outcome in one.cases],
             "measured": [{"what": told.what, "value": told.value, "bound": told.bound, "unit": told.unit, "held": told.held}
                          for told in one.measured]} for one in verdicts]
    runs = [{"log": os.path.relpath(log, build), "when": date(os.path.getmtime(log))} for log in logs_of(build)]
    return json.dumps({"runs": runs, "rows": rows}, indent=1) + "\n"


def plain_name(test: str) -> str:
    """A test's name without its module and without the rows, which stand beside it."""
    name = test.partition(".")[2]
    name = re.sub(rf"\s*\(hard cases? {ROW}(, {ROW})*\)", "", name)
    return re.sub(rf"^(hard case )?{ROW}(, {ROW})*(:|\b) *", "", name)


def page(verdicts: list[Verdict], build: str) -> str:
    """A table for each group, as HTML."""
    colour = {"passed": "green", "failed": "red", "not built": "darkorange", "not run": "darkorange", "no test yet": "darkorange"}
    newest = max((os.path.getmtime(log) for log in logs_of(build)), default=0.0)
    said = f"The verdicts are those of the tests that were run until {date(newest)}" if newest else \
        "No test was run where this site was built, so that no row has a verdict: <code>./workbook cases</code> gives them"
    text = [f'<p>{said}: {html.escape(counts(verdicts))}. The same for programs: <a href="hard_cases.json">hard_cases.json</a>.</p>']
    if changed := changed_since(verdicts):
        text.append(f"<p>{len(changed)} of the tests' files were changed since.</p>")
    group = ""
    for one in verdicts:
        if one.row.group != group:
            text += ["</table>"] * bool(group)
            group = one.row.group
            text.append(f'<h2 id="cases_{group[0]}">{html.escape(group[2:])}</h2>\n<table class="markdownTable">\n'
                        '<tr><th>row</th><th>what it asks</th><th>verdict</th><th>what was measured, and the bound</th><th>tests</th></tr>')
        verdict = f'<b style="color: {colour.get(one.verdict, "gray")}">{one.verdict}</b>'
        if one.reason:
            verdict += f"<br/>{html.escape(one.reason)}"
        told = [html.escape(f"{each.what}: {each.value} {each.unit}".rstrip()
                            + f" ({each.bound})" + ("" if each.held else " BROKEN")) for each in summary_of(one.measured)]
        links = [f'<a href="#case_{other}">{other}</a>' for other in one.row.by]
        for case in dict.fromkeys(case for case, _, _, _ in one.cases):
            name = plain_name(case.test) if not case.script else case.test
            links.append(f'<a href="{case.file}.txt" title="line {case.line} of {case.file}">{html.escape(name)}</a>')
        text.append(f'<tr id="case_{one.row.name}"><td>{one.row.name}</td><td>{html.escape(one.row.asks)}</td>'
                    f'<td>{verdict}</td><td>{"<br/>".join(told)}</td><td>{"<br/>".join(links)}</td></tr>')
    return "\n".join(text + ["</table>"]) + "\n"


def copy_sources(cases: list[Case], folder: str) -> None:
    """As text, so that a browser shows them."""
    for file in sorted({case.file for case in cases}):
        os.makedirs(os.path.dirname(f"{folder}/{file}"), exist_ok=True)
        shutil.copyfile(file, f"{folder}/{file}.txt")


def select(listed: str, cases: list[Case]) -> str:
    """Of ctest's list in JSON the tests of these cases, as ctest -I takes them; nothing where there is none."""
    tests = [test["name"] for test in json.loads(listed)["tests"]]
    numbers = [str(number) for number, test in enumerate(tests, 1) if any(is_of(test, case) for case in cases)]
    return "0,0,0," + ",".join(numbers) if numbers else ""


def main(arguments: list[str]) -> int:
    """One of the six."""
    parser = argparse.ArgumentParser(prog="cases.py", description="The hard cases, their tests and their verdicts.")
    jobs = parser.add_subparsers(dest="job", required=True)
    jobs.add_parser("check", help="lists the holes")
    job = jobs.add_parser("select", help="what ctest -I takes, from ctest --show-only=json-v1")
    job.add_argument("--all", action="store_true", help="scripts, too, which compile programs of their own")
    job.add_argument("words", nargs="*")
    job = jobs.add_parser("table", help="for a terminal")
    job.add_argument("build")
    job.add_argument("words", nargs="*")
    for name in ("json", "page"):
        jobs.add_parser(name).add_argument("build")
    jobs.add_parser("sources", help="copies the tests' files").add_argument("html")
    given = parser.parse_args(arguments)
    words: list[str] = getattr(given, "words", [])
    try:
        rows = read_list(read(LIST))
        refuse_unknown(rows, words)
    except ValueError as error:
        print(f"cases: {error}", file=sys.stderr)
        return 2
    cases = all_cases()
    if given.job == "check":
        faults = holes(rows, cases)
        for fault in faults:
            print(fault)
        return 1 if faults else 0
    if given.job == "sources":
        copy_sources(cases, given.html)
        return 0
    if given.job == "select":
        names = {name for row in rows if wished(row.name, words) for name in (row.name, *row.by)}
        print(select(sys.stdin.read(), [case for case in cases if case.rows & names and (given.all or not case.script)]))
        return 0
    verdicts = [one for one in judge(rows, cases, outcomes_of(given.build)) if wished(one.row.name, words)]
    if given.job == "table":
        colours = {name: os.environ.get(name, "") for name in ("BOLD", "DIM", "RED", "GREEN", "YELLOW", "PLAIN")}
        width = os.environ.get("WIDTH", "")
        text = table(verdicts, int(width) if width.isdigit() else 80, colours) + f"\n{counts(verdicts)}\n"
        text += sources_of_verdicts(given.build) + "\n"
        if changed := changed_since(verdicts):
            text += f"Changed since: {', '.join(changed[:5])}{' and others' if len(changed) > 5 else ''}.\n"
    else:
        text = as_json(verdicts, given.build) if given.job == "json" else page(verdicts, given.build)
    sys.stdout.buffer.write(text.encode("utf-8", "surrogateescape"))
    return 1 if given.job == "table" and any(one.verdict == "failed" for one in verdicts) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
