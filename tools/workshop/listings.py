# SPDX-License-Identifier: BSL-1.0
"""The listings that are pasted into text pages: a program is quoted from a file that is compiled.

    listings.py <texts>        prints a fault, and a line, each

It may stand in a \\code, in a fence that names C++ or only holds what looks like it, four spaces in, or in <pre>.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge  # noqa: E402  (it is run as a file)

CPP = frozenset(("cpp", "c++", "cxx", "hpp", "cc", "h", "c"))
PROGRAM = re.compile(r"(?:.*;[ \t]*(?://.*)?$| *(?:#include|template *<|struct |class |namespace ))")
CODE = re.compile(r" *[\\@]code *(?:\{\.(?:cpp|hpp|cc|h)\})? *$|.*<pre[ >]", re.IGNORECASE)
FENCE = re.compile(r" *(?P<fence>```+|~~~+)(?P<language>.*)")
ITEM = re.compile(r" *(?:[-*+]|[0-9]+[.)]) ")


def pasted(lines: list[str]) -> list[int]:
    """The numbers of the lines in which they begin."""
    found: list[int] = []
    fence = ""           # of the block that the line is in
    begin = 0            # of that block, or of the one that is indented
    in_list = indented = False
    after_empty = True
    for number, line in enumerate(lines, start=1):
        mark = FENCE.match(line)
        if not fence and CODE.match(line):
            found.append(number)
            continue
        if mark and not fence:
            fence, begin = mark["fence"], number
            if re.sub("[ {}.]", "", mark["language"]).lower() in CPP:
                found.append(number)
            continue
        if mark:
            fence = "" if fence in line else fence
            continue
        # Four spaces after an empty line, and not within a list.
        is_indented = re.match("    |\t", line) is not None
        if not fence and ITEM.match(line):
            in_list = True
        elif not fence and line and not line.startswith(" "):
            in_list = False
        if not fence and not in_list and is_indented and (after_empty or indented):
            begin = begin if indented else number
            indented = True
        else:
            indented = indented and is_indented
        if (fence or (indented and not in_list)) and PROGRAM.match(line) and begin not in found:
            found.append(begin)
        after_empty = not line.strip(" ") or number == 1    # a heading ends with its line
    return found


def main(arguments: list[str]) -> int:
    """Prints them; there may be none."""
    parser = argparse.ArgumentParser(prog="listings.py", description="The listings that are pasted into text pages.")
    parser.add_argument("texts", nargs="+", help="the pages")
    for file in parser.parse_args(arguments).texts:
        lines = forge.page(file).removesuffix("\n").split("\n")
        for number in pasted(lines):
            fault = f"a pasted listing, {file}:{number}; quote it from a file that is compiled (tools/workshop/forge.py)\n"
            sys.stdout.buffer.write(fault.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
