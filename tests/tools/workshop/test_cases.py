# SPDX-License-Identifier: BSL-1.0
"""The hard cases (tools/workshop/cases.py)."""

from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest

from workshop import cases

LISTED = """# A comment.
== C Contact
C1 Two bodies part.
C2 Others do not.
C28 Convex shapes.
    does not apply yet: there are none
== T The notes
T1 A difference.
    by: C1 C2
"""
TESTED = r"""
TEST_CASE("C1, C2: bodies \"part\"; x1 and C3PO are no rows, and 2.C4 neither",
          "[collision]") {
TEMPLATE_TEST_CASE("still (hard case W1)", "[water][W3]", float, double) {
// TEST_CASE("C5: commented out")
TEST_CASE("a step", "[world]") {
TEST_CASE("in two "
          "pieces C6") {
"""
LOG = """Start testing: Nov 25 03:34 UTC
----------------------------------------------------------
1/4 Testing: collision.C1: parts
1/4 Test: collision.C1: parts
Command: "/build/test_collision" "C1: parts"
Directory: /build
"collision.C1: parts" start time: Nov 25 03:34 UTC
Output:
----------------------------------------------------------
Filters: C1
measured | C1 | error | 2e-16 | <= 1e-12 | m/s | held
measured | C1 | error | 3e-16 | <= 1e-12 | m/s | held
measured | C1 | order | 1.98 | >= 1.95 |  | held
<end of output>
Test time =   0.02 sec
----------------------------------------------------------
Test Passed.
"collision.C1: parts" end time: Nov 25 03:34 UTC
----------------------------------------------------------
2/4 Testing: collision.C2: fails
Command: "/build/test_collision" "C2: fails"
Output:
----------------------------------------------------------
-------------------------------------------------------------------------------
C2: fails
-------------------------------------------------------------------------------
/somewhere/tests/collision/impulse.cpp:7
...............................................................................

/somewhere/tests/collision/impulse.cpp:9: FAILED:
  CHECK( a <= b )
with expansion:
  2 <= 1

===============================================================================
test cases: 1 | 1 failed
<end of output>
Test time =   0.02 sec
----------------------------------------------------------
Test Failed.
----------------------------------------------------------
3/4 Testing: collision.C3: gone
Command: ""
Output:
----------------------------------------------------------
<end of output>
Test time =   0.00 sec
----------------------------------------------------------
Test Passed.
----------------------------------------------------------
4/4 Testing: collision.C4: skipped
Command: "/build/test_collision" "C4: skipped"
Output:
----------------------------------------------------------
Test Passed.
test skipped: no gnuplot
<end of output>
Test time =   0.00 sec
----------------------------------------------------------
Test Pass Reason:
Skip regular expression found in output. Regex=[test skipped]
----------------------------------------------------------
End testing: Nov 25 03:34 UTC
"""


def case(test: str, *rows: str, template: bool = False) -> cases.Case:
    """A test."""
    return cases.Case(frozenset(rows), test, "tests/collision/impulse.cpp", 7, template)


class TheList(unittest.TestCase):
    """Its rows."""

    def test_rows(self) -> None:
        """With groups, reasons and what they hold by."""
        rows = cases.read_list(LISTED)
        self.assertEqual([row.name for row in rows], ["C1", "C2", "C28", "T1"])
        self.assertEqual(rows[0], cases.Row("C1", "C Contact", "Two bodies part."))
        self.assertEqual((rows[2].verdict, rows[2].reason), ("does not apply yet", "there are none"))
        self.assertEqual((rows[3].group, rows[3].by), ("T The notes", ("C1", "C2")))

    def test_refusals(self) -> None:
        """A line that is none is told with its number, and nothing is guessed."""
        for text, told in (("C1 Before any group.", ":1: C1 does not belong"), ("== C Contact\nG1 Elsewhere.", ":2: G1 does not"),
                           (LISTED + "== C Again\nC1 Twice.", ":11: C1 stands there twice"),
                           (LISTED + "    not yet: soon", ":10: neither"), (LISTED + "C3", ":10: neither"),
                           (LISTED + "T2 By none.\n    by: C9", "T2 holds by C9"),
                           (LISTED + "T2 By one that holds by others.\n    by: T1", "T2 holds by T1")):
            with self.assertRaises(ValueError) as refused:
                cases.read_list(text)
            self.assertIn(told, str(refused.exception))

    def test_holes(self) -> None:
        """A row that nothing decides, a reason that has been overtaken, a row that is not there."""
        rows = cases.read_list(LISTED)
        self.assertEqual(cases.holes(rows, [case("collision.a", "C1", "C2")]), [])
        for tests, told in (([case("collision.a", "C1")], "C2 has neither"),
                            ([case("collision.a", "C1", "C2", "C28")], "C28 has a test, and the list says"),
                            ([case("collision.a", "C1", "C2", "C9")], "impulse.cpp:7: there is no row C9")):
            faults = cases.holes(rows, tests)
            self.assertEqual(len(faults), 1)
            self.assertIn(told, faults[0])


