# SPDX-License-Identifier: BSL-1.0
"""The course in the site's search (tools/workshop/search_index.py)."""

from __future__ import annotations

import os
import tempfile
import unittest

from workshop import search_index

CHAPTER = """## 0 Before the chapter {#section_0}
# Chapter 1: motion {#chapter_motion}
## 1.7 Drag, the *law* {#section_1_7}
## No label
"""


class Words(unittest.TestCase):
    """What finds what."""

    def test_sections(self) -> None:
        """By each word of the title, and by those that mean the same; not by words that say nothing, or by letters."""
        index = search_index.Index()
        index.add_page(CHAPTER, {"1.7": "air resistance of a"})
        section = {"section_1_7.html": "1.7 Drag, the law"}
        self.assertEqual(index.links, {word: section for word in ("1.7", "drag", "law", "air", "resistance")})

    def test_glossary_and_labels(self) -> None:
        """A word finds where it is explained; a heading that is no section is found by its label's words alone."""
        index = search_index.Index()
        index.add_page(CHAPTER + """## More of it {#motion_more}
| word | meaning | where |
|---|---|---|
| slow, terminal speed | a | \\ref section_1_7 "1.7" |
| nowhere | b | \\ref section_9 "9" |
""", {"motion_more": "piles"})
        self.assertEqual(index.links["terminal"], {"section_1_7.html": "1.7 Drag, the law"})
        self.assertEqual(index.links["piles"], {"motion_more.html": "More of it"})
        self.assertFalse({"nowhere", "more", "word"} & set(index.links))

    def test_exercises(self) -> None:
        """From the rows of their list; an apostrophe would end a string of the script."""
        index = search_index.Index()
        index.add_page('| 1.7 | \\ref exercise_motion_drag "Euler\'s drag" | x |\n| a | b |\n', {})
        self.assertEqual(list(index.links), ["exercise", "1.7", "eulers", "drag"])
        self.assertEqual(index.links["drag"], {"exercise_motion_drag.html": "Exercise 1.7: Eulers drag"})

    def test_entries(self) -> None:
        """A full stop is written _2e; a word that two pages have leads to both."""
        index = search_index.Index()
        index.add("1.7 drag", "a.html", "A")
        index.add("drag", "b.html", "B")
        self.assertEqual(index.entries("1"), ",\n  ['1_2e7_topics',['1.7 (course)',['../a.html',1,'A']]]")
        self.assertEqual(index.entries("d"),
                         ",\n  ['drag_topics',['drag (course)',['../a.html',1,'A'],['../b.html',1,'B']]]")
        self.assertEqual(index.entries("x"), "")
        index.add("dam", "c.html", "C")
        self.assertEqual([line.split("_")[0] for line in index.entries("d").split("\n")[1:]], ["  ['dam", "  ['drag"])

    def test_aliases(self) -> None:
        """A remark and an empty line are none."""
        self.assertEqual(search_index.aliases_of("# why\n\n1.7 air  resistance\n"), {"1.7": "air  resistance"})


class Program(unittest.TestCase):
    """The files of the search."""

    def test_written(self) -> None:
        """Into the file of the first letter, the eleventh of which is all_a.js; the others stay."""
        with tempfile.TemporaryDirectory() as folder:
            def write(name: str, text: str) -> str:
                with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
                return os.path.join(folder, name)
            write("searchdata.js", 'var indexSectionsWithContent =\n{\n  0: "1bcefghijkd",\n  1: "b"\n};\n')
            for name in ("all_0.js", "all_1.js", "all_a.js"):
                write(name, "var searchData=\n[\n  ['one',['One']]\n];\n")
            page = write("motion.md", "# Motion {#chapter_motion}\n## 1.7 Drag {#section_1_7}\n")
            self.assertEqual(
                search_index.main(["--search", folder, "--aliases", write("aliases.txt", "# none\n"), page]), 0)
            link = "[['../section_1_7.html',1,'1.7 Drag']]"[1:-1]
            for name, entry in (("all_0.js", f",\n  ['1_2e7_topics',['1.7 (course)',{link}]]"), ("all_1.js", ""),
                                ("all_a.js", f",\n  ['drag_topics',['drag (course)',{link}]]")):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    self.assertEqual(stream.read(), f"var searchData=\n[\n  ['one',['One']]{entry}\n];\n")


if __name__ == "__main__":
    unittest.main()
