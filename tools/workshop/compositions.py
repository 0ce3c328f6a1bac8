# SPDX-License-Identifier: BSL-1.0
"""Draws compositions for the fuzzer of worlds (tests/fuzz), and writes their sources.

    compositions.py <folder> [--count 6] [--seed 1]

Each axis of a world (integrator, broadphase, response and so on) is a list of choices in an order that the seed shuffles, and the
compositions go round through each: every choice is there before one comes a second time. What cannot stand together is refused by
the compiler, so the rules for that are here: the next choice is taken first. A composition of one seed and number is always the
same one. Those of one space stand together, up to six in a source: each costs the compiler a third of what it costs alone.
Files whose text stays are not written again, so that nothing is compiled anew for them, and those of another drawing go.

It prints the names of the files.
"""

from __future__ import annotations

import argparse
import os
import random
import re
import sys
from dataclasses import dataclass
from functools import partial
from typing import Callable

SHAPES = "Narrowphase<Sphere, Plane, Box>"
AXES: dict[str, list[str]] = {
    "integrator": ["SemiImplicitEuler{}", "Verlet{}", "VelocityVerlet{}", "RungeKutta4{}", "ExplicitEuler{}", "ImplicitEuler{}"],
    "space": ["Space<double, 3>{}", "Space<float, 2>{}", "Space<double, 2>{}", "Space<float, 3>{}"],
    "forces": ["", "Gravity{}", "", "Gravity{}, Drag{0.5 / second}", "Drag{0.5 / second}"],
    "applied": ["AppliedForces{}", ""],
    "elements": ["", "Springs<>{}", "Springs<Breaking>{}"],
    "rest": ["Rest{}", "Rest{}", ""],
    "broadphase": ["SortAndSweep", "UniformGrid<>", "Octree<>", "BinarySplit<>", "Octree<SortAndSweep>", "AllPairs"],
    "narrowphase": [SHAPES + "{}", SHAPES + "{}", f"Swept<{SHAPES}>{{}}"],
    "response": ["Impulse<>{}, Projection{1e-3 * metre}", "SoftSubsteps<Friction>{}", "Impulse<>{}", "SoftSubsteps<>{}",
                 "Impulse<Friction>{}, Projection{}", "Penalty{2e3 * newton_per_metre, 8.0 * newton_second_per_metre}",
                 "Projection{}", "SoftSubsteps<Friction, Coloured>{}"],
}
TOGETHER = 6    # in a source: the compiler takes 1.3 GB for it
HEAD = """// SPDX-License-Identifier: BSL-1.0
// Compiled alone: worlds of its own. Made by tools/workshop/compositions.py.
// Runs long with the sanitizers.
#include "tests/fuzz/subject_of.hpp"

#include <nlohmann/json.hpp>
"""
TEMPLATE = """
namespace composition_{number} {{
auto world(bool every_pair) {{
    using namespace ansatz;
    return World{{{typed}}};
}}
const fuzz::Registered registered{{{number}, fuzz::subject({{
    .text = "{text}",
    .other = "{other}",
{facts}}}, world)}};
}} // namespace composition_{number}
"""


@dataclass
class Composition:
    """What is chosen on each axis."""

    chosen: dict[str, str]

    def policies(self, broadphase: str) -> str:
        """The list as it stands in World{...}."""
        axes = self.chosen | {"broadphase": broadphase}
        return ", ".join(choice for choice in [*axes.values(), "Keep<InverseMass>{}", "Datum<int>{}"] if choice)

    def facts(self) -> dict[str, bool]:
        """What it promises, by the names of fuzz::Facts."""
        forces, response = self.chosen["forces"], self.chosen["response"]
        falls, soft, swept = "Gravity" in forces, "Soft" in response, "Swept" in self.chosen["narrowphase"]
        return {
            "falls": falls,
            "closed": forces == "",
            "settles": falls and response != "Projection{}",
            "stays": "Projection" not in response and "Penalty" not in response and not soft and not swept,
            "keeps_energy": not falls and "Penalty" not in response,
            "soft": soft,
            "bounded": "Penalty" not in response and self.chosen["elements"] == "",
        }

    def source(self, number: int) -> str:
        """Its part of a file."""
        broadphase = self.chosen["broadphase"]
        return TEMPLATE.format(
            number=number, typed=self.policies(f"fuzz::Either<{broadphase}>{{{{}}, every_pair}}"),
            text=self.policies(broadphase + "{}"), other=self.policies("BoundingBoxes{}"),
            facts="".join(f"    .{name} = {str(holds).lower()},\n" for name, holds in self.facts().items()))


