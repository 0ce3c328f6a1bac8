# SPDX-License-Identifier: BSL-1.0
"""The navigation of the site (tools/workshop/layout.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import layout


class Tabs(unittest.TestCase):
    """Of chapters, programs and exercises."""

    def test_chapter(self) -> None:
        """With its pages; a heading without a label is none of them."""
        self.assertEqual(
            layout.chapter(["# Chapter 1: *motion* {#chapter_motion}",
                            "## 1.7 `v` & \"<drag>\" {#section_1_7}", "## None", "text {#section_1}"]), [
                '    <tab type="usergroup" visible="yes" url="@ref chapter_motion" title="Chapter 1: motion">',
                '      <tab type="user" visible="yes" url="@ref section_1_7" '
                'title="1.7 v &amp; &quot;&lt;drag>&quot;"/>', "    </tab>"])
        self.assertEqual(layout.chapter(["# A page {#page_world}", "## One {#section_1}"]), [])

    def test_rows(self) -> None:
        """Of the lists that pages.py makes."""
        head = ["# List", "| program | what |", "|---|---|"]
        self.assertEqual(layout.programs([*head, '| \\ref program_motion_1_7_drag "1.7-drag.cpp" | a "b" |']),
                         ['      <tab type="user" visible="yes" url="@ref program_motion_1_7_drag" '
                          'title="1.7-drag.cpp"/>'])
        self.assertEqual(layout.exercises([*head, '| 1.7 | \\ref exercise_motion_drag "Drag" | `./workbook` |']),
                         ['      <tab type="user" visible="yes" url="@ref exercise_motion_drag" title="1.7 Drag"/>'])


class Program(unittest.TestCase):
    """The layout whole."""

    def test_places(self) -> None:
        """Each list in the place of its remark; chapters by their number, 10 behind 2; other pages have no tab here."""
        with tempfile.TemporaryDirectory() as folder:
            def write(name: str, text: str) -> str:
                with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
                return os.path.join(folder, name)
            arguments = ["--programs", write("p.md", '| \\ref program_a "A" |\n'),
                         "--exercises", write("e.md", '| 1 | \\ref exercise_b "B" | c |\n'),
                         write("l.xml", "<a>\n<!-- exercises -->\n<!-- chapters -->\n<!-- programs -->\n</a>\n"),
                         write("10.md", "# Chapter 10: ten {#chapter_ten}\n"), write("a.md", "# Z {#page_z}\n"),
                         write("b.md", "# A {#page_a}\n"), write("2.md", "# Chapter 2: two {#chapter_two}\n")]
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(layout.main(arguments), 0)
            out.seek(0)
            said = [line.partition('title="')[2].partition('"')[0] or line for line in out.read().split("\n")]
            self.assertEqual(said, ["<a>", "1 B", "Chapter 2: two", "    </tab>", "Chapter 10: ten", "    </tab>", "A", "</a>", ""])

    def test_models(self) -> None:
        """By their names, and nothing else of their folder."""
        with tempfile.TemporaryDirectory() as folder:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(folder)
            os.makedirs("tests/package/models")
            for name in ("b.cpp", "a_c.cpp", "a.txt"):
                with open(f"tests/package/models/{name}", "w", encoding="utf-8") as stream:
                    stream.write("//\n")
            for name, text in (("l.xml", "<a>\n<!-- models -->\n</a>\n"), ("p.md", ""), ("d.md", "# A {#page_a}\n")):
                with open(name, "w", encoding="utf-8") as stream:
                    stream.write(text)
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                layout.main(["--programs", "p.md", "--exercises", "p.md", "l.xml", "d.md"])
            out.seek(0)
            self.assertEqual(out.read(), '<a>\n      <tab type="user" visible="yes" url="@ref model_a_c" title="a_c.cpp"/>\n'
                                         '      <tab type="user" visible="yes" url="@ref model_b" title="b.cpp"/>\n</a>\n')

    def test_refusal(self) -> None:
        """Without the list of the programs."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            layout.main(["--exercises", "e", "l.xml", "1.md"])
        self.assertEqual(end.exception.code, 2)

    def test_titles_keep_an_asterisk_that_is_a_name(self) -> None:
        self.assertEqual([layout.plain(title) for title in ("6.1 The A* algorithm", "1 *Why* `World`", "2 **All** of A*")],
                         ["6.1 The A* algorithm", "1 Why World", "2 All of A*"])


if __name__ == "__main__":
    unittest.main()
