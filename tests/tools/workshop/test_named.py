# SPDX-License-Identifier: BSL-1.0
"""What of the library its users name (tools/workshop/named.py)."""

from __future__ import annotations

import os
import tempfile
import unittest

from workshop import named


class Users(unittest.TestCase):
    """In a tree with one program and one page."""

    def setUp(self) -> None:
        """A tree."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        files = {"chapters/1-motion/1.cpp": "#include <ansatz/motion/drag.hpp>\n// Inside\nWorld w{Drag{}}; cast(w); Lot lot;\n",
                 "docs/motion.md": "Plain words. `Rest` is\n```cpp\nSpring s;\n```\n```text\nOutput\n```\n[x](../include/ansatz/a.hpp)\n",
                 "docs/frame.md": "`Lanes`\n", "docs/site/types.txt": "# Remark\nRay\n-Lot\n"}
        for name, text in files.items():
            os.makedirs(os.path.dirname(name), exist_ok=True)
            with open(name, "w", encoding="utf-8") as stream:
                stream.write(text)
        named.forget()
        self.addCleanup(named.forget)

    def test_types(self) -> None:
        """In programs, as code on pages, and in the list, which takes some away; in no comment, text or output, and not on
        the page of the frame."""
        self.assertEqual({name for name in ("World", "Drag", "Rest", "Spring", "Ray", "Lot", "Inside", "Plain", "Output", "Lanes", "Remark")
                          if named.is_named(("ansatz",), name)}, {"World", "Drag", "Rest", "Spring", "Ray"})
        self.assertTrue(named.is_named(("ansatz", "states"), "Drag< S >"))
        self.assertFalse(named.is_named(("ansatz", "hook"), "Drag"))

    def test_headers(self) -> None:
        """One that is included, that is linked, that has such a type, or the function of its name that is called."""
        for header, text in (("ansatz/motion/drag.hpp", ""), ("ansatz/a.hpp", ""), ("ansatz/b.hpp", "x\ntemplate <class T> struct Rest {\n"),
                             ("ansatz/cast.hpp", "inline void cast(int a) {\n")):
            self.assertTrue(named.is_for_users(header, text), header)
        for header, text in (("ansatz/b.hpp", "struct Rest;\n"), ("ansatz/b.hpp", "struct Lanes {\n    struct Rest {\n"),
                             ("ansatz/b.hpp", "inline void cast(int a) {\n"), ("ansatz/call.hpp", "void call();\n"),
                             ("ansatz/cast.hpp", "// cast(x)\n")):
            self.assertFalse(named.is_for_users(header, text), text)


if __name__ == "__main__":
    unittest.main()
