# SPDX-License-Identifier: BSL-1.0
"""The pages that follow from the tree (tools/workshop/pages.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import named, pages


class OfAProject(unittest.TestCase):
    """Each works in an empty folder."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        named.forget()
        self.addCleanup(named.forget)

    def write(self, file: str, *lines: str) -> None:
        """A file of the project."""
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write("".join(line + "\n" for line in lines))

    def text(self, file: str) -> str:
        """What was written."""
        with open(file, encoding="utf-8") as stream:
            return stream.read()


class Exercises(OfAProject):
    """Their list."""

    def test_in_the_order_of_their_sections(self) -> None:
        """1.9 before 1.10, and 1.6 before 1.6.1."""
        for name, number in (("a", "1.10"), ("b", "1.9"), ("c", "1.6.1"), ("d", "1.6")):
            self.write(f"exercises/1-motion/{name}/README.md", f"# {number} The {name}", "", "Text.")
        rows = [line for line in pages.exercises().split("\n") if "\\ref" in line]
        self.assertEqual([row.split()[1] for row in rows], ["1.6", "1.6.1", "1.9", "1.10"])
        self.assertEqual(rows[0], '| 1.6 | \\ref exercise_motion_d "The d" | `./workbook exercise d` |')


class OneExercise(OfAProject):
    """What stands behind its task."""

    def test_skeleton_and_hints(self) -> None:
        """The skeleton is the solution's, whatever the student has written; each hint is closed, below its heading."""
        folder = "exercises/1-motion/drag"
        self.write(f"{folder}/solution.hpp", "int a() {", "    // task 1: todo(1);", "    return 1;", "    // end of task 1", "}")
        self.write(f"{folder}/exercise.hpp", "int a() { return 7; }")
        self.write(f"{folder}/hints.md", "# Hints: drag", "", "## Task 1: a <question>", "", "Why?", "", "## Task 1: the place",
                   "", "`a`.")
        self.write(f"{folder}/README.md", "# 1.7 Drag", "", "Write `a`.")
        text = pages.exercise(folder, "out", "# Exercise 1.7: Drag\n\nWrite `a`.\n")
        self.assertTrue(text.startswith("# Exercise 1.7: Drag\n\nWrite `a`.\n\n## What you edit\n"))
        self.assertIn("todo(1);", self.text("out/listing/exercises/1-motion/drag/exercise.hpp"))
        self.assertNotIn("return", self.text("out/listing/exercises/1-motion/drag/exercise.hpp"))
        self.assertIn("\\include listing/exercises/1-motion/drag/exercise.hpp\n", text)
        self.assertIn("<details><summary>Task 1: a &lt;question&gt;</summary>\\endhtmlonly\n\nWhy?\n\n", text)
        self.assertEqual(text.count("<details>"), 2)
        self.assertEqual(text.count("</details>"), 2)

    def test_picture_of_its_section(self) -> None:
        """Behind the opening words; a task that has one of its own keeps it alone."""
        self.write("docs/motion.md", "# Chapter 1 {#chapter_motion}", "", "## 1.7 Drag {#section_1_7}", "",
                   '\\image html 1.7.svg "Falling" width=640px')
        task = "# Exercise 1.7: Drag\n\n`./workbook exercise drag`\n\nAir resists.\n\n**Write** it.\n"
        self.assertEqual(pages.illustrated(task, "1.7"), "# Exercise 1.7: Drag\n\n`./workbook exercise drag`\n\n"
                         'Air resists.\n\n\\image html 1.7.svg "Falling" width=640px\n\n**Write** it.\n')
        own = task + '\n\\image html own.svg "Mine"\n'
        self.assertEqual(pages.illustrated(own, "1.7"), own)
        self.assertEqual(pages.illustrated(task, "2.1"), task)


class Reading(OfAProject):
    """The front, and what leads from page to page."""

    def setUp(self) -> None:
        super().setUp()
        self.write("docs/water.md", "# Chapter 10: water {#chapter_water}", "", "[TOC]", "", "It flows. It", "waves.", "", "More.")
        self.write("docs/motion.md", "# Chapter 2: motion {#chapter_motion}", "", "It moves and", "moves! Or not.")
        self.write("docs/other.md", "# Other {#page_other}", "", "Text.")
        self.write("exercises/1-motion/drag/README.md", "# 1.7 A & B", "", "Text.")
        for name in ("1.10-b", "1.9-a"):
            self.write(f"chapters/1-motion/{name}.cpp", "// A program", "int main() {}")

    def test_order(self) -> None:
        """Numbers, not letters; a group each."""
        self.assertEqual(pages.order().split("\n"), [
            "chapter_motion\tChapter 2: motion", "chapter_water\tChapter 10: water", "",
            "exercise_motion_drag\t1.7 A &amp; B", "", "program_motion_1_9_a\t1.9-a.cpp",
            "program_motion_1_10_b\t1.10-b.cpp", "", "page_world\tWorlds", ""])
        for name in ("b.cpp", "a.cpp", "a.txt"):
            self.write(f"tests/package/models/{name}", "// A model")
        self.assertTrue(pages.order().endswith("\n\npage_world\tWorlds\nmodel_a\ta.cpp\nmodel_b\tb.cpp\n"))

    def test_front(self) -> None:
        """Its places are filled; that of the demo stays empty until there is one."""
        self.write("docs/site/front.md", "# Ansatz {#mainpage}", "FILM", "DEMO", "CHAPTERS", "VERSION")
        said = pages.front("1.2", "front.svg").split("\n")
        self.assertEqual(said, [
            "# Ansatz {#mainpage}", "\\image html front.svg width=760px",
            '- \\ref chapter_motion "2. motion": It moves and moves!', '- \\ref chapter_water "10. water": It flows.', "1.2", ""])
        self.write("docs/site/demo.html", "<canvas></canvas>")
        self.assertIn("\\htmlinclude docs/site/demo.html", pages.front("1.2", "front.svg"))


