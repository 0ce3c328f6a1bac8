# SPDX-License-Identifier: BSL-1.0
"""The hard cases for people and programs (tools/workshop/cases.py)."""

from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest

from test_case_verdicts import LOG
from test_hard_cases import LISTED, case
from workshop import case_verdicts, cases, hard_cases


class Texts(unittest.TestCase):
    """What people and programs read."""

    def setUp(self) -> None:
        self.rows = hard_cases.read_list(LISTED)
        self.tests = [case("collision.C1: parts", "C1"), case("collision.C2: fails", "C2")]

    def test_select(self) -> None:
        """ctest counts from one, and calls a template's test by its type as well."""
        listed = json.dumps({"tests": [{"name": name} for name in (
            "water.still - float", "water.still", "water.still - double", "water.still water", "collision.a")]})
        self.assertEqual(cases.select(listed, [case("water.still", "W1", template=True), case("collision.a", "C1")]), "0,0,0,1,2,3,5")
        self.assertEqual(cases.select(listed, [case("water.still", "W1")]), "0,0,0,2")
        self.assertEqual(cases.select(listed, [case("water.flows", "W1")]), "")

    def test_table(self) -> None:
        """Each row with its verdict, failures in red with the reason, no line too wide."""
        colours = {"BOLD": "", "DIM": "", "RED": "<", "GREEN": "", "YELLOW": "", "PLAIN": ">"}
        text = cases.table(case_verdicts.judge(self.rows, self.tests, case_verdicts.read_log(LOG, 5.0)), 70, colours)
        self.assertIn("  C2   <failed            > Others do not.", text)
        self.assertIn("error (of 2): 3e-16 m/s, bound <= 1e-12", text)
        self.assertIn("order: 1.98, bound >= 1.95", text)
        self.assertLessEqual(max(map(len, text.split("\n"))), 72)

    def test_long_rows(self) -> None:
        """What a row asks is cut nowhere: it goes on below itself."""
        listed = "".join(f"C{number} {'one two ' * 20}three.\n" for number in range(1, 10))
        verdicts = case_verdicts.judge(hard_cases.read_list(f"== C Contact\n{listed}"), [], {})
        lines = cases.table(verdicts, 60, dict.fromkeys(("BOLD", "DIM", "RED", "GREEN", "YELLOW", "PLAIN"), "")).split("\n")
        self.assertLessEqual(max(map(len, lines)), 60)
        self.assertEqual(sum(line.endswith("three.") for line in lines), 9)
        self.assertRegex(lines[2], "^ {26}(one|two)")

    def test_page_and_json(self) -> None:
        """Links to the tests, to rows and to the numbers; nothing of a test's name is taken for HTML."""
        tests = self.tests + [case("collision.C1: a < b", "C1")]
        told = case_verdicts.judge(self.rows, tests, case_verdicts.read_log(LOG, 5.0))
        page = cases.page(told, "/nowhere")
        for part in ('<tr id="case_C1">', '<a href="tests/collision/impulse.cpp.txt"', ">a &lt; b</a>", '<a href="#case_C2">C2</a>',
                     '<b style="color: red">failed</b><br/>', "No test was run"):
            self.assertIn(part, page)
        self.assertEqual(page.count("<table"), page.count("</table>"))
        rows = json.loads(cases.as_json(told, "/nowhere"))["rows"]
        self.assertEqual([row["verdict"] for row in rows], ["not run", "failed", "does not apply yet", "failed"])
        self.assertEqual(rows[0]["measured"][0]["value"], "2e-16")


class Program(unittest.TestCase):
    """In a project of its own."""

    complained = ""

    def test_all(self) -> None:
        """Of two runs the later counts; holes and failures end with 1, words that are no row with 2."""
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                os.makedirs("tests/collision/planted")
                os.makedirs("build/cases")
                os.makedirs("build/Testing/Temporary")
                for file, text in ((hard_cases.LIST, LISTED), ("tests/collision/planted/a.cpp", 'TEST_CASE("C77")'),
                                   ("tests/collision/b.cpp", 'TEST_CASE("C1: parts")\nTEST_CASE("C2: fails")'),
                                   ("build/cases/9.log", LOG), ("build/Testing/Temporary/LastTest.log", "")):
                    with open(file, "w", encoding="utf-8") as stream:
                        stream.write(text)
                self.assertEqual(self.said("check"), (0, ""))
                self.assertEqual(self.said("table", "build")[0], 1)
                with open("build/cases/2.log", "w", encoding="utf-8") as stream:
                    stream.write(LOG.replace("Test Failed.", "Test Passed."))
                os.utime("build/cases/9.log", (10, 10))
                code, text = self.said("table", "build")
                self.assertEqual(code, 0)
                self.assertIn("4 rows: 3 passed, 1 does not apply yet", text)
                self.assertEqual(self.said("table", "build", "c1"), self.said("table", "build", "C1"))
                self.assertEqual(self.said("table", "build", "Q")[0], 2)
                self.assertEqual(self.said("table", "build", "qx")[0], 2)
                self.assertIn("no group 'qx'\nThe groups: ", self.complained)
                self.assertEqual(self.said("sources", "site")[0], 0)
                self.assertTrue(os.path.exists("site/tests/collision/b.cpp.txt"))
                with open(hard_cases.LIST, "a", encoding="utf-8") as stream:
                    stream.write("T2 Nobody tests it.\n")
                self.assertEqual(self.said("check")[0], 1)
            finally:
                os.chdir(here)

    def said(self, *arguments: str) -> tuple[int, str]:
        """How it ends, and what it prints; what it complains about is kept."""
        errors = io.StringIO()
        with tempfile.TemporaryFile("w+", encoding="utf-8") as stream, contextlib.redirect_stdout(stream), \
                contextlib.redirect_stderr(errors):
            code = cases.main(list(arguments))
            self.complained = errors.getvalue()
            stream.flush()
            stream.seek(0)
            return code, stream.read()


if __name__ == "__main__":
    unittest.main()
