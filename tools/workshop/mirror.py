# SPDX-License-Identifier: BSL-1.0
"""The five trees hold the same things under the same names. This program lists what one of them lacks:

  - a public header without its test, tests/<module>/<thing>.cpp or an #include of it in tests/
  - a public header that neither a chapter nor the docs mention, by its path or by its name in PascalCase
  - an umbrella header (<module>.hpp beside the folder <module>/) that does not reach a file of its folder; a header
    that belongs outside says so in a line of its own: // not in the umbrella: <reason>
  - a test that is switched off, or skipped without a reason
  - a source file without its SPDX line
  - a header of more than 400 lines
  - headers that include each other in a ring
  - a header that includes one of a folder above its own: world/ knows no module, and core/ not even units
  - code of world/, comments and sentences aside, that names what belongs to a module

    mirror.py [the project's folder]

It ends with 0 when nothing is missing, else with 1 and one line for each fault.
"""

from __future__ import annotations

import argparse
import functools
import glob
import os
import re
import sys

SPDX = "SPDX-License-Identifier: BSL-1.0"
LONGEST = 400
# Hidden or allowed to fail in Catch2; compiled away; skipped without saying why; DISABLED as in GoogleTest.
OFF_IN_CODE = re.compile(
    r'"[^"]*\[(\.[A-Za-z0-9_-]*|!mayfail|!shouldfail|!hide)\]|^ *# *if +(0|false)\b|\bSKIP *\( *("")? *\)|\bDISABLED',
    re.ASCII)
OFF_IN_BUILD = re.compile(r"\b(DISABLED|WILL_FAIL)\b", re.ASCII)
INCLUDE = re.compile(r"^ *# *include *<(ansatz/[^>]+)>", re.MULTILINE)
OUTSIDE = re.compile(r"^ *// not in the umbrella: *[^ \n]", re.MULTILINE)
# The folders of the library from the bottom up; those of one row may not know each other unless they stand in order.
LAYERS = {folder: layer for layer, folder in enumerate(
    ("core", "units", "world", "motion", "springs", "collision", "soft_bodies"))}
OF_A_MODULE = re.compile(r"\b(collisions?|contacts?|sensors?|springs?|ropes?|verlet|penalty)\b", re.IGNORECASE)
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|#include[^\n]*', re.DOTALL)
SOURCE = re.compile(r".*(\.(cpp|hpp|h|cmake|sh|py|js)|CMakeLists\.txt)")


