# SPDX-License-Identifier: BSL-1.0
"""Where the time of a build went (tools/workshop/times.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import times

NINJA = """# ninja log v5
7	8
0\t1500\t2000000000000\ttests/CMakeFiles/headers_alone.dir/headers_alone/drag.hpp.cpp.o\ta
0\t1500\t2000000000000\ttests/CMakeFiles/headers_alone.dir/headers_alone/drag.hpp.cpp.d\ta
100\t4100\t3000000000000\ttests/CMakeFiles/test_world.dir/world/step.cpp.o\tb
100\t2100\t3000000000000\ttests/CMakeFiles/test_world_together.dir/together/test_world_1.cpp.o\ti
0\t9000\t1000000000000\tchapters/section_1.7\tc
0\t100\t3000000000000\tchapters/section_1.8\td
0\t600\t3000000000000\tchapters/sections_motion\tj
0\t200\t3000000000000\tchapters/costs_motion\te
0\t300\t3000000000000\texercises/drag/others\tf
0\t400\t3000000000000\tother\tg
0\t500\t3000000000000\ttests/CMakeFiles/static_tests.dir/models.cpp.o\th
"""
TESTS = """Start testing
1/3 Testing: world.a step
Test time =   0.50 sec
2/3 Testing: must_not_compile.sum.g++
Test time =   2.00 sec
3/3 Testing: world.another
Test time =   1.25 sec
"""


class Kinds(unittest.TestCase):
    """What counts as what."""

    def test_build(self) -> None:
        """One command with two outputs counts once; what was built before 1500 s after 1970 is left out."""
        kinds: times.Kinds = {}
        times.count_build(NINJA.split("\n"), 1500.0, kinds)
        self.assertEqual(
            {kind: (of.number, round(of.seconds, 3), of.dearest) for kind, of in kinds.items()},
            {"build: headers alone": (1, 1.5, "drag.hpp.cpp"), "build: tests of world": (2, 6.0, "world/step.cpp"),
             "build: sections": (2, 0.7, "chapters/sections_motion"),
             "build: what it costs": (1, 0.2, "chapters/costs_motion"),
             "build: exercises": (1, 0.3, "exercises/drag/others"), "build: other": (1, 0.4, "other"),
             "build: static tests": (1, 0.5, "tests/CMakeFiles/static_tests.dir/models.cpp")})

    def test_since(self) -> None:
        """What was written in that very second belongs to it."""
        for since, number in ((3000.0, 8), (3000.5, 0)):
            kinds: times.Kinds = {}
            times.count_build(NINJA.split("\n"), since, kinds)
            self.assertEqual(sum(of.number for of in kinds.values()), number)

    def test_tests(self) -> None:
        """By module, and mistakes by compiler; the longest kind first."""
        kinds: times.Kinds = {}
        times.count_tests(TESTS.split("\n"), kinds)
        self.assertEqual(times.table(kinds), "test: must not compile, g++\t1\t2.0\tmust_not_compile.sum.g++\t2.0\n"
                                             "test: world\t2\t1.8\tworld.another\t1.2\n")


class Program(unittest.TestCase):
    """Its arguments."""

    def test_a_log_that_is_not_there(self) -> None:
        """Is nothing: before the first test there is no LastTest.log."""
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(times.main(["--since", "0", os.path.join(folder, ".ninja_log")]), 0)

    def test_refusals(self) -> None:
        """Without a log, or with a time that is no number."""
        for arguments in ("", "--since noon log"):
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
                times.main(arguments.split())
            self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
