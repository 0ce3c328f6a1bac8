# SPDX-License-Identifier: BSL-1.0
"""Advice that cannot contradict its measurement. From the project's folder:

    advice.py take <folder>      keeps the runs of a folder (build/costs) as docs/costs/<module>.json
    advice.py write <texts>      writes the generated blocks of these pages anew
    advice.py check <texts>      prints a fault, and a line, each

A generated block stands between `<!-- from costs: KIND WHAT -->` and `<!-- end of costs -->`:

    run collision                              what it was measured on
    first collision broadphase                 for each problem who is the fastest, and from which number on another
    crossings collision broadphase: A : B      from how many bodies on A is faster than B
    errors motion integrator: 1e-1 1e-3        for each problem, who comes so near in the least time
    table paths crowd; rows key walkers; ...   any figures (advice_tables.py)

Elsewhere a sentence that compares what policies cost names its row, in the same paragraph, list item or row of a table:

    <!-- costs: collision broadphase/uniform: SortAndSweep < BoundingBoxes from 25 -->

Several stand behind each other with a semicolon. `A < 0.5 B` asks for less than half of the time, for each number of
bodies that both were measured with, or `from 25`, `to 64`, `at 1024`; `at error 1e-3` compares what so small an error
takes. `Octree@1` is the row whose parameter is 1, a name with blanks stands in quotes, `*` is every problem, and `work` or
`error` before the first name compares these in place of the time. Not every comparison is one of costs: a paragraph that
names its test (tests/...) is not asked.
"""

from __future__ import annotations

import argparse
import glob
import operator
import os
import re
import sys
from typing import Callable, Optional

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import cost_rows, forge  # noqa: E402  (it is run as a file)
from workshop.advice_blocks import BEGIN, END, Fault, generated, table_of  # noqa: E402
from workshop.cost_rows import Row, Table  # noqa: E402

CLAIMS = re.compile(r"<!-- costs: (.*?) *-->", re.DOTALL)
CLAIM = re.compile(
    r"(?P<module>\w+) (?P<axis>[\w-]+(?: [\w-]+)*)(?:/(?P<problem>[^:]*))?: (?:(?P<what>work|error) )?"
    r"(?P<a>\"[^\"]+\"\S*|\S+) (?P<op>[<>]) (?:(?P<factor>[0-9.]+) )?(?P<b>\"[^\"]+\"\S*|\S+?)"
    r"(?: (?P<where>from|to|at|at error) (?P<bound>[0-9.e+-]+))?$")
PRICE = re.compile(
    r"\b(?:nothing (?:\w+ )?is faster|fast(?:er|est)|slow(?:er|est)|cheap(?:er|est)?|dear(?:er|est)|pays? (?:off|for|from)"
    r"|(?:times|twice|half) as (?:long|fast|dear|cheap)|(?:half|third|quarter|tenth|ninth) of (?:the|its) time"
    r"|(?:less|more|twice|half|times) (?:the )?time\b|takes (?:less|more|longer)|costs? (?:less|more|twice|half|the same))",
    re.IGNORECASE)
# Whose comparisons are of motion, not of price: "approaches that are not faster than `threshold`".
OF_MOTION = re.compile(r"(?:faster|slower) than (?:a |the |its )?(?:\*|`)?threshold|m/s|fastest body|fall\w* (?:ever )?faster"
                       r"|fastest (?:wave|that anything swings)|waves [^.;]* faster",
                       re.IGNORECASE)
# Where a path or a plan has a cost, these words are of that.
OF_PATHS = re.compile(r"cheap|dear|costs? ", re.IGNORECASE)


