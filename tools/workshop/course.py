# SPDX-License-Identifier: BSL-1.0
"""The course as one table: section, program, headers, exercise, tests, page. From the project's folder:

    course.py table              prints it, as a page of the site
    course.py holes              prints a fault for each hole in it, for each word that is used before it is explained,
                                 and for each link whose text is broken over two lines

A section is a program of chapters/; the rest follows from what its page says at its end ("- Library: ...",
"- Exercise: ..."), and from the names of files. Each exercise that a page links to stands in the row of the section that
its README is headed by. A section that has none is in WITHOUT_EXERCISE with the reason; an entry that has one, or that is no
section, is a fault as well.

The page of a chapter has a glossary ("## Glossary"), and each of its words names the section that explains it: there it stands in
*italics* where it is first used. Earlier sections of the page do without it, or point to where it is explained; terms of several
words ("critical damping") are looked for in earlier chapters, too, where single ones may be plain English.
"""

from __future__ import annotations

import argparse
import dataclasses
import functools
import glob
import os
import re
import sys
from typing import Mapping

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge  # noqa: E402  (it is run as a file)

# Sections without an exercise, and why. What is "not asked yet" may become shorter, never longer.
WITHOUT_EXERCISE = {
    "1.6": "compares the methods of 1.6.1 to 1.6.4, each of which has its exercise",
    "2.1": "counts pairs; its parts, 2.1.1.1 to 2.1.2.2, have their exercises",
    "4.10": "shows where a rope of 4 breaks under two loads; nothing is added to it",
    "4.11": "shows what the ball of 4 does when it falls; nothing is added to it",
    "5.2.2": "counts transitions with and without parents, which the exercise of 5.3 has",
    "5.3.1": "not asked yet: what of a machine must be saved",
    "6.1.2": "not asked yet: a graph of one's own, as Boost.Graph asks for it",
    "6.3.6": "not asked yet: the estimate of several goals",
    "6.3.7": "not asked yet: a search backwards from the goal",
    "6.3.11": "not asked yet: the two branches of a conflict",
    "6.3.12": "not asked yet: the gates of a border",
    "7": "counts what a volume costs; the library has none",
}
# The asterisk of A* opens and closes nothing.
ITALICS = re.compile(r"(?<![\w*])\*{1,2}(?=[^\s*])([^*]+)(?<=\S)\*{1,2}(?!\w)")


@functools.lru_cache(maxsize=None)
def text_of(file: str) -> str:
    """A file."""
    return forge.page(file)


def in_order(number: str) -> list[int]:
    """The key that sorts 6.3.10 behind 6.3.9."""
    return [int(part) for part in number.split(".")]


@functools.lru_cache(maxsize=None)
def headers_of_names() -> dict[str, list[str]]:
    """The headers of each type, concept and function, by its whole name: ansatz::Rope is in springs/spring.hpp. That which
    is named after it comes first. One that only says that there is such a type ("struct Rope;") does not count."""
    found: dict[str, list[str]] = {}
    named = re.compile(r" *(?:template <.*> *)?(?:struct|class|concept|enum class|using) ([A-Z]\w+)|"
                       r" *(?:\[\[nodiscard\]\] )?(?:constexpr |inline |template <.*> )*[\w:<>]+(?:<.*>)?&? ([a-z_]+)\(")
    declared = re.compile(r" *(?:template <.*> *)?(?:struct|class) [A-Z]\w+;.*")
    for folder, _, files in sorted(os.walk("include/ansatz")):
        for file in sorted(files):
            if file in ("module.hpp", "roles.hpp"):
                continue
            path = f"{folder}/{file}".removeprefix("include/ansatz/")
            stem = "".join(word.capitalize() for word in file.removesuffix(".hpp").split("_"))
            space = "ansatz"
            for line in text_of(f"{folder}/{file}").split("\n"):
                if declared.fullmatch(line):
                    continue
                if opened := re.match(r"(?:inline )?namespace (ansatz(?:::\w+)*) \{", line):
                    space = opened[1]
                if (match := named.match(line)) and path not in (headers := found.setdefault(
                        f"{space}::{match[1] or match[2]}", [])):
                    headers.insert(0 if match[1] == stem else len(headers), path)
    return found


@dataclasses.dataclass
class Section:
    """A row of the table."""

    number: str
    title: str
    program: str
    chapter: str
    label: str
    headers: list[str]
    exercises: list[str]

    @property
    def module(self) -> str:
        """motion of 1-motion."""
        return self.chapter.partition("-")[2]


