# SPDX-License-Identifier: BSL-1.0
"""The library beside others in time, on the pages (tools/workshop/peer_times.py)."""

from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest
from typing import Any, Iterator

from workshop import peer_times


def row(scene: str, n: int, subject: str, value: float, unit: str = "ns a body", spread: float = 0.02) -> dict[str, Any]:
    """As the program writes it."""
    return {"area": "collision", "scene": scene, "n": n, "subject": subject, "value": value, "unit": unit, "spread": spread,
            "remark": f"says {subject}"}


def run() -> dict[str, Any]:
    """Two scenes of boxes, one of which we lose in one size, and a heap with its depth."""
    return {"machine": {"cpu": "A Machine", "cores": 2, "compiler": "GNU 12.2 (Debian)", "flags": "-O3", "date": "2026-11-27T00:00:00Z",
                        "clock": "thread CPU time, one thread", "repeats": 15},
            "versions": {"Rival": "1.2"},
            "rows": [row("boxes, even", 1000, "ansatz Grid", 10), row("boxes, even", 1000, "ansatz Tree", 20),
                     row("boxes, even", 1000, "Rival", 45.678), row("boxes, even", 1000, "in-place probe", 1),
                     row("boxes, even", 20000, "ansatz Grid", 30, spread=0.4), row("boxes, even", 20000, "Rival", 15),
                     row("boxes, mixed", 1000, "ansatz Grid", 100), row("boxes, mixed", 1000, "Rival", 1160.4),
                     row("heap, settled", 50, "ansatz Soft", 0.5, "ms a step"), row("heap, depth", 50, "ansatz Soft", 0.0004, "m", 0),
                     row("heap, settled", 50, "Rival", 2, "ms a step"), row("heap, depth", 50, "Rival", 0.003, "m", 0)]}


@contextlib.contextmanager
def project(page: str, kept: bool = True) -> Iterator[None]:
    """In a folder of its own, with one area."""
    before, areas = os.getcwd(), peer_times.AREAS
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        peer_times.AREAS = ("collision",)
        try:
            for place in ("docs", "build"):
                os.makedirs(place)
            with open("docs/a.md", "w", encoding="utf-8") as stream:
                stream.write(page)
            with open("build/collision.json", "w", encoding="utf-8") as stream:
                json.dump(run(), stream)
            if kept:
                with contextlib.redirect_stdout(io.StringIO()):
                    peer_times.main(["take", "build"])
            yield
        finally:
            peer_times.AREAS = areas
            os.chdir(before)


def asks(what: str) -> str:
    """A page with one block."""
    return f"Words.\n\n<!-- from contest: {what} -->\nstale\n<!-- end of contest -->\n\nMore.\n"


