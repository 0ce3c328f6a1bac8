# SPDX-License-Identifier: BSL-1.0
"""What is changed in Doxygen's pages (tools/workshop/site_pages.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import site_pages

DEFINITION = '<h2 class="groupheader">Concept definition</h2>\n<div>\n'
CONCEPT = f"<p>detail::A</p>\n{DEFINITION}detail::B</div><!-- fragment --><p>words</p>\n<p>more</p>\n"


class Texts(unittest.TestCase):
    """Of a page."""

    def test_definitions(self) -> None:
        """Without one of detail's names, up to where its listing ends; one of other names stays."""
        self.assertEqual(site_pages.without_details(CONCEPT), "<p>detail::A</p>\n<p>words</p>\n<p>more</p>\n")
        plain = CONCEPT.replace("detail::B", "A || B")
        self.assertEqual(site_pages.without_details(plain), plain)

    def test_an_end_that_is_missing(self) -> None:
        """Takes nothing of the page away."""
        page = f"{DEFINITION}detail::B\n<p>words</p>\n"
        self.assertEqual(site_pages.without_details(page), page)

    def test_components(self) -> None:
        """x is a link where it is called, and nowhere else; two in a row as well."""
        link = '<a class="el" href="a.html#1">x</a>'
        code = '<a class="code hl_function" href="b.html">y</a>'
        self.assertEqual(site_pages.without_components(f"{link}, {code} = {link}{code};\n{link}(), {link} ()"),
                         f"x, y = xy;\n{link}(), {link} ()")
        for kept in (link.replace(">x<", ">xs<"), link.replace('"el"', '"elRef"') + ","):
            self.assertEqual(site_pages.without_components(kept), kept)

    def test_head(self) -> None:
        """Lines before its end, as they are."""
        self.assertEqual(site_pages.with_head("<head>\n  </head>\n<body>\n", "<script>\\1</script>\n"),
                         "<head>\n<script>\\1</script>\n  </head>\n<body>\n")


    def test_told_once(self) -> None:
        """The sentence above a description goes where there is one below; links in it as well, and no other paragraph."""
        brief = '<div>\n\n<p>First <a href="x">x</a>.  \n <a href="a.html#details">More...</a></p>\n<p>rest</p>\n'
        self.assertEqual(site_pages.told_once(f'{brief}<a name="details">'), '<div>\n\n<p>rest</p>\n<a name="details">')
        self.assertEqual(site_pages.told_once(brief), brief)
        self.assertEqual(site_pages.told_once(f'\n<p>Other.</p>{brief}<a name="details">'),
                         '\n<p>Other.</p><div>\n\n<p>rest</p>\n<a name="details">')

    def test_paths(self) -> None:
        """Of headers, in what is read of a link."""
        link = '<a class="el" href="all__pairs_8hpp.html" title="a_b">collision/all_pairs.hpp</a>'
        self.assertEqual(site_pages.with_broken_paths(link),
                         link.replace(">collision/all_pairs", ">collision/<wbr/>all_<wbr/>pairs"))
        for other in ('<a class="el" href="section_1.html">a_b</a>', "a/b_c.hpp"):
            self.assertEqual(site_pages.with_broken_paths(other), other)

    def test_neighbours(self) -> None:
        """The first has none before it, the last none behind it, and a group ends where it ends."""
        lines = site_pages.neighbours("a\tA <1>\nb\tB\nc\tC\n\nx\tX\n")
        self.assertEqual(list(lines), ["a", "b", "c", "x"])
        self.assertIn('<span></span><a class="next" rel="next" href="b.html">B &rarr;</a>', lines["a"])
        self.assertIn('<a class="prev" rel="prev" href="a.html">&larr; A <1></a><a class="next" rel="next" href="c.html">C', lines["b"])
        self.assertNotIn("<a", lines["x"])
        page = "text</div></div><!-- contents -->\nrest"
        self.assertEqual(site_pages.with_neighbours(page, "L\n"), "textL\n</div></div><!-- contents -->\nrest")

    def test_foot(self) -> None:
        """Version and licence before what Doxygen says of itself."""
        said = site_pages.with_licence('<ul>\n<li class="footer">$generatedby x</li>')
        self.assertRegex(said, r'<li class="footer">Ansatz \$projectnumber .*LICENSE\.txt.* \$generatedby x</li>')


class Program(unittest.TestCase):
    """The pages of a site."""

    def test_which_pages(self) -> None:
        """Definitions on the pages of concepts, components on all, also of folders below; the rest is not touched."""
        component = '<a class="el" href="a">x</a>, '
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(f"{folder}/search")
            pages = {"concepta.html": CONCEPT, "structa.html": CONCEPT, "search/a.html": component, "a.js": component}
            for name, text in pages.items():
                with open(f"{folder}/{name}", "w", encoding="utf-8") as stream:
                    stream.write(text)
            self.assertEqual(site_pages.main(["mend", folder]), 0)
            self.assertFalse(os.path.exists(f"{folder}/annotated.js"))
            pages.update({"concepta.html": "<p>detail::A</p>\n<p>words</p>\n<p>more</p>\n", "search/a.html": "x, "})
            for name, text in pages.items():
                with open(f"{folder}/{name}", encoding="utf-8") as stream:
                    self.assertEqual(stream.read(), text, name)

    def test_which_pages_change_how(self) -> None:
        """Types tell once, the list of headers may be broken, and every page has mended listings."""
        brief = '\n<p>First. <a href="a.html#details">More...</a></p>\n<a name="details"></a>'
        path = '<a class="el" href="a_8hpp.html">a/b.hpp</a>'
        code = '<div class="fragment">x.<a class="code hl_variable" href="namespaceansatz.html#a">second</a></div><!-- fragment -->'
        pages = {"structa.html": (brief + path, '\n<a name="details"></a>' + path), "section_1.html": (brief + path, brief + path),
                 "page_library.html": (path, path.replace("/b", "/<wbr/>b")),
                 "a.html": (code, '<div class="fragment">x.second</div><!-- fragment -->')}
        with tempfile.TemporaryDirectory() as folder:
            for name, (text, _) in pages.items():
                with open(f"{folder}/{name}", "w", encoding="utf-8") as stream:
                    stream.write(text)
            site_pages.mend(folder)
            for name, (_, text) in pages.items():
                with open(f"{folder}/{name}", encoding="utf-8") as stream:
                    self.assertEqual(stream.read(), text, name)

    def test_refusals(self) -> None:
        """Without what is asked, or of what."""
        for arguments in ("", "mend", "head a"):
            with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
                site_pages.main(arguments.split())
            self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
