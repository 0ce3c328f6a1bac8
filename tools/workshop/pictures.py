# SPDX-License-Identifier: BSL-1.0
"""The pictures that pages show. From the project's folder:

    pictures.py stand-ins <out> --drawn <folder>... -- <texts>
        draws a stand-in into <out> for each that is in none of the folders: it says how to draw it; prints their names
    pictures.py undrawn <texts>
        prints a fault for each that is not in docs/pictures and that no section draws

A text shows one by \\image html 1.7.svg "Its title".
"""

from __future__ import annotations

import argparse
import glob
import os
import re
import sys
from typing import Union

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from workshop import forge  # noqa: E402  (it is run as a file)

STAND_IN = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="640" height="60" viewBox="0 0 640 60"><rect width="640" height="60" fill="#eee"/>'
    '<text x="320" y="35" text-anchor="middle" font-family="sans-serif" font-size="14" fill="#555">'
    "Not drawn yet. {command} draws it; then ./workbook docs shows it here.</text></svg>\n")


DRAWN_WITH_THE_SITE = ["frame.svg"]  # frame_picture.py


def pictures_of(text: str) -> list[str]:
    """Their names, in the order of the text."""
    return [name.replace('"', "") for name in re.findall(r"[\\@]image +html +([^ \n]+)", text)]


def in_order(name: str) -> list[Union[int, str]]:
    """The key that sorts 1.10 behind 1.9, and 1.6 before 1.6.1: text and numbers in turn."""
    return [int(part) if part.isdigit() else part for part in re.split("([0-9]+)", name.removesuffix(".svg"))]


def drawn_by(picture: str) -> str:
    """The command that draws it: a section's picture has its number in its name."""
    if re.match(r"[0-9].*\.svg$", picture):
        return f"./workbook section {picture.removesuffix('.svg').partition('-')[0]}"
    return "./workbook"


def stand_ins(out: str, drawn: list[str], texts: dict[str, str]) -> list[str]:
    """Those that got one."""
    shown = {picture for text in texts.values() for picture in pictures_of(text)}
    missing = [picture for picture in sorted(shown, key=in_order)
               if not any(os.path.isfile(f"{folder}/{picture}") for folder in drawn)]
    for picture in missing:
        with open(f"{out}/{picture}", "w", encoding="utf-8", errors="surrogateescape", newline="\n") as stream:
            stream.write(STAND_IN.format(command=drawn_by(picture)))
    return missing


def of_nobody(texts: dict[str, str]) -> list[str]:
    """A sentence for each that is there nowhere."""
    faults: list[str] = []
    for file, text in texts.items():
        for picture in pictures_of(text):
            number = re.sub(r"[-.][a-z].*$", "", picture)
            program = f"chapters/*/{glob.escape(number)}-*.cpp"
            if picture not in DRAWN_WITH_THE_SITE and not os.path.isfile(f"docs/pictures/{picture}") \
                    and not glob.glob(program):
                faults.append(f"{file} shows {picture}, which no section draws")
    return faults


def main(arguments: list[str]) -> int:
    """Prints names, or faults."""
    parser = argparse.ArgumentParser(prog="pictures.py", description="The pictures that pages show.")
    asked = parser.add_subparsers(dest="asked", required=True)
    making = asked.add_parser("stand-ins", help="draws a stand-in for each that is not drawn yet")
    making.add_argument("out", help="the folder of the stand-ins")
    making.add_argument("--drawn", nargs="+", required=True, help="the folders of the pictures that are there")
    checking = asked.add_parser("undrawn", help="the faults: pictures that nobody draws")
    for kind in (making, checking):
        kind.add_argument("texts", nargs="+", help="the pages that show them")
    given = parser.parse_args(arguments)
    texts: dict[str, str] = {}
    for file in given.texts:
        texts[file] = forge.page(file)
    lines = stand_ins(given.out, given.drawn, texts) if given.asked == "stand-ins" else of_nobody(texts)
    sys.stdout.buffer.write("".join(line + "\n" for line in lines).encode("utf-8", "surrogateescape"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
