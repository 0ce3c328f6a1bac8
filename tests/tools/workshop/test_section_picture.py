# SPDX-License-Identifier: BSL-1.0
"""The picture that stands for a section (tools/workshop/section_picture.py)."""

from __future__ import annotations

import os
import tempfile
import unittest

from workshop import section_picture

CHAPTER = (
    '# Chapter 2: collision {#chapter_collision}',
    '\\image html of_no_section.svg "Before the first section" width=640px',
    '## 2.1 Detection <a id="section_2_1"></a>',
    '### 2.1.9 Nine <a id="section_2_1_9"></a>',
    'Text that leads to [2.1.10](#section_2_1_10) and names no picture.',
    '### 2.1.10 Ten <a id="section_2_1_10"></a>',
    'Picture: [Cells](../chapters/2-collision/2.1.10-cells.cpp "picture 2.1.10-cells.svg")',
    'Picture: [Curve](../chapters/2-collision/2.1.10-cells.cpp "picture 2.1.10.svg 300px")',
    '#### Without a label',
    '![Still in ten](pictures/still.svg)',
    '## 2.2 Response <a id="section_2_2"></a>',
    'Picture: [Before the film](../chapters/2-collision/2.2-response.cpp "picture 2.2.svg")',
    '![Film](pictures/2.2-film.svg)',
    '![Sheet](pictures/2.2-sheet.svg)',
    '## What it costs <a id="collision_costs"></a>',
    '![Costs](pictures/costs.svg)',
    '## 2.3 Paper <a id="section_2_3"></a>',
    '![Sheet](pictures/2.3-sheet.svg)',
)


class PictureOfASection(unittest.TestCase):
    """Each works in a folder with one chapter."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        os.mkdir("docs")
        with open("docs/collision.md", "w", encoding="utf-8") as stream:
            stream.write("".join(line + "\n" for line in CHAPTER))

    def test_its_own_first(self) -> None:
        """As Doxygen reads it, with its title and width."""
        self.assertEqual(section_picture.picture_of("2.1.10"), '\\image html 2.1.10-cells.svg "Cells" width=640px')
        self.assertEqual(section_picture.pictures_by_section("2")["2.1.10"][1:], [
            '\\image html 2.1.10.svg "Curve" width=300px', '\\image html still.svg "Still in ten" width=640px'])

    def test_film_and_no_sheet(self) -> None:
        """A film before a picture that stands above it; the sheet is what the site prints in the place of the film."""
        self.assertIn("2.2-film.svg", section_picture.picture_of("2.2"))
        self.assertNotIn("2.3", section_picture.pictures_by_section("2"))

    def test_of_a_section_around_or_below(self) -> None:
        """2.1 has no picture of its own, 2.1.9 neither; both get that of 2.1.10."""
        self.assertIn("2.1.10-cells.svg", section_picture.picture_of("2.1"))
        self.assertIn("2.1.10-cells.svg", section_picture.picture_of("2.1.9"))
        self.assertIn("2.1.10-cells.svg", section_picture.picture_of("2"))

    def test_what_belongs_to_no_section(self) -> None:
        """Neither the pictures before the first section nor those behind a heading with another label."""
        every = str(section_picture.pictures_by_section("2"))
        self.assertNotIn("of_no_section", every)
        self.assertNotIn("costs.svg", every)

    def test_another_chapter(self) -> None:
        """No page has it."""
        self.assertEqual(section_picture.picture_of("3.1"), "")


if __name__ == "__main__":
    unittest.main()
