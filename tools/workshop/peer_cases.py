# SPDX-License-Identifier: BSL-1.0
"""The hard cases in other engines: the run of `./workbook peers cases` that is kept, and what docs/hard_cases.md says from it.

    peer_cases.py take <folder>     keeps <folder>/cases.json (build/peers) as docs/peers/cases.json, and writes the page anew
    peer_cases.py write             writes the page anew
    peer_cases.py check             prints a fault, and a line, each

from the project's folder. What stands between `<!-- from peers: cases -->` and `<!-- end of peers -->` is generated and never
typed. A row of tests/hard_cases.txt that is neither played nor left out with a reason is a fault, so that none is left out
in silence.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import sys
from typing import Any

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop.hard_cases import LIST, read, read_list  # noqa: E402  (it is run as a file)

KEPT = "docs/peers/cases.json"
PAGE = "docs/hard_cases.md"
BEGIN = "<!-- from peers: cases -->"
END = "<!-- end of peers -->"
OURS = "Ansatz"

Run = dict[str, Any]
Result = dict[str, Any]


class Fault(Exception):
    """What is wrong with the page or the run."""


def number(value: float, digits: int = 2) -> str:
    """Two digits: 0.27, 4.4e-16, 4900."""
    if value == 0:
        return "0"
    if 1 <= abs(value) < 100000:
        return f"{float(f'{value:.{digits}g}'):.10g}"
    return f"{value:.{digits}g}"


def name_of(engine: Run) -> str:
    """At the head of a column."""
    name = str(engine["name"])
    return name if name.startswith(OURS) else f'{name} ({engine["scalar"]})'


def cell(result: Result) -> str:
    """What one engine did in one row."""
    if result["verdict"] == "cannot":
        return "cannot"
    said = "none" if result["value"] is None else number(result["value"])
    return said if result["verdict"] == "passed" else f"{said} **fails**"


def label(row: Run) -> str:
    """What is measured, with its unit."""
    return str(row["what"]) + (f', {row["unit"]}' if row["unit"] else "")


def bound(row: Run) -> str:
    """That of double, and that of float where it is another one."""
    said = number(row["bound"], 3)
    if (of_float := number(row["bound_float"], 3)) != said:
        said += f", float {of_float}"
    return said + (" + slop" if row["slop_added"] else "")


def table(run: Run) -> list[str]:
    """A line a row, a column an engine."""
    heads = ["row", "what is measured", "bound"] + [name_of(engine) for engine in run["engines"]]
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for row in run["rows"]:
        cells = [row["row"], label(row), bound(row)] + [cell(result) for result in row["results"]]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def count(run: Run, engine: str) -> str:
    """How many rows it holds."""
    verdicts = [result["verdict"] for row in run["rows"] for result in row["results"] if result["engine"] == engine]
    cannot = verdicts.count("cannot")
    return f'{verdicts.count("passed")} of {len(verdicts) - cannot}' + (f", {cannot} it cannot play" if cannot else "")


def results_of(row: Run) -> dict[str, Result]:
    """By engine."""
    return {result["engine"]: result for result in row["results"]}


def our_failures(run: Run) -> list[str]:
    """Each row that we do not hold, and who does."""
    lines = []
    for row in run["rows"]:
        failed = [name for name, result in results_of(row).items() if name.startswith(OURS) and result["verdict"] == "failed"]
        if failed:
            held = [name for name, result in results_of(row).items() if result["verdict"] == "passed"]
            lines.append(f'- {row["row"]}, {label(row)}: {" and ".join(failed)} '
                         f'{"fails" if len(failed) == 1 else "fail"}; {", ".join(held) if held else "nobody"} '
                         f'{"hold" if len(held) > 1 else "holds"} it.')
    return lines


def better(run: Run) -> list[str]:
    """Rows that we hold in double, and others by less than half of our number, where that is worth a hundredth of the bound."""
    lines = []
    for row in run["rows"]:
        results = results_of(row)
        ours = results.get(f"{OURS} double")
        if ours is None or ours["verdict"] != "passed" or not ours["value"] > 0.01 * ours["bound"]:
            continue
        nearer = [f'{name} {number(result["value"])}' for name, result in results.items()
                  if not name.startswith(OURS) and result["verdict"] == "passed" and result["value"] < 0.5 * ours["value"]]
        if nearer:
            lines.append(f'- {row["row"]}, {label(row)}: {", ".join(nearer)}; {OURS} {number(ours["value"])}.')
    return lines


def reasons(run: Run) -> list[str]:
    """Why an engine has no number."""
    lines = []
    for row in run["rows"]:
        for result in row["results"]:
            if result.get("why"):
                lines.append(f'- {row["row"]}, {row["what"]}: {result["engine"]}: {result["why"]}.')
    return lines


def plain(words: list[str]) -> str:
    """Angle brackets are no HTML."""
    return "; ".join(words).replace("<", "&lt;").replace(">", "&gt;")


def block(run: Run) -> list[str]:
    """All that the page says."""
    machine, engines = run["machine"], run["engines"]
    compiler = str(machine["compiler"]).partition(" (")[0]
    lines = [f'*One run of `./workbook peers cases` on {str(machine["date"]).partition("T")[0]}: '
             + ", ".join(f'{engine["name"]} {engine["version"]}' for engine in engines)
             + f'; {compiler}, `{machine["flags"]}`. It depends on no clock.*', ""]
    lines += table(run) + ["", "Rows that are held: " + "; ".join(f'{e["name"]} {count(run, e["name"])}' for e in engines) + "."]
    for title, found, nothing in (
            ("**Where Ansatz fails.**", our_failures(run), "In no row."),
            ("**Where Ansatz holds a row and another engine is nearer**, by less than half of its number in double, "
             "where that is more than a hundredth of the bound.", better(run), "In no row."),
            ("**Why there is no number.**", reasons(run), "There is one everywhere.")):
        lines += ["", title, ""] + (found or [f"- {nothing}"])
    lines += ["", "**Settings.** Those that the documentation of each engine recommends; the same in all rows but for what a row itself is about.", ""]
    for engine in engines:
        flat = ", two dimensions" if engine["flat"] else ""
        lines.append(f'- {engine["name"]} {engine["version"]}, {engine["scalar"]}{flat}: {plain(engine["settings"])}.')
    lines += ["", "**What they do more**, and Ansatz does not.", ""]
    lines += [f'- {engine["name"]}: {plain(engine["does_more"])}.' for engine in engines if engine["does_more"]]
    lines += ["", "**Rows that are not played**, and why.", ""]
    return lines + [f'- {", ".join(one["rows"].split())}: {one["why"]}.' for one in run["left_out"]]


def generated(text: str, run: Run) -> str:
    """The page with its block written anew."""
    before, begin, rest = text.partition(BEGIN + "\n")
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise Fault(f"{PAGE} has no {BEGIN} with an {END}")
    return before + begin + "\n".join(block(run)) + "\n" + end + after


def holes(run: Run, listed: list[str]) -> list[str]:
    """Rows of the list that are neither played nor left out with a reason, or both; and rows that are not in the list."""
    played = {row["row"] for row in run["rows"]}
    left_out = [name for one in run["left_out"] for name in one["rows"].split()]
    faults = [f"{name} is neither played beside other engines nor left out with a reason (tests/peers/cases/table.cpp)"
              for name in listed if name not in played and name not in left_out]
    faults += [f"{name} is left out, and played as well" for name in left_out if name in played]
    return faults + [f"there is no row {name} in {LIST}" for name in sorted(played | set(left_out)) if name not in listed]


def load() -> Run:
    """The run that is kept."""
    if not os.path.exists(KEPT):
        raise Fault(f"there is no {KEPT}; ./workbook peers cases makes a run, and peer_cases.py take build/peers keeps it")
    run: Run = json.loads(read(KEPT))
    return run


def check() -> list[str]:
    """What is wrong with page and run."""
    run, text = load(), read(PAGE)
    faults = holes(run, [row.name for row in read_list(read(LIST))])
    if generated(text, run) != text:
        faults.append(f"{PAGE} does not say what {KEPT} says; python3 tools/workshop/peer_cases.py write")
    return faults


def write() -> None:
    """The page anew, where it says something else."""
    text = read(PAGE)
    if (fresh := generated(text, load())) != text:
        with open(PAGE, "w", encoding="utf-8") as stream:
            stream.write(fresh)
        print(f"written anew: {PAGE}")


def main(arguments: list[str]) -> int:
    """One of the three."""
    parser = argparse.ArgumentParser(prog="peer_cases.py", description="The hard cases in other engines.")
    asked = parser.add_subparsers(dest="asked", required=True)
    asked.add_parser("take", help="keeps a run").add_argument("folder", help="with cases.json")
    asked.add_parser("write", help="writes the page anew")
    asked.add_parser("check", help="prints faults")
    given = parser.parse_args(arguments)
    try:
        if given.asked == "check":
            for fault in check():
                print(fault)
            return 0
        if given.asked == "take":
            os.makedirs(os.path.dirname(KEPT), exist_ok=True)
            shutil.copyfile(os.path.join(given.folder, "cases.json"), KEPT)
            print(f"kept: {KEPT}")
        write()
    except Fault as fault:
        print(fault)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
