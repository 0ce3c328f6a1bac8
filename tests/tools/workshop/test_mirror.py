# SPDX-License-Identifier: BSL-1.0
"""What the five trees lack (tools/workshop/mirror.py); tests/tools/mirror.sh plants each fault in a tree and reads what
tools/mirror says of it. Here are the cases that lie beside those."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import mirror

SPDX = "// SPDX-License-Identifier: BSL-1.0\n"


class OfATree(unittest.TestCase):
    """Each works in an empty folder."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        mirror.text_of.cache_clear()

    def write(self, file: str, text: str = SPDX) -> str:
        """A file of the tree."""
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)
        return file

    def test_mentions_are_whole_words(self) -> None:
        """ExplicitEulerLike does not speak of ExplicitEuler, and a dot is a dot."""
        header = self.write("include/ansatz/world/explicit_euler.hpp")
        tests = [self.write("tests/a.cpp", "#include <ansatz/world/explicit_euler.hpp>\n")]
        for text, said in (("ExplicitEulerLike", False), ("`ExplicitEuler`", True), ("world/explicit_euler.hpp", True),
                           ("world/explicit_euler_hpp", False), ("myworld/explicit_euler.hpp", False)):
            mirror.text_of.cache_clear()
            faults = mirror.untested_and_unmentioned([header], tests, [self.write("docs/a.md", text)])
            self.assertEqual([fault.split(":")[0] for fault in faults], [] if said else ["not mentioned"], text)

    def test_includes_in_a_ring(self) -> None:
        """End, and reach what lies behind."""
        self.write("include/ansatz/a.hpp", "#include <ansatz/a/b.hpp>\n#include <ansatz/not_there.hpp>\n")
        self.write("include/ansatz/a/b.hpp", " # include <ansatz/a.hpp>\n#include <ansatz/a/c.hpp> // why\n")
        self.write("include/ansatz/a/c.hpp")
        self.assertEqual(mirror.reached_from("include/ansatz/a.hpp"),
                         {"include/ansatz/a.hpp", "include/ansatz/a/b.hpp", "include/ansatz/a/c.hpp"})

    def test_a_ring_is_named_once(self) -> None:
        """By the headers that make it up, and not by those that reach it."""
        for header, includes in (("a/one", "a/two"), ("a/two", "a/three"), ("a/three", "a/one"), ("a/four", "a/one")):
            self.write(f"include/ansatz/{header}.hpp", f"#include <ansatz/{includes}.hpp>\n")
        headers = mirror.files_below(r".*\.hpp", "include/ansatz")
        self.assertEqual([fault.split(" (")[0] for fault in mirror.rings_of_includes(headers)],
                         ["a ring of includes: a/one.hpp <- a/three.hpp <- a/two.hpp <- a/one.hpp"])

    def test_who_may_include_whom(self) -> None:
        """The frame may not know a module; a module may know the frame."""
        below = self.write("include/ansatz/world/a.hpp", "#include <ansatz/motion/b.hpp>\n#include <ansatz/core/c.hpp>\n")
        above = self.write("include/ansatz/motion/b.hpp", "#include <ansatz/world/a.hpp>\n")
        self.assertEqual([fault.split(" (")[0] for fault in mirror.above_their_place([below, above])],
                         ["an include of a higher folder: include/ansatz/world/a.hpp: ansatz/motion/b.hpp"])

    def test_words_of_a_module_in_the_frame(self) -> None:
        """Comments and sentences may give an example; code may not."""
        for code, found in (("int contacts;", 1), ("// contacts, e.g.", 0), ('say("a Spring")', 0),
                            ("/* springs\n and\n ropes */ int sensor;", 1), ("int contacted;", 0)):
            mirror.text_of.cache_clear()
            faults = mirror.above_their_place([self.write("include/ansatz/world/a.hpp", f"{code}\n")])
            self.assertEqual(len(faults), found, code)

    def test_length(self) -> None:
        """400 lines are not too long, with or without an end of the last; 401 are."""
        for lines, faults in ((399, 0), (400, 1)):
            for end in ("", "\n"):
                mirror.text_of.cache_clear()
                header = self.write("include/ansatz/a.hpp", SPDX + "\n".join(["//"] * lines) + end)
                self.assertEqual(len(mirror.unlicensed_and_long([header])), faults, f"{lines} lines and {end!r}")

    def test_skipped_with_a_reason(self) -> None:
        """Is not switched off; in the middle of a word nothing is."""
        test = self.write("tests/a.cpp",
                          'SKIP("no gnuplot");\nNOT_DISABLED\n#if 01\nUNSKIP()\n"[.]" // not with ours\n')
        self.assertEqual(mirror.switched_off(mirror.OFF_IN_CODE, [test]),
                         ['switched off: tests/a.cpp:5 ("[.]" // not with ours)'])

    def test_nothing_at_all(self) -> None:
        """Lacks nothing; bytes that are no UTF-8 are read."""
        os.makedirs("tests")
        with open("tests/a.cpp", "wb") as stream:
            stream.write(SPDX.encode() + b"// \xff\n")
        with contextlib.redirect_stdout(io.TextIOWrapper(io.BytesIO())) as out:
            self.assertEqual(mirror.main(["."]), 0)
            out.seek(0)
            self.assertEqual(out.read(), "mirror: 0 headers, 1 test files, nothing missing\n")

    def test_refusal(self) -> None:
        """Of two folders."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            mirror.main([".", "."])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
