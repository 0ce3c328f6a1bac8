# SPDX-License-Identifier: BSL-1.0
"""What of the build a change concerns.

    git diff --name-only | touched.py <project> <build folder> [seconds]

Every program knows from the compiler which files it was made from (ninja's record of it). A policy's header, however, is read by
all that include <ansatz/world.hpp>, and concerns only those that name it: a template that nobody names is not compiled. So of what
was made from a header of the library, what names nothing of it is left to a whole `./workbook test`. A name of it is what stands
at the beginning of its lines (the layout is clang-format's), and what other headers declare in which such a name stands. Where a
header declares an operator at that level, which is found without a name, whoever includes it is concerned.

With a number of seconds, no more is chosen than the compiler needs so long for, one after the other, by what it needed before:
first what always runs, what was changed itself and the tests of the changed headers, then what is quick. A verdict that comes in
minutes is asked for after every change; the rest waits for a whole `./workbook test`.

It prints lines of
    object <object>              to be built
    left <number>                how many were made from the changed files and name nothing of them
    late <number> <seconds>      how many name something of them and would take longer, and how much longer
    program <module> <command>   that links the chosen objects of a module's tests into <build folder>/touched/test_<module>
    section <number>   exercise <module>.<name>   mistake <name>   script <module>.<name>
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

# Built and run after every change: quick, and each goes through much of the library.
ALWAYS = ("tests/motion/newton.cpp", "tests/motion/momentum.cpp", "tests/performance/bytes.cpp", "tests/springs/hooke.cpp",
          "tests/paths/a_star.cpp", "tests/units/vector.cpp")
UNKNOWN = 15.0    # seconds that an object takes of which nothing is known
MISTAKE = 4.0     # seconds that the compiler takes to refuse one
KEYWORDS = {"alignas", "alignof", "decltype", "explicit", "if", "noexcept", "requires", "sizeof", "static_assert"}
TOKEN = re.compile(r"[A-Za-z_]\w*")
INCLUDE = re.compile(r'^#include (?:"([^"]+)"|<(ansatz/[^>]+)>)', flags=re.MULTILINE)
OF_SECTION = re.compile(r"chapters/CMakeFiles/section_([0-9.]+)\.dir/(.*\.cpp)\.o$")
OF_TEST = re.compile(r"tests/CMakeFiles/test_([a-z_]+)\.dir/(.*\.cpp)\.o$")


def code_of(text: str) -> str:
    """Without comments and texts."""
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', " ", text, flags=re.DOTALL)


def tokens_of(text: str) -> set[str]:
    """The identifiers of the code."""
    return set(TOKEN.findall(code_of(text)))


def without_templates(line: str) -> str:
    """A line without the lists of parameters at its beginning."""
    while match := re.match(r"\s*template\s*<", line):
        depth, at = 1, match.end()
        while at < len(line) and depth:
            depth += {"<": 1, ">": -1}.get(line[at], 0)
            at += 1
        line = line[at:]
    return line


def declared_in(text: str) -> tuple[set[str], bool]:
    """What a header declares outside of its classes, and whether something of it is found without a name."""
    names = set(re.findall(r"^#\s*define\s+(\w+)", text, flags=re.MULTILINE))
    for line in code_of(text).splitlines():
        if not line or line[0] in " #}\t" or line.startswith(("namespace", "using namespace")):
            continue
        line = without_templates(line)
        if re.search(r"\boperator\b", line):
            return names, True
        names.update(re.findall(r"\b(?:struct|class|union|enum|concept|using)\s+(?:\[\[[^\]]*\]\]\s*)?(\w+)", line))
        names.update(re.findall(r"\b(\w+)\s*\(", line))
        if "constexpr" in line and (constant := re.search(r"\b(\w+)\s*(?:\[\])?\s*(?:=|\{)", line)):
            names.add(constant[1])
    return names - KEYWORDS - {""}, False


class Library:
    """The headers, who includes whom, and who names what."""

    def __init__(self, project: Path) -> None:
        self.headers = {str(path.relative_to(project)): path.read_text(encoding="utf-8")
                        for path in sorted((project / "include").rglob("*.hpp"))}
        self.tokens = {header: tokens_of(text) for header, text in self.headers.items()}
        self.includes = {header: {"include/" + name for name in re.findall(r"#\s*include\s*<(ansatz/[^>]+)>", text)}
                         for header, text in self.headers.items()}

    def includers(self, header: str) -> set[str]:
        """Who includes it, or somebody who does."""
        found, before = {header}, 0
        while len(found) != before:
            before = len(found)
            found |= {one for one, included in self.includes.items() if included & found}
        return found

    def concerned(self, header: str) -> tuple[set[str], set[str], bool]:
        """The names by which a change of this header is reached, the headers in which they are declared, and whether it is
        reached without any."""
        if header not in self.headers:
            return set(), {header}, True    # it is gone
        names, nameless = declared_in(self.headers[header])
        reached, candidates = {header}, self.includers(header) - {header}
        grown = True
        while grown and not nameless:
            grown = False
            for other in candidates - reached:
                if self.tokens[other] & names:
                    more, operators = declared_in(self.headers[other])
                    reached.add(other)
                    names |= more
                    nameless |= operators
                    grown = True
        return names, reached, nameless


def read_by(project: Path, source: Path) -> list[str]:
    """The project's files that a source includes, by their place in it, in tools or beside the source: what is known of one that was
    never built. More than the compiler reads, where an include is left out by a condition."""
    found: dict[Path, None] = {source: None}
    to_read = [source]
    while to_read:
        reader = to_read.pop()
        for quoted, bracketed in INCLUDE.findall(reader.read_text(encoding="utf-8", errors="replace")):
            places = ([folder / quoted for folder in (reader.parent, project, project / "tools")] if quoted
                      else [project / "include" / bracketed])
            if (place := next((one for one in places if one.is_file()), None)) and place not in found:
                found[place] = None
                to_read.append(place)
    return [str(place) for place in found]


def deps_of(project: Path, build: Path) -> dict[str, list[str]]:
    """The files that each object was made from, as ninja knows it. Of tests and sections, which are compiled together (see
    cmake/Together.cmake), those that were never built by themselves have what their text includes; anything else that was never
    built has nothing."""
    objects: dict[str, list[str]] = {}
    targets = subprocess.run(["ninja", "-C", str(build), "-t", "targets", "all"], capture_output=True, text=True, check=True)
    for name in re.findall(r"^(\S+\.o): CXX_COMPILER__", targets.stdout, flags=re.MULTILINE):
        objects[name] = []
    record = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=True)
    current: list[str] = []
    for line in record.stdout.splitlines():
        if match := re.match(r"(\S+): #deps \d+", line):
            current = objects[match[1]] = []
        elif line.startswith("    ") and not line.startswith("    /usr/"):
            current.append(line[4:])
    for name, files in objects.items():
        for tree, pattern in (("tests", OF_TEST), ("chapters", OF_SECTION)):
            if not files and (match := pattern.match(name)) and (source := project / tree / match[2]).is_file():
                files.extend(read_by(project, source))
    return objects


def choose(project: Path, build: Path, changed: set[str], objects: dict[str, list[str]]) -> tuple[list[str], int]:
    """The objects that the change concerns, and how many more were made from what was changed."""
    library = Library(project)
    concerned = {header: library.concerned(header) for header in changed if header.startswith("include/")}

    @cache
    def place(path: str) -> str:
        return os.path.relpath(os.path.normpath(build / path), project)

    @cache
    def tokens(path: str) -> frozenset[str]:
        file = project / path
        return frozenset(tokens_of(file.read_text(encoding="utf-8", errors="replace"))) if file.is_file() else frozenset()

    chosen, left = [], 0
    for name, files in objects.items():
        made_from = {place(file) for file in files}
        touched = made_from & changed
        own = {file for file in made_from if not file.startswith(("include/", "../"))}
        alone = re.search(r"headers_alone/(ansatz/.*)\.cpp\.o$", name)
        if not files or touched - concerned.keys() or any(file in ALWAYS for file in own):
            chosen.append(name)
        elif any(nameless or ("include/" + alone[1] in reached if alone else any(names & tokens(file) for file in own))
                 for names, reached, nameless in (concerned[header] for header in touched)):
            chosen.append(name)
        elif touched:
            left += 1
    return chosen, left


def seconds_of(log: Path) -> dict[str, float]:
    """How long the compiler needed for each object, by ninja's log: the longest, and none under a second, which is the compiler's
    cache."""
    seconds: dict[str, float] = {}
    if log.is_file():
        for line in log.read_text(encoding="utf-8", errors="replace").splitlines():
            fields = line.split("\t")
            if len(fields) > 3 and fields[0].isdigit() and fields[1].isdigit():
                seconds[fields[3]] = max(seconds.get(fields[3], 0.0), (int(fields[1]) - int(fields[0])) / 1000)
    return {name: needed for name, needed in seconds.items() if needed >= 1}


def comes_first(name: str, files: list[str], changed: set[str], place: Callable[[str], str]) -> bool:
    """Whether an object is built whatever it takes: one that always is or never was, one whose own files were
    changed, the test of a changed header, and that header alone."""
    made_from = {place(file) for file in files}
    headers = {file.removeprefix("include/ansatz/").removesuffix(".hpp") for file in changed if file.startswith("include/")}
    return (not made_from or not made_from.isdisjoint(ALWAYS) or any(not file.startswith("include/") for file in made_from & changed)
            or any(f"tests/{header}.cpp" in made_from or f"headers_alone/ansatz/{header}.hpp.cpp" in name
                   for header in headers))


def within(limit: float, chosen: list[str], first: set[str], seconds: dict[str, float]) -> tuple[list[str], float]:
    """As many as the compiler is done with in so many seconds, the quick ones before the others; and how many seconds what is
    left would take."""
    kept, late = [], 0.0
    for name in sorted(chosen, key=lambda one: (one not in first, seconds.get(one, UNKNOWN))):
        cost = seconds.get(name, UNKNOWN)
        if name in first or cost <= limit:
            kept.append(name)
            limit -= cost
        else:
            late += cost
    return sorted(kept), late


def link_command(build: Path, module: str, chosen: set[str]) -> str:
    """How the tests of a module are linked, with its chosen objects alone."""
    commands = subprocess.run(["ninja", "-C", str(build), "-t", "commands", f"tests/test_{module}"],
                              capture_output=True, text=True, check=True).stdout.splitlines()
    link = re.sub(r"^: && ", "", commands[-1]).split(" && ")[0]
    own = f"tests/CMakeFiles/test_{module}.dir/"
    words = [word for word in link.split() if not word.startswith(own) or word in chosen]
    words[words.index("-o") + 1] = f"touched/test_{module}"
    return " ".join(words)


def mistakes_of(project: Path, changed: set[str]) -> list[str]:
    """The mistakes that must not compile and were changed, or name something of what was."""
    library = Library(project)
    names: set[str] = set()
    for header in changed:
        if header.startswith("include/"):
            names |= library.concerned(header)[0]
    return [mistake.stem for mistake in sorted((project / "tests/must_not_compile").glob("*.cpp"))
            if str(mistake.relative_to(project)) in changed or tokens_of(mistake.read_text(encoding="utf-8")) & names]


def main(arguments: list[str]) -> int:
    """As the module's description says."""
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    project, build = (Path(argument).resolve() for argument in arguments[:2])
    changed = {line.strip() for line in sys.stdin if line.strip()}
    objects = deps_of(project, build)
    chosen, left = choose(project, build, changed, objects)
    ignored = re.compile(r"^peers/|/peer[^/]*\.dir/|_perf\.dir/|costs_[a-z_]+\.dir/|/(student|measured)\.dir/|/play\.|"
                         r"_together\.dir/|/sections_[a-z_]+\.dir/|\.(student|measured)\.dir/|test_precompiled\.dir/|test_main\.dir/|third_party")
    kept = [name for name in chosen if not ignored.search(name)]
    mistakes = mistakes_of(project, changed)
    if len(arguments) == 3:
        def place(path: str) -> str:
            return os.path.relpath(os.path.normpath(build / path), project)

        first = {name for name in kept if comes_first(name, objects[name], changed, place)}
        taken, late = within(float(arguments[2]) - MISTAKE * len(mistakes), kept, first, seconds_of(build / ".ninja_log"))
        print("late", len(kept) - len(taken), round(late))
        kept = taken
    modules = sorted({match[1] for name in kept if (match := OF_TEST.match(name))})
    for name in kept:
        if match := OF_SECTION.match(name):
            print("section", match[1])
        elif match := re.match(r"exercises/CMakeFiles/exercise\.([a-z_]+\.[a-z_0-9]+)\.others\.dir/", name):
            print("exercise", match[1])
        else:
            print("object", name)
    for module in modules:
        print("program", module, link_command(build, module, set(kept)))
    for mistake in mistakes:
        print("mistake", mistake)
    for file in sorted(changed):
        if match := re.match(r"tests/([a-z_]+)/([a-z_]+)\.sh$", file):
            print(f"script {match[1]}.{match[2]}")
    print("left", left)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
