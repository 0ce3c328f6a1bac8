# SPDX-License-Identifier: BSL-1.0
"""Advice from the rows of cost tables (tools/workshop/advice.py)."""

from __future__ import annotations

import unittest

from test_advice_blocks import block, project, said
from workshop import advice


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
