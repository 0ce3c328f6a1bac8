# SPDX-License-Identifier: BSL-1.0
"""A chapter as several pages of the site (tools/workshop/parts.py)."""

from __future__ import annotations

import os

from test_link_targets import OfAProject
from workshop import parts

CHAPTER = ["# Chapter 2: motion {#chapter_motion}", "", "What it is about.", "", "## 2.1 The `step` {#section_2_1}", "", "A step.",
           "", "### Deeper", "", "```sh", "## no heading {#at_all}", "```", "", "#### 2.1.1 A \"turn\" {#section_2_1_1}", "",
           "A turn.", "", "### Not much {#motion_more}", "", "More.", "", "## Words {#motion_words}"]


class Parts(OfAProject):
    """Of a chapter, one for each label."""

    def test_headings(self) -> None:
        """A heading without a label, and a remark in a fence, begin none; other texts are no chapters."""
        found = parts.parts_of(CHAPTER)
        self.assertEqual([(part.level, part.label) for part in found], [
            (1, "chapter_motion"), (2, "section_2_1"), (4, "section_2_1_1"), (3, "motion_more"), (2, "motion_words")])
        self.assertEqual([part.name("Chapter 2") for part in found], [
            "Chapter 2: motion", "2.1 The `step`", '2.1.1 A "turn"', "Chapter 2: not much", "Chapter 2: words"])
        self.assertEqual(parts.chapter_of(CHAPTER), "Chapter 2")
        self.assertEqual([parts.chapter_of(lines) for lines in (list[str](), ["# Worlds {#page_world}"])], ["", ""])

    def test_texts(self) -> None:
        """Headings rise with their page; the chapter's leads to the others."""
        found = parts.parts_of(CHAPTER)
        self.assertEqual(parts.text_of(found[1], "Chapter 2", []), "\n".join([
            "# 2.1 The `step` {#section_2_1}", "", "A step.", "", "## Deeper", "", "```sh", "## no heading {#at_all}", "```", "", ""]))
        self.assertEqual(parts.text_of(found[0], "Chapter 2", found[1:]).split("\n")[-8:], [
            "", "## In this chapter", "", '- \\subpage section_2_1 "2.1 The step"', '    - \\subpage section_2_1_1 "2.1.1 A turn"',
            '  - \\subpage motion_more "Not much"', '- \\subpage motion_words "Words"', ""])

    def test_program(self) -> None:
        """Writes the parts as Doxygen reads them; other pages stay whole, and the list of docs/ is none. No line is lost."""
        self.write("docs/motion.md", *CHAPTER, "", "See [1.7](#section_1_7).")
        self.write("docs/world.md", "# Worlds {#page_world}")
        os.makedirs("out")
        self.write("docs/README.md", "# Pages")
        self.assertEqual(parts.main(["out", "docs/motion.md", "docs/world.md", "docs/README.md"]), 0)
        self.assertEqual(sorted(os.listdir("out")), [
            "chapter_motion.md", "motion_more.md", "motion_words.md", "section_2_1.md", "section_2_1_1.md",
            "world.md"])
        with open("out/motion_words.md", encoding="utf-8") as stream:
            self.assertEqual(stream.read(), '# Chapter 2: words {#motion_words}\n\nSee \\ref section_1_7 "1.7".\n')
        whole = sum(len(part.lines) + 1 for part in parts.parts_of(CHAPTER))
        self.assertEqual(whole, len(CHAPTER))
