# SPDX-License-Identifier: BSL-1.0
"""How much of the library a reader meets who follows one step into its depth:

    call_tree.py <callgrind's output> [--from "World<.*>::step"] [--list]

prints how many functions of include/ansatz are called from there, and in how many files they stand. Instances of one
template, and the lambdas of one function, count once. What is compiled must have debug information and no optimisation
(`-O0 -g`); tests/performance/call_tree.sh makes it.
"""

from __future__ import annotations

import argparse
import re
import sys
from dataclasses import dataclass, field

ENTRY = re.compile(r"\((\d+)\)(?: (.*))?")


@dataclass
class Calls:
    """Who calls whom, and where functions stand."""
    file_of: dict[str, str] = field(default_factory=dict)
    called: dict[str, set[str]] = field(default_factory=dict)


def plain(name: str) -> str:
    """The name of a function without the arguments of templates and of calls; a lambda counts to who makes it."""
    name = re.sub(r"operator(<=>|<<|>>|<=|>=|->|<|>)", "operator?", name)
    name = re.sub(r"\{lambda.*", "", name.replace("(anonymous namespace)::", ""))
    kept, depth = [], 0
    for letter in name:
        depth += letter in "<("
        if depth == 0:
            kept.append(letter)
        depth -= letter in ">)"
    words = "".join(kept).replace("[abi:cxx11]", "").split()
    found = next((word for word in words if "::" in word or word == words[-1]), "")
    return found.rstrip(":")


def read(lines: list[str]) -> Calls:
    """The graph of callgrind's format: names are given once, with a number, and by the number from then on."""
    calls = Calls()
    files: dict[str, str] = {}
    functions: dict[str, str] = {}
    file = caller = callee = ""

    def named(known: dict[str, str], text: str) -> str:
        match = ENTRY.fullmatch(text)
        if not match:
            return text
        if match[2]:
            known[match[1]] = match[2]
        return known[match[1]]

    callee_file = ""
    for line in lines:
        key, _, value = line.partition("=")
        if key == "fl":
            file = named(files, value)
        elif key == "fn":
            caller = named(functions, value)
            calls.file_of.setdefault(caller, file)
        elif key in ("cfi", "cfl"):
            callee_file = named(files, value)
        elif key in ("fi", "fe"):
            named(files, value)
        elif key == "cfn":
            callee = named(functions, value)
            calls.called.setdefault(caller, set()).add(callee)
            calls.file_of.setdefault(callee, callee_file or file)
            callee_file = ""
    return calls


def below(calls: Calls, start: re.Pattern[str]) -> set[str]:
    """All that is called from functions of this name."""
    waiting = [name for name in calls.file_of if start.search(name)]
    found: set[str] = set(waiting)
    while waiting:
        for name in calls.called.get(waiting.pop(), set()) - found:
            found.add(name)
            waiting.append(name)
    return found


def met(calls: Calls, start: re.Pattern[str]) -> dict[str, set[str]]:
    """The functions of the library, by file."""
    rooms: dict[str, set[str]] = {}
    for name in below(calls, start):
        file = calls.file_of[name].rpartition("include/ansatz/")
        if file[1]:
            rooms.setdefault(file[2], set()).add(plain(name))
    return rooms


def main(arguments: list[str]) -> int:
    """Prints the numbers."""
    parser = argparse.ArgumentParser(prog="call_tree.py", description="What one step calls.")
    parser.add_argument("output", help="callgrind's")
    parser.add_argument("--from", dest="start", default=r"World<.*>::step<", help="a regular expression")
    parser.add_argument("--list", action="store_true", help="name them")
    given = parser.parse_args(arguments)
    with open(given.output, encoding="utf-8", errors="replace") as stream:
        rooms = met(read(stream.read().splitlines()), re.compile(given.start))
    if not rooms:
        print(f"nothing of the library is called from {given.start}", file=sys.stderr)
        return 1
    for file, functions in sorted(rooms.items()):
        print(f"{len(functions):4} {file}")
        if given.list:
            for name in sorted(functions):
                print(f"         {name}")
    print(f"{sum(map(len, rooms.values())):4} functions in {len(rooms)} files")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
