# SPDX-License-Identifier: BSL-1.0
"""A text page, an exercise's README.md or the project's, as Doxygen reads it: with its label, its contents, and links between pages
where the files have links between files.

doxygen_filter.py is the program.
"""

from __future__ import annotations

import os
import re

from workshop.link_targets import Course


class TextPage:
    """A text page, line by line."""

    def __init__(self, course: Course, file: str) -> None:
        self.course = course
        # Doxygen names files by their whole path: from the project's folder on, links can be followed.
        self.folder = file.removeprefix(os.environ.get("PWD", os.getcwd()) + "/").rpartition("/")[0]
        self.is_exercise = bool(re.search(r"exercises/.*README\.md$", file))
        self.place = file.split("/")
        self.fenced = False

    def filtered(self, lines: list[str]) -> list[str]:
        """What stands in their place."""
        out: list[str] = []
        if self.is_exercise:
            out += self.heading(lines.pop(0))
        elif self.place[-1] == "README.md":
            out.append("# At a glance {#page_readme}")    # a forge shows the text without a label
            lines.pop(0)
        elif re.search(r"docs/[^/]*\.md$", "/".join(self.place)) and lines[0].startswith("# ") and is_long(lines):
            out += [lines.pop(0), "", "[TOC]"]
        for line in lines:
            if re.match(" *(```|~~~)", line):
                self.fenced = not self.fenced
            out.append(line if self.fenced else self.text(line))
        return out

    def heading(self, title: str) -> list[str]:
        """Of an exercise, with its command."""
        *_, module, name, _ = self.place
        title = re.sub(r"^# ([0-9.]+) ", r"# Exercise \1: ", title)
        return [f"{title} {{#{self.course.exercises.get(name, '')}}}", "",
                f"`./workbook exercise {name}` builds and tests your answer, which you write in "
                f"`exercises/{module}/{name}/exercise.hpp`."]

    def text(self, line: str) -> str:
        """A line that is no code."""
        if self.is_exercise:    # "Notes 1.7" leads to the section
            line = re.sub(r"([Nn]otes )([0-9]+(?:\.[0-9]+)*)", lambda notes: notes[1] + self.course.linked(notes[2]),
                          line, count=1)
        if line.startswith("#"):
            return line
        return self.course.with_names(re.sub(r"(!?)\[([^]]*)\]\(([^)]*)\)", self.link, line) if "](" in line else line)

    def link(self, link: re.Match[str]) -> str:
        """A link as it is on the site; a picture stays."""
        return link[0] if link[1] else self.link_of(link[2], link[3])

    def link_of(self, text: str, target: str) -> str:
        """What a link of a text page to a file of the project becomes."""
        if re.match(r"https?:|mailto:|#|@ref|\\ref", target):
            return f"[{text}]({target})"
        bare = text.replace("`", "")
        path = plain_path(f"{self.folder}/{target}" if self.folder else target)
        if path == "LICENSE":
            return f'<a href="LICENSE.txt">{bare}</a>'
        if path.endswith(".md") and not path.startswith("exercises/") and path != "README.md":
            label = self.course.label_of(path) if re.fullmatch(r"(docs/)?[^/]*\.md", path) else ""
            return f'\\ref {label} "{bare}"' if label else f"[{text}]({path})"
        page = self.page_of(path)
        return f'\\ref {page} "{bare}"' if page else f"`{bare}`"

    def page_of(self, path: str) -> str:
        """The page on which a file or folder is shown, or nothing."""
        part = path.split("/")
        name = part[-1]
        module = re.sub("^[0-9]+-", "", part[1]) if len(part) > 1 else ""
        if path == "README.md" or re.match(r"include/.*\.hpp$", path):
            return "page_readme" if path == "README.md" else path.removeprefix("include/")
        if part[0] == "exercises":
            if len(part) < 3:
                return "page_exercises"
            return self.course.exercises.get(part[2], "") if len(part) == 3 or name == "README.md" else ""
        if re.fullmatch(r"tests/package/models/\w+\.cpp", path):
            return f"model_{name.removesuffix('.cpp')}"
        if part[0] != "chapters":
            return ""
        if len(part) < 3:
            return (len(part) == 2 and self.course.label_of(f"docs/{module}.md")) or "page_programs"
        if not re.fullmatch(r"chapters/[^/]*/[^/]*\.[ch]pp", path):
            return ""
        # The name that tools/workshop/pages.py gives to a program's page.
        program = re.sub("[^A-Za-z0-9]", "_", name[:-len(".cpp")])
        return f"program_{module}_{program}" + ("_hpp" if name.endswith(".hpp") else "")


def plain_path(path: str) -> str:
    """A path without "folder/.."."""
    while (shorter := re.sub(r"[^/.][^/]*/\.\./", "", path, count=1)) != path:
        path = shorter
    return path.replace("/./", "/").removeprefix("./").removesuffix("/")


def is_long(lines: list[str]) -> bool:
    """Whether a page begins with its contents: of more than two sections, unless it asks for them itself."""
    asks = re.search(r"\[TOC\]|[\\@]tableofcontents", "\n".join(lines))
    return not asks and sum(line.startswith("## ") for line in lines) > 2
