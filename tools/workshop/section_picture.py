# SPDX-License-Identifier: BSL-1.0
"""The picture that stands for a section: what the page of an exercise shows beside its task."""

from __future__ import annotations

import glob
import re

from workshop import forge

HEADING = re.compile(r"#+ .*\{#(?:section_(?P<section>[0-9_]+)|[\w-]+)\} *$")
SHEET = re.compile(r'\\image html .*-sheet\.svg ')    # a film on paper: the site prints it where it plays the film


def pictures_by_section(chapter: str) -> dict[str, list[str]]:
    """The pictures of each numbered section of a chapter, as Doxygen reads them, in the order of the page."""
    found: dict[str, list[str]] = {}
    label = re.compile(rf'(?:\{{#|<a id=")section_{chapter}[_"}}]')
    for page in sorted(glob.glob("docs/*.md")):
        if not label.search(forge.read(page)):
            continue    # it costs ten times as much to read it as Doxygen does
        section = ""
        for line in forge.page(page).split("\n"):
            if heading := HEADING.match(line):
                section = (heading["section"] or "").replace("_", ".")
            elif section and line.startswith("\\image html ") and not SHEET.match(line):
                found.setdefault(section, []).append(line)
    return found


def picture_of(section: str) -> str:
    """Its film or else its first picture, or that of the section around it, or of a section below that; "" where there is none."""
    pictures = pictures_by_section(section.partition(".")[0])
    while section:
        below = sorted((name for name in pictures if name.startswith(f"{section}.")), key=in_order)
        for name in (section, *below):
            if name in pictures:
                return min(pictures[name], key=lambda picture: "-film.svg " not in picture)
        section = section.rpartition(".")[0]
    return ""


def in_order(section: str) -> list[int]:
    """The key that sorts 1.10 behind 1.9."""
    return [int(number) for number in section.split(".")]