def can_be(chosen: dict[str, str], axis: str, choice: str) -> bool:
    """Whether a choice can stand beside those of the axes before it."""
    implicit = chosen.get("integrator") == "ImplicitEuler{}"
    if implicit and axis == "elements":
        return choice == ""    # springs would need a solver of many bodies
    if implicit and axis == "response":
        return "Penalty" not in choice and "Soft" not in choice
    return True


def shuffled(choices: list[str], below: Callable[[int], int]) -> list[str]:
    """Fisher and Yates, by our own hand: random.shuffle may differ from one Python to the next."""
    choices = list(choices)
    for i in range(len(choices) - 1, 0, -1):
        k = below(i + 1)
        choices[i], choices[k] = choices[k], choices[i]
    return choices


class Axis:
    """Goes round through the choices of an axis, each time in another order."""

    def __init__(self, choices: list[str], below: Callable[[int], int]) -> None:
        self.choices, self.below = choices, below
        self.queue: list[str] = []

    def take(self, fits: Callable[[str], bool]) -> str:
        """The first choice that fits; those that it passes over are first in the next turn."""
        while not any(fits(choice) for choice in self.queue):
            self.queue += shuffled(self.choices, self.below)
        choice = next(choice for choice in self.queue if fits(choice))
        self.queue.remove(choice)
        return choice


def drawn(count: int, seed: int) -> list[Composition]:
    """The first compositions of a seed."""
    numbers = random.Random(seed)
    axes = {name: Axis(choices, lambda n: int(numbers.random() * n)) for name, choices in AXES.items()}
    compositions: list[Composition] = []
    for _ in range(count):
        chosen: dict[str, str] = {}
        for name, axis in axes.items():
            chosen[name] = axis.take(partial(can_be, chosen, name))
        compositions.append(Composition(chosen))
    return compositions


def sources(compositions: list[Composition]) -> dict[str, str]:
    """The text of each file, by its name."""
    of_space: dict[str, list[int]] = {}
    for number, composition in enumerate(compositions):
        of_space.setdefault(composition.chosen["space"], []).append(number)
    texts: dict[str, str] = {}
    for space, numbers in of_space.items():
        for k in range(0, len(numbers), TOGETHER):
            together = numbers[k:k + TOGETHER]
            name = "_".join(["worlds", *re.findall(r"\w+", space)[1:], str(together[0])]) + ".cpp"
            texts[name] = HEAD + "".join(compositions[n].source(n) for n in together)
    return texts


def write_all(folder: str, count: int, seed: int) -> list[str]:
    """Writes the sources, and removes those of another drawing. Returns the names of the files."""
    os.makedirs(folder, exist_ok=True)
    texts = sources(drawn(count, seed))
    for other in os.listdir(folder):
        if other not in texts and re.fullmatch(r"worlds?_\w+\.cpp", other):
            os.remove(os.path.join(folder, other))
    for name, text in texts.items():
        path = os.path.join(folder, name)
        try:
            with open(path, encoding="utf-8") as there:
                stays = there.read() == text
        except FileNotFoundError:
            stays = False
        if not stays:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
    return [os.path.join(folder, name) for name in texts]


def main(arguments: list[str]) -> int:
    """Ends with 0."""
    parser = argparse.ArgumentParser(prog="compositions.py", description="Draws compositions for the fuzzer of worlds.")
    parser.add_argument("folder", help="where the sources are written")
    parser.add_argument("--count", type=int, default=6, help="how many (6)")
    parser.add_argument("--seed", type=int, default=1, help="which ones (1)")
    given = parser.parse_args(arguments)
    if given.count < 1:
        parser.error("--count is at least 1")
    print("\n".join(write_all(given.folder, given.count, given.seed)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
