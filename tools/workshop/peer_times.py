# SPDX-License-Identifier: BSL-1.0
"""The library beside others, in time: the runs of `./workbook peers` that are kept, and what the pages say from them.

    peer_times.py take <folder>       keeps <folder>/<area>.json (build/peers) as docs/peers/<area>.json, all that are there, and
                                      writes the pages anew
    peer_times.py write               writes the pages anew
    peer_times.py check               prints a fault, and a line, each
    peer_times.py summary <folder>    says for each scene who of ours and who of the others was fastest

from the project's folder. What stands on a page between `<!-- from contest: ... -->` and `<!-- end of contest -->` is generated and
never typed. The dots are one of

    run <area>                        the machine, the versions, the repeats and their spread
    all                               for each scene of each area who of ours and who of the others is fastest, and their ratio
    table <area>; <option>; ...       the numbers of one area, with the options
        rows <what>                   scene, n, subject, or two of them: what the lines are
        columns <what>                what the columns are; without it there is one
        scenes <text> | <text>        only scenes that begin so; what all of them begin with is cut off
        n <number> <number>           only those
        subjects <name> | <name>      only those, in this order; each may be followed by "= <label>"
        ratio <subject>               each number, and how many times that of this subject it is; "first" is the first in each scene
        remarks <title>               a last column with what each subject says of itself
"""

from __future__ import annotations

import argparse
import glob
import json
import os
import re
import shutil
import sys
from dataclasses import dataclass
from typing import Any

KEPT = "docs/peers"
AREAS: tuple[str, ...] = ("collision", "paths", "scale", "soft_bodies", "threads", "water")
BLOCK = re.compile(r"^(<!-- from contest: ([^\n]*) -->\n)(.*?)^(<!-- end of contest -->)", flags=re.DOTALL | re.MULTILINE)
OURS = "ansatz"
OPTIONS = ("rows", "columns", "scenes", "n", "subjects", "ratio", "remarks")
TIME = re.compile(r"[pnum]?s( |$)")

Run = dict[str, Any]


class Fault(Exception):
    """What is wrong with a page or a run."""


@dataclass(frozen=True)
class Row:
    """One number."""

    scene: str
    n: int
    subject: str
    value: float
    unit: str
    spread: float
    remark: str = ""

    @property
    def ours(self) -> bool:
        """Whether it is the library's."""
        return self.subject.startswith(OURS)


def rows_of(run: Run) -> list[Row]:
    """The numbers of a run; picoseconds, in which a terminal shows what is less than a nanosecond, as nanoseconds."""
    found = []
    for row in run["rows"]:
        small = row["unit"].startswith("ps ")
        found.append(Row(row["scene"], row["n"], row["subject"], row["value"] / 1000 if small else row["value"],
                         row["unit"].replace("ps ", "ns ", 1) if small else row["unit"], row["spread"],
                         row.get("remark", "")))
    return found


def number(value: float) -> str:
    """Three digits, and never an exponent: 0.64, 16.5, 1160."""
    if value == 0:
        return "0"
    text = f"{float(f'{value:.3g}'):.10f}".rstrip("0").rstrip(".")
    return text if text not in ("", "0") else f"{value:.2g}"


def scaled(value: float, unit: str) -> tuple[float, str]:
    """In the unit that a reader expects: no thousands of nanoseconds or microseconds, no thousandths of a metre."""
    if unit == "m" and value < 0.1:
        return 1000 * value, "mm"
    larger = {"ns": "us", "us": "ms"}
    while value >= 1000 and (of := larger.get(unit[:2])):
        value, unit = value / 1000, of + unit[2:]
    return value, unit


def quantity(value: float, unit: str) -> str:
    """With its unit."""
    value, unit = scaled(value, unit)
    return f"{number(value)} {unit}"


def who(subject: str) -> str:
    """What a subject is called: a type of the library's as code."""
    if not subject.startswith(OURS):
        return subject
    name, comma, rest = subject.removeprefix(OURS + " ").partition(", ")
    return (f"`{name}`" if name[:1].isupper() else name) + comma + rest


