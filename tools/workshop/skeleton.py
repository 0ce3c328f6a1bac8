# SPDX-License-Identifier: BSL-1.0
"""Makes the skeleton of an exercise from its solution, so that the two cannot drift apart.

    // task 1: todo(1);          becomes the line after the colon;
    x += v * dt;                 the lines of the answer are left out,
    // end of task 1             and so is this one.

Where the first tasks are taken as solved, their answers stay and only their marks go.
"""

from __future__ import annotations

import argparse
import os
import re
import sys

BEGIN = re.compile(r"( *)// task ([0-9]+): (.*)", re.DOTALL)
END = re.compile(r" *// end of task [0-9]+")


def read(file: str) -> str:
    """The text of a file, whatever bytes are in it."""
    with open(file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        return stream.read()


def write(file: str, text: str) -> None:
    """Writes what `read` would read, byte for byte."""
    with open(file, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
        stream.write(text)


def lines_of(text: str) -> list[str]:
    """The lines of a text, the last of which may end without a newline."""
    lines = text.split("\n")
    return lines[:-1] if lines[-1] == "" else lines


def skeleton(solution: str, solved: int = 0) -> str:
    """The solution with its tasks open, but for the first `solved`."""
    kept: list[str] = []
    inside = False
    for line in lines_of(solution):
        begins = BEGIN.match(line)
        if begins:
            if int(begins[2]) > solved:
                kept.append(begins[1] + begins[3])
                inside = True
        elif END.match(line):
            inside = False
        elif not inside:
            kept.append(line)
    return "".join(line + "\n" for line in kept)


def tasks_of(solution: str) -> int:
    """The highest number of a task; 0 where none is marked."""
    marks = (BEGIN.match(line) for line in lines_of(solution))
    return max((int(mark[2]) for mark in marks if mark), default=0)


def write_all(solution: str, folder: str) -> list[str]:
    """Writes skeleton.hpp and, for each n below the number of tasks, skeleton.<n>.hpp. Returns their names."""
    names: list[str] = []
    for solved in range(max(tasks_of(solution), 1)):
        names.append(f"skeleton.{solved}" if solved else "skeleton")
        write(os.path.join(folder, names[-1] + ".hpp"), skeleton(solution, solved))
    return names


def is_untouched(exercise: str) -> bool:
    """Whether an exercise's exercise.hpp is the skeleton of its solution, letter by letter."""
    try:
        return read(os.path.join(exercise, "exercise.hpp")) == skeleton(read(os.path.join(exercise, "solution.hpp")))
    except (FileNotFoundError, NotADirectoryError):
        return False


def main(arguments: list[str]) -> int:
    """Ends with 1 where a file cannot be read or written."""
    parser = argparse.ArgumentParser(prog="skeleton.py", description="Makes the skeleton of an exercise.")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--all", metavar="FOLDER", help="write all skeletons of the solution there and print their names")
    what.add_argument("--untouched", action="store_true", help="print those exercises whose answer nobody has begun")
    parser.add_argument("paths", nargs="+", metavar="PATH", help="a solution.hpp; or, with --untouched, exercises")
    given = parser.parse_args(arguments)
    if not given.untouched and len(given.paths) > 1:
        parser.error("one solution.hpp at a time")
    try:
        if given.untouched:
            said = "".join(path + "\n" for path in given.paths if is_untouched(path))
        elif given.all:
            said = "".join(name + "\n" for name in write_all(read(given.paths[0]), given.all))
        else:
            said = skeleton(read(given.paths[0]))
    except OSError as error:
        print(f"skeleton.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    sys.stdout.buffer.write(said.encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
