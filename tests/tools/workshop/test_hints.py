# SPDX-License-Identifier: BSL-1.0
"""What is found missing in an exercise's hints (tools/workshop/hints.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import hints

WHOLE = """# Hints

## Task 1: a question

Which is known?

## Task 1: the place
There.

## Task 1: the shape
    x += ...

## Task 1: the key line
    x += v * dt;
"""


class Hints(unittest.TestCase):
    """The sentences."""

    def test_nothing_is_missing(self) -> None:
        """Of one task."""
        self.assertEqual(hints.missing(WHOLE, 1), [])

    def test_a_heading_that_is_not_there(self) -> None:
        """Under another name, or of another task: task 10 is not task 1."""
        self.assertEqual(hints.missing(WHOLE.replace("key line", "end"), 1), ["hints.md has no '## Task 1: the line'"])
        self.assertEqual(hints.missing(WHOLE.replace("Task 1: the place", "Task 10: the place"), 1),
                         ["hints.md has no '## Task 1: the place'"])
        self.assertEqual(hints.missing(WHOLE, 2), [
            "hints.md has no '## Task 2: the question'", "hints.md has no '## Task 2: the place'",
            "hints.md has no '## Task 2: the shape'", "hints.md has no '## Task 2: the line'"])

    def test_a_heading_without_a_text(self) -> None:
        """Blanks are none, nor is the text of the next heading; at the end of the file neither."""
        self.assertEqual(hints.missing(WHOLE.replace("There.", "  "), 1),
                         ["hints.md has no text below '## Task 1: the place'"])
        self.assertEqual(hints.missing(WHOLE.replace("    x += v * dt;\n", ""), 1),
                         ["hints.md has no text below '## Task 1: the line'"])

    def test_files(self) -> None:
        """One that is not there has no hints."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "hints.md")
            with open(file, "w", encoding="utf-8") as stream:
                stream.write(WHOLE.replace("There.", ""))
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                self.assertEqual(hints.main([file, "1"]), 0)
                self.assertEqual(hints.main([os.path.join(folder, "nowhere.md"), "1"]), 0)
        self.assertEqual(out.getvalue(), (
            "hints.md has no text below '## Task 1: the place'\n"
            "hints.md has no '## Task 1: the question'\nhints.md has no '## Task 1: the place'\n"
            "hints.md has no '## Task 1: the shape'\nhints.md has no '## Task 1: the line'\n"))


if __name__ == "__main__":
    unittest.main()
