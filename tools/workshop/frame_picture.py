# SPDX-License-Identifier: BSL-1.0
"""The drawing of the page about the frame, made from the headers. From the project's folder:

    frame_picture.py include/ansatz > frame.svg

To the left the rooms of the library, each with the number of its headers, and an arrow to those whose headers it
includes (not where the way leads through another room). To the right a step: the phases, and which systems of the
library stand there; a driver is a bar beside the phases that it owns.
"""

from __future__ import annotations

import argparse
import glob
import os
import re
import sys
from dataclasses import dataclass
from xml.sax.saxutils import escape

INCLUDE = re.compile(r"^#include <ansatz/(\w+)/", re.MULTILINE)
PHASE = re.compile(r"inline constexpr Phase (\w+)\{([0-9.]+)\};\s*///< (.*)")
BETWEEN = re.compile(r"inline constexpr Phase (\w+) = between\((\w+), (\w+)\);\s*///< (.*)")
SYSTEM = re.compile(r"static constexpr Phase phase = phases::(\w+)(?:, until = phases::(\w+))?;\s*"
                    r'static constexpr std::string_view name = "([^"]+)";')
COLOURS = {"world": "#5b6c7d", "motion": "#2c6e91", "collision": "#a4532a"}


@dataclass
class System:
    """What is done at a phase."""
    name: str
    room: str
    phase: str
    until: str


@dataclass
class Phase:
    """A place in the order of a step."""
    name: str
    at: float
    what: str


def headers_of(folder: str) -> dict[str, dict[str, str]]:
    """The text of each header, by room and path."""
    rooms: dict[str, dict[str, str]] = {}
    for path in sorted(glob.glob(f"{glob.escape(folder)}/*/**/*.hpp", recursive=True)):
        room = os.path.relpath(path, folder).split(os.sep)[0]
        with open(path, encoding="utf-8") as stream:
            rooms.setdefault(room, {})[path] = stream.read()
    return rooms


def arrows_of(rooms: dict[str, dict[str, str]]) -> dict[str, set[str]]:
    """Which rooms each one includes."""
    return {room: {to for text in headers.values() for to in INCLUDE.findall(text)} - {room}
            for room, headers in rooms.items()}


def reached(arrows: dict[str, set[str]], start: str) -> set[str]:
    """All rooms below one."""
    found: set[str] = set()
    waiting = [start]
    while waiting:
        for to in arrows.get(waiting.pop(), set()) - found:
            found.add(to)
            waiting.append(to)
    return found


def reduced(arrows: dict[str, set[str]]) -> dict[str, set[str]]:
    """Without those that a way through another room says already."""
    return {room: {to for to in below if not any(to in reached(arrows, other) for other in below - {to})}
            for room, below in arrows.items()}


def storeys(arrows: dict[str, set[str]]) -> dict[str, int]:
    """How many rooms stand below each, one upon another. Rooms in a ring are refused."""
    known: dict[str, int] = {}

    def storey(room: str, way: tuple[str, ...]) -> int:
        if room in way:
            raise ValueError("rooms include each other in a ring: " + " -> ".join((*way, room)))
        if room not in known:
            known[room] = max((1 + storey(to, (*way, room)) for to in sorted(arrows.get(room, set()))), default=0)
        return known[room]

    for room in sorted(arrows):
        storey(room, ())
    return known


def phases_of(rooms: dict[str, dict[str, str]]) -> list[Phase]:
    """In their order."""
    texts = [text for headers in rooms.values() for text in headers.values()]
    phases = {name: Phase(name, float(at), what) for text in texts for name, at, what in PHASE.findall(text)}
    for text in texts:
        for name, before, behind, what in BETWEEN.findall(text):
            phases[name] = Phase(name, (phases[before].at + phases[behind].at) / 2, what)
    return sorted(phases.values(), key=lambda phase: phase.at)


def systems_of(rooms: dict[str, dict[str, str]]) -> list[System]:
    """Those of the library, by room and name."""
    return [System(name, room, phase, until) for room, headers in sorted(rooms.items())
            for _, text in sorted(headers.items()) for phase, until, name in SYSTEM.findall(text)]


