# SPDX-License-Identifier: BSL-1.0
"""Concepts that the site says nothing of: Doxygen is silent about one that is not documented, and makes no page for it.

    concepts.py <the folder with the html> <headers>

prints a fault, and a line, each: a concept without a page; a page that shows names of namespace detail; and the page of
a role that names no policy which has it. Concepts of a namespace detail are nobody's business.
"""

from __future__ import annotations

import argparse
import glob
import os
import re
import sys

CONCEPT = re.compile(r"(?:^|[ >])concept +([A-Za-z_][A-Za-z_0-9]*) *(?:=|$)")
DETAIL = re.compile(r"namespace +(?:[A-Za-z_]+::)*detail(?:::[A-Za-z_]+)* *\{")


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read().removesuffix("\n").split("\n")


def code_of(lines: list[str]) -> list[str]:
    """What the lines hold beside comments, strings and characters."""
    code: list[str] = []
    in_comment = False
    for line in lines:
        line = re.sub(r"\\.", "", line)
        line = re.sub(r"\"[^\"]*\"|'[^']'", "", line)
        if in_comment:
            _, end, line = line.rpartition("*/")
            in_comment = not end
            if in_comment:
                code.append("")
                continue
        line = re.sub(r"/\*.*?\*/", "", line)
        line, in_comment = re.sub("//.*", "", line), False
        if "/*" in line:
            line, in_comment = line.partition("/*")[0], True
        code.append(line)
    return code


def concepts_of(lines: list[str]) -> list[tuple[int, str]]:
    """The concepts that a header defines, each with its line, but for those of a namespace detail, which ends with the
    brace that closes it."""
    found: list[tuple[int, str]] = []
    depth, hidden = 0, -1    # how many braces are open, and how many were before namespace detail
    for number, line in enumerate(code_of(lines), start=1):
        if hidden < 0 and DETAIL.search(line):
            hidden = depth
        if hidden < 0 and (concept := CONCEPT.search(line)):
            found.append((number, concept[1]))
        depth += line.count("{") - line.count("}")
        if hidden >= 0 and depth <= hidden:
            hidden = -1
    return found


def shows_details(page: list[str]) -> bool:
    """Whether a definition on the page is made of names of namespace detail."""
    defining = False
    for line in page:
        begins = not defining and "Concept definition" in line
        if (defining or begins) and "detail::" in line:
            return True
        defining = begins or (defining and 'class="ttc"' not in line)
    return False


def names_policies(page: list[str]) -> bool:
    """Whether the words of the page lead to a type."""
    begin = next((number for number, line in enumerate(page) if 'name="details"' in line), len(page))
    return any(re.search('href="(struct|class)ansatz', line) for line in page[begin:])


def main(arguments: list[str]) -> int:
    """Prints them; there may be none."""
    parser = argparse.ArgumentParser(prog="concepts.py", description="Concepts that the site says nothing of.")
    parser.add_argument("html", help="the folder of the site")
    parser.add_argument("headers", nargs="+", help="the headers of the library")
    given = parser.parse_args(arguments)
    faults: list[str] = []
    pages = sorted(glob.glob(f"{glob.escape(given.html)}/concept*.html"))
    names = [os.path.basename(page) for page in pages]
    for header in given.headers:
        for number, concept in concepts_of(read(header)):
            if not any(name.endswith(f"_1_1{concept}.html") or name == f"concept{concept}.html" for name in names):
                faults.append(f"{header}:{number}: the concept {concept} is not documented")
    for page, name in zip(pages, names):
        if "_1_1" not in name:
            continue
        lines = read(page)
        if shows_details(lines):
            faults.append(f"{name} shows names of namespace detail")
        if name.endswith("In.html") and not names_policies(lines):
            faults.append(f"{name} names no policy of its kind")
    sys.stdout.buffer.write("".join(f"{fault}\n" for fault in faults).encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
