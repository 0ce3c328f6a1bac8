# SPDX-License-Identifier: BSL-1.0
"""Advice from the rows of cost tables (tools/workshop/advice.py)."""

from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest
from typing import Iterator, Optional

from workshop import advice

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
    return f"# T\n\n<!-- from costs: {words} -->\nold\n{advice.END}\n\nAfter.\n"


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
                self.assertTrue(text.startswith("# T\n\n<!-- from") and text.endswith(f"{advice.END}\n\nAfter.\n"))
                self.assertNotIn("\nold\n", text)
                advice.write(page, text.replace("`", "'", 1))
                self.assertIn("advice.py write", "".join(said("check", page)))

    def test_who_is_first(self) -> None:
        """QuickStart to 50; then SteadyPace, and not RoundAbout, which is alike."""
        with project({}):
            line = advice.first_block("walks search")[2]
            self.assertIn("`QuickStart` up to 50, `SteadyPace` from 50", line)
            self.assertNotIn("`RoundAbout` from", line)

    def test_crossings(self) -> None:
        """By more than a twentieth; never, and always."""
        with project({}):
            told = advice.crossings_block("walks search: SteadyPace : QuickStart, SlowMarch : SteadyPace, "
                                          "SteadyPace : SlowMarch, RoundAbout : SteadyPace")[2:]
            self.assertEqual([line.split("|")[2].strip() for line in told], ["50", "never", "always", "never"])
            with self.assertRaises(advice.Fault):
                advice.crossings_block("walks search: Nobody : QuickStart")
            self.assertIn("a map, rooms | a map, blocks", advice.crossings_block("walks open list: Circle : Square")[0])

    def test_errors(self) -> None:
        """The cheaper, the factor of the other; who does not get there is not told."""
        with project({}):
            first, second = advice.errors_block("walks steps: 0.1 0.001")[2:]
            self.assertIn("| 0.1 | `ShortStep`, 10 | `LongStride`, 1.6 times as long |  |", first)
            self.assertEqual(second, "|  | 0.001 | `LongStride`, 160 |  |  |")
            self.assertIn("waste \\| of it", first)

    def test_what_is_not_there(self) -> None:
        """A block of no kind, without an end, of no run."""
        for words in ("best walks", "run nothing"):
            with project({"docs/a.md": block(words)}):
                self.assertEqual(len(said("check", "docs/a.md")), 1, words)
        with project({"docs/a.md": "<!-- from costs: run walks -->\nno end\n"}):
            self.assertIn(advice.END, "".join(said("check", "docs/a.md")))


class Claims(unittest.TestCase):
    """Sentences and their rows."""

    def test_claims(self) -> None:
        """That hold, and that do not; each is looked at in every row that it names."""
        rows = "walks search/spread: "
        with project({}):
            for claim in ("QuickStart < SteadyPace to 10", "SteadyPace < QuickStart from 100", "SteadyPace < SlowMarch",
                          "SteadyPace < 0.3 SlowMarch", "SlowMarch > 4 SteadyPace at 10", "work QuickStart > 0.9 SteadyPace",
                          "QuickStart@10 < 0.1 QuickStart@1000", "error QuickStart < 1.1 SteadyPace"):
                self.assertEqual(advice.faults_of_claim(rows + claim), [], claim)
            self.assertEqual(advice.faults_of_claim("walks steps/*: LongStride < 0.6 ShortStep at error 0.01"), [])
            for claim in ("QuickStart < SteadyPace", "SteadyPace < 0.1 SlowMarch", "SteadyPace < Nobody",
                          "SteadyPace < QuickStart at 11", "SteadyPace is quick", "QuickStart@10 < QuickStart@11"):
                self.assertEqual(len(advice.faults_of_claim(rows + claim)), 1, claim)
            self.assertEqual(len(advice.faults_of_claim("walks steps/*: ShortStep < LongStride at error 0.001")), 1)
            self.assertEqual(len(advice.faults_of_claim("nothing search/spread: A < B")), 1)
            wordy = "walks open list/*: "
            self.assertEqual(advice.faults_of_claim(wordy + '"Ring, wide" < 0.5 "Ring, narrow"'), [])
            for claim in ('"Ring, narrow" < "Ring, wide"', '"Ring, low" < "Ring, wide"', 'Ring, wide < "Ring, narrow"'):
                self.assertEqual(len(advice.faults_of_claim(wordy + claim)), 1, claim)

    def test_sentences(self) -> None:
        """About what policies cost are asked for their row; about motion, or with a row or a test, they are not."""
        row_of_it = " <!-- costs: walks search/*: SteadyPace < SlowMarch -->"
        for text, faults in (
                ("`SteadyPace` is faster.", 1), ("A steady pace costs less\nthan anything.", 1),
                ("- `SlowMarch` takes twice as long.\n- Other.", 1), ("| `SlowMarch` | pays off late |", 1),
                ("`SteadyPace` is faster." + row_of_it, 0), ("`SteadyPace`\nis faster." + row_of_it, 0),
                ("Write `<!-- costs: a b: C < D -->`.", 0), ("Write <!-- costs: a b: C < D -->.", 1),
                ("`SteadyPace` is faster.\n\nAnother." + row_of_it, 1), ("A ball is faster than `this`.", 0),
                ("`SteadyPace` is faster: tests/a/b.perf.cpp.", 0), ("`SteadyPace` sees who is faster than the threshold.", 0),
                ("`SteadyPace` is a word. A ball is faster.", 0),
                (block("first walks search").replace("old", "`SteadyPace` is faster"), 1)):
            with project({"docs/a.md": text}):
                self.assertEqual(len(said("check", "docs/a.md")), faults, text)

    def test_headers(self) -> None:
        """Speak of themselves; their code is not read."""
        file = "include/ansatz/walks/steady_pace.hpp"
        for text, faults in (
                ("/// \\file\n/// Nothing here\n/// is faster.\n#include <a>\n", 1),
                ("/// Nothing is faster. <!-- costs: walks search/*: SteadyPace < SlowMarch -->\n", 0),
                ("int faster = 0;\nint cheapest();\n", 0)):
            with project({file: text}):
                self.assertEqual(len(said("check", file)), faults, text)

    def test_paths(self) -> None:
        """Where a path has a cost, dear and cheap are of that."""
        file = "include/ansatz/paths/steady_pace.hpp"
        for text, faults in (("/// The cheapest way costs less than others.\n", 0), ("/// Nothing here is faster.\n", 1)):
            with project({file: text}):
                self.assertEqual(len(said("check", file)), faults, text)


if __name__ == "__main__":
    unittest.main()
