# SPDX-License-Identifier: BSL-1.0
"""The hard cases in other engines, on their page (tools/workshop/peer_cases.py)."""

from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest
from typing import Any, Iterator, Optional

from workshop import hard_cases, peer_cases

LISTED = "== C Contact\nC1 Two part.\nC2 Nothing happens.\n== W Water\nW1 It stays flat.\n"
PAGE = "# Hard cases\n\nWords.\n\n<!-- from peers: cases -->\nstale words\n<!-- end of peers -->\n\nMore words.\n"


def result(engine: str, value: Optional[float], verdict: str, **more: object) -> dict[str, Any]:
    """As the program writes it."""
    return {"engine": engine, "value": value, "bound": 0.01, "verdict": verdict} | more


def run() -> dict[str, Any]:
    """Two rows, three engines; one row that we do not hold, one in which another is nearer."""
    def engine(name: str, **more: object) -> dict[str, Any]:
        return {"name": name, "version": "1.2", "scalar": "double", "flat": False, "settings": ["as it comes", "Grid<Fine>"],
                "does_more": []} | more
    return {"machine": {"compiler": "GNU 12.2 (Debian)", "flags": "-O3", "date": "2026-11-27T00:00:00Z"},
            "engines": [engine("Ansatz double"), engine("Rival", does_more=["it turns"]), engine("Flat", flat=True, scalar="float")],
            "rows": [{"row": "C1", "what": "off", "unit": "m/s", "bound": 0.01, "bound_float": 0.01, "slop_added": False, "results": [
                        result("Ansatz double", 0.02, "failed"), result("Rival", 1e-9, "passed"),
                        result("Flat", None, "failed", why="it ended the program")]},
                     {"row": "C2", "what": "moved", "unit": "", "bound": 0.01, "bound_float": 0.1, "slop_added": True, "results": [
                         result("Ansatz double", 0.004, "passed"), result("Rival", 0.001, "passed"),
                         result("Flat", None, "cannot", why="it has no floor")]}],
            "left_out": [{"rows": "W1", "why": "nobody has water"}]}


@contextlib.contextmanager
def project(kept: Optional[dict[str, Any]], page: str = PAGE) -> Iterator[None]:
    """In a folder of its own."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for name, text in ((hard_cases.LIST, LISTED), (peer_cases.PAGE, page)):
                os.makedirs(os.path.dirname(name), exist_ok=True)
                with open(name, "w", encoding="utf-8") as stream:
                    stream.write(text)
            os.makedirs("build")
            if kept is not None:
                with open("build/cases.json", "w", encoding="utf-8") as stream:
                    json.dump(kept, stream)
                with contextlib.redirect_stdout(io.StringIO()):
                    peer_cases.main(["take", "build"])
            yield
        finally:
            os.chdir(before)


class Page(unittest.TestCase):
    """What it says."""

    def setUp(self) -> None:
        self.said = "\n".join(peer_cases.block(run()))

    def test_a_line_a_row(self) -> None:
        self.assertIn("| row | what is measured | bound | Ansatz double | Rival (double) | Flat (float) |", self.said)
        self.assertIn("| C1 | off, m/s | 0.01 | 0.02 **fails** | 1e-09 | none **fails** |", self.said)
        self.assertIn("| C2 | moved | 0.01, float 0.1 + slop | 0.004 | 0.001 | cannot |", self.said)

    def test_what_we_do_not_hold_and_where_others_are_nearer(self) -> None:
        self.assertEqual(peer_cases.our_failures(run()), ["- C1, off, m/s: Ansatz double fails; Rival holds it."])
        self.assertEqual(peer_cases.better(run()), ["- C2, moved: Rival 0.001; Ansatz 0.004."])

    def test_counts_reasons_and_what_they_do_more(self) -> None:
        self.assertIn("Ansatz double 1 of 2; Rival 2 of 2; Flat 0 of 1, 1 it cannot play.", self.said)
        self.assertIn("- C1, off: Flat: it ended the program.", self.said)
        self.assertIn("- Rival: it turns.", self.said)
        self.assertIn("- Flat 1.2, float, two dimensions: as it comes; Grid&lt;Fine&gt;.", self.said)
        self.assertIn("- W1: nobody has water.", self.said)

    def test_numbers_have_two_digits(self) -> None:
        self.assertEqual([peer_cases.number(x) for x in (0, 0.2749, 4.4409e-16, 4902, 12, 3.2e7)],
                         ["0", "0.27", "4.4e-16", "4900", "12", "3.2e+07"])


class Check(unittest.TestCase):
    """What is found."""

    def test_a_run_that_is_kept_is_what_the_page_says(self) -> None:
        with project(run()):
            self.assertEqual(peer_cases.check(), [])
            text = hard_cases.read(peer_cases.PAGE)
            self.assertTrue(text.startswith("# Hard cases\n\nWords.\n"))
            self.assertTrue(text.endswith("<!-- end of peers -->\n\nMore words.\n"))
            self.assertNotIn("stale words", text)

    def test_a_number_that_was_typed(self) -> None:
        with project(run()):
            with open(peer_cases.PAGE, encoding="utf-8") as stream:
                text = stream.read()
            with open(peer_cases.PAGE, "w", encoding="utf-8") as stream:
                stream.write(text.replace("0.02 **fails**", "0.002"))
            self.assertEqual(len(peer_cases.check()), 1)
            self.assertIn("does not say what docs/peers/cases.json says", peer_cases.check()[0])

    def test_rows_that_are_missing_doubled_or_unknown(self) -> None:
        changes: list[tuple[dict[str, Any], str]] = [
            ({"left_out": []}, "W1 is neither played"),
            ({"left_out": [{"rows": "W1 C1", "why": "x"}]}, "C1 is left out, and played"),
            ({"left_out": [{"rows": "W1 Q9", "why": "x"}]}, "there is no row Q9")]
        for change, fault in changes:
            with project(run() | change):
                self.assertEqual([fault in said for said in peer_cases.check()], [True])

    def test_no_run_and_no_place(self) -> None:
        with project(None), self.assertRaisesRegex(peer_cases.Fault, "there is no docs/peers/cases.json"):
            peer_cases.check()
        with project(None), self.assertRaisesRegex(peer_cases.Fault, "has no <!-- from peers: cases -->"):
            peer_cases.generated("# Nothing\n", run())

    def test_this_project(self) -> None:
        self.assertEqual(peer_cases.check(), [])


if __name__ == "__main__":
    unittest.main()
