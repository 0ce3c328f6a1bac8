# SPDX-License-Identifier: BSL-1.0
"""Adds the sections of the chapters and the exercises to the site's search, by every word of their titles.

Doxygen's own finds types and pages alone, and those by their first letters only. The course stands before them. What the search
finds of the frame's insides are its types alone, not their members, of which there are hundreds with plain names (named.py says
whose they are); and of a template only itself, not each list of arguments that is somewhere a base or a member.

    search_index.py --search <site>/search --aliases docs/site/aliases.txt docs/*.md <the page of exercises>

A line of the aliases is a section, or the label of another heading or of a page, and the words that find it beside its title:
1.7 friction "air resistance", collision_beyond piles. What is in quotes is found as a whole too, as it is typed: the site's search
compares beginnings, blanks included. The words of a page's glossary find the section that explains them, in the same way.
"""

from __future__ import annotations

import argparse
import glob
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge, layout, named  # noqa: E402  (it is run as a file)

ENTRY = re.compile(r"^  \['(?P<key>[^']*)',\['(?P<name>(?:[^'\\]|\\.)*)'(?P<links>(?:,\[[^\[\]]*\])+)\]\],?$", re.MULTILINE)
LINK = re.compile(r"\['\.\./(?P<page>[^'#]*)(?P<place>#[^']*)?',[^\[\]]*\]")
SAYS_NOTHING = frozenset("and the for of in to as what how from with its is it an not by on at or".split())


def read(file: str) -> str:
    """The text of a file."""
    return forge.page(file)


def write(file: str, text: str) -> None:
    """A file of the search."""
    with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        stream.write(text)


class Index:
    """What each word finds."""

    def __init__(self) -> None:
        self.links: dict[str, dict[str, str]] = {}    # of a word: its pages, with their titles

    def add(self, words: str, url: str, title: str) -> None:
        """Each of the words finds `url`, which is shown as `title`, and so does what stands in quotes, as a whole."""
        keys = [key.removesuffix(".") for key in re.split(r"[^a-z0-9.]+", words.replace("'", "").lower())]
        phrases = [phrase.lower() for phrase in re.findall(r'"([a-z0-9][^"]*)"', words, re.IGNORECASE)]
        for key in [key for key in keys if len(key) > 1 and key not in SAYS_NOTHING] + phrases:
            self.links.setdefault(key, {}).setdefault(url, title.replace("'", ""))

    def add_page(self, text: str, aliases: dict[str, str]) -> None:
        """The sections of a chapter below its heading, and the rows of the list of exercises."""
        chapter = ""
        titles: dict[str, str] = {}    # of the headings so far
        for line in text.split("\n"):
            if heading := re.match(r"# +(.*?) *\{#([^}]*)\}", line):
                chapter = heading[2] if heading[2].startswith("chapter_") else chapter
                self.add(aliases.get(heading[2], ""), f"{heading[2]}.html", heading[1])
            elif chapter and (heading := re.match(r"##+ .*\{#([^}]*)\}", line)):
                title = titles[heading[1]] = re.sub(r'["\\]', "", layout.plain(re.sub(r"^#+ *| *\{#.*", "", line)))
                if heading[1].startswith("section_"):
                    also = aliases.get(title.split(" ")[0], "")
                    self.add(f"{title} {also}", f"{heading[1]}.html", title)
                elif heading[1] in aliases:
                    self.add(aliases[heading[1]], f"{heading[1]}.html", title)
            elif chapter and (word := re.match(r"\| ([^|`\\]+) \|.*\\ref (\w+)[^|]*\|$", line)) and word[2] in titles:
                said = " ".join(f'"{one}"' if re.search("[^A-Za-z0-9]", one) else one for one in word[1].strip().split(", "))
                self.add(said, f"{word[2]}.html", titles[word[2]])
            elif row := re.match(r'\| ([0-9.]+) \| \\ref (exercise_[a-z0-9_]+) "([^"]*)"', line):
                number, label, title = row.groups()
                self.add(f"exercise {number} {title}", f"{label}.html", f"Exercise {number}: {title}")

    def entries(self, letter: str) -> str:
        """The lines of the words that begin with this letter, as the site's scripts read them: a full stop is _2e. A page has
        a line of its own, which shows its title; in one line for all of them titles would show by a click alone."""
        lines = ""
        for key in sorted(self.links):
            if key[0] == letter:
                name = re.sub("[^a-z0-9]", lambda one: f"_{ord(one[0]):02x}", key)
                lines += "".join(f",\n  ['{name}_topics{number}',['{title}',['../{url}',1,'course']]]"
                                 for number, (url, title) in enumerate(self.links[key].items()))
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
    """A list of the search, with these lines at its beginning: what it shows of what is asked for, it shows in its order."""
    head, bracket, rest = text.partition("[\n")
    return head + bracket + entries.removeprefix(",\n") + ("," if entries and rest[:1] != "]" else "") + ("\n" if entries else "") + rest


def is_inside(page: str, place: str) -> bool:
    """Whether it is a member of a type that no user names, or a type in one; or a member of a type in any other."""
    found = re.fullmatch(r"(?:struct|class|union)(ansatz(?:_1_1.*)?)\.html", page)
    if not found:
        return False
    *names, last = re.sub("_3_01.*", "", found[1]).split("_1_1")
    types = [name for name in (*names, last) if name[:1].isupper()]
    space = tuple(name for name in names if not name[:1].isupper())
    outer = bool(types) and not named.is_named(space, types[0])
    return len(types) > 1 and bool(place) or outer and bool(place or len(types) > 1)


def without_insides(text: str) -> str:
    """A list of the search without members of the frame, and without templates of given arguments."""
    def entry(found: re.Match[str]) -> str:
        links = [link[0] for link in LINK.finditer(found["links"]) if not is_inside(link["page"], link["place"] or "")]
        if not links or "_3c_20" in found["key"]:
            return ""
        return f"  ['{found['key']}',['{found['name']}',{','.join(links)}]]"
    head, bracket, rest = text.partition("[\n")
    lines = ENTRY.sub(entry, rest.rpartition("];")[0]).split("\n")
    return head + bracket + ",\n".join(filter(None, (line.removesuffix(",") for line in lines))) + "\n];\n"


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
    index.add(aliases.get("page_readme", ""), "page_readme.html", "At a glance")    # whose label a forge does not show
    for file in sorted(glob.glob(f"{glob.escape(given.search)}/*_*.js")):
        write(file, without_insides(read(file)))
    for place, letter in enumerate(letters_of(read(f"{given.search}/searchdata.js"))):
        if entries := index.entries(letter):
            file = f"{given.search}/all_{place:x}.js"
            write(file, with_entries(read(file), entries))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
