# SPDX-License-Identifier: BSL-1.0
"""What the comments and pages of the site can lead to (tools/workshop/link_targets.py)."""

from __future__ import annotations

import os
import tempfile
import unittest

from workshop import doxygen_filter, link_targets


class OfAProject(unittest.TestCase):
    """Each works in a small project: chapter 1 has section 1.7, the exercise drag, and the headers drag and cell."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        before = os.environ.get("PWD", "")
        self.addCleanup(os.environ.__setitem__, "PWD", before)
        os.chdir(folder.name)
        os.environ["PWD"] = folder.name
        self.write("docs/motion.md", "# Chapter 1: motion {#chapter_motion}", "", "## 1.7 Drag {#section_1_7}",
                   "## 1.9 Rest {#section_1_9}")
        self.write("docs/plain.md", "# No label")
        self.write("exercises/1-motion/drag/README.md", "# 1.7 Drag", "", "Notes 1.7 and Notes 1.8.")
        self.write("include/ansatz/motion/drag.hpp", "namespace ansatz {", "struct Drag {", "};", "}")
        self.write("include/ansatz/paths/cell.hpp", "namespace ansatz::paths {", "class Cell {", "};", "}")
        self.write("include/ansatz/paths/later.hpp", "namespace ansatz {", "struct Later ;", "}")

    def write(self, file: str, *lines: str) -> None:
        """A file of the project."""
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write("".join(line + "\n" for line in lines))

    def header(self, name: str, *lines: str) -> list[str]:
        """What stands in the place of these lines in a header of this name."""
        self.write(f"include/ansatz/motion/{name}.hpp", *lines)
        return doxygen_filter.filtered(f"include/ansatz/motion/{name}.hpp")

    def page(self, *lines: str) -> list[str]:
        """And on a text page of docs/."""
        self.write("docs/page.md", *lines)
        return doxygen_filter.filtered("docs/page.md")


class Targets(OfAProject):
    """Looked up in the project."""

    def test_course(self) -> None:
        """Sections, exercises and types by what they are called; a page without a label, and one that is not there, have none."""
        course = link_targets.Course()
        self.assertEqual(course.sections, {"section_1_7", "section_1_9"})
        self.assertEqual(course.exercises, {"drag": "exercise_motion_drag"})
        self.assertEqual(course.names, {"Drag": "ansatz::Drag", "Cell": "ansatz::paths::Cell"})
        self.assertEqual([course.label_of(page) for page in ("docs/motion.md", "docs/plain.md", "docs/none.md")],
                         ["chapter_motion", "", ""])
        self.assertEqual(course.with_sections("(notes 1.8, 1.9) 1.7"),
                         ('(notes 1.8, \\ref section_1_9 "1.9") 1.7', "1.8"))
        self.assertEqual(course.with_sections("1.7"), ("1.7", ""))


if __name__ == "__main__":
    unittest.main()
