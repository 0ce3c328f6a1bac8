# SPDX-License-Identifier: BSL-1.0
"""Concepts that the site says nothing of (tools/workshop/concepts.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import concepts

HEADER = """// concept InARemark = true;
/* concept InAComment = true; { */
/* {
concept InItsMiddle = true;
concept InALongComment = true; */ template <class T> concept AfterIt = true;
namespace ansatz {
namespace detail {
struct Braces { char c = '}'; const char* s = "}}"; };
template <class T> concept Hidden = true;
} // namespace detail
template <class T>
    requires true
concept OnALineOfItsOwn
    = true;
namespace ansatz::detail::more { template <class T> concept HiddenToo = true; }
template <class T> concept Last = true;
constexpr auto no_concept = 1;
}
"""


class Definitions(unittest.TestCase):
    """What a header defines."""

    def test_which(self) -> None:
        """Neither what comments say, nor what namespace detail holds, which ends with the brace that closes it."""
        self.assertEqual(concepts.concepts_of(HEADER.split("\n")),
                         [(5, "AfterIt"), (13, "OnALineOfItsOwn"), (16, "Last")])

    def test_detail_at_the_margin(self) -> None:
        """Over several lines, and what comes behind it."""
        self.assertEqual(concepts.concepts_of(
            ["namespace ansatz::detail {", "concept A = true;", "}", "concept B = true;"]), [(4, "B")])


class Pages(unittest.TestCase):
    """What the pages of concepts show."""

    def test_details(self) -> None:
        """Within a definition, of which a page may hold two; elsewhere detail:: is a word."""
        definition, end = "Concept definition", '<div class="ttc">'
        self.assertFalse(concepts.shows_details(["detail::A", definition, "true", end, "detail::B"]))
        self.assertTrue(concepts.shows_details([definition, "true", "detail::A", end]))
        self.assertTrue(concepts.shows_details([definition, end, definition + " detail::A"]))

    def test_policies(self) -> None:
        """Named in the words, not in the head of the page."""
        link, words = '<a href="structansatz_1_1Drag.html">', '<a name="details">'
        self.assertTrue(concepts.names_policies([words, link]))
        self.assertFalse(concepts.names_policies([link, words, '<a href="other.html">']))
        self.assertFalse(concepts.names_policies([link]))


class Program(unittest.TestCase):
    """What it prints of a site."""

    def test_faults(self) -> None:
        """A concept without a page, one of detail's names, a role without a policy; one by one."""
        with tempfile.TemporaryDirectory() as folder:
            def write(name: str, text: str) -> str:
                with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
                    stream.write(text)
                return os.path.join(folder, name)
            header = write("a.hpp", "concept One = true;\nconcept Two = true;\nconcept Three = true;\n")
            write("conceptansatz_1_1One.html", "Concept definition detail::A\n")
            write("conceptTwo.html", "of no namespace: Concept definition detail::A")
            write("conceptansatz_1_1ForceIn.html", "")
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(concepts.main([folder, header]), 0)
            out.seek(0)
            self.assertEqual(out.read(), f"{header}:3: the concept Three is not documented\n"
                                         "conceptansatz_1_1ForceIn.html names no policy of its kind\n"
                                         "conceptansatz_1_1One.html shows names of namespace detail\n")

    def test_refusal(self) -> None:
        """Without headers it would be content."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            concepts.main(["html"])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