def spaced(n: int) -> str:
    """10 000, on one line."""
    return f"{n:,}".replace(",", "\u00a0")


def common_start(scenes: list[str]) -> str:
    """What all of them begin with, up to a comma."""
    start = os.path.commonprefix(scenes)
    return start[:start.rfind(", ") + 2] if ", " in start and len(scenes) > 1 else ""


def label(key: tuple[Any, ...], what: list[str], cut: str, names: dict[str, str]) -> str:
    """What a line or a column is called."""
    words = []
    for value, kind in zip(key, what):
        if kind == "n":
            words.append(spaced(value))
        elif kind == "scene":
            words.append(str(value).removeprefix(cut))
        else:
            words.append(names.get(value) or who(value))
    return ", ".join(words)


def options_of(text: str) -> dict[str, str]:
    """Of `rows scene; columns subject`."""
    found: dict[str, str] = {}
    for option in filter(None, (one.strip() for one in text.split(";"))):
        name, _, value = option.partition(" ")
        if name not in OPTIONS:
            raise Fault(f"there is no option '{name}'; there are {', '.join(OPTIONS)}")
        found[name] = value.strip()
    return found


def chosen(rows: list[Row], options: dict[str, str], names: dict[str, str]) -> list[Row]:
    """Those that a table shows."""
    if "scenes" in options:
        starts = tuple(start.strip() for start in options["scenes"].split("|"))
        for start in starts:
            if not any(row.scene.startswith(start) for row in rows):
                raise Fault(f"no scene begins with '{start}'")
        rows = [row for row in rows if row.scene.startswith(starts)]
    if "n" in options:
        rows = [row for row in rows if str(row.n) in options["n"].split()]
    if "subjects" in options:
        for one in options["subjects"].split("|"):
            name, _, called = (part.strip() for part in one.partition("="))
            names[name] = called or who(name)
            if not any(row.subject == name for row in rows):
                raise Fault(f"nobody is called '{name}'")
        rows = [row for row in rows if row.subject in names]
        rows.sort(key=lambda row: list(names).index(row.subject))
    if not rows:
        raise Fault("no row is left")
    return rows


def ordered(rows: list[Row], what: list[str], by_subject: bool) -> list[tuple[Any, ...]]:
    """The lines or columns, as the run has them; subjects as they were asked for."""
    keys = [tuple(getattr(row, kind) for kind in what) for row in rows]
    found = list(dict.fromkeys(keys))
    return found if by_subject and what == ["subject"] else sorted(found, key=keys.index)


def table(run: Run, text: str) -> list[str]:
    """The numbers of one area."""
    options, names = options_of(text), dict[str, str]()
    everything = rows_of(run)
    in_run = {id(row): k for k, row in enumerate(everything)}
    rows = chosen(everything, options, names)
    as_run = sorted(rows, key=lambda row: in_run[id(row)])
    if "rows" not in options:
        raise Fault("a table says its rows")
    across, down = options.get("columns", "").split(), options["rows"].split()
    if wrong := [kind for kind in across + down if kind not in ("scene", "n", "subject")]:
        raise Fault(f"rows and columns are scene, n or subject, and not '{wrong[0]}'")
    lines_of = ordered(rows if down == ["subject"] else as_run, down, "subjects" in options)
    columns = ordered(rows if across == ["subject"] else as_run, across, "subjects" in options)
    units = list(dict.fromkeys(row.unit for row in as_run))
    least = min(row.value for row in as_run)
    unit = scaled(least, units[0])[1] if len(units) == 1 else ""
    by_unit = scaled(least, units[0])[0] / least if len(units) == 1 and least > 0 else 1
    cut = common_start(list(dict.fromkeys(row.scene for row in as_run)))
    at: dict[tuple[tuple[Any, ...], tuple[Any, ...]], Row] = {}
    for row in rows:
        place = tuple(getattr(row, kind) for kind in down), tuple(getattr(row, kind) for kind in across)
        if place in at:
            raise Fault("two numbers for one cell: rows and columns together name scene, n and subject, or fewer rows are chosen")
        at[place] = row
    measure: dict[tuple[str, int], Row] = {}
    for row in as_run:
        if options.get("ratio") in (row.subject, "first"):
            measure.setdefault((row.scene, row.n), row)

    def cell(row: Row | None) -> str:
        if row is None:
            return ""
        said = number(row.value * by_unit) if len(units) == 1 else quantity(row.value, row.unit)
        by = measure.get((row.scene, row.n))
        return f"{said}, {number(row.value / by.value)} times" if by and by is not row else said

    head = ", ".join(filter(None, (cut.removesuffix(", "), unit))) or "scene"
    made = ["| " + " | ".join([head] + [label(key, across, cut, names) or "time" for key in columns]) + " |", "|" + "---|" * (len(columns) + 1)]
    for key in lines_of:
        made.append("| " + " | ".join([label(key, down, cut, names)] + [cell(at.get((key, column))) for column in columns]) + " |")
    if "remarks" in options:
        said = [options["remarks"], "---"] + ["; ".join(dict.fromkeys(filter(None, (at[key, one].remark for one in columns if (key, one) in at)))) for key in lines_of]
        made = [line + ("" if last == "---" else " ") + last + ("|" if last == "---" else " |") for line, last in zip(made, said)]
    return made


