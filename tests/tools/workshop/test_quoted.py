# SPDX-License-Identifier: BSL-1.0
"""Quoted pieces at the left margin (tools/workshop/quoted.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import quoted


class Pieces(unittest.TestCase):
    """Between their marks."""

    def test_margin(self) -> None:
        """Each piece by itself, as far as its leftmost line; what is between them too. An empty line is no line."""
        self.assertEqual(
            quoted.unindented(
                ["int main() {", "    //! [a]", "    if (b)", "", "        c();", "    //! [a]", "        d();", "}",
                 " //! [e]", " f();", " //! [e]"]),
            ["int main() {", "//! [a]", "if (b)", "", "    c();", "//! [a]", "        d();", "}",
             "//! [e]", "f();", "//! [e]"])

    def test_within(self) -> None:
        """A piece within a piece keeps its place in it."""
        self.assertEqual(
            quoted.unindented(["  //! [a]", "  a();", "      //! [b]", "      b();", "      //! [b]", "  //! [a]"]),
            ["//! [a]", "a();", "    //! [b]", "    b();", "    //! [b]", "//! [a]"])


class Program(unittest.TestCase):
    """The copies."""

    def test_copies(self) -> None:
        """Of what has a piece, under its own path; of nothing else."""
        with tempfile.TemporaryDirectory() as folder:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(folder)
            os.makedirs("chapters/1-motion")
            for file in ("a.cpp", "b.hpp", "c.md", "d.hpp"):
                with open(f"chapters/1-motion/{file}", "w", encoding="utf-8") as stream:
                    stream.write("int i;\n" if file == "b.hpp" else "  //! [x]\n  int i;\n  //! [x]\n")
            self.assertEqual(quoted.main(["out", "chapters", "nowhere"]), 0)
            self.assertEqual(sorted(os.listdir("out/chapters/1-motion")), ["a.cpp", "d.hpp"])
            with open("out/chapters/1-motion/a.cpp", encoding="utf-8") as stream:
                self.assertEqual(stream.read(), "//! [x]\nint i;\n//! [x]\n")
            os.chdir("/")

    def test_refusal(self) -> None:
        """Without a folder of sources."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            quoted.main(["out"])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