def text_of_sections(page: str) -> dict[str, tuple[str, str]]:
    """For each label section_..., its title and its text up to the next heading."""
    found: dict[str, tuple[str, str]] = {}
    label = title = ""
    lines: list[str] = []
    for line in page.split("\n") + ["# end"]:
        if re.match("#+ ", line):
            if label:
                found[label] = (title, "\n".join(lines))
            heading = re.match(r"#+ +(.*?) *\{#(section_[0-9_]+)\} *$", line)
            title, label = (ITALICS.sub(r"\1", heading[1].replace("`", "")), heading[2]) if heading else ("", "")
            lines = []
        else:
            lines.append(line)
    return found


def bullet(text: str, *names: str) -> str:
    """What "- Library: ..." says, with the lines that go on."""
    found = re.search(rf"^- (?:{'|'.join(names)}): (.*(?:\n  .*)*)", text, re.MULTILINE)
    return found[1] if found else ""


def headers_in(said: str, module: str) -> list[str]:
    """Those that a bullet names: by path, by a type, or by a link to a function; of several that of the module."""
    found: list[str] = []
    names = headers_of_names()
    for path, name, short in re.findall(r"([a-z_]+(?:/[a-z_0-9]+)+\.hpp)|\\ref (ansatz(?:::\w+)+)|`([A-Z]\w+)", said):
        headers = [path.removeprefix("ansatz/")] if path else names.get(name or f"ansatz::{short}", [])
        own = [header for header in headers if header.startswith(f"{module}/")]
        found += [header for header in (own or headers)[:1] if os.path.isfile(f"include/ansatz/{header}")]
    return list(dict.fromkeys(found))


def sections() -> list[Section]:
    """All of them, in the order of the course."""
    found: list[Section] = []
    for program in glob.glob("chapters/*/[0-9]*-*.cpp"):
        _, chapter, name = program.split("/")
        number = name.partition("-")[0]
        label = "section_" + number.replace(".", "_")
        page = f"docs/{chapter.partition('-')[2]}.md"
        title, text = text_of_sections(text_of(page)).get(label, ("", "")) if os.path.isfile(page) else ("", "")
        found.append(Section(
            number, title.removeprefix(number).strip(), program, chapter, label if title else "",
            headers_in(bullet(text, "Library"), chapter.partition("-")[2]),
            re.findall(r"exercise_[a-z0-9_]+", bullet(text, "Exercises?"))))
    return sorted(found, key=lambda section: in_order(section.number))


def twice(file: str, page: str) -> list[str]:
    """Sections with two lists of one kind: only the first is read."""
    return [f"{file}: {label} has {len(found)} lines '- {kind}:'; one names them all"
            for label, (_, text) in text_of_sections(page).items() for kind in ("Program", "Library", "Exercise")
            if len(found := re.findall(rf"^- {kind}s?: ", text, re.MULTILINE)) > 1]


@functools.lru_cache(maxsize=None)
def tests_of(header: str) -> tuple[str, ...]:
    """By its name; or two that include it, of its module if there are any: those that speak most of what it defines."""
    stem = header.removesuffix(".hpp")
    module, thing = stem.partition("/")[0], stem.rpartition("/")[2]
    named = [file for ending in (".cpp", ".perf.cpp") for place in (stem, f"{module}/{thing}")
             if os.path.isfile(file := f"tests/{place}{ending}")]
    if named:
        return tuple(dict.fromkeys(named))
    names = [name.rpartition("::")[2] for name, headers in headers_of_names().items() if header in headers]
    spoken = re.compile(rf"\b(?:{'|'.join(names) or '(?!)'})\b")
    for place in (module, "*"):
        files = sorted(glob.glob(f"tests/{place}/**/*.[ch]pp", recursive=True))
        including = [file for file in files if f"<ansatz/{header}>" in text_of(file)]
        # What tests share is no test: those that include it are.
        shared = {f'"{os.path.basename(file)}"' for file in including if file.endswith(".hpp")}
        tests = [file for file in files if file.endswith(".cpp")
                 and (file in including or any(name in text_of(file) for name in shared))]
        if tests:
            return tuple(sorted(tests, key=lambda file: (-len(spoken.findall(text_of(file))), file))[:2])
    return ()


