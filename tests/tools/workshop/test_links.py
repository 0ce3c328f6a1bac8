# SPDX-License-Identifier: BSL-1.0
"""Dead links and requests of a site (tools/workshop/links.py); tests/tools/docs.sh plants such in the site itself."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import links


class OfASite(unittest.TestCase):
    """Sites of a few files."""

    def faults(self, **files: str) -> list[str]:
        """Of files by name: a_b_html is a/b.html; there is always an other.html with the place `here`."""
        with tempfile.TemporaryDirectory() as root:
            for name, text in {"other_html": '<p id="here">', **files}.items():
                *folders, stem, ending = name.split("_")
                path = os.path.join(root, *folders, f"{stem}.{ending}")
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as stream:
                    stream.write(text)
            return sorted(links.Site(root).read())

    def asks(self, text: str, fault: str) -> None:
        """A page with this text has that fault alone."""
        self.assertEqual(self.faults(page_html=text), [f"page.html {fault}"], text)


class DeadLinks(OfASite):
    """Pages and places that are not there."""

    def test_good(self) -> None:
        """Pages, places by id and by name, the folder above, what a reader may follow elsewhere, and remarks."""
        self.assertEqual(self.faults(
            page_html='<a href="other.html#here">x</a><a href=other.html>x</a><a href="#own">x</a><a name="own"></a>'
                      '<a href="https://example.org/x">x</a><a href="mailto:a@example.org">x</a><a href="#">x</a>'
                      '<!-- <a href="nowhere.html"> --><img src="a%20b.png"><p>a < b</p><a href="other.html?q#here">',
            search_page_html='<a href="../other.html#here">x</a>', **{"a b_png": ""}), [])

    def test_dead(self) -> None:
        """Each said once, with the first page that leads there and how many more."""
        self.assertEqual(
            self.faults(one_html='<A\n HREF="no.html">', two_html="<a href='no.html'><img src=no.png>",
                        three_html='<a href="no.html#x"><a href="other.html#gone"><a href="#gone">'), [
                "other.html has no place 'gone', to which three.html links",
                "there is no no.html, to which one.html links, and 1 more",
                "there is no no.html, to which three.html links", "there is no no.png, to which two.html links",
                "three.html has no place 'gone', to which three.html links"])

    def test_entities(self) -> None:
        """A link is read as a browser reads it."""
        self.assertEqual(self.faults(page_html='<a href="other.html&#35;here">x</a><a href="a&amp;b.html">x</a>'),
                         ["there is no a&b.html, to which page.html links"])

    def test_of_doxygen(self) -> None:
        """Its head names the place of nested classes where all of them are private."""
        self.assertEqual(self.faults(page_html='<a href="#nested-classes">x</a>'), [])

    def test_lists(self) -> None:
        """In the navigation places count, in the branches of its tree only pages; its index is not read."""
        self.assertEqual(
            self.faults(navtreedata_js='["a", "other.html#gone", ["b", "@ref nowhere", null]]\n'
                                       'var NAVTREEINDEX = ["other.html#c"]',
                        page_js='[ "a", "other.html#gone" ], [ "b", "no.html" ]', navtreeindex0_js='"no.html"',
                        search_all_js="['../other.html#lost']", mathjax_page_html='<a href="no.html">'), [
                "navtreedata.js names '@ref nowhere', which no page has",
                "other.html has no place 'gone', to which navtreedata.js links",
                "other.html has no place 'lost', to which search/all.js links",
                "there is no no.html, to which page.js links"])


class Requests(OfASite):
    """What a browser would ask another host."""

    def test_tags(self) -> None:
        """In every way in which a page loads something."""
        for text in ('<script src="//a.example/x"></script>', '<IMG SRC="//a.example/x">', "<img src=//a.example/x>",
                     "<link href='//a.example/x'/>", '<object data="//a.example/x">', '<video poster="//a.example/x">',
                     '<form action="//a.example/x">', '<image\n xlink:href="//a.example/x"/>',
                     '<p style="background: url(//a.example/x)">', "<style>a { b: url(\n  '//a.example/x') }</style>",
                     '<p style="background: url(&quot;//a.example/x&quot;)">',
                     '<img srcset="a.png 1x, //a.example/x 2x">'):
            faults = [fault for fault in self.faults(page_html=text) if "there is no a.png" not in fault]
            self.assertEqual(faults, ["page.html asks another host: //a.example/x"], text)

    def test_two_in_a_tag(self) -> None:
        """Are two."""
        self.assertEqual(self.faults(page_html='<img src="//a.example/x" style="background: url(//a.example/y)">'),
                         ["page.html asks another host: //a.example/x", "page.html asks another host: //a.example/y"])

    def test_styles_and_pictures(self) -> None:
        """Files of their own."""
        self.assertEqual(self.faults(a_css='@IMPORT "https://a.example/x";', b_css='a{b:image-set("//a.example/y" 1x)}',
                                     c_svg='<feImage href="https://a.example/z"/>'), [
            "a.css asks another host: https://a.example/x", "b.css asks another host: //a.example/y",
            "c.svg asks another host: https://a.example/z"])

    def test_pages_within(self) -> None:
        """And readers who are sent on."""
        self.asks('<iframe srcdoc="&lt;img src=&quot;https://a.example/x&quot;&gt;">',
                  "has a page within that names another host")
        self.assertEqual(self.faults(page_html='<meta http-equiv="x-ua" content="a"><p http-equiv="refresh">'), [])
        self.asks('<meta http-equiv="refresh" content="0; url=a">', 'sends the reader on: <meta http-equiv="refresh" '
                  'content="0; url=a">')

    def test_scripts(self) -> None:
        """That name another host, or that could put its name together; not those of Doxygen."""
        self.asks('<script>var a = "HTTPS://A.example/x";</script>', "has a script that names another host")
        self.asks("<script>if (a < b) { fetch(a + b); }</script>", "has a script that asks for something")
        self.asks("<script>prefetch(a); refetch.import_(b);</script><script>new WebSocket(a)</script>",
                  "has a script that asks for something")
        self.assertEqual(self.faults(own_js="var a = '//a.example'", jquery_js="var a = '//a.example'"),
                         ["own.js has a script that names another host"])


class Program(unittest.TestCase):
    """Its argument."""

    def test_refusal(self) -> None:
        """Without a folder."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            links.main([])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
