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
import html
import json
import os
import re
import shutil
import sys
import textwrap
import time

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop.case_verdicts import Verdict, counts, is_of, judge, logs_of, outcomes_of, summary_of  # noqa: E402  (it is run as a file)
from workshop.hard_cases import LIST, ROW, Case, Row, all_cases, holes, read, read_list  # noqa: E402


def wished(name: str, words: list[str]) -> bool:
    """Whether a row is among those that were asked for: all, a group by its letter, or by name."""
    return not words or name in words or name[0] in words


def refuse_unknown(rows: list[Row], words: list[str]) -> None:
    """ValueError with a word that is neither a row nor a group, as it was typed; a second line says which groups there are."""
    known = {row.name for row in rows} | {row.name[0] for row in rows}
    for word in words:
        if word.upper() not in known:
            groups = ", ".join(dict.fromkeys(row.group for row in rows))
            raise ValueError(f"there is no row and no group '{word}'\nThe groups: {groups}.")


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
        colour = paint.get(verdict.verdict, colours["YELLOW"])
        asks = ("\n" + " " * 26).join(textwrap.wrap(row.asks, max(width - 26, 20), break_on_hyphens=False))
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
        print(error, file=sys.stderr)
        return 2
    words = [word.upper() for word in words]
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
