# SPDX-License-Identifier: BSL-1.0
"""What is missing in the hints of an exercise: for each task its hints.md has four headings with a text below each,

    ## Task 1: a question
    ## Task 1: the place
    ## Task 1: the shape
    ## Task 1: the key line
"""

from __future__ import annotations

import argparse
import re
import sys

LEVELS = ("question", "place", "shape", "line")


def missing(hints: str, tasks: int) -> list[str]:
    """A sentence for each heading that is not there for the tasks 1 to `tasks`, or that has no text below it."""
    parts = re.split(r"^## ", hints, flags=re.MULTILINE)[1:]
    sentences: list[str] = []
    for task in range(1, tasks + 1):
        for level in LEVELS:
            headings = [part.partition("\n") for part in parts]
            texts = [text for heading, _, text in headings
                     if heading.startswith(f"Task {task}: ") and level in heading.lower()]
            if not texts:
                sentences.append(f"hints.md has no '## Task {task}: the {level}'")
            elif not any(text.strip() for text in texts):
                sentences.append(f"hints.md has no text below '## Task {task}: the {level}'")
    return sentences


def main(arguments: list[str]) -> int:
    """A file that is not there has no hints."""
    parser = argparse.ArgumentParser(prog="hints.py", description="Prints what is missing in an exercise's hints.")
    parser.add_argument("file", help="the hints.md")
    parser.add_argument("tasks", type=int, help="how many tasks the exercise has")
    given = parser.parse_args(arguments)
    try:
        with open(given.file, encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            text = stream.read()
    except OSError:
        text = ""
    print("".join(sentence + "\n" for sentence in missing(text, given.tasks)), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
