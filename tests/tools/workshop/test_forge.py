# SPDX-License-Identifier: BSL-1.0
"""Text pages as a forge shows them, and as Doxygen reads them (tools/workshop/forge.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import course, forge

# What may be written, and what write makes of it; Doxygen reads the left of both.
PAIRS = (
    ("# Chapter 1: motion {#chapter_motion}", '# Chapter 1: motion <a id="chapter_motion"></a>'),
    ('See \\ref section_1_7 "1.7".', "See [1.7](#section_1_7)."),
    ('See \\ref section_2_1 "2.1".', "See [2.1](collision.md#section_2_1)."),
    ('See \\ref chapter_collision "chapter 2".', "See [chapter 2](collision.md)."),
    ('| \\ref ansatz::Drag "Drag" | it |', '| [Drag](../include/ansatz/motion/drag.hpp "ansatz::Drag") | it |'),
    ('A \\ref ansatz/motion/drag.hpp "header".', "A [header](../include/ansatz/motion/drag.hpp)."),
    ('- Exercise: \\ref exercise_motion_drag "drag".', "- Exercise: [drag](../exercises/1-motion/drag/README.md)."),
    ('\\ref program_motion_1_7_drag "1.7-drag.cpp"', "[1.7-drag.cpp](../chapters/1-motion/1.7-drag.cpp)"),
    ('\\ref model_law "law.cpp"', "[law.cpp](../tests/package/models/law.cpp)"),
    ("With \\f$ v = a\\,t \\f$ it is \\f$ x \\f$.", "With $`v = a\\,t`$ it is $`x`$."),
    ("\\f[\na = -c\\,v\n\\f]", "```math\na = -c\\,v\n```"),
    ("1. One:\n   \\f[\n   a\n   \\f]\n   and so on", "1. One:\n   ```math\n   a\n   ```\n   and so on"),
    ('\\image html 1.7-film.svg "A film" width=640px', "![A film](pictures/1.7-film.svg)"),
    ('\\image html 1.7-film.svg "Wide" width=100%', '![Wide](pictures/1.7-film.svg "100%")'),
    ('\\image html 1.7.svg "A curve, at 0.5 s" width=640px',
     'Picture: [A curve, at 0.5 s](../chapters/1-motion/1.7-drag.cpp "picture 1.7.svg")'),
    ("\\htmlinclude table.html", "<!-- site: table.html -->"),
    ("Code: `\\ref x`, `{#y}` and ``\\f$ `` stay.\n\n```sh\n\\ref x\n```", "Code: `\\ref x`, `{#y}` and ``\\f$ `` stay.\n\n```sh\n\\ref x\n```"),
)
QUOTED = "<!-- snippet: 1-motion/1.7-drag.cpp by hand -->\n```cpp\nint i = 0;\n\n++i;\n```"
OUTPUT = "<!-- output: docs/recordings/1.7.txt -->\n```text\nIt falls.\n```"


class Pages(unittest.TestCase):
    """In a small project."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        for forget in (forge.labels.cache_clear, forge.files_of_labels.cache_clear, forge.header_of.cache_clear,
                       forge.snippet.cache_clear, course.text_of.cache_clear, course.headers_of_names.cache_clear):
            forget()
            self.addCleanup(forget)
        for file, text in {
                "docs/motion.md": '# Chapter 1: motion <a id="chapter_motion"></a>\n\n## 1.7 Drag {#section_1_7}\n',
                "docs/collision.md": "# Chapter 2: collision {#chapter_collision}\n\n## 2.1 Detection {#section_2_1}\n",
                "docs/recordings/1.7.txt": "It falls.\n", "docs/pictures/1.7-film.svg": "<svg/>\n",
                "include/ansatz/motion/drag.hpp": "namespace ansatz {\nstruct Drag {\n};\ninline constexpr Motion fixed = 1;\n}\n",
                "exercises/1-motion/drag/README.md": "# 1.7 Drag\n",
                "tests/package/models/law.cpp": "//\n",
                "chapters/1-motion/1.7-drag.cpp":
                    "int main() {\n    //! [by hand]\n    int i = 0;\n\n    //! [step]\n    ++i;\n    //! [step]\n    //! [by hand]\n}\n",
        }.items():
            self.write(file, text)

    @staticmethod
    def write(file: str, text: str) -> None:
        """A file of the project."""
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)

    def test_both_ways(self) -> None:
        """What Doxygen has a command for is Markdown on a forge, and that is the command again on the site."""
        for command, markdown in PAIRS:
            with self.subTest(markdown):
                self.assertEqual(forge.markdown("docs/motion.md", command), markdown)
                self.assertEqual(forge.markdown("docs/motion.md", markdown), markdown)
                self.assertEqual(forge.doxygen(markdown), command)
        self.assertEqual(forge.markdown("docs/motion.md", "\\f[ a \\f]"), "```math\na\n```")
        self.assertEqual(forge.markdown("docs/motion.md", "# A\n\n[TOC]\n\nB"), "# A\n\nB")
        self.assertEqual(forge.markdown("docs/motion.md", "\\ref section_1_7"), "[1.7](#section_1_7)")
        self.assertEqual(forge.markdown("docs/motion.md", '\\ref ansatz::fixed "fixed"'),
                         '[fixed](../include/ansatz/motion/drag.hpp "ansatz::fixed")')
        self.assertEqual(forge.markdown("docs/motion.md", '\\ref nowhere "x"'), '\\ref nowhere "x"')

    def test_ordinary_links(self) -> None:
        """A link that leads to no page of the site stays, and so does its text in code."""
        for link in ("[x](https://example.org)", "[x](#here)", "[x](../tools/mirror)", "![x](docs/a.svg)"):
            self.assertEqual(forge.doxygen(link), link)
        link = "[`drag.hpp`](../include/ansatz/motion/drag.hpp)"
        self.assertEqual(forge.doxygen(link), '\\ref ansatz/motion/drag.hpp "drag.hpp"')
        self.assertEqual(forge.markdown("docs/motion.md", link), link)

    def test_quotations(self) -> None:
        """Code without its marks and at the margin, and output; both are written anew, and keep their lines for Doxygen."""
        for command, markdown in (("\\snippet{trimleft} 1-motion/1.7-drag.cpp by hand", QUOTED),
                                  ("\\verbinclude docs/recordings/1.7.txt", OUTPUT)):
            self.assertEqual(forge.markdown("docs/motion.md", command), markdown)
            self.assertEqual(forge.doxygen(markdown), command + "\n" * markdown.count("\n"))
        self.assertEqual(forge.markdown("docs/motion.md", QUOTED.replace("int i = 0;", "int j = 9;\n\nold();")), QUOTED)
        self.assertEqual(forge.markdown("docs/motion.md", OUTPUT.replace("falls", "flies")), OUTPUT)

    def test_faults(self) -> None:
        """Each is planted alone, and told with its line."""
        good = f'# A <a id="page_a"></a>\n\n[1.7](motion.md#chapter_motion), `\\ref x<y>`.\n\n{QUOTED}\n\n{OUTPUT}\n'
        self.assertEqual(forge.faults_of("docs/a.md", good), [])
        for planted, told in {
                '\\ref section_1_7 "1.7"': "docs/a.md:17: a forge shows \\ref as it is written",
                "\\f$ x \\f$": "docs/a.md:17: a forge shows \\f$ as it is written", "## B {#b}": "docs/a.md:17: a forge shows {#b}",
                "[TOC]": "docs/a.md:17: a forge shows [TOC]", '\\image html 1.7.svg "x"': "docs/a.md:17: a forge shows \\image",
                QUOTED.replace("++i", "--i"): "docs/a.md:21: what it quotes or links to is otherwise now: \"--i;\"",
                OUTPUT.replace("falls", "flies"): "docs/a.md:19: what it quotes or links to is otherwise now: \"It flies.\"",
                QUOTED.replace("by hand", "nothing"): "docs/a.md:17: what it quotes or links to is otherwise now",
                "[x](nowhere.md)": "docs/a.md:17: there is no docs/nowhere.md, to which it links",
                "[x](collision.md#nowhere)": "docs/a.md:17: docs/collision.md has no place 'nowhere', to which it links",
                "![x](pictures/2.svg)": "docs/a.md:17: there is no docs/pictures/2.svg",
                "The Odeint<Stepper> of Boost.": "docs/a.md:17: a forge takes <Stepper> for HTML and drops it",
                "<!-- costs: x --> A sentence.": "docs/a.md:17: a forge shows text behind a comment as HTML",
                "| a | b |\n|---|---|\n| `x || y` | z |": "docs/a.md:19: a forge cuts this row: 4 cells, the head of its table has 2",
        }.items():
            with self.subTest(planted):
                found = forge.faults_of("docs/a.md", good + "\n" + planted + "\n")
                self.assertTrue(any(told in fault for fault in found), found)

    def test_program(self) -> None:
        """write says which page it wrote, once."""
        self.write("docs/a.md", 'See \\ref section_1_7 "1.7".\n')
        said = []
        for asked in ("check", "write", "write"):
            with contextlib.redirect_stdout(io.StringIO()) as out:
                self.assertEqual(forge.main([asked, "docs/a.md"]), 0)
            said.append(out.getvalue())
        self.assertIn("docs/a.md:1: a forge shows \\ref", said[0])
        self.assertEqual(said[1:], ["written anew: docs/a.md\n", ""])
        self.assertEqual(forge.page("docs/a.md"), 'See \\ref section_1_7 "1.7".\n')


if __name__ == "__main__":
    unittest.main()