@functools.lru_cache(maxsize=None)
def text_of(file: str) -> str:
    """A file."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def files_below(pattern: str, *places: str) -> list[str]:
    """The files below those of the places that exist, or such a file itself, whose paths are of this form."""
    found = [place for place in places if os.path.isfile(place)]
    for folder, _, files in (below for place in places for below in os.walk(place)):
        found += [f"{folder}/{file}" for file in files]
    return sorted(file for file in found if re.fullmatch(pattern, file) and not os.path.islink(file))


def fault(what: str, where: str, how: str) -> str:
    """What is wrong, where, and how to mend it."""
    return f"{what}: {where} ({how})"


def is_umbrella(header: str) -> bool:
    """Whether it stands beside a folder of its name."""
    return os.path.isdir(header.removesuffix(".hpp"))


def untested_and_unmentioned(headers: list[str], tests: list[str], mentions: list[str]) -> list[str]:
    """Each header has its test, and is spoken of."""
    faults: list[str] = []
    tested, mentioned = ("\n".join(map(text_of, files)) for files in (tests, mentions))
    for header in (header for header in headers if not is_umbrella(header)):
        path = header.removeprefix("include/ansatz/")                    # collision/broadphase/uniform_grid.hpp
        module, stem = path.partition("/")[0], path.removesuffix(".hpp")
        thing = stem.rpartition("/")[2]                                  # uniform_grid
        name = "".join(word[:1].upper() + word[1:] for word in thing.split("_"))
        if not os.path.exists(f"tests/{stem}.cpp") and not os.path.exists(f"tests/{module}/{thing}.cpp") \
                and f"#include <ansatz/{path}>" not in tested:
            faults.append(fault("no test", header, f"write tests/{stem}.cpp, or include it in a test"))
        # Modules without a chapter in the course are spoken of somewhere; the others as soon as their chapter exists.
        if module in ("units", "world") or glob.glob(f"chapters/*-{glob.escape(module)}"):
            if not re.search(rf"\b({re.escape(path)}|{name})\b", mentioned, re.ASCII):
                faults.append(fault("not mentioned", header, f"speak of {path} or {name} in chapters/ or docs/"))
    return faults


def reached_from(umbrella: str) -> set[str]:
    """The headers that it includes, and that those include."""
    reached = {umbrella}
    queue = [umbrella]
    while queue:
        for include in INCLUDE.findall(text_of(queue.pop())):
            header = f"include/{include}"
            if os.path.exists(header) and header not in reached:
                reached.add(header)
                queue.append(header)
    return reached


def beside_their_umbrellas(headers: list[str]) -> list[str]:
    """Each umbrella reaches all that stands under it, and each folder has one."""
    faults: list[str] = []
    for umbrella in filter(is_umbrella, headers):
        reached = reached_from(umbrella)
        how = f"include it in {umbrella.removeprefix('include/')}, or say in it: // not in the umbrella: <reason>"
        for header in files_below(r".*\.hpp", umbrella.removesuffix(".hpp")):
            if header not in reached and not OUTSIDE.search(text_of(header)):
                faults.append(fault("not in its umbrella", header, how))
    for folder in sorted(glob.glob("include/ansatz/*/")):
        umbrella = folder.removesuffix("/") + ".hpp"
        if not os.path.exists(umbrella):
            faults.append(fault("no umbrella", folder, f"write {umbrella}, which includes all of it"))
    return faults


def rings_of_includes(headers: list[str]) -> list[str]:
    """Headers that include each other can be read in no order: the shortest ring through each, named once."""
    faults: list[str] = []
    seen: set[frozenset[str]] = set()
    for start in headers:
        came_from: dict[str, str] = {}
        queue = [start]
        while queue and start not in came_from:
            header = queue.pop(0)
            for include in INCLUDE.findall(text_of(header)):
                included = f"include/{include}"
                if included not in came_from and os.path.exists(included):
                    came_from[included] = header
                    queue.append(included)
        if start not in came_from:
            continue
        ring = [start]
        while came_from[ring[-1]] != start:
            ring.append(came_from[ring[-1]])
        if frozenset(ring) not in seen:
            seen.add(frozenset(ring))
            names = " <- ".join(header.removeprefix("include/ansatz/") for header in [*ring, start])
            faults.append(fault("a ring of includes", names, "one of them has a part that the others need; move it out"))
    return faults


def folder_of(header: str) -> str:
    """The module of a header, by its path below include/ansatz; of an umbrella, its own."""
    return header.removeprefix("include/").removeprefix("ansatz/").split("/")[0].removesuffix(".hpp")


def above_their_place(headers: list[str]) -> list[str]:
    """No header includes one of a higher folder, and the frame names nothing that stands on it."""
    faults: list[str] = []
    for header in headers:
        folder = folder_of(header)
        if is_umbrella(header) or folder not in LAYERS:
            continue
        for include in INCLUDE.findall(text_of(header)):
            if LAYERS.get(folder_of(include), len(LAYERS)) > LAYERS[folder]:
                faults.append(fault("an include of a higher folder", f"{header}: {include}",
                                    f"{folder}/ stands below it; let the module tell the frame by a hook or a door"))
        if folder == "world":
            code = NOT_CODE.sub(lambda found: "\n" * found.group().count("\n"), text_of(header))
            faults += [fault("the frame names what a module has", f"{header}:{number}: {found.group()}",
                             "it belongs to that module, which the frame tells by a hook")
                       for number, line in enumerate(code.split("\n"), start=1) for found in OF_A_MODULE.finditer(line)]
    return faults


def switched_off(pattern: re.Pattern[str], files: list[str]) -> list[str]:
    """No test is switched off: the lines that do so."""
    return [
        fault("switched off", f"{file}:{number}", line.lstrip(" ").rstrip(" \t"))
        for file in files for number, line in enumerate(text_of(file).split("\n"), start=1) if pattern.search(line)]


def is_source(file: str) -> bool:
    """A program, by its name or by its first line."""
    if SOURCE.fullmatch(file):
        return True
    with open(file, "rb") as stream:
        return stream.read(2) == b"#!"


def unlicensed_and_long(headers: list[str]) -> list[str]:
    """Each source says its license, and no header is too long to read."""
    sources = files_below(
        ".*", "tests", "chapters", "exercises", "tools", "cmake", "docs", ".ci", "CMakeLists.txt", "workbook")
    faults = [fault("no SPDX line", file, f"it says in a comment: {SPDX}")
              for file in sources if is_source(file) and SPDX not in text_of(file)]
    faults += [fault("no SPDX line", header, f"its first line is: // {SPDX}")
               for header in headers if text_of(header).split("\n")[0] != f"// {SPDX}"]
    faults += [fault("too long", header, f"more than {LONGEST} lines; one policy or one algorithm a file")
               for header in headers if len(text_of(header).removesuffix("\n").split("\n")) > LONGEST]
    return faults


def main(arguments: list[str]) -> int:
    """Prints the faults, and how much was looked at."""
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(prog="tools/mirror", description="Lists what one of the five trees lacks.")
    parser.add_argument("folder", nargs="?", default=f"{here}/../..", help="the project's folder")
    os.chdir(parser.parse_args(arguments).folder)
    headers = files_below(r".*\.hpp", "include/ansatz")
    tests = files_below(r".*\.[ch]pp", "tests")
    mentions = files_below(r".*\.([ch]pp|md|dox)", "chapters", "docs")
    faults = untested_and_unmentioned(headers, tests, mentions) + beside_their_umbrellas(headers)
    faults += switched_off(OFF_IN_CODE, files_below(r".*\.[ch]pp", "tests", "chapters", "exercises"))
    faults += switched_off(
        OFF_IN_BUILD, files_below(r".*(\.cmake|CMakeLists\.txt)", "tests", "chapters", "exercises", "cmake"))
    faults += unlicensed_and_long(headers) + rings_of_includes(headers) + above_their_place(headers)
    if faults:
        faults.append(f"mirror: {len(faults)} faults in {len(headers)} headers and {len(tests)} test files")
    else:
        print(f"mirror: {len(headers)} headers, {len(tests)} test files, nothing missing")
    sys.stdout.buffer.write("".join(f"{line}\n" for line in faults).encode("utf-8", "surrogateescape"))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