def read(file: str) -> str:
    """The text of a file."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def write(file: str, text: str) -> None:
    """A file."""
    with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        stream.write(text)


# ---------------------------------------------------------------- claims
def named(rows: list[Row], name: str) -> list[Row]:
    """The rows of Octree, or of Octree@64."""
    choice, _, key = name.replace('"', "").partition("@")
    found = [row for row in rows if row.choice == choice and (not key or row.key == float(key))]
    if not found:
        raise Fault(f"there is no row of {name}")
    return found


def pairs_of(rows: list[Row], claim: re.Match[str]) -> list[tuple[float, float]]:
    """The numbers that are compared."""
    a, b = named(rows, claim["a"]), named(rows, claim["b"])
    what = claim["what"] or "time"
    if claim["where"] == "at error":
        bound = float(claim["bound"])
        times = tuple(cost_rows.time_for(rows, claim[name].replace('"', "").partition("@")[0], bound) for name in "ab")
        return [(times[0], times[1])] if times[0] is not None and times[1] is not None else []
    value = operator.attrgetter(what)
    if "@" in claim["a"] or "@" in claim["b"]:
        return [(value(x), value(y)) for x in a for y in b
                if x.problem == y.problem and value(x) is not None and value(y) is not None]
    within: Callable[[float], bool] = {
        "from": lambda key: key >= float(claim["bound"]), "to": lambda key: key <= float(claim["bound"]),
        "at": lambda key: key == float(claim["bound"])}.get(claim["where"] or "", lambda _: True)
    of_b = {(row.problem, row.key): value(row) for row in b}
    return [(value(row), other) for row in a
            if row.key is not None and within(row.key) and value(row) is not None
            and (other := of_b.get((row.problem, row.key))) is not None]


def faults_of_claim(text: str) -> list[str]:
    """Whether the rows say what a claim says."""
    claim = CLAIM.match(text)
    if not claim:
        return [f"'{text}' is no claim: costs: <module> <axis>/<problem>: A < 2 B from 100"]
    try:
        pairs = pairs_of(table_of(claim["module"]).of(claim["axis"], claim["problem"] or "*"), claim)
        if not pairs:
            raise Fault("no two rows to compare")
    except Fault as fault:
        return [f"'{text}': {fault}"]
    factor = float(claim["factor"] or 1)
    holds = operator.lt if claim["op"] == "<" else operator.gt
    wrong = [(x, y) for x, y in pairs if not holds(x, factor * y)]
    return [f"'{text}' does not hold: {len(wrong)} of {len(pairs)} rows say otherwise, such as {x:.3g} and {y:.3g}"
            for x, y in wrong[:1]]


# ---------------------------------------------------------------- sentences
def paragraphs(file: str, text: str) -> list[tuple[int, str]]:
    """Where each begins, and what it says: paragraphs, list items, rows of tables, and comments of a header."""
    header = file.endswith(".hpp")
    found: list[tuple[int, list[str]]] = []
    inside = block = False
    for number, line in enumerate(text.split("\n"), start=1):
        if header:
            comment = re.search(r"//[/!]<? ?(.*)$", line)
            line = comment[1] if comment else ""
        if BEGIN.fullmatch(line):
            block = True
        if block or not line.strip() or line.startswith("```"):
            inside = False
            block = block and line.strip() != END
            continue
        if not inside or re.match(r" *(?:[-*+]|[0-9]+\.) |\||#", line):
            found.append((number, []))
        found[-1][1].append(line.strip())
        inside = True
    return [(number, " ".join(lines)) for number, lines in found]


def squeezed(text: str) -> str:
    """Letters alone, small."""
    return re.sub("[^a-z]", "", text.lower())


def names_in(sentence: str, names: set[str]) -> bool:
    """Whether it speaks of a policy: in one word as it is written, or in several ("semi-implicit Euler")."""
    for name in names:
        if re.search(rf"\b{name}\b", sentence):
            return True
        if re.search("[a-z][A-Z]", name) and squeezed(name) in squeezed(sentence):
            return True
    return False


def policies(tables: list[Table]) -> set[str]:
    """The policies among the choices, without what they are told in angle brackets."""
    every = {name for table in tables for choice in table.choices() for name in re.findall(r"\b[A-Z][A-Za-z0-9]+", choice)}
    return {name for name in every if len(name) > 4}


def own_name(file: str) -> Optional[str]:
    """BoundingBoxes of bounding_boxes.hpp: what it says of itself has no name."""
    stem = os.path.basename(file).removesuffix(".hpp")
    return "".join(word.capitalize() for word in stem.split("_")) if file.endswith(".hpp") else None


def faults_of_text(file: str, text: str, names: set[str]) -> list[str]:
    """Claims that do not hold, and sentences about costs that make none."""
    faults: list[str] = []
    of_itself = own_name(file) in names
    for number, told in paragraphs(file, text):
        written = re.sub("`[^`]*`", "", told)    # how a claim is written is none
        claims = [one.strip() for found in CLAIMS.findall(written) for one in found.split(";")]
        faults += [f"{file}:{number}: {fault}" for claim in claims for fault in faults_of_claim(claim)]
        if claims or re.search(r"tests/[\w/]+\.\w+|workbook peers", told):
            continue
        for sentence in re.split(r"(?<=[.:!?]) +(?=[A-Z*`(])", told):
            price = next((word for word in PRICE.finditer(sentence)
                          if "paths/" not in file or not OF_PATHS.match(word[0])), None)
            if price and not OF_MOTION.search(sentence) and (of_itself or names_in(sentence, names)):
                faults.append(f"{file}:{number}: '{price[0]}' has no row: \"{sentence[:100]}\" names it by "
                              "<!-- costs: ... -->, or stands in a block that is generated (tools/workshop/advice.py)")
    return faults


def faults_of_page(file: str, text: str, names: set[str]) -> list[str]:
    """Of its blocks, claims and sentences."""
    try:
        stale = generated(text) != text
    except Fault as fault:
        return [f"{file}: {fault}"]
    return ([f"{file}: its tables are not those of docs/costs; advice.py write makes them anew"] if stale else []) \
        + faults_of_text(file, forge.doxygen(text) if forge.is_text(file) else text, names)


# ---------------------------------------------------------------- what it is asked for
def take(folder: str) -> int:
    """Keeps the runs of a folder, whole or not at all."""
    runs = sorted(glob.glob(f"{glob.escape(folder)}/*.json"))
    if not runs:
        print(f"there is no run in {folder}; ./workbook costs <module> makes one", file=sys.stderr)
        return 1
    for run in runs:
        write(f"docs/costs/{os.path.basename(run)}", cost_rows.shortened(read(run)))
    return 0


def main(arguments: list[str]) -> int:
    """One of the three."""
    parser = argparse.ArgumentParser(prog="advice.py", description="Advice from measurements.")
    asked = parser.add_subparsers(dest="asked", required=True)
    asked.add_parser("take", help="keeps the runs of a folder").add_argument("folder", help="with <module>.json")
    for name, does in (("write", "writes the blocks of pages anew"), ("check", "prints faults")):
        asked.add_parser(name, help=does).add_argument("texts", nargs="+", help="pages, and headers")
    given = parser.parse_args(arguments)
    if given.asked == "take":
        return take(given.folder)
    tables = [table for file in sorted(glob.glob("docs/costs/*.json"))
              if (table := cost_rows.load(os.path.basename(file).removesuffix(".json")))]
    names = policies(tables)
    for file in given.texts:
        text = read(file)
        if given.asked == "write":
            if (fresh := generated(text)) != text:
                write(file, fresh)
                print(f"written anew: {file}")
            continue
        for fault in faults_of_page(file, text, names):
            print(fault)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Fault as fault:
        print(fault)
        sys.exit(1)
