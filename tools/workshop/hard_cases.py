# SPDX-License-Identifier: BSL-1.0
"""The hard cases as they are written down: the rows of tests/hard_cases.txt, the tests that name them, and the holes between both.

cases.py is the program; from the project's folder.
"""

from __future__ import annotations

import glob
import re
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
