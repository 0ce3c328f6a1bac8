# SPDX-License-Identifier: BSL-1.0
"""The navigation of the site: chapters with their pages, the programs, the exercises and the models of policies of
one's own, in place of the remarks <!-- chapters -->, <!-- programs -->, <!-- exercises --> and <!-- models --> of Doxygen's layout.

    layout.py --programs <the list of programs> --exercises <that of exercises> docs/site/layout.xml docs/*.md

prints the layout. Both lists are pages that pages.py makes; the models are in tests/package/models.
"""

from __future__ import annotations

import argparse
import glob
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge, parts  # noqa: E402  (it is run as a file)


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    return forge.page(file).removesuffix("\n").split("\n")


def attributes(url: str, title: str, kind: str = "user") -> str:
    """Of a tab."""
    title = title.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    return f'type="{kind}" visible="yes" url="{url}" title="{title}"'


def plain(title: str) -> str:
    """Without what sets it; the asterisk of A* opens nothing."""
    return re.sub(r"(?<![\w*])(\*{1,2})(?=\S)(.+?)(?<=\S)\1(?!\w)", r"\2", title.replace("`", ""))


def chapter(lines: list[str]) -> list[str]:
    """A chapter with its pages; nothing of a page that is no chapter."""
    if not parts.chapter_of(lines):
        return []
    tabs: list[str] = []
    for part in parts.parts_of(lines):
        title, leads = plain(part.title), f"@ref {part.label}"
        tabs.append(f"      <tab {attributes(leads, title)}/>" if tabs else f"    <tab {attributes(leads, title, 'usergroup')}>")
    return tabs + ["    </tab>"]


def in_order(pages: list[str]) -> list[str]:
    """Chapters by their number; what is none stays behind them."""
    def number(page: str) -> int:
        found = re.search(r"^# Chapter ([0-9]+)", "\n".join(read(page)), re.MULTILINE)
        return int(found[1]) if found else sys.maxsize
    return sorted(pages, key=number)


def programs(lines: list[str]) -> list[str]:
    """From the rows of their list."""
    rows = (re.match(r'\| \\ref (program_[a-z0-9_A-Z]+)[^"]*"([^"]*)', line) for line in lines)
    return [f"      <tab {attributes(f'@ref {row[1]}', row[2])}/>" for row in rows if row]


def exercises(lines: list[str]) -> list[str]:
    """From the rows of their list, with their sections."""
    rows = (re.match(r'\| ([0-9][^ |]*) \|[^|]*(exercise_[a-z0-9_]+)[^"|]*"([^|]*)" *\|', line) for line in lines)
    return [f"      <tab {attributes(f'@ref {row[2]}', f'{row[1]} {row[3]}')}/>" for row in rows if row]


def models() -> list[str]:
    """Each is a page that pages.py makes."""
    names = sorted(os.path.basename(file).removesuffix(".cpp") for file in glob.glob("tests/package/models/*.cpp"))
    return [f"      <tab {attributes(f'@ref model_{name}', f'{name}.cpp')}/>" for name in names]


def main(arguments: list[str]) -> int:
    """Prints it."""
    parser = argparse.ArgumentParser(prog="layout.py", description="The navigation of the site.")
    parser.add_argument("--programs", required=True, help="the page that lists the programs")
    parser.add_argument("--exercises", required=True, help="the page that lists the exercises")
    parser.add_argument("layout", help="Doxygen's layout, with the places of these")
    parser.add_argument("pages", nargs="+", help="the chapters, and other pages")
    given = parser.parse_args(arguments)
    out: list[str] = []
    for line in read(given.layout):
        if "<!-- chapters -->" in line:
            out += [tab for page in in_order(given.pages) for tab in chapter(read(page))]
        elif "<!-- programs -->" in line:
            out += programs(read(given.programs))
        elif "<!-- exercises -->" in line:
            out += exercises(read(given.exercises))
        elif "<!-- models -->" in line:
            out += models()
        else:
            out.append(line)
    sys.stdout.buffer.write("".join(line + "\n" for line in out).encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