# ---------------------------------------------------------------- the table
def row(section: Section) -> str:
    """A line of it."""
    program = section.program.rpartition("/")[2]
    page = f"program_{section.module}_" + re.sub("[^A-Za-z0-9]", "_", program.removesuffix(".cpp"))
    tests = list(dict.fromkeys(test for header in section.headers for test in tests_of(header)))
    said = program.removesuffix(".cpp").partition("-")[2].replace("_", " ")
    names = [os.path.basename(header) for header in section.headers]
    modules = "|".join(os.path.basename(folder).partition("-")[2] for folder in glob.glob("chapters/*-*"))
    return (f'| \\ref {section.label} "{section.number} {section.title}" | \\ref {page} "{said}" | '
            + ", ".join(f'\\ref ansatz/{header} "{header if names.count(os.path.basename(header)) > 1 else os.path.basename(header)}"'
                        for header in section.headers) + " | "
            + ", ".join(f'\\ref {label} "{re.sub(f"exercise_({modules})_", "", label)}"' for label in section.exercises) + " | "
            + ", ".join(os.path.basename(test) for test in tests) + " |")


def table() -> str:
    """The page."""
    text = ("# The course in one table {#page_course}\n\nEach section of the notes, with its program, what the library "
            "has of it, the exercise that asks for it, and its\ntests (in `tests/`). `./workbook section 1.7` runs a program, "
            "`./workbook exercise drag` an exercise.\n")
    chapter = ""
    for section in sections():
        if not section.label:
            continue
        if section.chapter != chapter:
            chapter = section.chapter
            text += (f"\n## {chapter[0]}. {section.module.replace('_', ' ').capitalize()} {{#course_{section.module}}}\n\n"
                     "| section | program | in the library | exercise | tests |\n|---|---|---|---|---|\n")
        text += row(section) + "\n"
    return text


def holes(without: Mapping[str, str]) -> list[str]:
    """What the table lacks, but for the exercises of those that are without."""
    faults: list[str] = []
    rows = sections()
    told: set[str] = set()    # of which it is said already that they name no exercise
    faults += [f"section {number} is not there: it leaves the list of those without an exercise (tools/workshop/course.py)"
               for number in without if number not in {section.number for section in rows}]
    for section in rows:
        if not section.label:
            faults.append(f"{section.program} has no section {section.number} on its page")
            continue
        has = bool(section.exercises)
        if has and section.number in without:
            faults.append(f"section {section.number} has an exercise: it leaves the list of those without one "
                          "(tools/workshop/course.py)")
        if not section.headers:
            faults.append(f"section {section.number} names no header behind '- Library:'")
        faults += [f"{header}, which section {section.number} teaches, has no test" for header in section.headers
                   if not tests_of(header)]
        if not has and section.number not in without:
            told.add(section.number)
            faults.append(f"section {section.number} has no exercise behind '- Exercise:'")
    for readme in sorted(glob.glob("exercises/*/*/README.md")):
        _, chapter, name, _ = readme.split("/")
        module = chapter.partition("-")[2]
        number = (text_of(readme).split(maxsplit=2) + ["", ""])[1]    # of "# 1.7 Drag"
        label = f"exercise_{module}_{name}"
        # One that the chapter links to nowhere is told by course_links.py.
        page = f"docs/{module}.md"
        if number not in told and os.path.isfile(page) and label in text_of(page) and not any(
                label in section.exercises for section in rows if section.number == number):
            faults.append(f"section {number} does not name its exercise {name} behind '- Exercise:'")
    return faults


# ---------------------------------------------------------------- words
def plain(text: str) -> str:
    """What is read of a text: no code, formulas, commands, or words that only look alike."""
    text = re.sub(r"^\\(?:snippet|verbinclude|image|include)[^\n]*|`[^`\n]*`", " ", text, flags=re.MULTILINE)
    return re.sub(r"\\f\[.*?\\f\]|\\f\$.*?\\f\$|<!--.*?-->", " ", text, flags=re.DOTALL)


def words_of(page: str) -> list[tuple[str, str]]:
    """Of its glossary: the word, and the label of the place that explains it. "slack, taut" are two."""
    found: list[tuple[str, str]] = []
    words = re.search(r"^## Glossary .*?(?=^## |\Z)", page, re.DOTALL | re.MULTILINE)
    for line in words[0].split("\n") if words else []:
        if entry := re.match(r"\| ([^|]+) \|.*\\ref (\w+)", line):
            found += [(word.strip(), entry[2]) for word in entry[1].split(",")]
    return found