@dataclass(frozen=True)
class Match:
    """A scene in which somebody else plays, too."""

    scene: str
    n: int
    ours: Row
    other: Row

    @property
    def ratio(self) -> float:
        """How many times as long the other takes."""
        return self.other.value / self.ours.value


def matches(run: Run) -> list[Match]:
    """The fastest of ours beside the fastest of the others, scene by scene, where a time is measured. A probe of the memory does not
    do the work."""
    scenes: dict[tuple[str, int], list[Row]] = {}
    for row in rows_of(run):
        if TIME.match(row.unit) and "probe" not in row.subject:
            scenes.setdefault((row.scene, row.n), []).append(row)
    found = []
    for (scene, n), rows in scenes.items():
        ours, others = [row for row in rows if row.ours], [row for row in rows if not row.ours]
        if ours and others:
            fastest = [min(some, key=lambda row: row.value) for some in (ours, others)]
            found.append(Match(scene, n, *fastest))
    return found


def everything(runs: dict[str, Run]) -> list[str]:
    """All areas in one table."""
    lines = ["| area | scene | n | the fastest of ours | of the others | times as long |", "|---|---|---|---|---|---|"]
    for area, run in runs.items():
        for match in matches(run):
            ratio = number(match.ratio)
            lines.append("| " + " | ".join([
                area.replace("_", " "), match.scene, spaced(match.n),
                f"{who(match.ours.subject)}, {quantity(match.ours.value, match.ours.unit)}",
                f"{match.other.subject}, {quantity(match.other.value, match.other.unit)}"
                + (f" ({match.other.remark})" if match.ratio < 1 and match.other.remark else ""),
                ratio if match.ratio >= 1 else f"**{ratio}**"]) + " |")
    return lines


def run_line(run: Run, area: str) -> list[str]:
    """The machine, the versions, the repeats and their spread."""
    machine = run["machine"]
    spreads = sorted(row.spread for row in rows_of(run) if TIME.match(row.unit))
    others = ", ".join(f"{name} {version.replace('_', '.')}" for name, version in run["versions"].items())
    return [f'*One run of `./workbook peers {area}` on {str(machine["date"]).partition("T")[0]}: {machine["cpu"]}, {machine["cores"]} cores; '
            f'{str(machine["compiler"]).partition(" (")[0]}, `{machine["flags"]}`; {machine["clock"]}, the smallest of {machine["repeats"]} '
            f'repeats taken in turn{"; " + others if others else ""}. The median of the repeats lies {100 * spreads[len(spreads) // 2]:.0f} % above the smallest in the middle '
            f'of all rows, {100 * spreads[-1]:.0f} % at most.*']


def block(asked: str, runs: dict[str, Run]) -> list[str]:
    """What a page says for one asking."""
    kind, _, rest = asked.partition(" ")
    if kind == "all" and not rest:
        return everything(runs)
    area, _, options = (part.strip() for part in rest.partition(";"))
    if area not in runs:
        raise Fault(f"there is no run of '{area}' in {KEPT}; ./workbook peers {area} makes one, and peer_times.py take build/peers keeps it")
    if kind == "run" and not options:
        return run_line(runs[area], area)
    if kind == "table":
        return table(runs[area], options)
    raise Fault("it is 'run <area>', 'all' or 'table <area>; ...'")


