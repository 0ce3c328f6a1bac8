# SPDX-License-Identifier: BSL-1.0
"""The faults of formulas (tools/workshop/formulas.py)."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest

from workshop import formulas

KNOWN = frozenset(("frac", "begin", "end"))


class Paragraphs(unittest.TestCase):
    """What is looked at."""

    def test_text(self) -> None:
        """Between empty lines; neither fences nor code within a line."""
        lines = ["One", "two `$x$`.", "", "```", "$y$", "", "```", "three"]
        self.assertEqual(formulas.paragraphs(lines, header=False), [(1, "One\ntwo .\n"), (8, "three\n")])

    def test_header(self) -> None:
        """Comments for the site, behind code as well; what is no comment ends the paragraph."""
        lines = ["/// One", "/// two", "int i; // $x$", "int j; ///< three", "///"]
        self.assertEqual(formulas.paragraphs(lines, header=True), [(1, " One\n two\n"), (4, " three\n")])


class Faults(unittest.TestCase):
    """What each paragraph says."""

    def faults(self, text: str) -> list[str]:
        """Of a paragraph."""
        return formulas.faults_of_paragraph(text, KNOWN)

    def test_none(self) -> None:
        """Formulas over several lines, braces and dollars that are escaped, and a price."""
        for text in (r"\f$ \frac{1}{2} \f$ and \f[ x \f]", "\\f$ \\frac\n{1}{2}\n\\f$", r"\f$ \{ \$ \f$",
                     "It costs $5.", r"\f{align}"):
            self.assertEqual(self.faults(text), [], text)

    def test_each(self) -> None:
        """In the words that a page's author reads."""
        for text, fault in {
                "The step $x$ is long.": r"a formula would stay as TeX, write $`...`$ on a page and \f$...\f$ in a header: $x$ is long.",
                "$$x$$": r"a formula would stay as TeX, write $`...`$ on a page and \f$...\f$ in a header: $$x$$",
                r"A \f$ x is": "a formula has no end:  x is", r"x \f] is": "a formula has no beginning",
                r"\f$ \frca{1}{2} \f$": r"MathJax knows no \frca:  \frca{1}{2} ",
                r"\f$ \frac{1}{2 \f$": r"a brace has no partner:  \frac{1}{2 ",
                r"\f$ 1} \f$": "a brace has no partner:  1} "}.items():
            self.assertEqual(self.faults(text), [fault])

    def test_several(self) -> None:
        """In one paragraph: each is told, formulas first."""
        self.assertEqual(self.faults(r"$5 and $x$, \f$ \a \f$, \f$ \b \f$, all"), [
            r"MathJax knows no \a:  \a ", r"MathJax knows no \b:  \b ",
            r"a formula would stay as TeX, write $`...`$ on a page and \f$...\f$ in a header: $5 and $x$,  ,  , all"])

    def test_closing_before_opening(self) -> None:
        """As many of both, and wrong."""
        self.assertEqual(self.faults(r"\f$ }{ \f$"), ["a brace has no partner:  }{ "])


class Program(unittest.TestCase):
    """As the check of the site calls it."""

    def test_places(self) -> None:
        """Each fault with its file and its paragraph's first line; the commands are those of the scripts."""
        with tempfile.TemporaryDirectory() as folder:
            script, page = os.path.join(folder, "TeX.js"), os.path.join(folder, "page.md")
            with open(script, "w", encoding="utf-8") as stream:
                stream.write('x={frac:["a"],"\\\\quad":1,sqrt:2}')
            with open(page, "w", encoding="utf-8") as stream:
                stream.write("# Title\n\n\\f$ \\frac \\quad \\sqrt \\left \\a \\f$\n")
            self.assertEqual(formulas.commands_of('x={frac:["a"],"\\\\quad":1,sqrt:2}'), {"frac", "quad", "sqrt"})
            out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
            with contextlib.redirect_stdout(out):
                self.assertEqual(formulas.main(["--mathjax", script, "--", page]), 0)
            out.seek(0)
            self.assertEqual(out.read(), f"{page}:3: MathJax knows no \\a:  \\frac \\quad \\sqrt \\left \\a \n")

    def test_refusal(self) -> None:
        """Without MathJax nothing could be judged."""
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as end:
            formulas.main(["page.md"])
        self.assertEqual(end.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
