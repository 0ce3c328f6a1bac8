# SPDX-License-Identifier: BSL-1.0
"""A text page as Doxygen reads it (tools/workshop/text_pages.py)."""

from __future__ import annotations

import unittest

from test_link_targets import OfAProject
from workshop import doxygen_filter, text_pages


class Files(OfAProject):
    """What links between files become."""

    def test_files(self) -> None:
        """A link to a file of the project leads to its page."""
        for target, becomes in {
                "motion.md": '\\ref chapter_motion "x"', "plain.md": "[x](docs/plain.md)",
                "../README.md": '\\ref page_readme "x"', "../LICENSE": '<a href="LICENSE.txt">x</a>',
                "../include/ansatz/motion/drag.hpp": '\\ref ansatz/motion/drag.hpp "x"',
                "../exercises/1-motion/drag/": '\\ref exercise_motion_drag "x"',
                "../exercises/1-motion/drag/README.md": '\\ref exercise_motion_drag "x"',
                "../exercises/1-motion": '\\ref page_exercises "x"',
                "../exercises/1-motion/drag/solution.hpp": "`x`",
                "../chapters/1-motion": '\\ref chapter_motion "x"',
                "../chapters/9-magic": '\\ref page_programs "x"', "../chapters": '\\ref page_programs "x"',
                "../chapters/1-motion/1.7-drag.cpp": '\\ref program_motion_1_7_drag "x"',
                "../chapters/1-motion/problems.hpp": '\\ref program_motion_problems_hpp "x"',
                "../tests/package/models/law.cpp": '\\ref model_law "x"', "../tests/package/pool.cpp": "`x`",
                "../tools/mirror": "`x`", "https://example.org": "[x](https://example.org)",
                "#here": "[x](#here)"}.items():
            with self.subTest(target):
                self.assertEqual(self.page(f"A [`x`]({target})." if "`" in becomes else f"A [x]({target})."),
                                 [f"A {becomes}."])
        self.assertEqual(self.page("A picture ![x](motion.md)."), ["A picture ![x](motion.md)."])

    def test_paths(self) -> None:
        """Without the folders that they leave again."""
        for path, plain in (("docs/../README.md", "README.md"), ("a/b/../../c/", "c"), ("./a/./b", "a/b"), ("a", "a")):
            self.assertEqual(text_pages.plain_path(path), plain)


class Pages(OfAProject):
    """Their beginnings."""

    def test_readme(self) -> None:
        """Gets its label here, so that a forge shows none."""
        self.write("./README.md", "# Ansatz", "", "Text.")
        self.assertEqual(doxygen_filter.filtered("README.md"), ["# At a glance {#page_readme}", "", "Text."])

    def test_contents(self) -> None:
        """Of three sections on, unless the page has them already."""
        sections = ["## a", "## b", "## c"]
        self.assertEqual(self.page("# Title", *sections), ["# Title", "", "[TOC]", *sections])
        self.assertEqual(self.page("# Title", *sections[:2]), ["# Title", *sections[:2]])
        own = ["# Title", *sections, "\\tableofcontents"]
        self.assertEqual(self.page(*own), own)

    def test_exercise(self) -> None:
        """Its title says its number, its second paragraph its command; the first section of a line is a link."""
        self.assertEqual(doxygen_filter.filtered("exercises/1-motion/drag/README.md"), [
            "# Exercise 1.7: Drag {#exercise_motion_drag}", "",
            "`./workbook exercise drag` builds and tests your answer, which you write in "
            "`exercises/1-motion/drag/exercise.hpp`.", "", 'Notes \\ref section_1_7 "1.7" and Notes 1.8.'])

    def test_other_files(self) -> None:
        """The list of the headers gets its links to sections; what is made already, and what is no page, stays."""
        for file, line in (("build/pages/library.md", '(notes \\ref section_1_7 "1.7") `Drag`'),
                           ("build/pages/exercises.md", "(notes 1.7) `Drag`"), ("docs/a.dox", "(notes 1.7) `Drag`")):
            self.write(file, "(notes 1.7) `Drag`")
            self.assertEqual(doxygen_filter.filtered(file), [line])


if __name__ == "__main__":
    unittest.main()