class Tests(unittest.TestCase):
    """Which tests name rows."""

    def test_names(self) -> None:
        """In their names, however these are written, or in their tags."""
        found = cases.cases_in("tests/collision/a/b.cpp", TESTED)
        self.assertEqual([(sorted(one.rows), one.line, one.template) for one in found],
                         [(["C1", "C2"], 2, False), (["W1", "W3"], 4, True), (["C6"], 7, False)])
        self.assertEqual(found[0].test, 'collision.C1, C2: bodies "part"; x1 and C3PO are no rows, and 2.C4 neither')
        self.assertEqual(found[2].test, "collision.in two pieces C6")

    def test_scripts(self) -> None:
        """In their first comment, in brackets."""
        text = "#!/usr/bin/env bash\n# A script (hard case N5), for N4.\n\necho '(hard case N3)'\n"
        self.assertEqual(cases.cases_in("tests/performance/symbols.sh", text),
                         [cases.Case(frozenset(["N5"]), "performance.symbols", "tests/performance/symbols.sh", 1, script=True)])
        self.assertEqual(cases.cases_in("tests/performance/symbols.sh", "# N5\n"), [])

    def test_select(self) -> None:
        """ctest counts from one, and calls a template's test by its type as well."""
        listed = json.dumps({"tests": [{"name": name} for name in (
            "water.still - float", "water.still", "water.still - double", "water.still water", "collision.a")]})
        self.assertEqual(cases.select(listed, [case("water.still", "W1", template=True), case("collision.a", "C1")]), "0,0,0,1,2,3,5")
        self.assertEqual(cases.select(listed, [case("water.still", "W1")]), "0,0,0,2")
        self.assertEqual(cases.select(listed, [case("water.flows", "W1")]), "")


class Logs(unittest.TestCase):
    """What ctest says."""

    def test_outcomes(self) -> None:
        """One that is not there is called passed by ctest, and is not."""
        outcomes = cases.read_log(LOG, 5.0)
        self.assertEqual({name: one.verdict for name, one in outcomes.items()},
                         {"collision.C1: parts": "passed", "collision.C2: fails": "failed", "collision.C3: gone": "not built",
                          "collision.C4: skipped": "skipped"})
        self.assertEqual(outcomes["collision.C2: fails"].said,
                         "tests/collision/impulse.cpp:9: CHECK( a <= b ) with expansion: 2 <= 1")
        self.assertEqual(outcomes["collision.C1: parts"].measured[2], cases.Measured("C1", "order", "1.98", ">= 1.95", "", True))

    def test_broken(self) -> None:
        """A bound that did not hold fails, whatever the test made of it; so does what crashed."""
        outcomes = cases.read_log(LOG.replace("1e-12 | m/s | held", "1e-16 | m/s | broken"), 5.0)
        self.assertEqual(outcomes["collision.C1: parts"].verdict, "failed")
        self.assertIn("it said nothing", cases.why_it_failed("\n"))
        self.assertEqual(cases.why_it_failed("a\nb\n\n"), "b")

    def test_summary(self) -> None:
        """The value next to the bound: the largest below one, the smallest above, both ends in between."""
        def told(bound: str, *values: str) -> cases.Measured:
            return cases.summary_of(tuple(cases.Measured("C1", "x", value, bound, "m", True) for value in values))[0]
        self.assertEqual(told("<= 1", "0.5", "2e-3").value, "0.5")
        self.assertEqual(told(">= 1", "12", "3").value, "3")
        self.assertEqual(told("1 to 9", "5", "3", "4").value, "3 to 5")
        self.assertEqual((told("1 to 9", "5").value, told("1 to 9", "5").what), ("5", "x"))
        self.assertEqual(told("<= 1", "0", "0").what, "x (of 2)")
        both = tuple(cases.Measured("C1", "x", value, "<= 1", "m", held) for value, held in (("nan", False), ("0.5", True)))
        self.assertEqual([(one.value, one.held) for one in cases.summary_of(both)], [("nan", False)])


