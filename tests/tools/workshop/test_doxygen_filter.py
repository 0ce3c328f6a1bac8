# SPDX-License-Identifier: BSL-1.0
"""What Doxygen reads instead of a file (tools/workshop/doxygen_filter.py)."""

from __future__ import annotations

import contextlib
import io
import unittest

from test_link_targets import OfAProject
from workshop import doxygen_filter, link_targets


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

    def test_names_in_concepts(self) -> None:
        """Doxygen finds none of these itself; in other headers it does."""
        self.assertEqual(self.header("concepts", "/// As `Drag`."), ['/// As <code>\\ref ansatz::Drag "Drag"</code>.'])
        self.assertEqual(self.header("other", "/// As `Drag`."), ["/// As `Drag`."])


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

    def test_exercises_that_lead_to_the_header(self) -> None:
        """That of its name first; the section of one says more where it lies below that of the notes, and only there."""
        link = "[`thing.hpp`](../../../include/ansatz/motion/thing.hpp)"
        for name, number in (("split", "1.9.3"), ("halved", "1.8")):
            self.write(f"exercises/1-motion/{name}/README.md", f"# {number} A title", "", f"See {link}, {link}.")
        halved, split = (f'\\ref exercise_motion_{name} "{name}"' for name in ("halved", "split"))

        def taught(notes: str, path: str = "include/ansatz/motion/thing.hpp") -> str:
            header = doxygen_filter.Header(link_targets.Course(), path)
            return [line for row in ("/// \\file", f"/// {notes}", "int i;") for line in header.filtered(row)][-2]
        self.assertEqual(taught("(notes 1.9)"), f"/// Section 1.9.3, exercises {halved} and {split}.")
        self.assertEqual(taught("(notes 1.7)"), f'/// Section \\ref section_1_7 "1.7", exercises {halved} and {split}.')
        self.assertEqual(taught("Plain."), f"/// The exercises {halved} and {split}.")
        self.assertEqual(taught("Plain.", "include/ansatz/motion/other.hpp"), "/// Plain.")
        self.write("exercises/1-motion/thing/README.md", "# 1.7 A title")
        self.assertEqual(taught("Plain."), f'/// The exercises \\ref exercise_motion_thing "thing", {halved} and {split}.')

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
