# SPDX-License-Identifier: BSL-1.0
"""How the skeletons of an exercise are made from its solution (tools/workshop/skeleton.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import skeleton

SOLUTION = """#include "todo.hpp"

double twice(double x) {
    // task 1: return todo(1);
    const double y = x;
    return x + y;
    // end of task 1
}

struct Drag {
        // task 2: todo(2);
        v *= 0.5;
        // end of task 2
};
"""

OPEN = """#include "todo.hpp"

double twice(double x) {
    return todo(1);
}

struct Drag {
        todo(2);
};
"""

FIRST_SOLVED = """#include "todo.hpp"

double twice(double x) {
    const double y = x;
    return x + y;
}

struct Drag {
        todo(2);
};
"""


class Skeleton(unittest.TestCase):
    """The text alone."""

    def test_a_task_is_its_line_after_the_colon(self) -> None:
        """The answer and both marks go, and the line has the mark's indent."""
        self.assertEqual(skeleton.skeleton(SOLUTION), OPEN)

    def test_solved_tasks_keep_their_answer(self) -> None:
        """Their marks go all the same."""
        self.assertEqual(skeleton.skeleton(SOLUTION, 1), FIRST_SOLVED)
        self.assertNotIn("task", skeleton.skeleton(SOLUTION, 2))
        self.assertIn("v *= 0.5;", skeleton.skeleton(SOLUTION, 2))

    def test_tasks_are_counted_by_their_number(self) -> None:
        """Task 10 is solved after task 9, not after task 1."""
        self.assertEqual(skeleton.skeleton("// task 10: a\nb\n// end of task 10\n", 9), "a\n")
        self.assertEqual(skeleton.skeleton("// task 10: a\nb\n// end of task 10\n", 10), "b\n")
        self.assertEqual(skeleton.tasks_of("// task 2: a\n// end of task 2\n// task 10: b\n"), 10)
        self.assertEqual(skeleton.tasks_of("no task\n"), 0)

    def test_what_is_no_mark_stays(self) -> None:
        """A comment that names a task, and other bytes than ours; the last line gets its end."""
        text = "// see task 1: there\nx; // task 1: y\n//task 1: z\r\n"
        self.assertEqual(skeleton.skeleton(text), text)
        self.assertEqual(skeleton.skeleton("a"), "a\n")
        self.assertEqual(skeleton.skeleton(""), "")


class Command(unittest.TestCase):
    """Files and arguments."""

    def setUp(self) -> None:
        """An exercise."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.solution = self.put("solution.hpp", SOLUTION)

    def put(self, name: str, text: str) -> str:
        """Writes a file and returns its path."""
        skeleton.write(os.path.join(self.folder, name), text)
        return os.path.join(self.folder, name)

    def run_it(self, *arguments: str) -> tuple[int, str, str]:
        """The code it ends with, and what it prints and complains."""
        out, err = io.TextIOWrapper(io.BytesIO(), encoding="utf-8"), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = skeleton.main(list(arguments))
        out.seek(0)
        return code, out.read(), err.getvalue()

    def test_prints_the_skeleton(self) -> None:
        """Without an option."""
        self.assertEqual(self.run_it(self.solution), (0, OPEN, ""))

    def test_writes_all_but_the_solution(self) -> None:
        """With two tasks: none solved, and one."""
        self.assertEqual(self.run_it("--all", self.folder, self.solution), (0, "skeleton\nskeleton.1\n", ""))
        self.assertEqual(skeleton.read(os.path.join(self.folder, "skeleton.hpp")), OPEN)
        self.assertEqual(skeleton.read(os.path.join(self.folder, "skeleton.1.hpp")), FIRST_SOLVED)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "skeleton.2.hpp")))

    def test_a_solution_without_tasks_has_one_skeleton(self) -> None:
        """Itself."""
        self.assertEqual(self.run_it("--all", self.folder, self.put("plain.hpp", "int x;\n")), (0, "skeleton\n", ""))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "skeleton.1.hpp")))

    def test_one_solution_at_a_time(self) -> None:
        """More would be one text without a seam."""
        with self.assertRaises(SystemExit):
            self.run_it(self.solution, self.solution)

    def test_untouched_is_letter_by_letter(self) -> None:
        """A blank more is an answer that was begun; what has no answer, or is no exercise, is not named."""
        self.assertEqual(self.run_it("--untouched", self.folder), (0, "", ""))
        answer = self.put("exercise.hpp", OPEN)
        self.assertEqual(self.run_it("--untouched", self.folder, answer, "nowhere"), (0, self.folder + "\n", ""))
        self.put("exercise.hpp", OPEN + " ")
        self.assertEqual(self.run_it("--untouched", self.folder), (0, "", ""))

    def test_every_byte_stays(self) -> None:
        """Also what is no UTF-8."""
        with open(self.solution, "wb") as stream:
            stream.write(b"// \xff \xe2\x80\x98\r\n")
        skeleton.write_all(skeleton.read(self.solution), self.folder)
        with open(os.path.join(self.folder, "skeleton.hpp"), "rb") as made:
            self.assertEqual(made.read(), b"// \xff \xe2\x80\x98\r\n")

    def test_a_file_that_is_not_there_is_named(self) -> None:
        """And nothing is printed."""
        self.assertEqual(self.run_it("nowhere/solution.hpp"),
                         (1, "", "skeleton.py: nowhere/solution.hpp: No such file or directory\n"))


if __name__ == "__main__":
    unittest.main()
