# SPDX-License-Identifier: BSL-1.0
"""Copies of the sources that pages quote from, in which each quoted piece begins at the left margin: Doxygen 1.9.4
quotes a piece as far indented as it stands in the program.

    quoted.py <out> <folder>...     <out>/chapters/1-motion/1.7-drag.cpp, and so on, of all that has a quoted piece

A piece stands between two lines `//! [name]`.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

MARK = re.compile(r" *//! \[")


def at_margin(lines: list[str]) -> list[str]:
    """The lines as far to the left as the one that stands farthest to the left."""
    least = min((len(line) - len(line.lstrip(" ")) for line in lines if line.strip(" ")), default=0)
    return [line[least:] for line in lines]


def unindented(lines: list[str]) -> list[str]:
    """A program with its quoted pieces, and what is between them, at the margin; a piece within a piece keeps its place
    in it."""
    out: list[str] = []
    part: list[str] = []
    opened: set[str] = set()
    for line in lines:
        if not MARK.match(line):
            part.append(line)
            continue
        if not opened:
            out += at_margin(part)
            part = []
        part.append(line)
        opened ^= {line}
        if not opened:
            out += at_margin(part)
            part = []
    return out + at_margin(part)


def main(arguments: list[str]) -> int:
    """Writes the copies."""
    parser = argparse.ArgumentParser(prog="quoted.py", description="Copies of what is quoted, at the left margin.")
    parser.add_argument("out", help="the folder of the copies")
    parser.add_argument("folders", nargs="+", help="where the sources are")
    given = parser.parse_args(arguments)
    for place, _, files in (below for folder in given.folders for below in os.walk(folder)):
        for file in files:
            if not file.endswith((".cpp", ".hpp")):
                continue
            with open(f"{place}/{file}", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
                lines = stream.read().removesuffix("\n").split("\n")
            if any(MARK.match(line) for line in lines):
                os.makedirs(f"{given.out}/{place}", exist_ok=True)
                with open(f"{given.out}/{place}/{file}", "w", encoding="utf-8", errors="surrogateescape",
                          newline="\n") as stream:
                    stream.write("".join(line + "\n" for line in unindented(lines)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
