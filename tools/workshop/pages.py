# SPDX-License-Identifier: BSL-1.0
"""The pages of the site that follow from the tree, as Markdown. From the project's folder:

    pages.py exercises              prints the list of the exercises
    pages.py library                prints every header with its first sentence
    pages.py programs <out>         writes <out>/pages/programs.md, beside it a page for each program of the chapters,
                                    and into <out>/listing what that page shows: the program without marks of quotations
"""

from __future__ import annotations

import argparse
import glob
import os
import re
import sys
from typing import Union

QUOTED = re.compile(r" *//! \[")


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read().removesuffix("\n").split("\n")


def write(file: str, text: str) -> None:
    """A file, and the folder that it stands in."""
    os.makedirs(os.path.dirname(file), exist_ok=True)
    with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        stream.write(text)


def in_order(name: str) -> list[Union[int, str]]:
    """The key that sorts 1.10 behind 1.9, and 1.6 before 1.6.1: text and numbers in turn."""
    stem = re.sub(r"\.[a-z]+$", "", name)
    return [int(part) if part.isdigit() else part for part in re.split("([0-9]+)", stem)]


def below(folder: str, endings: tuple[str, ...]) -> list[str]:
    """The files below a folder whose names end so."""
    return sorted(f"{place}/{file}" for place, _, files in os.walk(folder) for file in files if file.endswith(endings))


def module_of(folder: str) -> str:
    """"motion" of "1-motion"."""
    return folder.partition("-")[2] or folder


# ---------------------------------------------------------------- the exercises

def row_of_exercise(readme: str) -> str:
    """Of the list: the first line of a README.md is "# <section> <title>"."""
    _, folder, name, _ = readme.split("/")
    _, number, *title = read(readme)[0].split()
    return (f'| {number} | \\ref exercise_{module_of(folder)}_{name} "{" ".join(title)}" '
            f"| `./workbook exercise {name}` |")


def exercises() -> str:
    """The list, by section."""
    rows = (row_of_exercise(readme) for readme in glob.glob("exercises/*/*/README.md"))
    return ("# Exercises {#page_exercises}\n\n"
            "Each asks for exactly what the library has; when yours passes, `./workbook play` puts it into the real "
            "world beside\nthe library's own. `./workbook exercise` begins with the first that is not done, "
            "`./workbook hint` helps.\n\n| section | exercise | command |\n|---|---|---|\n"
            + "".join(row + "\n" for row in sorted(rows, key=lambda row: (in_order(row.split("|")[1]), row))))


# ---------------------------------------------------------------- the library

def first_sentence(lines: list[str]) -> str:
    """Of the comment that begins with \\file: up to where a sentence ends and another begins."""
    told: list[str] = []
    telling = False
    for line in lines:
        if re.match(r"/// \\file", line):
            telling = True
        elif telling and re.fullmatch("/// *", line):
            break
        elif telling and line.startswith("///"):
            told.append(re.sub("^/// ?", "", line))
    text = re.sub(r"\. [A-Z`].*", ".", " ".join(told))
    return re.sub("[:;]$", ".", text)


def library() -> str:
    """Every header, module by module."""
    text = ("# The library {#page_library}\n\nEvery header, with its first sentence. `#include <ansatz/world.hpp>` "
            "brings all of them but a few, which say so.\n")
    for umbrella in sorted(glob.glob("include/ansatz/*.hpp")):
        module = umbrella.removesuffix(".hpp")
        name = module.rpartition("/")[2]
        text += f"\n## {name} {{#headers_{name}}}\n\n| header | what it holds |\n|---|---|\n"
        for header in below(module, (".hpp",)):
            path = header.removeprefix("include/ansatz/")
            sentence = first_sentence(read(header)).replace("|", "\\|")
            text += f'| \\ref ansatz/{path} "{path}" | {sentence} |\n'
    return text


# ---------------------------------------------------------------- the programs

def what_it_shows(lines: list[str]) -> str:
    """The first line of a program's comment."""
    for line in lines:
        if re.match("///? [^-]", line) and not line.startswith("// SPDX") and "\\file" not in line:
            return re.sub("^//+ ", "", line)
    return ""


class Program:
    """A program of a chapter, or a header that such programs share."""

    def __init__(self, file: str, labels: frozenset[str]) -> None:
        self.folder, self.name = file.split("/")[1], file.rpartition("/")[2]
        self.lines = read(file)
        stem, _, ending = self.name.rpartition(".")
        self.page = f"program_{module_of(self.folder)}_" + re.sub("[^A-Za-z0-9]", "_", stem)
        if ending == "hpp":
            self.page += "_hpp"
        section = re.match(r"([0-9][^-]*)-.*\.cpp$", self.name)
        self.number = section[1] if section else ""
        label = f"section_{self.number.replace('.', '_')}"
        self.section = f'\\ref {label} "{self.number}"' if label in labels else self.number
        self.shows = what_it_shows(self.lines)
        if self.number:
            self.shows = self.shows.removeprefix(self.number + " ")

    def row(self) -> str:
        """Of the list of its chapter."""
        shows = re.sub(r"([|<>@\\#])", r"\\\1", self.shows)
        return f'| \\ref {self.page} "{self.name}" | {shows} |\n'

    def text(self) -> str:
        """Its page."""
        said = (f"The program of section {self.section}: `./workbook section {self.number}` builds and runs it.\n\n"
                if self.number else "")
        return f"# {self.name} {{#{self.page}}}\n\n{said}\\include listing/{self.folder}/{self.name}\n"

    def listing(self) -> str:
        """Itself, without the marks of what is quoted."""
        return "".join(line + "\n" for line in self.lines if not QUOTED.match(line))


def programs(out: str) -> None:
    """The programs of the chapters, whole: the chapters quote from them, the exercises name them."""
    texts = "\n".join(line for page in glob.glob("docs/*.md") for line in read(page))
    labels = frozenset(re.findall(r"\{#(section_[0-9_]+)\}", texts))
    text = "# The programs {#page_programs}\n\nOne for each section, runnable alone: `./workbook section 1.6.1`.\n"
    for folder in sorted(glob.glob("chapters/*/")):
        chapter = folder.split("/")[1]
        text += (f"\n## {chapter.replace('-', '. ', 1)} {{#programs_{module_of(chapter)}}}\n\n"
                 "| program | what it shows |\n|---|---|\n")
        for file in sorted(below(folder.rstrip("/"), (".cpp", ".hpp")), key=in_order):
            program = Program(file, labels)
            write(f"{out}/listing/{chapter}/{program.name}", program.listing())
            write(f"{out}/pages/{program.page}.md", program.text())
            text += program.row()
    write(f"{out}/pages/programs.md", text)


def main(arguments: list[str]) -> int:
    """One of the three."""
    parser = argparse.ArgumentParser(prog="pages.py", description="The pages of the site that follow from the tree.")
    kinds = parser.add_subparsers(dest="kind", required=True)
    kinds.add_parser("exercises", help="prints the list of the exercises")
    kinds.add_parser("library", help="prints every header with its first sentence")
    kinds.add_parser("programs", help="writes the pages of the programs").add_argument("out", help="the site's folder")
    given = parser.parse_args(arguments)
    if given.kind == "programs":
        programs(given.out)
    else:
        text = exercises() if given.kind == "exercises" else library()
        sys.stdout.buffer.write(text.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
