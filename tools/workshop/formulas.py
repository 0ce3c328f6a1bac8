# SPDX-License-Identifier: BSL-1.0
"""The faults of the formulas in texts and in the comments of headers.

    formulas.py --mathjax <a script of MathJax that reads TeX>... -- <texts and headers>

A line for each: what would stay as TeX on the page ($x$, a \\f$ without its end), and what MathJax does not understand
(an unknown command, a brace that is open). Code is left alone: fences, `...`, and in headers all but comments.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge  # noqa: E402  (it is run as a file)

# What MathJax reads without an entry of that name in a script.
BUILT_IN = frozenset(("begin", "end", "left", "right"))


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    return forge.page(file).removesuffix("\n").split("\n")


def commands_of(script: str) -> set[str]:
    """The commands that a script of MathJax has an entry for: {frac: ...}, {"\\\\quad": ...}."""
    entry = re.compile(r'[{,]"?\\*([A-Za-z]+)"?(?=:)')
    return {name for name in entry.findall(script)}


def shown(formula: str) -> str:
    """As much of it as a fault needs to be found by."""
    return formula.split("\n")[0][:60]


def faults_of_formula(formula: str, known: frozenset[str]) -> list[str]:
    """What MathJax would not read of it."""
    faults: list[str] = []
    depth = 0
    for token in re.finditer(r"\\([A-Za-z]+)|\\[\s\S]|[{}]", formula):
        if token[1] and token[1] not in known:
            faults.append(f"MathJax knows no \\{token[1]}: {shown(formula)}")
        depth += (token[0] == "{") - (token[0] == "}")
        if depth < 0:
            break
    if depth != 0:
        faults.append(f"a brace has no partner: {shown(formula)}")
    return faults


def faults_of_paragraph(text: str, known: frozenset[str]) -> list[str]:
    """Formula by formula, then what is between them."""
    faults: list[str] = []
    between = ""
    while begin := re.search(r"\\f([$\[])", text):
        between += text[:begin.start()] + " "
        formula, end, text = text[begin.end():].partition("\\f$" if begin[1] == "$" else "\\f]")
        if not end:
            return faults + [f"a formula has no end: {shown(formula)}"]
        faults += faults_of_formula(formula, known)
    between += text
    if re.search(r"\\f[\]$]", between):
        faults.append("a formula has no beginning")
    if bare := re.search(r"\$[^$ \n][^$\n]*\$|\$\$", between):
        faults.append(f"a formula would stay as TeX, write $`...`$ on a page and \\f$...\\f$ in a header: {shown(between[bare.start():])}")
    return faults


def paragraphs(lines: list[str], header: bool) -> list[tuple[int, str]]:
    """The paragraphs that may hold formulas, each with the number of its first line. A formula may go over several
    lines, but over no empty one."""
    found: list[tuple[int, str]] = []
    first, text, fenced = 0, "", False
    for number, line in enumerate(lines + [""], start=1):
        if header:
            line = re.sub("^.*///<?", "", line) if re.search(r"///|\\f[$\[\]]", line) else ""
        elif re.match(" *(```|~~~)", line):
            fenced = not fenced
            continue
        if fenced and number <= len(lines):
            continue
        if line.strip(" "):
            first = first if text else number
            text += re.sub("`[^`]*`", "", line) + "\n"
        elif text:
            found.append((first, text))
            text = ""
    return found


def main(arguments: list[str]) -> int:
    """Prints them; there may be none."""
    parser = argparse.ArgumentParser(prog="formulas.py", description="The faults of the formulas in texts and headers.")
    parser.add_argument("--mathjax", nargs="+", required=True, help="the scripts of MathJax that read TeX")
    parser.add_argument("files", nargs="+", help="texts and headers")
    given = parser.parse_args(arguments)
    known = BUILT_IN.union(*(commands_of("\n".join(read(script))) for script in given.mathjax))
    for file in given.files:
        for first, text in paragraphs(read(file), file.endswith(".hpp")):
            for fault in faults_of_paragraph(text, known):
                line = f"{file}:{first}: {fault}\n"
                sys.stdout.buffer.write(line.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