def generated(text: str, runs: dict[str, Run]) -> str:
    """A page with its blocks written anew."""
    def fresh(match: re.Match[str]) -> str:
        try:
            return match[1] + "\n".join(block(match[2], runs)) + "\n" + match[4]
        except Fault as fault:
            raise Fault(f"<!-- from contest: {match[2]} -->: {fault}") from fault

    if len(re.findall(r"^<!-- from contest: ", text, flags=re.MULTILINE)) != len(BLOCK.findall(text)):
        raise Fault("a <!-- from contest: ... --> has no <!-- end of contest -->")
    return BLOCK.sub(fresh, text)


def read(path: str) -> str:
    """A whole file."""
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def load(folder: str) -> dict[str, Run]:
    """The runs of a folder, by area."""
    return {area: json.loads(read(path)) for area in AREAS if os.path.exists(path := os.path.join(folder, area + ".json"))}


def pages() -> list[str]:
    """Those that may have blocks."""
    return sorted(glob.glob("docs/*.md"))


def check() -> list[str]:
    """What is wrong with pages and runs."""
    runs, faults, shown = load(KEPT), [], set[str]()
    faults += [f"there is no {KEPT}/{area}.json" for area in AREAS if area not in runs]
    for page in pages():
        text = read(page)
        try:
            if generated(text, runs) != text:
                faults.append(f"{page} does not say what {KEPT} says; python3 tools/workshop/peer_times.py write")
        except Fault as fault:
            faults.append(f"{page}: {fault}")
        shown.update(found[1].split()[1].rstrip(";") for found in BLOCK.findall(text) if " " in found[1])
    return faults + [f"no page has a table of {KEPT}/{area}.json" for area in runs if area not in shown]


def write() -> None:
    """The pages anew, where they say something else."""
    runs = load(KEPT)
    for page in pages():
        text = read(page)
        if (fresh := generated(text, runs)) != text:
            with open(page, "w", encoding="utf-8") as stream:
                stream.write(fresh)
            print(f"written anew: {page}")


def summary(folder: str) -> list[str]:
    """For the terminal."""
    lines = []
    for area, run in load(folder).items():
        found = matches(run)
        if not found:
            continue
        versions = ", ".join(f"{name} {version.replace('_', '.')}" for name, version in run["versions"].items())
        lines += ["", f"{area.replace('_', ' ')}: the fastest of ours, of the others, and how many times as long it takes" + (f" ({versions})" if versions else "")]
        for match in found:
            lines.append(f"  {match.scene[:48]:<48} {match.n:>7}  {match.ours.subject.removeprefix(OURS + ' ')[:26]:<26} "
                         f"{number(match.ours.value):>7}  {match.other.subject[:26]:<26} {number(match.other.value):>7} {match.ours.unit:<12} {match.ratio:6.2f}")
    return lines


def main(arguments: list[str]) -> int:
    """One of the four."""
    parser = argparse.ArgumentParser(prog="peer_times.py", description="The library beside others, in time.")
    asked = parser.add_subparsers(dest="asked", required=True)
    asked.add_parser("take", help="keeps the runs of a folder").add_argument("folder")
    asked.add_parser("write", help="writes the pages anew")
    asked.add_parser("check", help="prints faults")
    asked.add_parser("summary", help="says who was fastest").add_argument("folder")
    given = parser.parse_args(arguments)
    try:
        if given.asked in ("check", "summary"):
            for line in check() if given.asked == "check" else summary(given.folder):
                print(line)
            return 0
        if given.asked == "take":
            os.makedirs(KEPT, exist_ok=True)
            for area in load(given.folder):
                shutil.copyfile(os.path.join(given.folder, area + ".json"), os.path.join(KEPT, area + ".json"))
                print(f"kept: {KEPT}/{area}.json")
        write()
    except Fault as fault:
        print(fault)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