class Verdicts(unittest.TestCase):
    """Of rows."""

    def setUp(self) -> None:
        self.rows = cases.read_list(LISTED)
        self.tests = [case("collision.C1: parts", "C1"), case("collision.C2: fails", "C2")]

    def test_of_the_worst(self) -> None:
        """A row fails with one of its tests, and one that holds by others with one of these."""
        told = cases.judge(self.rows, self.tests, cases.read_log(LOG, 5.0))
        self.assertEqual([one.verdict for one in told], ["passed", "failed", "does not apply yet", "failed"])
        self.assertIn("2 <= 1", told[1].reason)
        self.assertEqual(told[3].reason, "C2 failed")
        self.assertEqual(cases.counts(told), "4 rows: 2 failed, 1 passed, 1 does not apply yet")

    def test_of_its_own(self) -> None:
        """A row that holds by others and has a test fails with that one; a number belongs to the row that it names."""
        log = LOG.replace("Test Failed.", "Test Passed.").replace("measured | C1 | order", "measured | C2 | order")
        outcomes = cases.read_log(log, 5.0)
        outcomes["collision.T1: own"] = cases.Outcome("failed", "why", (), 5.0)
        told = cases.judge(self.rows, self.tests + [case("collision.T1: own", "T1")], outcomes)
        self.assertEqual([one.verdict for one in told], ["passed", "passed", "does not apply yet", "failed"])
        self.assertEqual(told[3].reason, "collision.T1: own: why")
        self.assertEqual({one.what for one in told[0].measured}, {"error"})
        outcomes = {**cases.read_log(LOG, 5.0), "collision.T1: own": cases.Outcome("passed", "", (), 5.0)}
        told = cases.judge(self.rows, self.tests + [case("collision.T1: own", "T1")], outcomes)
        self.assertEqual((told[3].verdict, told[3].reason), ("failed", "C2 failed"))

    def test_without_a_run(self) -> None:
        """Nobody knows; what passed in part has not passed."""
        told = cases.judge(self.rows, self.tests, {})
        self.assertEqual([one.verdict for one in told], ["not run", "not run", "does not apply yet", "not run"])
        self.assertEqual(cases.worst(["passed", "not run"]), "not run")
        self.assertEqual(cases.worst(["passed", "skipped"]), "passed")
        self.assertEqual(cases.worst([]), "not run")

    def test_table(self) -> None:
        """Each row with its verdict, failures in red with the reason, no line too wide."""
        colours = {"BOLD": "", "DIM": "", "RED": "<", "GREEN": "", "YELLOW": "", "PLAIN": ">"}
        text = cases.table(cases.judge(self.rows, self.tests, cases.read_log(LOG, 5.0)), 70, colours)
        self.assertIn("  C2   <failed            > Others do not.", text)
        self.assertIn("error (of 2): 3e-16 m/s, bound <= 1e-12", text)
        self.assertIn("order: 1.98, bound >= 1.95", text)
        self.assertLessEqual(max(map(len, text.split("\n"))), 72)

    def test_page_and_json(self) -> None:
        """Links to the tests, to rows and to the numbers; nothing of a test's name is taken for HTML."""
        tests = self.tests + [case("collision.C1: a < b", "C1")]
        told = cases.judge(self.rows, tests, cases.read_log(LOG, 5.0))
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

    def test_all(self) -> None:
        """Of two runs the later counts; holes and failures end with 1, words that are no row with 2."""
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                os.makedirs("tests/collision/planted")
                os.makedirs("build/cases")
                os.makedirs("build/Testing/Temporary")
                for file, text in ((cases.LIST, LISTED), ("tests/collision/planted/a.cpp", 'TEST_CASE("C77")'),
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
                self.assertEqual(self.said("table", "build", "Q")[0], 2)
                self.assertEqual(self.said("sources", "site")[0], 0)
                self.assertTrue(os.path.exists("site/tests/collision/b.cpp.txt"))
                with open(cases.LIST, "a", encoding="utf-8") as stream:
                    stream.write("T2 Nobody tests it.\n")
                self.assertEqual(self.said("check")[0], 1)
            finally:
                os.chdir(here)

    def said(self, *arguments: str) -> tuple[int, str]:
        """How it ends, and what it prints."""
        with tempfile.TemporaryFile("w+", encoding="utf-8") as stream, contextlib.redirect_stdout(stream), \
                contextlib.redirect_stderr(io.StringIO()):
            code = cases.main(list(arguments))
            stream.flush()
            stream.seek(0)
            return code, stream.read()


if __name__ == "__main__":
    unittest.main()
