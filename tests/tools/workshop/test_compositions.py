# SPDX-License-Identifier: BSL-1.0
"""How the compositions of the fuzzer of worlds are drawn (tools/workshop/compositions.py)."""

from __future__ import annotations

import contextlib
import io
import os
import re
import tempfile
import unittest

from workshop import compositions


class Drawing(unittest.TestCase):
    def test_a_seed_gives_the_same_ones_whatever_their_number(self) -> None:
        few = compositions.drawn(4, 7)
        self.assertEqual(few, compositions.drawn(30, 7)[:4])
        self.assertNotEqual(few, compositions.drawn(4, 8))

    def test_every_choice_is_there_before_one_comes_a_second_time(self) -> None:
        for seed in range(20):
            for axis in ("space", "broadphase", "narrowphase", "forces", "rest", "applied"):    # those without a rule
                choices = compositions.AXES[axis]
                first = [one.chosen[axis] for one in compositions.drawn(len(choices), seed)]
                self.assertEqual(sorted(first), sorted(choices))

    def test_pairs_of_choices_are_not_always_the_same(self) -> None:
        pairs = {(one.chosen["integrator"], one.chosen["broadphase"]) for one in compositions.drawn(60, 1)}
        self.assertGreater(len(pairs), 20)

    def test_what_cannot_stand_together_does_not(self) -> None:
        for seed in range(20):
            for one in compositions.drawn(30, seed):
                if one.chosen["integrator"] == "ImplicitEuler{}":
                    self.assertEqual(one.chosen["elements"], "")
                    self.assertNotIn("Penalty", one.chosen["response"])

    def test_what_is_promised_follows_from_what_is_chosen(self) -> None:
        for one in compositions.drawn(60, 3):
            facts = one.facts()
            self.assertEqual(facts["falls"], "Gravity" in one.policies("X"))
            self.assertFalse(facts["closed"] and ("Gravity" in one.policies("X") or "Drag" in one.policies("X")))
            self.assertFalse(facts["keeps_energy"] and facts["falls"])


class Sources(unittest.TestCase):
    def test_a_source_names_the_broadphase_and_the_one_that_it_is_held_against(self) -> None:
        one = compositions.drawn(1, 1)[0]
        text = one.source(5)
        broadphase = one.chosen["broadphase"]
        self.assertIn(f"fuzz::Either<{broadphase}>{{{{}}, every_pair}}", text)
        self.assertIn(f'.text = "{one.policies(broadphase + "{}")}"', text)
        self.assertIn(f'.other = "{one.policies("BoundingBoxes{}")}"', text)
        self.assertIn("registered{5, ", text)
        self.assertNotIn("{{}}", text.replace("{{}, every_pair}", ""))

    def test_what_stays_is_not_written_again(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            names = compositions.write_all(folder, 3, 1)
            self.assertEqual(len(names), 3)    # of three spaces
            for name in names:
                os.utime(name, (1, 1))
            compositions.write_all(folder, 3, 1)
            self.assertEqual({os.stat(name).st_mtime for name in names}, {1.0})
            names = compositions.write_all(folder, 3, 2)
            self.assertNotEqual({os.stat(name).st_mtime for name in names}, {1.0})

    def test_those_of_one_space_stand_together_each_once(self) -> None:
        drawn = compositions.drawn(30, 1)
        texts = compositions.sources(drawn)
        found: list[int] = []
        for text in texts.values():
            numbers = [int(n) for n in re.findall(r"registered\{(\d+),", text)]
            self.assertLessEqual(len(numbers), compositions.TOGETHER)
            self.assertEqual(len({drawn[n].chosen["space"] for n in numbers}), 1)
            found += numbers
        self.assertEqual(sorted(found), list(range(30)))
        self.assertEqual(len(texts), 8)    # of four spaces, seven or eight each

    def test_sources_of_another_drawing_go_and_other_files_stay(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            for name in ("mine.cpp", "world_3.cpp"):
                with open(os.path.join(folder, name), "w", encoding="utf-8"):
                    pass
            compositions.write_all(folder, 30, 1)
            names = compositions.write_all(folder, 2, 1)
            self.assertEqual({os.path.join(folder, name) for name in os.listdir(folder)},
                             {*names, os.path.join(folder, "mine.cpp")})

    def test_the_command_prints_the_names(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                self.assertEqual(compositions.main([folder, "--count", "2"]), 0)
            self.assertEqual(said.getvalue().split(), compositions.write_all(folder, 2, 1))
            self.assertEqual(sorted(said.getvalue().split()), [os.path.join(folder, name) for name in sorted(os.listdir(folder))])

    def test_no_composition_is_no_fuzzer(self) -> None:
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
            compositions.main(["nowhere", "--count", "0"])


if __name__ == "__main__":
    unittest.main()
