# SPDX-License-Identifier: BSL-1.0
"""Listings that are pasted into pages (tools/workshop/listings.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import listings


class Pasted(unittest.TestCase):
    """Where a program stands, whether it says so or not."""

    def test_fences(self) -> None:
        """That name C++ in any of its ways, or that hold a program under another name: said once a fence."""
        for fence in ("```cpp", "```c++", "~~~{.cpp}", "  ``` CPP", "~~~~ {.h}"):
            self.assertEqual(listings.pasted(["# T", fence, "a", fence[:5].strip()[:4], "b"]), [2], fence)
        self.assertEqual(listings.pasted(["# T", "```sh", "./a", "int i = 0; // one", "int j = 0;", "```"]), [2])
        for line in ("#include <a>", "template <class T>", "struct A {", "  class A", "namespace a {", "a();"):
            self.assertEqual(listings.pasted(["```", line, "```"]), [1], line)

    def test_other_marks(self) -> None:
        """A \\code of C++, a <pre>, and four spaces behind an empty line or a heading."""
        for line in ("\\code", "@code{.cpp}", "  \\code{.hpp} ", "<pre>", "a <PRE class=x>b"):
            self.assertEqual(listings.pasted(["# T", "", line]), [3], line)
        self.assertEqual(listings.pasted(["Text", "", "    a", "    int i = 0;", "    int j = 0;"]), [3])
        self.assertEqual(listings.pasted(["# T", "\tint i = 0;"]), [2])
        self.assertEqual(listings.pasted(["    int i = 0;", "    int j = 0;"]), [1])

    def test_none(self) -> None:
        """Commands, drawings, other languages, the second paragraph of a list, and lines that only go on."""
        for lines in (["```sh", "./workbook", "```"], ["```", "wake -> rest", "```", "A sentence; and", "more;"],
                      ["\\code{.sh}"], ["- a list", "", "    goes on; and on;"], ["Text", "more", "    goes on;"],
                      ["1. a list", "", "    goes on;"]):
            self.assertEqual(listings.pasted(lines), [], lines)

    def test_behind_a_list(self) -> None:
        """A line at the margin ends it."""
        self.assertEqual(listings.pasted(["- a list", "", "Text", "", "    int i = 0;"]), [5])


class Program(unittest.TestCase):
    """What it prints."""

    def test_faults(self) -> None:
        """With the file, the line and what to do."""
        with tempfile.TemporaryDirectory() as folder:
            page = os.path.join(folder, "page.md")
            with open(page, "w", encoding="utf-8") as stream:
                stream.write("# T\n\n```cpp\n```\n")
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(listings.main([page]), 0)
            out.seek(0)
            self.assertEqual(out.read(),
                             f"a pasted listing, {page}:3; quote it from a file that is compiled (tools/workshop/forge.py)\n")

    def test_refusal(self) -> None:
        """Without a page."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            listings.main([])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
