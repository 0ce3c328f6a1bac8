# SPDX-License-Identifier: BSL-1.0
"""Whether chapter, API and exercise know each other (tools/workshop/course_links.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import course_links

EXERCISE, HEADER = "exercises/1-motion/drag", "include/ansatz/motion/drag.hpp"
LINK = '<a href="exercise_motion_drag.html">x</a>'
PAGE = ('./workbook exercise drag exercises/1-motion/drag/exercise.hpp <a href="section_1_7.html">x</a>'
        '<a href="drag_8hpp.html">x</a><div class="image">')
TITLE = "<title>Ansatz: ansatz/motion/drag.hpp File Reference</title>"
WHOLE = {"exercise_motion_drag.html": PAGE, "section_1_7.html": LINK, "structansatz_1_1Drag.html": LINK,
         "drag_8hpp.html": TITLE}


class OfASite(unittest.TestCase):
    """In which all is well, but for what each changes."""

    def faults(self, header: str = HEADER, **changed: str) -> list[str]:
        """Of the exercise; a page that is empty is not there."""
        pages = {**WHOLE, **{f"{name}.html": text for name, text in changed.items()}}
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                if text:
                    with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                        stream.write(text)
            return course_links.faults_of_exercise(course_links.Site(folder), EXERCISE, header)

    def test_none(self) -> None:
        """With a type that leads to the exercise, or the header's own page; an exercise may have no header."""
        self.assertEqual(self.faults(), [])
        self.assertEqual(self.faults(structansatz_1_1Drag="", drag_8hpp=TITLE + LINK), [])
        self.assertEqual(self.faults("", structansatz_1_1Drag=""), [])

    def test_no_page(self) -> None:
        """Then nothing else is asked of it."""
        self.assertEqual(self.faults(exercise_motion_drag="", section_1_7=""),
                         [f"{EXERCISE} has no page exercise_motion_drag.html"])

    def test_each(self) -> None:
        """What it does not say, and who does not lead to it."""
        no_words = "the page of the exercise drag does not say"
        for part, fault in (("./workbook exercise drag", f"{no_words} its command"),
                            (f"{EXERCISE}/exercise.hpp", f"{no_words} which file to edit"),
                            ('class="image"', "the page of the exercise drag shows no picture"),
                            ("section_1_7.html", "the exercise drag does not link to its section"),
                            ("drag_8hpp.html", f"the exercise drag does not link to {HEADER}")):
            self.assertEqual(self.faults(exercise_motion_drag=PAGE.replace(part, "")), [fault])
        other = '<a href="exercise_motion_drag_more.html">x</a>'
        self.assertEqual(self.faults(section_1_7=other), ["no chapter links to the exercise drag"])
        self.assertEqual(self.faults(structansatz_1_1Drag=other), ["no page of the API links to the exercise drag"])
        self.assertEqual(self.faults(drag_8hpp=TITLE.replace("motion", "springs")), [f"{HEADER} has no page"])


class Program(unittest.TestCase):
    """Over all exercises."""

    def test_headers(self) -> None:
        """The one of the exercise's name, wherever in its module."""
        with tempfile.TemporaryDirectory() as folder:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(folder)
            for file in ("include/ansatz/motion/forces/drag.hpp", "include/ansatz/springs/rope.hpp"):
                os.makedirs(os.path.dirname(file))
                with open(file, "w", encoding="utf-8"):
                    pass
            self.assertEqual(course_links.header_of(EXERCISE), "include/ansatz/motion/forces/drag.hpp")
            self.assertEqual(course_links.header_of("exercises/1-motion/rope"), "")
            os.chdir("/")

    def test_printed(self) -> None:
        """A line for each exercise that has a fault, in the order of their folders."""
        with tempfile.TemporaryDirectory() as folder:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(folder)
            for exercise in ("2-collision/a", "1-motion/b", "1-motion/a"):
                os.makedirs(f"exercises/{exercise}")
                with open(f"exercises/{exercise}/README.md", "w", encoding="utf-8"):
                    pass
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(course_links.main(["html"]), 0)
            out.seek(0)
            self.assertEqual(out.read(), "exercises/1-motion/a has no page exercise_motion_a.html\n"
                                         "exercises/1-motion/b has no page exercise_motion_b.html\n"
                                         "exercises/2-collision/a has no page exercise_collision_a.html\n")
            os.chdir("/")

    def test_refusal(self) -> None:
        """Without a site."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            course_links.main([])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
