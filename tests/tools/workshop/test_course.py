# SPDX-License-Identifier: BSL-1.0
"""The course as one table, its holes, and words before their explanation (tools/workshop/course.py)."""

from __future__ import annotations

import contextlib
import os
import tempfile
import unittest
from typing import Iterator, Mapping, Optional

from workshop import course

PAGE = r"""# Chapter 1: motion {#chapter_motion}

Of inertia, before anything begins.

## 1.7 Drag {#section_1_7}

Air resists. A word: *inertia*.

- Program: the program.
- Library: \ref ansatz::Drag "Drag", `FrameDrag`,
  and decay of `motion/decay.hpp`.
- Exercise: \ref exercise_motion_drag "drag".

## 1.8 Rest {#section_1_8}

A *threshold* and `inertia`.

- Library: \ref ansatz::rest "rest".
- Exercise: \ref exercise_motion_rest "rest".

## Glossary {#motion_words}

| word | meaning | where |
|---|---|---|
| inertia | it goes on | \ref section_1_7 "1.7" |
| threshold, slow start | from where on | \ref section_1_8 "1.8" |
"""
FILES = {
    "docs/motion.md": PAGE.replace("`inertia`", "a *slow\nstart*"),
    "chapters/1-motion/1.7-drag.cpp": "", "chapters/1-motion/1.8-rest.cpp": "", "chapters/1-motion/problems.hpp": "",
    "include/ansatz/motion/drag.hpp": "struct Drag {\n", "include/ansatz/motion/frame_drag.hpp": "struct FrameDrag {\n",
    "include/ansatz/motion/decay.hpp": "", "include/ansatz/motion/rest.hpp": "inline Motion rest(int a) {\n",
    "tests/motion/drag.cpp": "#include <ansatz/motion/frame_drag.hpp>\n", "tests/motion/decay.cpp": "",
    # Of another module, and of a namespace of its own: not what is meant.
    "include/ansatz/collision/rest.hpp": "inline Motion rest(int a) {\n",
    "include/ansatz/motion/body.hpp": "namespace ansatz::other {\nstruct Drag {\n",
    # Says that there is such a type, and no more.
    "include/ansatz/motion/all.hpp": "struct Still;\ntemplate <class Of> class Slow; // of anything\n",
    "include/ansatz/motion/low.hpp": "struct Still {\ntemplate <class Of>\nclass Slow : Of {\n",
    "exercises/1-motion/drag/README.md": "# 1.7 Drag\n", "exercises/1-motion/rest/README.md": "# 1.8 Rest\n",
    "tests/world/all.cpp": "#include <ansatz/motion/rest.hpp>\n",
}


