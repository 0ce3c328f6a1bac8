# SPDX-License-Identifier: BSL-1.0
"""The generated blocks of pages (tools/workshop/advice_blocks.py)."""

from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest
from typing import Iterator, Optional

from workshop import advice, advice_blocks

Row = dict[str, object]


def row(choice: str, n: int, time: Optional[float], problem: str = "spread, wide", **more: object) -> Row:
    """As the harness writes it."""
    return {"axis": "search", "choice": choice, "problem": problem, "parameter": None, "n": n, "error": 1.0,
            "error_norm": "waste", "work": n, "work_unit": "pairs", "time": time, "time_unit": "ns", "spread": 0.01,
            "order": None, "known_order": None, "diverged": False} | more


# Quick falls behind Steady where 2.1 n = 105, at 50; Rounds is alike to Steady, Slow never first.
ROWS = [entry for n in (10, 100, 1000) for entry in (
    row("QuickStart", n, 2.1 * n), row("SteadyPace", n, 100.0), row("SlowMarch", n, 400.0 + n),
    row("RoundAbout", n, 101.0))]
WORDY = [row(choice, 10, time, axis="open list", problem=f"a map, {problem}") for problem in ("rooms", "blocks")
         for choice, time in (("Ring, wide", 1.0), ("Ring, narrow", 3.0), ("Circle", 2.0), ("Square", 4.0))]
LADDER = [row("ShortStep", 2, 1 / dt, axis="steps", error=dt, error_norm="waste | of it", parameter=f"dt = {dt:g} s") for dt in (1.0, 0.1, 0.01)] + [
    row("LongStride", 2, 5 / dt, axis="steps", error=dt * dt, parameter=f"dt = {dt:g} s") for dt in (1.0, 0.1, 0.01)] + [
    row("LostWay", 2, 7.0, axis="steps", error=0.5, parameter="dt = 1 s", diverged=True)]
RUN = {"machine": {"cpu": "a processor", "compiler": "g++ 12.2 (x)", "flags": "-O3", "date": "2026-01-02T03:04:05Z",
                   "repeats": 15}, "rows": ROWS + LADDER + WORDY}


@contextlib.contextmanager
def project(texts: dict[str, str]) -> Iterator[None]:
    """A folder with a run of the module "walks", and texts."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        os.makedirs("docs/costs")
        os.makedirs("build/costs")
        advice.write("build/costs/walks.json", json.dumps(RUN, indent=2))
        for file, text in texts.items():
            os.makedirs(os.path.dirname(file) or ".", exist_ok=True)
            advice.write(file, text)
        try:
            assert advice.main(["take", "build/costs"]) == 0
            yield
        finally:
            os.chdir(before)


def said(*arguments: str) -> list[str]:
    """What the program prints."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        advice.main(list(arguments))
    return out.getvalue().splitlines()


def block(words: str) -> str:
    """A page that asks for a block."""
    return f"# T\n\n<!-- from costs: {words} -->\nold\n{advice_blocks.END}\n\nAfter.\n"


class Blocks(unittest.TestCase):
    """What is written into pages."""

    def test_written_and_fresh(self) -> None:
        """Written once, a page has no fault; with a sign changed by hand it has one."""
        page = "docs/walks.md"
        for words in ("run walks", "first walks search", "crossings walks search: SteadyPace : QuickStart",
                      "errors walks steps: 0.1 0.01"):
            with project({page: block(words)}):
                self.assertEqual(len(said("check", page)), 1, words)
                self.assertEqual(said("write", page), [f"written anew: {page}"])
                self.assertEqual(said("check", page), [], words)
                text = advice.read(page)
                self.assertTrue(text.startswith("# T\n\n<!-- from") and text.endswith(f"{advice_blocks.END}\n\nAfter.\n"))
                self.assertNotIn("\nold\n", text)
                advice.write(page, text.replace("`", "'", 1))
                self.assertIn("advice.py write", "".join(said("check", page)))

    def test_who_is_first(self) -> None:
        """QuickStart to 50; then SteadyPace, and not RoundAbout, which is alike."""
        with project({}):
            line = advice_blocks.first_block("walks search")[2]
            self.assertIn("`QuickStart` up to 50, `SteadyPace` from 50", line)
            self.assertNotIn("`RoundAbout` from", line)

    def test_crossings(self) -> None:
        """By more than a twentieth; never, and always."""
        with project({}):
            told = advice_blocks.crossings_block("walks search: SteadyPace : QuickStart, SlowMarch : SteadyPace, "
                                                 "SteadyPace : SlowMarch, RoundAbout : SteadyPace")[2:]
            self.assertEqual([line.split("|")[2].strip() for line in told], ["50", "never", "always", "never"])
            with self.assertRaises(advice_blocks.Fault):
                advice_blocks.crossings_block("walks search: Nobody : QuickStart")
            self.assertIn("a map, rooms | a map, blocks", advice_blocks.crossings_block("walks open list: Circle : Square")[0])

    def test_errors(self) -> None:
        """The cheaper, the factor of the other; who does not get there is not told."""
        with project({}):
            first, second = advice_blocks.errors_block("walks steps: 0.1 0.001")[2:]
            self.assertIn("| 0.1 | `ShortStep`, 10 | `LongStride`, 1.6 times as long |  |", first)
            self.assertEqual(second, "|  | 0.001 | `LongStride`, 160 |  |  |")
            self.assertIn("waste \\| of it", first)

    def test_what_is_not_there(self) -> None:
        """A block of no kind, without an end, of no run."""
        for words in ("best walks", "run nothing"):
            with project({"docs/a.md": block(words)}):
                self.assertEqual(len(said("check", "docs/a.md")), 1, words)
        with project({"docs/a.md": "<!-- from costs: run walks -->\nno end\n"}):
            self.assertIn(advice_blocks.END, "".join(said("check", "docs/a.md")))


if __name__ == "__main__":
    unittest.main()
