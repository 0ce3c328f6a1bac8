# SPDX-License-Identifier: BSL-1.0
"""What one step calls (tools/workshop/call_tree.py)."""

from __future__ import annotations

import contextlib
import io
import os
import re
import tempfile
import unittest

from workshop import call_tree

OUTPUT = """version: 1
fl=(1) main.cpp
fn=(1) main
cfi=(2) /p/include/ansatz/world/door.hpp
cfn=(2) void ansatz::World<ansatz::Gravity>::step<double>(double const&)
calls=1 5
1 20
fl=(2)
fn=(2)
10 3
cfi=(3) /p/include/ansatz/world/step.hpp
cfn=(3) ansatz::detail::run<int>(int)::{lambda(auto:1&)#1}::operator()(int&) const
calls=2 7
2 9
cfn=(5) ansatz::hidden<(ansatz::Motion)1>(int)
calls=1 1
3 3
fl=(3)
fn=(3)
cfi=(4) /usr/include/c++/12/vector
cfn=(4) std::vector<int>::size() const
calls=1 1
1 1
cfi=(3)
cfn=(6) ansatz::detail::run<double>(double)
calls=1 1
1 1
fl=(5) /p/include/ansatz/world/save.hpp
fn=(7) ansatz::never(int)
1 1
"""


class Names(unittest.TestCase):
    """Of functions, without what the compiler adds."""

    def test_plain(self) -> None:
        """Templates, arguments, results and lambdas fall away; operators stay."""
        for name, plain in (("void ansatz::World<A<B>, C>::step<double>(double const&)", "ansatz::World::step"),
                            ("ansatz::detail::run<int>(int)::{lambda(auto:1&)#1}::operator()(int&) const",
                             "ansatz::detail::run"),
                            ("ansatz::operator<=>(int, int)", "ansatz::operator?"),
                            ("main", "main")):
            self.assertEqual(call_tree.plain(name), plain)


class Tree(unittest.TestCase):
    """What is called from a step."""

    def test_met(self) -> None:
        """By file; other libraries and what is not called do not count, instances of one template count once."""
        rooms = call_tree.met(call_tree.read(OUTPUT.splitlines()), re.compile("World<.*>::step<"))
        self.assertEqual(rooms, {"world/door.hpp": {"ansatz::World::step", "ansatz::hidden"},
                                 "world/step.hpp": {"ansatz::detail::run"}})

    def test_main(self) -> None:
        """The numbers, and a sentence where the function is not called."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "out")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(OUTPUT)
            said, complained = io.StringIO(), io.StringIO()
            with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
                self.assertEqual(call_tree.main([path, "--list"]), 0)
                self.assertEqual(call_tree.main([path, "--from", "nobody"]), 1)
        self.assertEqual(said.getvalue().splitlines()[-1], "   3 functions in 2 files")
        self.assertIn("ansatz::detail::run", said.getvalue())
        self.assertIn("nothing of the library is called from nobody", complained.getvalue())