@contextlib.contextmanager
def project(changed: Mapping[str, Optional[str]]) -> Iterator[None]:
    """A folder with a small course; None removes a file."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for file, text in (FILES | dict(changed)).items():
            if text is None:
                continue
            os.makedirs(os.path.dirname(file), exist_ok=True)
            with open(file, "w", encoding="utf-8") as stream:
                stream.write(text)
        course.text_of.cache_clear()
        course.headers_of_names.cache_clear()
        course.tests_of.cache_clear()
        try:
            yield
        finally:
            os.chdir(before)


class Table(unittest.TestCase):
    """Each section with all that belongs to it."""

    def test_a_row(self) -> None:
        """Headers by link, by name and by path; tests by name and by what they include."""
        with project({}):
            drag, rest = course.sections()
            self.assertEqual((drag.number, drag.title, drag.label), ("1.7", "Drag", "section_1_7"))
            self.assertEqual(drag.headers, ["motion/drag.hpp", "motion/frame_drag.hpp", "motion/decay.hpp"])
            self.assertEqual(drag.exercises, ["exercise_motion_drag"])
            self.assertEqual(rest.headers, ["motion/rest.hpp"])
            self.assertEqual(course.headers_in("`Still`, `Slow`", "motion"), ["motion/low.hpp"])
            self.assertEqual(course.tests_of("motion/frame_drag.hpp"), ("tests/motion/drag.cpp",))
            self.assertEqual(course.tests_of("motion/rest.hpp"), ("tests/world/all.cpp",))
            self.assertIn('| \\ref section_1_7 "1.7 Drag" | \\ref program_motion_1_7_drag "drag" | \\ref ansatz/motion/drag.hpp "drag.hpp", ',
                          course.table())
            self.assertIn("| drag.cpp, decay.cpp |", course.table())
            self.assertEqual(course.holes({}), [])

    def test_tests(self) -> None:
        """By name; else who includes it and speaks most of it, and not what tests share but those that include that."""
        with project({
                "include/ansatz/motion/slope.hpp": "struct Slope {\ninline int steepness(int a) {\n",
                "tests/motion/a.cpp": "#include <ansatz/motion/slope.hpp>\n", "tests/motion/b.cpp": '#include "shared.hpp"\nSlope\n',
                "tests/motion/c.cpp": "#include <ansatz/motion/slope.hpp>\nSlope steepness\n",
                "tests/motion/shared.hpp": "#include <ansatz/motion/slope.hpp>\nSlope Slope Slope\n",
                "tests/world/slopes.cpp": "#include <ansatz/motion/slope.hpp>\nSlope Slope Slope\n"}):
            self.assertEqual(course.tests_of("motion/slope.hpp"), ("tests/motion/c.cpp", "tests/motion/b.cpp"))
            self.assertEqual(course.tests_of("motion/decay.hpp"), ("tests/motion/decay.cpp",))

    def test_names(self) -> None:
        """Two headers of one name are told apart; a title keeps the asterisk of A*."""
        page = FILES["docs/motion.md"].replace("## 1.8 Rest", "## 1.8 *A* `rest` of A*").replace(
            '\\ref ansatz::rest "rest"', "`motion/rest.hpp`, `collision/rest.hpp`, `motion/decay.hpp`")
        with project({"docs/motion.md": page}):
            self.assertIn('"1.8 A rest of A*" |', course.table())
            self.assertIn('"motion/rest.hpp", \\ref ansatz/collision/rest.hpp "collision/rest.hpp", \\ref ansatz/motion/decay.hpp "decay.hpp" |',
                          course.table())

    def test_exercise_of_another_module(self) -> None:
        """Named as it is called, without the module."""
        page = FILES["docs/motion.md"].replace("exercise_motion_rest", "exercise_soft_bodies_cloth")
        with project({"docs/motion.md": page, "chapters/4-soft_bodies/4-a.cpp": "", "docs/soft_bodies.md": ""}):
            self.assertIn('\\ref exercise_soft_bodies_cloth "cloth" |', course.table())

    def test_holes(self) -> None:
        """Each kind, alone."""
        page = FILES["docs/motion.md"]
        without: dict[str, Optional[str]] = {"exercises/1-motion/rest/README.md": None}
        cases: tuple[tuple[dict[str, Optional[str]], str], ...] = (
                (without | {"docs/motion.md": page.replace("{#section_1_8}", "")}, "has no section 1.8"),
                ({"docs/motion.md": page.replace('- Library: \\ref ansatz::rest "rest".', "")}, "names no header"),
                ({"docs/motion.md": page.replace("- Exercise: \\ref exercise_motion_rest", "- See \\ref a")}, "has no exercise"),
                ({"tests/world/all.cpp": ""}, "motion/rest.hpp, which section 1.8 teaches, has no test"),
                ({"exercises/1-motion/suvat/README.md": "# 1.5 SUVAT\n", "docs/motion.md": page + "\n\\ref exercise_motion_suvat\n"},
                 "section 1.5 does not name its exercise suvat"),
                ({"exercises/1-motion/drag/README.md": "# 1.8 Drag\n"}, "section 1.8 does not name its exercise drag"))
        for changed, says in cases:
            with project(changed):
                self.assertEqual(len(course.holes({})), 1, says)
                self.assertIn(says, course.holes({})[0])

    def test_linked_nowhere(self) -> None:
        """Is not told here."""
        with project({"exercises/1-motion/suvat/README.md": "# 1.5 SUVAT\n"}):
            self.assertEqual(course.holes({}), [])

    def test_without_exercise(self) -> None:
        """Who is in the list needs none; it holds neither sections that have one, nor those that are not there."""
        page = FILES["docs/motion.md"].replace("- Exercise: \\ref exercise_motion_rest", "- See \\ref a")
        with project({"docs/motion.md": page, "exercises/1-motion/rest/README.md": None}):
            self.assertEqual(course.holes({"1.8": "why"}), [])
            self.assertEqual(len(course.holes({"1.7": "why", "1.8": "why"})), 1)
            self.assertIn("section 1.7 has an exercise: it leaves the list", course.holes({"1.7": "why", "1.8": "why"})[0])
            self.assertEqual(len(course.holes({"1.8": "why", "1.80": "why"})), 1)
            self.assertIn("section 1.80 is not there", course.holes({"1.8": "why", "1.80": "why"})[0])

    def test_the_list(self) -> None:
        """Of the course as it is. An exercise that is written makes the number smaller; nothing makes it larger."""
        later = [number for number, reason in course.WITHOUT_EXERCISE.items() if reason.startswith("not asked yet: ")]
        self.assertLessEqual(len(later), 29)
        self.assertEqual(sorted(course.WITHOUT_EXERCISE, key=course.in_order), list(course.WITHOUT_EXERCISE))

    def test_twice(self) -> None:
        """A second line of one kind would not be read."""
        self.assertEqual(course.twice("p", PAGE), [])
        faults = course.twice("p", PAGE.replace("- Exercise: \\ref exercise_motion_drag", "- Exercises: \\ref a\n- Exercise: \\ref b"))
        self.assertEqual(faults, ["p: section_1_7 has 2 lines '- Exercise:'; one names them all"])

    def test_order(self) -> None:
        """By numbers, not by letters."""
        self.assertEqual(sorted(["6.3.10", "6.3.9", "6.3", "10"], key=course.in_order), ["6.3", "6.3.9", "6.3.10", "10"])


class Words(unittest.TestCase):
    """What a glossary explains."""

    def test_in_their_order(self) -> None:
        """Over a line's end, in the plural, in code and formulas of no account."""
        page = FILES["docs/motion.md"]
        self.assertEqual(course.words_of(page), [("inertia", "section_1_7"), ("threshold", "section_1_8"),
                                                 ("slow start", "section_1_8")])
        for said in ("", "`threshold`", "\\f$ threshold \\f$", "\\snippet a threshold", "thresholding",
                     'Wait (\\ref section_1_8 "1.8") for thresholds.', 'See \\ref section_1_8 "1.8".\n\nA threshold.'):
            self.assertEqual(course.used_too_early("p", page.replace("Air resists.", said + "\n\n")), [], said)

    def test_too_early(self) -> None:
        """Told once for a section; a word that its own section does not use; a section that is not there."""
        page = FILES["docs/motion.md"]
        for said in ("A threshold.", "Two\nThresholds.\n\nA threshold.", "A slow-start.", "- one\n- a threshold"):
            faults = course.used_too_early("p", page.replace("Air resists.", said + "\n\n"))
            self.assertEqual(len(faults), 1, said)
            self.assertIn("section_1_7 uses", faults[0])
        self.assertIn("does not use it", course.used_too_early("p", page.replace("*threshold*", "*limit*"))[0])
        self.assertIn("not on this page", course.used_too_early("p", page.replace('\\ref section_1_7 "1.7" |', "\\ref a |"))[0])
        self.assertIn("has no glossary", course.used_too_early("p", page.partition("## Glossary")[0])[0])

    def test_earlier_chapters(self) -> None:
        """Terms of several words are looked for in chapters before theirs, by their numbers and not by their files' names."""
        def chapter(number: int, said: str, word: str = "", place: str = "") -> str:
            return (f"# Chapter {number}: a {{#chapter_{number}}}\n\n## {number} B {{#section_{number}}}\n\n{said}\n\n## Glossary {{#words}}\n"
                    + f'\n| {word} | what it is | \\ref {place} "there" |\n')
        later = chapter(3, "*Critical damping* and *drag*.", "critical damping", "section_3")
        for said in ("Nothing.", 'See \\ref section_3 "3".\n\nThe critical damping.', 'Critical damping (\\ref section_3 "3").', "A drag.",
                     "`critical damping`"):
            self.assertEqual(course.used_in_earlier_chapters({"a": later, "z": chapter(1, said)}), [], said)
        self.assertEqual(course.used_in_earlier_chapters({"z": chapter(1, "Critical\ndamping."), "a": later}),
                         ["z: section_1 uses 'critical damping', which section_3 of a explains; point to it"])
        self.assertEqual(len(course.used_in_earlier_chapters({"c": chapter(20, "Critical damping."), "a": later})), 0)
        own = chapter(1, "*Critical damping*.", "critical damping", "section_1")
        self.assertEqual(course.used_in_earlier_chapters({"b": own, "a": later}), [])
        single = chapter(3, "*Drag*.", "drag", "section_3")
        self.assertEqual(course.used_in_earlier_chapters({"b": chapter(1, "Drag."), "a": single}), [])

    def test_italics(self) -> None:
        """Where a word is first used, in whatever it is said; an asterisk that belongs to a name opens and closes nothing."""
        for said in ("It is a *search*.", "A* is a **best-first\nsearch**.", "*Searches* of A*.", "`search` is a *search*.",
                     "Nothing.\n\nA *search*, a search."):
            self.assertEqual(course.explains("search", said), "", said)
        for said in ("A* is a search of A*.", "A search.\n\nA *search*.", "- a search\n- a *search*", "*One* search *two*."):
            self.assertIn("does not set it in *italics*", course.explains("search", said), said)
        self.assertIn("does not use it", course.explains("search", "A `search`."))


class Links(unittest.TestCase):
    """Of pages."""

    def test_broken(self) -> None:
        """Text in one line, and text that goes on."""
        self.assertEqual(course.broken("p", 'See \\ref a "one text", and \\ref b "another".\nA "quote\nover" lines.'), [])
        self.assertEqual(len(course.broken("p", 'See \\ref a "one", \\ref b "a\ntext".')), 1)


if __name__ == "__main__":
    unittest.main()