class Tables(unittest.TestCase):
    """What a block says."""

    def said(self, what: str) -> list[str]:
        return peer_times.block(what, {"collision": run()})

    def test_lines_are_subjects(self) -> None:
        self.assertEqual(self.said("table collision; rows subject; columns scene n; scenes boxes; subjects Rival = it | ansatz Grid"), [
            "| boxes, ns a body | even, 1\u00a0000 | even, 20\u00a0000 | mixed, 1\u00a0000 |", "|---|---|---|---|",
            "| it | 45.7 | 15 | 1160 |", "| `Grid` | 10 | 30 | 100 |"])

    def test_lines_are_scenes_and_numbers(self) -> None:
        self.assertEqual(self.said("table collision; rows n scene; columns subject; scenes boxes; n 1000; subjects ansatz Grid | Rival; ratio ansatz Grid"), [
            "| boxes, ns a body | `Grid` | Rival |", "|---|---|---|",
            "| 1\u00a0000, even | 10 | 45.7, 4.57 times |", "| 1\u00a0000, mixed | 100 | 1160, 11.6 times |"])

    def test_one_column(self) -> None:
        self.assertEqual(self.said("table collision; rows scene n subject; scenes boxes, even; subjects ansatz Grid | Rival; ratio first"), [
            "| ns a body | time |", "|---|---|",
            "| boxes, even, 1\u00a0000, `Grid` | 10 |", "| boxes, even, 1\u00a0000, Rival | 45.7, 4.57 times |",
            "| boxes, even, 20\u00a0000, `Grid` | 30 |", "| boxes, even, 20\u00a0000, Rival | 15, 0.5 times |"])

    def test_remarks(self) -> None:
        self.assertEqual(self.said("table collision; rows subject; columns scene; scenes heap, settled; remarks what"), [
            "| ms a step | heap, settled | what |", "|---|---|---|", "| `Soft` | 0.5 | says ansatz Soft |", "| Rival | 2 | says Rival |"])

    def test_several_units_stand_in_the_cells(self) -> None:
        self.assertEqual(self.said("table collision; rows subject; columns scene; scenes heap"), [
            "| heap | settled | depth |", "|---|---|---|", "| `Soft` | 0.5 ms a step | 0.4 mm |", "| Rival | 2 ms a step | 3 mm |"])

    def test_all_areas(self) -> None:
        self.assertEqual(self.said("all")[2:], [
            "| collision | boxes, even | 1\u00a0000 | `Grid`, 10 ns a body | Rival, 45.7 ns a body | 4.57 |",
            "| collision | boxes, even | 20\u00a0000 | `Grid`, 30 ns a body | Rival, 15 ns a body (says Rival) | **0.5** |",
            "| collision | boxes, mixed | 1\u00a0000 | `Grid`, 100 ns a body | Rival, 1.16 us a body | 11.6 |",
            "| collision | heap, settled | 50 | `Soft`, 0.5 ms a step | Rival, 2 ms a step | 4 |"])

    def test_the_run(self) -> None:
        said = self.said("run collision")[0]
        for words in ("2026-11-27", "A Machine, 2 cores", "GNU 12.2, `-O3`", "15 repeats", "Rival 1.2", "2 % above", "40 % at most"):
            self.assertIn(words, said)

    def test_the_terminal(self) -> None:
        with project(asks("all")):
            said = "\n".join(peer_times.summary("build"))
        self.assertIn("(Rival 1.2)", said)
        self.assertRegex(said, r"boxes, even +1000  Grid +10  Rival +45\.7 ns a body +4\.57")

    def test_units_that_a_reader_expects(self) -> None:
        self.assertEqual([peer_times.quantity(*one) for one in ((1500, "ns a body"), (2.5e6, "us"), (999, "us"), (0.02, "m"), (3, "m"))],
                         ["1.5 us a body", "2500 ms", "999 us", "20 mm", "3 m"])

    def test_types_of_ours_are_code(self) -> None:
        self.assertEqual([peer_times.who(name) for name in ("ansatz Soft, whole", "ansatz heap", "Rival")], ["`Soft`, whole", "heap", "Rival"])

    def test_numbers_have_three_digits(self) -> None:
        self.assertEqual([peer_times.number(x) for x in (0, 0.63749, 16.54, 1163, 0.000041, 5)], ["0", "0.637", "16.5", "1160", "0.000041", "5"])


class Check(unittest.TestCase):
    """What is found."""

    def test_a_run_that_is_kept_is_what_the_page_says(self) -> None:
        with project(asks("run collision")):
            self.assertEqual(peer_times.check(), [])
            text = peer_times.read("docs/a.md")
        self.assertTrue(text.startswith("Words.\n\n<!-- from contest: run collision -->\n*One run"))
        self.assertTrue(text.endswith("<!-- end of contest -->\n\nMore.\n"))

    def test_a_page_that_was_typed(self) -> None:
        with project(asks("table collision; rows subject; columns scene n; scenes boxes")):
            with open("docs/a.md", encoding="utf-8") as stream:
                text = stream.read()
            with open("docs/a.md", "w", encoding="utf-8") as stream:
                stream.write(text.replace("45.7", "47.5"))
            self.assertEqual(peer_times.check(), ["docs/a.md does not say what docs/peers says; python3 tools/workshop/peer_times.py write"])

    def test_a_run_that_no_page_shows(self) -> None:
        with project("Words.\n"):
            self.assertEqual(peer_times.check(), ["no page has a table of docs/peers/collision.json"])

    def test_no_run(self) -> None:
        with project(asks("run collision"), kept=False):
            faults = "\n".join(peer_times.check())
        self.assertIn("there is no docs/peers/collision.json", faults)
        self.assertIn("./workbook peers collision makes one", faults)

    def test_what_cannot_be_asked(self) -> None:
        for what, said in (("table collision; rows subject; columns scene n; colour red", "there is no option 'colour'"),
                           ("table collision; rows subject; columns scene; scenes holes", "no scene begins with 'holes'"),
                           ("table collision; rows subject; columns scene; subjects Nobody", "nobody is called 'Nobody'"),
                           ("table collision; rows subject; columns scene; n 7", "no row is left"),
                           ("table collision; columns subject", "a table says its rows"),
                           ("table collision; rows n; columns subject", "two numbers for one cell"),
                           ("table collision; rows colour; columns subject", "and not 'colour'"),
                           ("sum collision", "it is 'run <area>'"), ("run weather", "there is no run of 'weather'")):
            with project(asks(what), kept=False):
                os.makedirs("docs/peers")
                os.rename("build/collision.json", "docs/peers/collision.json")
                self.assertIn(said, "\n".join(peer_times.check()), what)

    def test_a_block_without_an_end(self) -> None:
        with project("<!-- from contest: all -->\n", kept=False):
            self.assertIn("has no <!-- end of contest -->", "\n".join(peer_times.check()))


if __name__ == "__main__":
    unittest.main()
