# SPDX-License-Identifier: BSL-1.0
"""Writes the file in which the answers to an exercise are compiled.

`others`, all but the student's in one: each has a namespace of its own, with the tests in it once more; the last has none,
since the student's has none either, and a name of the tests that the library has too must be found before a student finds
it. The headers that it includes come before, so that they are parsed once; inside, their guards leave nothing of them. What macros an
answer defines or undefines, in itself or in the files beside it that it includes, are as they were after it. What is
written does not compile those that ANSATZ_BROKEN_<n> names, and with ANSATZ_ONLY=<n> but one.

`student`, the file of the student, as others may include it.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

BLANKS = r"[ \t\f\v]*"
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
DIRECTIVE = re.compile(rf"{BLANKS}(?:#|%:){BLANKS}(.*)", re.DOTALL)
MACRO = re.compile(r"(?:define|undef)[ \t\f\v]+([A-Za-z_][A-Za-z_0-9]*)")
BESIDE = re.compile(rf'include{BLANKS}"([^"]*)"')
LIBRARY = re.compile(r" *# *include *(<[^>]*>)")


def read(file: str) -> str:
    """The text of a file, whatever bytes are in it."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def directives_of(text: str) -> list[str]:
    """What stands after the # of each directive. It may go on in the next line, and have comments between its words."""
    whole = re.sub(r"\\\n", "", text.replace("\r\n", "\n"))
    found = (DIRECTIVE.match(COMMENT.sub(" ", line)) for line in whole.split("\n"))
    return [directive[1] for directive in found if directive]


def collect_macros(file: str, names: dict[str, None], seen: set[str]) -> None:
    """Adds the macros that a file changes, and those of the files beside it that it includes, where they are there."""
    whole = os.path.realpath(file)
    if whole in seen:
        return
    seen.add(whole)
    try:
        text = read(file)
    except OSError:
        return
    for directive in directives_of(text):
        macro, beside = MACRO.match(directive), BESIDE.match(directive)
        if macro:
            names[macro[1]] = None
        elif beside:
            collect_macros(os.path.join(os.path.dirname(file), beside[1]), names, seen)


def macros_of(file: str) -> list[str]:
    """The macros that an answer defines or undefines, each once, in order."""
    names: dict[str, None] = {}
    collect_macros(file, names, set())
    return list(names)


def kept(macros: list[str], way: str) -> str:
    """The lines that `push` the macros before an answer, or `pop` them after it."""
    return "\n".join(f'#pragma {way}_macro("{name}")' for name in macros)


def headers_of(file: str) -> list[str]:
    """The lines that include what a file includes of the libraries, each once."""
    found = (LIBRARY.match(line) for line in read(file).split("\n"))
    return list(dict.fromkeys(f"#include {header[1]}" for header in found if header))


def student(place: str, file: str) -> str:
    """What compiles the file, which is included by its place.

    Only where no brace is open a template can be specialised: else the compiler would blame whatever comes next.
    """
    macros = macros_of(file)
    lines = ["template <class> struct NothingIsOpen;", kept(macros, "push"), f'#include "{place}/exercise.hpp"',
             kept(macros, "pop"), "template <> struct NothingIsOpen<int> {};"]
    return "".join(line + "\n" for line in lines if line)


def only_for(number: int, lines: list[str]) -> list[str]:
    """Lines that are there for the subject of that number."""
    one = f"#if !defined(ANSATZ_BROKEN_{number}) && (!defined(ANSATZ_ONLY) || ANSATZ_ONLY + 0 == {number})"
    return [one, *lines, "#endif"]


def alone(number: int, last: int, lines: list[str]) -> list[str]:
    """Lines in the namespace of the subject of that number; the last one has none, as the student's file."""
    return lines if number == last else [f"namespace subject_{number} {{", *lines, "}"]


def others(place: str, exercise: str, out: str, names: list[str]) -> str:
    """What compiles the subjects of these names: solution and library stand in the exercise's folder, those that are
    made in `out`, where what is returned belongs."""
    lines = ["// Made by tools/exercises/subjects.sh.", '#include "tools/exercises/expect.hpp"',
             "template <int> struct NothingIsOpen;"]
    last = len(names) - 1
    for number, name in enumerate(names):
        written = name in ("solution", "library")
        file = os.path.join(exercise if written else out, name + ".hpp")
        macros = macros_of(file)
        # What others include is no help to this one as long as it comes first: so does the solution, and the skeletons.
        lines += ["", f"// subject {number}: {name}", *only_for(number, [
            "\n".join(headers_of(file)), kept(macros, "push"),
            *alone(number, last, [f'static constexpr const char* tested_subject = "{name}";',
                                  f'#include "{place + "/" if written else ""}{name}.hpp"']),
            kept(macros, "pop"), f"template <> struct NothingIsOpen<{number}> {{}};"])]
    lines += ["", *headers_of(os.path.join(exercise, "test.cpp"))]
    for number in range(len(names)):
        lines += only_for(number, alone(number, last, [
            f'#include "{place}/test.cpp"',
            "static const ansatz::workbook::RegisteredProbe registered_probe(tested_subject, &probe);"]))
    return "".join(line + "\n" for line in lines)


def main(arguments: list[str]) -> int:
    """Ends with 1 where a file cannot be read."""
    parser = argparse.ArgumentParser(prog="subjects.py", description="Writes what answers are compiled as.")
    parser.add_argument("kind", choices=["student", "others"])
    parser.add_argument("exercise", help="the folder of the exercise")
    parser.add_argument("place", help="that folder as it is included: by its place in the project")
    parser.add_argument("out", nargs="?", default="", help="where the subjects that are made lie")
    parser.add_argument("names", nargs="*", metavar="NAME", help="solution, skeleton[.<n>], library, wrong.<name>")
    given = parser.parse_args(arguments)
    try:
        if given.kind == "student":
            said = student(given.place, os.path.join(given.exercise, "exercise.hpp"))
        else:
            said = others(given.place, given.exercise, given.out, given.names)
    except OSError as error:
        print(f"subjects.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    sys.stdout.buffer.write(said.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
