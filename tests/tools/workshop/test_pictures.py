# SPDX-License-Identifier: BSL-1.0
"""The pictures that pages show (tools/workshop/pictures.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import pictures


class OfAProject(unittest.TestCase):
    """Each works in a project that has a picture, a drawn one, and the program of section 1.7."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        for file in ("docs/pictures/there.svg", "drawn/1.6.svg", "chapters/1-motion/1.7-drag.cpp", "out/none"):
            os.makedirs(os.path.dirname(file), exist_ok=True)
            with open(file, "w", encoding="utf-8"):
                pass

    def test_shown(self) -> None:
        """In both manners of Doxygen's commands, with and without quotes; other formats are not the site's."""
        text = '\\image html 1.7.svg "A"\n@image html "b.svg" "B"\n\\image latex c.pdf\n'
        self.assertEqual(pictures.pictures_of(text), ["1.7.svg", "b.svg"])

    def test_stand_ins(self) -> None:
        """For each that is in none of the folders, once, in the order of the sections."""
        texts = {"a.md": "".join(f"\\image html {name}.svg\n" for name in
                                 ("1.10", "1.9", "1.7-b", "1.7", "there", "1.6", "own", "1.9"))}
        self.assertEqual(pictures.stand_ins("out", ["docs/pictures", "drawn"], texts),
                         ["1.7.svg", "1.7-b.svg", "1.9.svg", "1.10.svg", "own.svg"])
        for name, command in (("1.7-b", "./workbook section 1.7"), ("own", "./workbook")):
            with open(f"out/{name}.svg", encoding="utf-8") as stream:
                self.assertIn(f">Not drawn yet. {command} draws it; then ./workbook docs shows it here.<",
                              stream.read())

    def test_stand_in_shrinks(self) -> None:
        """A phone is narrower than a stand-in: without a viewBox its words would be cut there."""
        self.assertIn('viewBox="0 0 640 60"', pictures.STAND_IN)

    def test_of_nobody(self) -> None:
        """Neither in docs/pictures nor of a section that there is."""
        text = "".join(f"\\image html {name}.svg\n" for name in ("there", "1.7", "1.7-two", "1.8", "own"))
        self.assertEqual(pictures.of_nobody({"docs/a.md": text}), [
            "docs/a.md shows 1.8.svg, which no section draws", "docs/a.md shows own.svg, which no section draws"])

    def test_program(self) -> None:
        """Prints what is asked: names, or faults."""
        with open("docs/a.md", "w", encoding="utf-8") as stream:
            stream.write("\\image html 1.8.svg\n")
        for arguments, said in (("stand-ins out --drawn drawn -- docs/a.md", "1.8.svg\n"),
                                ("undrawn docs/a.md", "docs/a.md shows 1.8.svg, which no section draws\n")):
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(pictures.main(arguments.split()), 0)
            out.seek(0)
            self.assertEqual(out.read(), said)

    def test_refusals(self) -> None:
        """Without what is asked, or without a text."""
        for arguments in ("", "undrawn", "stand-ins out -- a.md"):
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
                pictures.main(arguments.split())
            self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
