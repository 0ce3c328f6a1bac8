# SPDX-License-Identifier: BSL-1.0
"""What the comments and text pages of the site can lead to: sections, exercises, the types that headers are named after, pages.

For doxygen_filter.py and text_pages.py, which start once for each of some hundred files: each is looked up when it is first needed.
"""

from __future__ import annotations

import functools
import glob
import os
import re

from workshop import forge


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    return forge.page(file).removesuffix("\n").split("\n")


def stem_of(file: str) -> str:
    """"explicit_euler" of a path."""
    return re.sub(r"\.[a-z]+$", "", file.rpartition("/")[2])


def policy_of(stem: str) -> str:
    """"ExplicitEuler" of "explicit_euler"."""
    return "".join(word[:1].upper() + word[1:] for word in stem.split("_"))


class Course:
    """What a link can lead to, from the folder that the program was started in: each asked when it is first needed."""

    @functools.cached_property
    def sections(self) -> frozenset[str]:
        """The labels of the sections."""
        found: set[str] = set()
        for page in glob.glob("docs/*.md"):
            found.update(re.findall(r"(?:\{#|<a id=\")(section_[0-9_]+)[}\"]", forge.read(page)))    # in either form
        return frozenset(found)

    @functools.cached_property
    def exercises(self) -> dict[str, str]:
        """The page of an exercise by its name: exercise_motion_drag of drag."""
        pages: dict[str, str] = {}
        for folder in sorted(glob.glob("exercises/*/*/")):
            _, module, name, _ = folder.split("/")
            pages[name] = f"exercise_{re.sub('^[0-9]+-', '', module)}_{name}"
        return pages

    @functools.cached_property
    def asking(self) -> dict[str, list[tuple[str, str]]]:
        """For the path of a header the exercises whose README.md links to it: their names, and the sections that head them."""
        found: dict[str, list[tuple[str, str]]] = {}
        for readme in sorted(glob.glob("exercises/*/*/README.md")):
            text = forge.read(readme)
            number = re.match(r"# ([0-9.]+) ", text)
            for header in re.findall(r"\]\([./]*(include/ansatz/[\w/]+\.hpp)", text):
                found.setdefault(header, []).append((readme.split("/")[2], number[1] if number else ""))
        return found

    @functools.cached_property
    def names(self) -> dict[str, str]:
        """What headers are named after: ansatz::World of World, which world.hpp holds, with the namespace that the
        header opens first."""
        names: dict[str, str] = {}
        type_line = re.compile(r"(?:template <.*> *)?(?:struct|class) [A-Z][A-Za-z0-9]*(?: |$|\{)")
        for folder, _, files in sorted(os.walk("include/ansatz")):
            for file in sorted(files):
                policy, space, there = policy_of(stem_of(file)), "", False
                for line in read(f"{folder}/{file}"):
                    if not space and (opened := re.match(r"namespace (ansatz::[a-z_]+) \{", line)):
                        space = opened[1]
                    if type_line.match(line) and not re.search(r"; *$", line):
                        name = re.sub(r"^.*(?:struct|class) ", "", line)
                        there = there or re.sub(r"[^A-Za-z0-9].*", "", name) == policy
                if there:
                    names[policy] = f"{space or 'ansatz'}::{policy}"
        return names

    @functools.lru_cache(maxsize=None)
    def label_of(self, file: str) -> str:
        """The label of a page, from the first heading of its file that has one."""
        try:
            lines = forge.read(file).split("\n")
        except OSError:
            return ""
        labelled = (re.match(r"# .*(?:\{#|<a id=\")([A-Za-z0-9_]+)(?:\}|\"></a>) *$", line) for line in lines)
        return next((label[1] for label in labelled if label), "")

    def linked(self, number: str) -> str:
        """"1.6.1" as a link, where its page has that section."""
        anchor = "section_" + number.replace(".", "_")
        return f'\\ref {anchor} "{number}"' if anchor in self.sections else number

    def with_sections(self, text: str) -> tuple[str, str]:
        """The text with the numbers behind its first "(notes " as links, and the first of those numbers."""
        number = r"[0-9]+(?:\.[0-9]+)+"
        if not (notes := re.search(r"\(notes ([0-9., and]+)", text)):
            return text, ""
        first = re.search(number, notes[1])
        linked = re.sub(number, lambda found: self.linked(found[0]), notes[1])
        return text[:notes.start(1)] + linked + text[notes.end(1):], first[0] if first else ""

    def with_names(self, text: str) -> str:
        """`Drag` as a link."""
        def link(quoted: re.Match[str]) -> str:
            name = quoted[1]
            return f'<code>\\ref {self.names[name]} "{name}"</code>' if name in self.names else quoted[0]
        return re.sub("`([^`]+)`", link, text) if "`" in text else text
