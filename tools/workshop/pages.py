# SPDX-License-Identifier: BSL-1.0
"""The pages of the site that follow from the tree, as Markdown. From the project's folder:

    pages.py exercises              prints the list of the exercises
    pages.py library                prints every header with its first sentence
    pages.py front <version> <film>
                                    prints the front page of docs/site/front.md, with the version, the film, the chapters, and
                                    docs/site/demo.html where there is a live demo
    pages.py order                  prints the pages that lead to each other, with their titles: chapters, exercises, programs
    pages.py exercise <folder> <out> <task>
                                    prints the page of an exercise: its README.md, which <task> has as Doxygen reads it, with the
                                    picture of its section, the skeleton, which it writes into <out>/listing, and its hints,
                                    folded
    pages.py programs <out>         writes <out>/pages/programs.md, beside it a page for each program of the chapters,
                                    and into <out>/listing what that page shows: the program without marks of quotations;
                                    the same of tests/package/models, the policies that the page of worlds shows
"""

from __future__ import annotations

import argparse
import glob
import html
import os
import re
import sys
from typing import Union

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge, named, parts, section_picture, skeleton  # noqa: E402  (it is run as a file)

QUOTED = re.compile(r" *//! \[")


def read(file: str) -> list[str]:
    """Its lines, without their ends."""
    return forge.page(file).removesuffix("\n").split("\n")


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


def hints_of(lines: list[str]) -> str:
    """Each below its heading, and hidden until it is asked for."""
    text = ""
    for part in re.split(r"^## ", "\n".join(lines), flags=re.MULTILINE)[1:]:
        heading, _, said = part.partition("\n")
        text += (f"\\htmlonly[block]<details><summary>{html.escape(heading.strip())}</summary>\\endhtmlonly\n\n"
                 f"{said.strip()}\n\n\\htmlonly[block]</details>\\endhtmlonly\n\n")
    return text


def illustrated(task: str, section: str) -> str:
    """The task with the picture of its section behind its opening words, unless it has a picture of its own."""
    picture = section_picture.picture_of(section)
    if not picture or "\\image html " in task:
        return task
    heading, command, opening, rest = (task.split("\n\n", 3) + ["", "", ""])[:4]
    return "\n\n".join((heading, command, opening, picture, rest))


def exercise(folder: str, out: str, task: str) -> str:
    """The task with its picture; the skeleton as everybody begins with it, not as somebody has left it; and the hints."""
    _, chapter, name = folder.rstrip("/").split("/")
    place = f"{chapter}/{name}/exercise.hpp"
    solution = "\n".join(read(f"{folder}/solution.hpp")) + "\n"
    write(f"{out}/listing/exercises/{place}", skeleton.skeleton(solution))
    text = illustrated(task, read(f"{folder}/README.md")[0].split()[1])
    text += f"\n## What you edit\n\n\\include listing/exercises/{place}\n"
    if os.path.isfile(f"{folder}/hints.md"):
        text += ("\n## Hints\n\nOne at a time: a question, the place, the shape, the key line. "
                 f"`./workbook hint {name}` gives the next.\n\n" + hints_of(read(f"{folder}/hints.md")))
    return text


# ---------------------------------------------------------------- the front

def first_words(page: list[str]) -> str:
    """What a chapter says of itself first: up to the end of its first sentence."""
    body = "\n".join(page[1:]).replace("[TOC]", "").strip().split("\n\n")[0]
    return re.split(r"(?<=[.!?]) ", body.replace("\n", " "))[0]


def front(version: str, film: str) -> str:
    """The places in capitals are filled."""
    rows = "".join(f'- \\ref {label} "{number}. {title}": {first_words(read(page))}\n' for number, label, title, page in chapters())
    demo = "\\htmlinclude docs/site/demo.html\n" if os.path.isfile("docs/site/demo.html") else ""
    text = "\n".join(read("docs/site/front.md")) + "\n"
    for place, filled in (("VERSION", version), ("FILM", f"\\image html {film} width=760px"), ("DEMO\n", demo),
                          ("CHAPTERS\n", rows)):
        text = text.replace(place, filled, 1)
    return text


# ---------------------------------------------------------------- the order of reading

def chapters() -> list[tuple[int, str, str, str]]:
    """Number, label, title and file of each, by number."""
    return sorted((int(found[1]), found[3], found[2], page) for page in glob.glob("docs/*.md") for line in read(page)[:1]
                  if (found := re.match(r"# Chapter ([0-9]+): (.*?) *\{#(chapter_\w+)\}", line)))


