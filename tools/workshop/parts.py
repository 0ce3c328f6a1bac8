# SPDX-License-Identifier: BSL-1.0
"""The text pages as Doxygen reads them, and a chapter as several of them: one for each heading that has a label, of that name.
From the project's folder:

    parts.py <out> <texts>     writes <out>/<label>.md for each part of a chapter, and <out>/<name>.md of any other text

The file stays one, which a forge shows whole. The chapter's first page keeps what stands before its first section, and lists the others.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from typing import NamedTuple

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge  # noqa: E402  (it is run as a file)
from workshop.doxygen_filter import filtered  # noqa: E402

HEADING = re.compile(r"(#+) +(.*?) *\{#([\w-]+)\} *$")
CHAPTER = re.compile(r"# (Chapter \d+): .*\{#chapter_\w+\}")


class Part(NamedTuple):
    """A heading with a label, and what follows it up to the next one."""
    level: int
    title: str
    label: str
    lines: list[str]

    def name(self, chapter: str) -> str:
        """Its title where others stand beside it: one without a number says of which chapter it is."""
        numbered = self.level == 1 or re.match(r"\d", self.title)
        return self.title if numbered else f"{chapter}: {self.title[:1].lower()}{self.title[1:]}"


def chapter_of(lines: list[str]) -> str:
    """"Chapter 1" of a chapter's text, nothing of another."""
    found = CHAPTER.match(lines[0]) if lines else None
    return found[1] if found else ""


def parts_of(lines: list[str]) -> list[Part]:
    """Those of a text as Doxygen reads it; nothing stands before its first heading."""
    found: list[Part] = []
    fence = ""
    for line in lines:
        marked = forge.FENCE.match(line)
        if marked:
            fence = "" if fence and line.strip() == fence else fence or marked[1]
        heading = None if fence or marked else HEADING.match(line)
        if heading:
            found.append(Part(len(heading[1]), heading[2], heading[3], []))
        elif found:
            found[-1].lines.append(line)
    return found


def text_of(part: Part, chapter: str, others: list[Part]) -> str:
    """Its page; that of the chapter leads to the others."""
    out = [f"# {part.name(chapter)} {{#{part.label}}}"]
    fence = ""
    for line in part.lines:
        if marked := forge.FENCE.match(line):
            fence = "" if fence and line.strip() == fence else fence or marked[1]
        out.append(line[part.level - 1:] if line.startswith("##") and not fence else line)
    if part.level == 1:
        out = [line for line in out if line != "[TOC]"] + ["", "## In this chapter", ""]
        out += ["  " * (other.level - 2) + f'- \\subpage {other.label} "{plain(other.title)}"' for other in others]
    return "\n".join(out) + "\n"


def plain(title: str) -> str:
    """Without marks of Markdown, and with nothing that ends a text in quotes."""
    return re.sub('[`"]', "", title)


def write(file: str, text: str) -> None:
    """A page."""
    with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        stream.write(text)


def main(arguments: list[str]) -> int:
    """Writes them."""
    parser = argparse.ArgumentParser(prog="parts.py", description="A chapter as several pages of the site.")
    parser.add_argument("out", help="the folder of the pages")
    parser.add_argument("texts", nargs="+", help="the chapters, and other pages")
    given = parser.parse_args(arguments)
    for file in given.texts:
        if file == "docs/README.md":    # the list of the pages, for a forge
            continue
        lines = filtered(file)
        if not (chapter := chapter_of(lines)):
            write(f"{given.out}/{os.path.basename(file)}", "\n".join(lines) + "\n")
            continue
        first, *others = parts_of(lines)
        for part in [first, *others]:
            write(f"{given.out}/{part.label}.md", text_of(part, chapter, others if part is first else []))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