def form(word: str) -> str:
    """Matches a word, its plural, and its parts joined by a hyphen or a line's end."""
    return r"\b" + r"[\s-]+".join(re.escape(part) for part in word.split()) + r"(?:s|es|d|ed)?\b"


def paragraphs(text: str) -> list[str]:
    """Those of a section, each item of a list and each row of a table by itself."""
    return re.split(r"\n\n+|\n(?=[-|] )", text)


def in_italics(paragraph: str) -> str:
    """What stands between asterisks; the one of A* is none of them."""
    return "\n".join(ITALICS.findall(paragraph))


def explains(word: str, text: str) -> str:
    """Nothing where a section sets a word in italics when it first uses it; else what is wrong."""
    for paragraph in map(plain, paragraphs(text)):
        if re.search(form(word), paragraph, re.IGNORECASE):
            return "" if re.search(form(word), in_italics(paragraph), re.IGNORECASE) else (
                f"which does not set it in *italics* where it is first used: \"{' '.join(paragraph.split())[:80]}\"")
    return "which does not use it"


def used_too_early(file: str, page: str) -> list[str]:
    """Words of the glossary that their section does not explain, or one before it uses without pointing to it."""
    faults: list[str] = []
    if re.search(r"^# .*\{#chapter_", page, re.MULTILINE) and not words_of(page):
        faults.append(f"{file}: the chapter has no glossary, '## Glossary'")
    # The pieces of the page in their order: the label, and the text below its heading.
    pieces = re.split(r"^#+ .*\{#(\w+)\} *$", page, flags=re.MULTILINE)
    labels = pieces[1::2]
    texts = dict(zip(labels, pieces[2::2]))
    for word, place in words_of(page):
        if place not in texts:
            faults.append(f"{file}: the glossary explains '{word}' in {place}, which is not on this page")
            continue
        if wrong := explains(word, texts[place]):
            faults.append(f"{file}: the glossary explains '{word}' in {place}, {wrong}")
        for label in labels[:labels.index(place)]:
            if uses(word, place, label, texts[label]):
                faults.append(f"{file}: {label} uses '{word}' before {place} explains it; "
                              "explain it there, or point to where it is")
    return faults


def uses(word: str, place: str, label: str, text: str) -> bool:
    """Whether a section says a word before it has pointed to its place."""
    if not label.startswith("section_"):
        return False
    for paragraph in paragraphs(text):
        if f"\\ref {place}" in paragraph:
            return False
        if re.search(form(word), plain(paragraph), re.IGNORECASE):
            return True
    return False


def used_in_earlier_chapters(pages: Mapping[str, str]) -> list[str]:
    """Terms of several words that chapters before theirs use without pointing to them, unless their own glossary has them."""
    faults: list[str] = []
    numbered = {file: int(found[1]) for file, page in pages.items()
                if (found := re.match(r"# Chapter (\d+): .*\{#chapter_", page))}
    chapters = sorted(numbered, key=lambda file: numbered[file])
    known: set[str] = set()
    for number, file in enumerate(chapters):
        for word, place in words_of(pages[file]):
            if len(re.split(r"[\s-]", word)) < 2 or word in known:
                continue
            for earlier in chapters[:number]:
                faults += [f"{earlier}: {label} uses '{word}', which {place} of {file} explains; point to it"
                           for label, (_, text) in text_of_sections(pages[earlier]).items() if uses(word, place, label, text)]
        known |= {word for word, _ in words_of(pages[file])}
    return faults


def broken(file: str, page: str) -> list[str]:
    """Links whose text goes on in the next line: Doxygen ends them there, and what follows is no Markdown any more."""
    return [f"{file}:{number}: the text of a \\ref goes on in the next line; it stands in one"
            for number, line in enumerate(page.split("\n"), start=1) if re.search(r'\\ref \S+ "[^"]*$', line)]


def main(arguments: list[str]) -> int:
    """One of the two."""
    parser = argparse.ArgumentParser(prog="course.py", description="The course as one table.")
    parser.add_argument("asked", choices=("table", "holes"))
    if parser.parse_args(arguments).asked == "table":
        sys.stdout.buffer.write(table().encode("utf-8", "surrogateescape"))
        return 0
    pages = {file: text_of(file) for file in sorted(glob.glob("docs/*.md"))}
    faults = holes(WITHOUT_EXERCISE) + used_in_earlier_chapters(pages)
    for file, page in pages.items():
        faults += twice(file, page) + used_too_early(file, page) + broken(file, page)
    for fault in faults:
        print(fault)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
