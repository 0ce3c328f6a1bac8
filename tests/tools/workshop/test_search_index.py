# SPDX-License-Identifier: BSL-1.0
"""The course in the site's search (tools/workshop/search_index.py)."""

from __future__ import annotations

import os
import tempfile
import unittest
import unittest.mock

from workshop import named, search_index

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

    def test_an_asterisk_that_is_a_name(self) -> None:
        """That of A* stays."""
        index = search_index.Index()
        index.add_page(CHAPTER + "## 6.1 The `A*` search of A* {#section_6_1}\n", {})
        self.assertEqual(index.links["search"], {"section_6_1.html": "6.1 The A* search of A*"})

    def test_glossary_and_labels(self) -> None:
        """A word finds where it is explained; a heading that is no section is found by its label's words alone."""
        index = search_index.Index()
        index.add_page(CHAPTER + """## More of it {#motion_more}
| word | meaning | where |
|---|---|---|
| slow, terminal speed | a | \\ref section_1_7 "1.7" |
| nowhere | b | \\ref section_9 "9" |
""", {"motion_more": "piles"})
        for found in ("slow", "terminal", "terminal speed"):
            self.assertEqual(index.links[found], {"section_1_7.html": "1.7 Drag, the law"})
        self.assertNotIn("slow, terminal speed", index.links)
        self.assertEqual(index.links["piles"], {"motion_more.html": "More of it"})
        self.assertFalse({"nowhere", "more", "word"} & set(index.links))

    def test_exercises(self) -> None:
        """From the rows of their list; an apostrophe would end a string of the script."""
        index = search_index.Index()
        index.add_page('| 1.7 | \\ref exercise_motion_drag "Euler\'s drag" | x |\n| a | b |\n', {})
        self.assertEqual(list(index.links), ["exercise", "1.7", "eulers", "drag"])
        self.assertEqual(index.links["drag"], {"exercise_motion_drag.html": "Exercise 1.7: Eulers drag"})

    def test_phrases(self) -> None:
        """What is in quotes is found as it is typed, and by each of its words; so are a chapter and a page by their labels."""
        index = search_index.Index()
        index.add_page("# Chapter 6: paths {#chapter_paths}\n## 6.1 The A* algorithm {#section_6_1}\n",
                       {"6.1": 'way "k-d tree" "hpa*"', "chapter_paths": '"path finding"'})
        self.assertEqual(index.links["k-d tree"], {"section_6_1.html": "6.1 The A* algorithm"})
        self.assertEqual(index.links["path finding"], {"chapter_paths.html": "Chapter 6: paths"})
        for key in ("way", "tree", "hpa", "hpa*"):
            self.assertIn(key, index.links)
        self.assertIn("['k_2dd_20tree_topics0',['6.1 The A* algorithm',", index.entries("k"))

    def test_entries(self) -> None:
        """A full stop is written _2e; a word that two pages have leads to both."""
        index = search_index.Index()
        index.add("1.7 drag", "a.html", "A")
        index.add("drag", "b.html", "B")
        self.assertEqual(index.entries("1"), ",\n  ['1_2e7_topics0',['A',['../a.html',1,'course']]]")
        self.assertEqual(index.entries("d"), ",\n  ['drag_topics0',['A',['../a.html',1,'course']]]"
                                             ",\n  ['drag_topics1',['B',['../b.html',1,'course']]]")
        self.assertEqual(index.entries("x"), "")
        index.add("dam", "c.html", "C")
        self.assertEqual([line.split("_")[0] for line in index.entries("d").split("\n")[1:]], ["  ['dam", "  ['drag", "  ['drag"])

    def test_aliases(self) -> None:
        """A remark and an empty line are none."""
        self.assertEqual(search_index.aliases_of("# why\n\n1.7 air  resistance\n"), {"1.7": "air  resistance"})


class Insides(unittest.TestCase):
    """What the search of Doxygen finds of the frame."""

    def test_which(self) -> None:
        """Members of types that no user names; types in those; members of types in others; nothing else."""
        with unittest.mock.patch.object(named, "types", lambda: frozenset(("World", "Table"))):
            for page, place in (("classansatz_1_1Lanes", "#a"), ("classansatz_1_1Lanes_1_1Kept", ""), ("structansatz_1_1World_1_1Row", "#a"),
                                ("structansatz_1_1hook_1_1World", "#a"), ("classansatz_1_1Lanes_3_01S_01_4", "#a")):
                self.assertTrue(search_index.is_inside(f"{page}.html", place), page)
            for page, place in (("classansatz_1_1Lanes", ""), ("classansatz_1_1World", "#a"), ("structansatz_1_1World_1_1Row", ""),
                                ("namespaceansatz", "#a"), ("section_1", ""), ("structansatz_1_1states_1_1Table_3_01S_01_4", "#a")):
                self.assertFalse(search_index.is_inside(f"{page}.html", place), page)

    def test_left_out(self) -> None:
        """An entry keeps its other links, and goes with its last one; the last line has no comma. A template of given arguments
        is the template again."""
        with unittest.mock.patch.object(named, "types", lambda: frozenset(("World",))):
            inside, other = "['../classansatz_1_1Lanes.html#a',1,'ansatz::Lanes::f(int a[2])']", "['../classansatz_1_1World.html#b',1,'']"
            inside = inside.replace("[2]", "")
            text = (f"var searchData=\n[\n  ['f_0',['f',{inside},{other}]],\n  ['g_1',['g',{inside}]],\n"
                    f"  ['world_3c_20s_20_3e_2',['World&lt; S &gt;',{other}]],\n  ['h_3',['h',{other}]],\n  ['i_4',['i',{inside}]]\n];\n")
            self.assertEqual(search_index.without_insides(text),
                             f"var searchData=\n[\n  ['f_0',['f',{other}]],\n  ['h_3',['h',{other}]]\n];\n")


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
            link = "['1.7 Drag',['../section_1_7.html',1,'course']]"
            for name, entry in (("all_0.js", f"  ['1_2e7_topics0',{link}],\n"), ("all_1.js", ""),
                                ("all_a.js", f"  ['drag_topics0',{link}],\n")):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    self.assertEqual(stream.read(), f"var searchData=\n[\n{entry}  ['one',['One']]\n];\n")


if __name__ == "__main__":
    unittest.main()
