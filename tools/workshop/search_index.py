# SPDX-License-Identifier: BSL-1.0
"""Adds the sections of the chapters and the exercises to the site's search, by every word of their titles.

Doxygen's own finds types and pages alone, and those by their first letters only.

    search_index.py --search <site>/search --aliases docs/site/aliases.txt docs/*.md <the page of exercises>

A line of the aliases is a section, or another heading's label, and the words that find it beside its title:
"1.7 friction resistance", "collision_beyond piles". The words of a page's glossary find the section that explains them.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge  # noqa: E402  (it is run as a file)

SAYS_NOTHING = frozenset("and the for of in to as what how from with its is it an not by on at or".split())


def read(file: str) -> str:
    """The text of a file."""
    return forge.page(file)


class Index:
    """What each word finds."""

    def __init__(self) -> None:
        self.links: dict[str, dict[str, str]] = {}    # of a word: its pages, with their titles

    def add(self, words: str, url: str, title: str) -> None:
        """Each of the words finds `url`, which is shown as `title`."""
        for key in re.split(r"[^a-z0-9.]+", words.replace("'", "").lower()):
            key = key.removesuffix(".")
            if len(key) > 1 and key not in SAYS_NOTHING:
                self.links.setdefault(key, {}).setdefault(url, title.replace("'", ""))

    def add_page(self, text: str, aliases: dict[str, str]) -> None:
        """The sections of a chapter below its heading, and the rows of the list of exercises."""
        chapter = ""
        titles: dict[str, str] = {}    # of the headings so far
        for line in text.split("\n"):
            if heading := re.match(r"# .*\{#(chapter_[^}]*)\}", line):
                chapter = heading[1]
            elif chapter and (heading := re.match(r"##+ .*\{#([^}]*)\}", line)):
                title = titles[heading[1]] = re.sub(r"^#+ *| *\{#.*|[`*\"\\]", "", line)
                if heading[1].startswith("section_"):
                    also = aliases.get(title.split(" ")[0], "")
                    self.add(f"{title} {also}", f"{heading[1]}.html", title)
                elif heading[1] in aliases:
                    self.add(aliases[heading[1]], f"{heading[1]}.html", title)
            elif chapter and (word := re.match(r"\| ([^|`\\]+) \|.*\\ref (\w+)[^|]*\|$", line)) and word[2] in titles:
                self.add(word[1], f"{word[2]}.html", titles[word[2]])
            elif row := re.match(r'\| ([0-9.]+) \| \\ref (exercise_[a-z0-9_]+) "([^"]*)"', line):
                number, label, title = row.groups()
                self.add(f"exercise {number} {title}", f"{label}.html", f"Exercise {number}: {title}")

    def entries(self, letter: str) -> str:
        """The lines of the words that begin with this letter, as the site's scripts read them: a full stop is _2e."""
        lines = ""
        for key in sorted(self.links):
            if key[0] == letter:
                links = "".join(f",['../{url}',1,'{title}']" for url, title in self.links[key].items())
                lines += f",\n  ['{key.replace('.', '_2e')}_topics',['{key} (course)'{links}]]"
        return lines


def aliases_of(text: str) -> dict[str, str]:
    """The words of each section; a line that begins with # is a remark."""
    lines = (line.partition(" ") for line in text.split("\n") if line and not line.startswith("#"))
    return {section: words.strip() for section, _, words in lines}


def letters_of(searchdata: str) -> str:
    """What there is a file all_<n>.js for: its n-th letter."""
    found = re.search(r'^ *0: "([^"]*)"', searchdata, re.MULTILINE)
    return found[1] if found else ""


def with_entries(text: str, entries: str) -> str:
    """A list of the search, with these lines at its end."""
    return re.sub(r"\n\];\n*\Z", "", text) + entries + "\n];\n"


def main(arguments: list[str]) -> int:
    """Writes into the files of the search."""
    parser = argparse.ArgumentParser(prog="search_index.py", description="Adds the course to the site's search.")
    parser.add_argument("--search", required=True, help="the site's folder search")
    parser.add_argument("--aliases", required=True, help="other words that find a section")
    parser.add_argument("pages", nargs="+", help="the chapters, and the page of the exercises")
    given = parser.parse_args(arguments)
    index = Index()
    aliases = aliases_of(read(given.aliases))
    for page in given.pages:
        index.add_page(read(page), aliases)
    for place, letter in enumerate(letters_of(read(f"{given.search}/searchdata.js"))):
        if entries := index.entries(letter):
            file = f"{given.search}/all_{place:x}.js"
            text = with_entries(read(file), entries)
            with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
                stream.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