class Library(OfAProject):
    """The headers."""

    def test_first_sentences(self) -> None:
        """Up to where a sentence ends and another begins; the end of the first paragraph ends it too."""
        for lines, sentence in (
                (["/// \\file", "/// One", "/// two. Three.", "/// Four."], "One two."),
                (["/// \\file", "/// It is 1.7 e.g. that:", "///", "/// Two."], "It is 1.7 e.g. that."),
                (["// remark", "/// before", "/// \\file", "/// After. `This` too."], "After."), (["int i;"], "")):
            self.assertEqual(pages.first_sentence(lines), sentence)

    def test_modules(self) -> None:
        """A table for each umbrella, of what stands below it; a bar would end the cell."""
        self.write("include/ansatz/motion.hpp", "/// \\file", "/// All.")
        self.write("include/ansatz/motion/drag.hpp", "/// \\file", "/// |v|.")
        self.assertEqual(pages.library().partition("\n\n## ")[2],
                         "motion {#headers_motion}\n\n| header | what it holds |\n|---|---|\n"
                         '| \\ref ansatz/motion/drag.hpp "motion/drag.hpp" | \\|v\\|. |\n')

    def test_insides(self) -> None:
        """What no user names stands behind the others, in a table of its own."""
        for name in ("a", "b", "c"):
            self.write(f"include/ansatz/motion/{name}.hpp", "/// \\file", f"/// It is {name}.")
        self.write("include/ansatz/motion.hpp", "/// \\file", "/// All.")
        self.write("chapters/1-motion/1.cpp", "#include <ansatz/motion/b.hpp>")
        head = "| header | what it holds |\n|---|---|\n"
        self.assertEqual(pages.library().partition("{#headers_motion}\n\n")[2],
                         f'{head}| \\ref ansatz/motion/b.hpp "motion/b.hpp" | It is b. |\n\nThe insides of motion:\n\n{head}'
                         '| \\ref ansatz/motion/a.hpp "motion/a.hpp" | It is a. |\n'
                         '| \\ref ansatz/motion/c.hpp "motion/c.hpp" | It is c. |\n')


class Programs(OfAProject):
    """Of the chapters."""

    def test_written(self) -> None:
        """A page and a listing each, and their list: sections by their numbers, links where a page has the section."""
        self.write("docs/motion.md", "## 1.7 Drag {#section_1_7}")
        self.write("chapters/1-motion/1.7-drag.cpp", "// SPDX-License-Identifier: BSL-1.0", "//", "// 1.7 Drag: <slow>",
                   "    //! [rate]", "int i;", "//! [rate]")
        self.write("chapters/1-motion/1.10-late.cpp", "// - a list", "/// \\file", "/// 1.10 Late")
        self.write("chapters/1-motion/problems.hpp", "// 2 problems")
        pages.programs("out")
        self.assertEqual(self.text("out/pages/programs.md").partition("\n\n## ")[2],
                         "1. motion {#programs_motion}\n\n| program | what it shows |\n|---|---|\n"
                         '| \\ref program_motion_1_7_drag "1.7-drag.cpp" | Drag: \\<slow\\> |\n'
                         '| \\ref program_motion_1_10_late "1.10-late.cpp" | Late |\n'
                         '| \\ref program_motion_problems_hpp "problems.hpp" | 2 problems |\n')
        self.assertEqual(self.text("out/pages/program_motion_1_7_drag.md"),
                         "# 1.7-drag.cpp {#program_motion_1_7_drag}\n\n"
                         'The program of section \\ref section_1_7 "1.7": '
                         "`./workbook section 1.7` builds and runs it.\n\n"
                         "\\include listing/1-motion/1.7-drag.cpp\n")
        self.assertIn("The program of section 1.10: ", self.text("out/pages/program_motion_1_10_late.md"))
        self.assertEqual(self.text("out/pages/program_motion_problems_hpp.md"),
                         "# problems.hpp {#program_motion_problems_hpp}\n\n\\include listing/1-motion/problems.hpp\n")
        self.assertEqual(self.text("out/listing/1-motion/1.7-drag.cpp"),
                         "// SPDX-License-Identifier: BSL-1.0\n//\n// 1.7 Drag: <slow>\nint i;\n")

    def test_models(self) -> None:
        """A page each, with the whole file and the way back."""
        self.write("tests/package/models/law.cpp", "// SPDX-License-Identifier: BSL-1.0", "// A law.", "//! [model]", "int i;", "//! [model]")
        pages.models("out")
        self.assertEqual(self.text("out/pages/model_law.md").split("\n\n")[:4], [
            "# law.cpp {#model_law}", "A law.", "\\include listing/models/law.cpp",
            'One of the policies of \\ref page_world "the page about worlds"; it is compiled against an installed Ansatz, and run.\n'])
        self.assertEqual(self.text("out/listing/models/law.cpp"), "// SPDX-License-Identifier: BSL-1.0\n// A law.\nint i;\n")

    def test_printed(self) -> None:
        """The two lists that are no files."""
        for kind, title in (("exercises", "# Exercises {#page_exercises}"),
                            ("library", "# The library {#page_library}")):
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(pages.main([kind]), 0)
            out.seek(0)
            self.assertEqual(out.read().split("\n")[0], title)

    def test_refusals(self) -> None:
        """No kind of page, one that there is not, programs without a folder."""
        for arguments in ("", "chapters", "programs"):
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
                pages.main(arguments.split())
            self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
