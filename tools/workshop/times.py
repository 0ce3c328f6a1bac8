# SPDX-License-Identifier: BSL-1.0
"""Where the time of a build and of its tests went, by kind.

    times.py --since <seconds since 1970> <build>/.ninja_log <build>/Testing/Temporary/LastTest.log

It prints lines of kind, number, seconds, the dearest and its seconds, the longest kind first. Seconds are added up over
all jobs, and are wall clock: on two cores that are busy the build takes half as long.
"""

from __future__ import annotations

import argparse
import re
import sys

ALONE = "tests/CMakeFiles/headers_alone.dir/headers_alone/"


class Kind:
    """What was built or tested of one kind."""

    def __init__(self) -> None:
        self.number = 0
        self.seconds = 0.0
        self.dearest = ""
        self.most = -1.0

    def count(self, name: str, seconds: float) -> None:
        """One more."""
        self.number += 1
        self.seconds += seconds
        if seconds > self.most:
            self.dearest, self.most = name, seconds


Kinds = dict[str, Kind]


def kind_of_output(output: str) -> tuple[str, str]:
    """The kind of what ninja built, and its name within that kind."""
    if output.startswith(ALONE):
        return "build: headers alone", output.removeprefix(ALONE)
    module = re.search(r"CMakeFiles/test_([a-z_]+?)(?:_together)?\.dir/", output)
    if module:
        return f"build: tests of {module[1]}", output[module.end():]
    for pattern, kind in (
            (r"CMakeFiles/(static|archetypes)_tests\.dir", "static tests"), ("sections?_", "sections"),
            ("costs_", "what it costs"), ("exercise", "exercises")):
        if re.search(pattern, output):
            return f"build: {kind}", output
    return "build: other", output


def count_build(lines: list[str], since: float, kinds: Kinds) -> None:
    """.ninja_log: begin and end in ms since that build began, when the output was written in ns since 1970, the output.
    What was built before `since` is left out; several outputs of one command have one begin and end, and count once."""
    seen: set[tuple[str, ...]] = set()
    for line in lines:
        fields = line.split("\t")
        if len(fields) < 4 or not fields[0].isdigit() or float(fields[2]) / 1e9 < since:
            continue
        command = tuple(fields[:3])
        if command not in seen:
            kind, name = kind_of_output(fields[3])
            kinds.setdefault(kind, Kind()).count(
                re.sub(r"\.cpp\.o$", ".cpp", name), (int(fields[1]) - int(fields[0])) / 1000)
        seen.add(command)


def count_tests(lines: list[str], kinds: Kinds) -> None:
    """LastTest.log: "3/784 Testing: name", and later "Test time =   0.05 sec"."""
    name = ""
    for line in lines:
        if begun := re.match(r"[0-9]+/[0-9]+ Testing: (.*)", line):
            name = begun[1]
        elif took := re.match(r"Test time = +([0-9.]+)", line):
            kind = name.split(".")[0]
            if kind == "must_not_compile":
                kind = f"must not compile, {name.rpartition('.')[2]}"
            kinds.setdefault(f"test: {kind}", Kind()).count(name, float(took[1]))


def table(kinds: Kinds) -> str:
    """A line for each kind, the longest first."""
    rows = sorted(kinds.items(), key=lambda row: (-round(row[1].seconds, 1), row[0]))
    return "".join(f"{kind}\t{of.number}\t{of.seconds:.1f}\t{of.dearest}\t{of.most:.1f}\n" for kind, of in rows)


def main(arguments: list[str]) -> int:
    """A file that is not there is nothing."""
    parser = argparse.ArgumentParser(prog="times.py", description="Where the time of a build and of its tests went.")
    parser.add_argument("--since", type=float, default=0.0, help="seconds since 1970; older is left out")
    parser.add_argument("logs", nargs="+", help="a .ninja_log, a LastTest.log")
    given = parser.parse_args(arguments)
    kinds: Kinds = {}
    for log in given.logs:
        try:
            with open(log, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
                lines = stream.read().split("\n")
        except FileNotFoundError:
            continue
        if log.endswith(".ninja_log"):
            count_build(lines, given.since, kinds)
        else:
            count_tests(lines, kinds)
    sys.stdout.buffer.write(table(kinds).encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