def text_at(x: float, y: float, text: str, size: int = 13, colour: str = "#222", more: str = "") -> str:
    """A line of text."""
    return f'<text x="{x:g}" y="{y:g}" font-size="{size}" fill="{colour}" {more}>{escape(text)}</text>'


def rooms_drawn(rooms: dict[str, dict[str, str]], height: float) -> list[str]:
    """The panel to the left."""
    arrows = arrows_of(rooms)
    storey = storeys(arrows)
    rows: dict[int, list[str]] = {}
    for room in sorted(rooms):
        rows.setdefault(storey[room], []).append(room)
    apart = (height - 120) / max(len(rows) - 1, 1)
    place: dict[str, tuple[float, float]] = {}
    for row, there in rows.items():
        for number, room in enumerate(there):
            place[room] = (170 + (number - (len(there) - 1) / 2) * 115, height - 60 - row * apart)
    lines = [text_at(20, 28, "Rooms: who includes whom", 15, "#222", 'font-weight="bold"')]
    for room, below in sorted(reduced(arrows).items()):
        for to in sorted(below):
            (x, y), (end_x, end_y) = place[room], place[to]
            lines.append(f'<line x1="{x:g}" y1="{y + 20:g}" x2="{end_x:g}" y2="{end_y - 24:g}" stroke="#888" '
                         'stroke-width="1.4" marker-end="url(#head)"/>')
    for room, (x, y) in place.items():
        colour = COLOURS.get(room, "#777")
        lines += [f'<rect x="{x - 50:g}" y="{y - 20:g}" width="100" height="40" rx="6" fill="{colour}"/>',
                  text_at(x, y - 2, room, 14, "#fff", 'text-anchor="middle" font-weight="bold"'),
                  text_at(x, y + 13, "1 header" if len(rooms[room]) == 1 else f"{len(rooms[room])} headers", 10, "#fff", 'text-anchor="middle"')]
    return lines


def step_drawn(phases: list[Phase], systems: list[System], left: float) -> tuple[list[str], float]:
    """The panel to the right, and how high it is."""
    lines = [text_at(left, 28, "A step: phases, and the systems that stand there", 15, "#222", 'font-weight="bold"')]
    top: dict[str, float] = {}
    y = 56.0
    for phase in phases:
        top[phase.name] = y
        lines += [text_at(left + 40, y, phase.name, 13, "#222", 'font-weight="bold"'),
                  text_at(left + 130, y, phase.what.replace("`", ""), 11, "#777")]
        y += 18
        for system in systems:
            if system.phase == phase.name:
                owns = ": a driver, it owns the phases along the bar" if system.until else ""
                lines.append(text_at(left + 52, y, f"{system.name} ({system.room}){owns}", 12,
                                     COLOURS.get(system.room, "#777")))
                y += 16
        y += 6
    for number, system in enumerate(one for one in systems if one.until):
        x = left + 24 - 10 * number
        lines.append(f'<rect x="{x:g}" y="{top[system.phase] - 10:g}" width="5" '
                     f'height="{top[system.until] - top[system.phase] - 8:g}" rx="2" '
                     f'fill="{COLOURS.get(system.room, "#777")}"/>')
    return lines, y


def drawing(rooms: dict[str, dict[str, str]]) -> str:
    """The whole of it."""
    step, height = step_drawn(phases_of(rooms), systems_of(rooms), 370)
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="960" height="{height:g}" viewBox="0 0 960 {height:g}" '
        'font-family="sans-serif">',
        '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        '<path d="M0,0 L8,4 L0,8 z" fill="#888"/></marker></defs>',
        f'<rect width="960" height="{height:g}" fill="#fff"/>',
        *rooms_drawn(rooms, height), *step, "</svg>", ""])


def main(arguments: list[str]) -> int:
    """Prints it."""
    parser = argparse.ArgumentParser(prog="frame_picture.py", description="The drawing of the frame.")
    parser.add_argument("include", help="the folder of the library's rooms")
    given = parser.parse_args(arguments)
    sys.stdout.write(drawing(headers_of(given.include)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
