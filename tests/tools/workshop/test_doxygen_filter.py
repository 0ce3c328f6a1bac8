# SPDX-License-Identifier: BSL-1.0
"""What Doxygen reads instead of a file (tools/workshop/doxygen_filter.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import doxygen_filter


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


class Links(OfAProject):
    """In comments of headers, and on text pages."""

    def test_sections(self) -> None:
        """Behind "(notes ", where a page has them; elsewhere numbers are numbers."""
        self.assertEqual(self.header("a", "/// Linear (notes 1.8, 1.7 and 1.9), in 1.7.", "int i = 0; // (notes 1.7)"),
                         ['/// Linear (notes 1.8, \\ref section_1_7 "1.7" and \\ref section_1_9 "1.9"), in 1.7.',
                          "int i = 0; // (notes 1.7)"])

    def test_names(self) -> None:
        """Of what headers are named after, with the namespace; a declaration is no type; fences are left alone."""
        self.assertEqual(self.page("`Drag`, `Cell`, `Later`.", "# `Drag`", "```", "`Drag`", "```"), [
            '<code>\\ref ansatz::Drag "Drag"</code>, <code>\\ref ansatz::paths::Cell "Cell"</code>, `Later`.',
            "# `Drag`", "```", "`Drag`", "```"])

    def test_readme(self) -> None:
        """Gets its label here, so that a forge shows none."""
        self.write("./README.md", "# Ansatz", "", "Text.")
        self.assertEqual(doxygen_filter.filtered("README.md"), ["# At a glance {#page_readme}", "", "Text."])

    def test_names_in_concepts(self) -> None:
        """Doxygen finds none of these itself; in other headers it does."""
        self.assertEqual(self.header("concepts", "/// As `Drag`."), ['/// As <code>\\ref ansatz::Drag "Drag"</code>.'])
        self.assertEqual(self.header("other", "/// As `Drag`."), ["/// As `Drag`."])

    def test_files(self) -> None:
        """A link to a file of the project leads to its page."""
        for target, becomes in {
                "motion.md": '\\ref chapter_motion "x"', "plain.md": "[x](docs/plain.md)",
                "../README.md": '\\ref page_readme "x"', "../LICENSE": '<a href="LICENSE.txt">x</a>',
                "../include/ansatz/motion/drag.hpp": '\\ref ansatz/motion/drag.hpp "x"',
                "../exercises/1-motion/drag/": '\\ref exercise_motion_drag "x"',
                "../exercises/1-motion/drag/README.md": '\\ref exercise_motion_drag "x"',
                "../exercises/1-motion": '\\ref page_exercises "x"',
                "../exercises/1-motion/drag/solution.hpp": "`x`",
                "../chapters/1-motion": '\\ref chapter_motion "x"',
                "../chapters/9-magic": '\\ref page_programs "x"', "../chapters": '\\ref page_programs "x"',
                "../chapters/1-motion/1.7-drag.cpp": '\\ref program_motion_1_7_drag "x"',
                "../chapters/1-motion/problems.hpp": '\\ref program_motion_problems_hpp "x"',
                "../tools/mirror": "`x`", "https://example.org": "[x](https://example.org)",
                "#here": "[x](#here)"}.items():
            with self.subTest(target):
                self.assertEqual(self.page(f"A [`x`]({target})." if "`" in becomes else f"A [x]({target})."),
                                 [f"A {becomes}."])
        self.assertEqual(self.page("A picture ![x](motion.md)."), ["A picture ![x](motion.md)."])


class Pages(OfAProject):
    """Their beginnings."""

    def test_contents(self) -> None:
        """Of three sections on, unless the page has them already."""
        sections = ["## a", "## b", "## c"]
        self.assertEqual(self.page("# Title", *sections), ["# Title", "", "[TOC]", *sections])
        self.assertEqual(self.page("# Title", *sections[:2]), ["# Title", *sections[:2]])
        own = ["# Title", *sections, "\\tableofcontents"]
        self.assertEqual(self.page(*own), own)

    def test_exercise(self) -> None:
        """Its title says its number, its second paragraph its command; the first section of a line is a link."""
        self.assertEqual(doxygen_filter.filtered("exercises/1-motion/drag/README.md"), [
            "# Exercise 1.7: Drag {#exercise_motion_drag}", "",
            "`./workbook exercise drag` builds and tests your answer, which you write in "
            "`exercises/1-motion/drag/exercise.hpp`.", "", 'Notes \\ref section_1_7 "1.7" and Notes 1.8.'])

    def test_other_files(self) -> None:
        """The list of the headers gets its links to sections; what is made already, and what is no page, stays."""
        for file, line in (("build/pages/library.md", '(notes \\ref section_1_7 "1.7") `Drag`'),
                           ("build/pages/exercises.md", "(notes 1.7) `Drag`"), ("docs/a.dox", "(notes 1.7) `Drag`")):
            self.write(file, "(notes 1.7) `Drag`")
            self.assertEqual(doxygen_filter.filtered(file), [line])


class Headers(OfAProject):
    """What is told twice, and what is told once for all."""

    def test_the_policy_is_told_of(self) -> None:
        """The page of Drag, which has no comment of its own, tells what the header tells; both say where it is
        taught."""
        taught = ["/// \\par In the course",
                  '/// Section \\ref section_1_7 "1.7", exercise \\ref exercise_motion_drag "drag".']
        told = ["/// Drag (notes \\ref section_1_7 \"1.7\").", "///", "/// When to use it."]
        self.assertEqual(
            self.header("drag", "/// \\file", "/// Drag (notes 1.7).", "///", "// a remark", "/// When to use it.", "",
                        "struct Drag;", "struct Drag {"),
            ["/// \\file", told[0], "///", "///", told[2], *taught, "", "struct Drag;",
             "///", *told, *taught, "struct Drag {"])

    def test_without_an_exercise(self) -> None:
        """Only the section is said; and without a comment of the file nothing is."""
        taught = ["/// \\par In the course", '/// Section \\ref section_1_9 "1.9".']
        self.assertEqual(self.header("thing", "/// \\file", "/// (notes 1.9).", "int i;")[2:], [*taught, "int i;"])
        self.assertEqual(self.header("thing", "struct Thing {", "int i;"), ["struct Thing {", "int i;"])

    def test_a_comment_of_its_own(self) -> None:
        """Is its first sentence: the header's is not told again. One that begins with a command is none."""
        lines = ["/// \\file", "/// All.", "///", "/// More.", "", "/// Own.", "struct Thing {"]
        self.assertEqual(self.header("thing", *lines), [*lines[:6], "///", "/// More.", lines[6]])
        lines[5] = "/// \\tparam S space"
        self.assertEqual(self.header("thing", *lines),
                         [*lines[:6], "///", "/// \\brief All.", "///", "/// More.", lines[6]])

    def test_members(self) -> None:
        """That every policy has, before or behind; not with a comment of their own, and no others."""
        self.assertEqual(self.header(
            "a", "    using role = Force;", "    static constexpr int order = 2; ///< mine", "    using mine = int;",
            "    void check() const {}", "    static constexpr Set reads = columns{}",
            "    template <class Cost, class Graph>"), [
                "    /** the role that it has in a world */ using role = Force;",
                "    static constexpr int order = 2; ///< mine", "    using mine = int;",
                "    /** refuses parameters out of their range: std::invalid_argument with name, value and range */ "
                "void check() const {}",
                "    static constexpr Set reads = columns{} ///< the columns that it reads",
                "    /** the estimate for one graph and goal: a function of a vertex */ "
                "template <class Cost, class Graph>"])

    def test_functions_of_boost(self) -> None:
        """Without a comment before them."""
        self.assertEqual(
            self.header("a", "inline int source(Edge e) {", "/// Mine.", "inline int source(Edge e) {",
                        "void source(Edge);"),
            ["/** the vertex that an edge leaves */ inline int source(Edge e) {", "/// Mine.",
             "inline int source(Edge e) {", "void source(Edge);"])

    def test_inside_a_world(self) -> None:
        """What a policy is there is hidden up to the brace of the same indentation."""
        self.assertEqual(self.header("a", "    struct In {", "        };", "    };", "    struct In { int i; };"),
                         ["/** \\cond */     struct In {", "        };", "    }; /** \\endcond */",
                          "    struct In { int i; };"])

    def test_refusal(self) -> None:
        """It takes one file."""
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(doxygen_filter.main([]), 2)
        self.assertIn("usage: doxygen_filter.py FILE", said.getvalue())


if __name__ == "__main__":
    unittest.main()