def order() -> str:
    """A group for the chapters with their pages, one for the exercises, one for the programs, and one for worlds and the
    models of what can be put into them."""
    text = "".join(f"{part.label}\t{html.escape(parts.plain(part.name(f'Chapter {number}')), quote=False)}\n"
                   for number, _, _, page in chapters() for part in parts.parts_of(read(page))) + "\n"
    rows = (re.match(r'\| ([0-9.]+) \| \\ref (\w+) "(.*?)" \|', row) for row in exercises().split("\n"))
    text += "".join(f"{row[2]}\t{row[1]} {html.escape(row[3])}\n" for row in rows if row) + "\n"
    numbered = sorted(glob.glob("chapters/*/[0-9]*-*.cpp"), key=lambda file: in_order(file.rpartition("/")[2]))
    for file in numbered:
        program = Program(file, frozenset())
        text += f"{program.page}\t{program.name}\n"
    names = sorted(file.rpartition("/")[2].removesuffix(".cpp") for file in glob.glob("tests/package/models/*.cpp"))
    return text + "\npage_world\tWorlds\n" + "".join(f"model_{name}\t{name}.cpp\n" for name in names)


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


def row_of_header(header: str) -> str:
    """Of the list."""
    path = header.removeprefix("include/ansatz/")
    sentence = first_sentence(read(header)).replace("|", "\\|")
    return f'| \\ref ansatz/{path} "{path}" | {sentence} |\n'


def library() -> str:
    """Every header, module by module: those that users name, and behind them what those are made of."""
    text = ("# The library {#page_library}\n\nEvery header, with its first sentence. `#include <ansatz/world.hpp>` "
            "brings all of them but a few, which say so.\n\nFirst stand those that the chapters, the exercises or the text pages "
            "include or speak of.\n")
    head = "| header | what it holds |\n|---|---|\n"
    for umbrella in sorted(glob.glob("include/ansatz/*.hpp")):
        module = umbrella.removesuffix(".hpp")
        name = module.rpartition("/")[2]
        text += f"\n## {name} {{#headers_{name}}}\n"
        headers = below(module, (".hpp",))
        public = [header for header in headers if named.is_for_users(header.removeprefix("include/"), forge.read(header))]
        text += f"\n{head}" + "".join(map(row_of_header, public)) if public else ""
        if inside := [header for header in headers if header not in public]:
            text += (f"\nThe insides of {name}:\n" if public else "") + f"\n{head}" + "".join(map(row_of_header, inside))
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
    models(out)


def models(out: str) -> None:
    """A page for each model of a policy of one's own, to which the page of worlds leads."""
    for file in sorted(glob.glob("tests/package/models/*.cpp")):
        name, lines = file.rpartition("/")[2], read(file)
        write(f"{out}/listing/models/{name}", "".join(line + "\n" for line in lines if not QUOTED.match(line)))
        write(f"{out}/pages/model_{name.removesuffix('.cpp')}.md",
              f"# {name} {{#model_{name.removesuffix('.cpp')}}}\n\n{what_it_shows(lines)}\n\n\\include listing/models/{name}\n\n"
              f"One of the policies of \\ref page_world \"the page about worlds\"; it is compiled against an installed Ansatz, and run.\n")


def main(arguments: list[str]) -> int:
    """One of them."""
    parser = argparse.ArgumentParser(prog="pages.py", description="The pages of the site that follow from the tree.")
    kinds = parser.add_subparsers(dest="kind", required=True)
    kinds.add_parser("exercises", help="prints the list of the exercises")
    kinds.add_parser("library", help="prints every header with its first sentence")
    kinds.add_parser("programs", help="writes the pages of the programs").add_argument("out", help="the site's folder")
    kinds.add_parser("order", help="prints the pages that lead to each other")
    fronting = kinds.add_parser("front", help="prints the front page")
    fronting.add_argument("version", help="of the library")
    fronting.add_argument("film", help="the picture or film that it shows")
    of_one = kinds.add_parser("exercise", help="prints the page of an exercise")
    of_one.add_argument("folder", help="of the exercise")
    of_one.add_argument("out", help="the site's folder")
    of_one.add_argument("task", help="its README.md, as Doxygen reads it")
    given = parser.parse_args(arguments)
    if given.kind == "programs":
        programs(given.out)
    elif given.kind == "front":
        sys.stdout.buffer.write(front(given.version, given.film).encode("utf-8", "surrogateescape"))
    elif given.kind == "exercise":
        page = exercise(given.folder, given.out, forge.read(given.task))
        sys.stdout.buffer.write(page.encode("utf-8", "surrogateescape"))
    else:
        text = {"exercises": exercises, "library": library, "order": order}[given.kind]()
        sys.stdout.buffer.write(text.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
