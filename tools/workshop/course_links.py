# SPDX-License-Identifier: BSL-1.0
"""Whether chapter, API and exercise know each other. From the project's folder:

    course_links.py <the folder with the html>

prints a fault, and a line, each. The page of an exercise says its command and the file to edit, and leads to its
section and to the header of its name; a chapter and a page of the API lead to it.
"""

from __future__ import annotations

import argparse
import functools
import glob
import os
import re
import sys


class Site:
    """What its pages say."""

    def __init__(self, html: str) -> None:
        self.html = html

    def pages(self, *patterns: str) -> list[str]:
        """Their files."""
        return sorted(page for pattern in patterns for page in glob.glob(f"{glob.escape(self.html)}/{pattern}"))

    @staticmethod
    def text(page: str) -> str:
        """A page."""
        with open(page, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            return stream.read()

    def leading(self, *patterns: str) -> frozenset[str]:
        """The exercises that these pages lead to."""
        return frozenset(
            anchor for page in self.pages(*patterns)
            for anchor in re.findall(r'href="(exercise_[^".]*)\.html', self.text(page)))

    @functools.cached_property
    def by_chapters(self) -> frozenset[str]:
        """The exercises that chapters lead to."""
        return self.leading("chapter_*.html", "section_*.html")

    @functools.cached_property
    def by_types(self) -> frozenset[str]:
        """The exercises that the pages of types and namespaces lead to."""
        return self.leading("struct*.html", "class*.html", "namespace*.html")

    @functools.cached_property
    def headers(self) -> dict[str, str]:
        """The page of a header, by the path that its title tells."""
        titles = ((page, re.search("<title>Ansatz: (.*?) File Reference", self.text(page)))
                  for page in self.pages("*_8hpp.html"))
        return {title[1]: os.path.basename(page) for page, title in titles if title}


def faults_of_exercise(site: Site, exercise: str, header: str) -> list[str]:
    """Of exercises/1-motion/drag, and of include/ansatz/motion/drag.hpp or nothing where there is no such header."""
    _, folder, name = exercise.split("/")
    anchor = f"exercise_{re.sub('^[^-]*-', '', folder)}_{name}"
    if not os.path.isfile(f"{site.html}/{anchor}.html"):
        return [f"{exercise} has no page {anchor}.html"]
    page = site.text(f"{site.html}/{anchor}.html")
    faults: list[str] = []
    if anchor not in site.by_chapters:
        faults.append(f"no chapter links to the exercise {name}")
    if f"./workbook exercise {name}" not in page:
        faults.append(f"the page of the exercise {name} does not say its command")
    if f"{exercise}/exercise.hpp" not in page:
        faults.append(f"the page of the exercise {name} does not say which file to edit")
    if not re.search('href="section_', page):
        faults.append(f"the exercise {name} does not link to its section")
    if 'class="image"' not in page:
        faults.append(f"the page of the exercise {name} shows no picture")
    if not header:
        return faults
    file = site.headers.get(header.removeprefix("include/"))
    if not file:
        return faults + [f"{header} has no page"]
    if f'href="{file}"' not in page:
        faults.append(f"the exercise {name} does not link to {header}")
    if anchor not in site.by_types and anchor not in site.leading(glob.escape(file)):
        faults.append(f"no page of the API links to the exercise {name}")
    return faults


def header_of(exercise: str) -> str:
    """The header of an exercise's name, in the folder of its module, or nothing."""
    _, folder, name = exercise.split("/")
    module = f"include/ansatz/{re.sub('^[^-]*-', '', folder)}"
    found = sorted(place for place, _, files in os.walk(module) if f"{name}.hpp" in files)
    return f"{found[0]}/{name}.hpp" if found else ""


def main(arguments: list[str]) -> int:
    """Prints them; there may be none."""
    parser = argparse.ArgumentParser(prog="course_links.py", description="Whether chapter, API and exercise agree.")
    parser.add_argument("html", help="the folder of the site")
    site = Site(parser.parse_args(arguments).html)
    for readme in sorted(glob.glob("exercises/*/*/README.md")):
        exercise = readme.removesuffix("/README.md")
        for fault in faults_of_exercise(site, exercise, header_of(exercise)):
            sys.stdout.buffer.write(f"{fault}\n".encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
