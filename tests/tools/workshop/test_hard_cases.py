# SPDX-License-Identifier: BSL-1.0
"""The hard cases as they are written down (tools/workshop/hard_cases.py)."""

from __future__ import annotations

import unittest

from workshop import hard_cases

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


def case(test: str, *rows: str, template: bool = False) -> hard_cases.Case:
    """A test."""
    return hard_cases.Case(frozenset(rows), test, "tests/collision/impulse.cpp", 7, template)


class TheList(unittest.TestCase):
    """Its rows."""

    def test_rows(self) -> None:
        """With groups, reasons and what they hold by."""
        rows = hard_cases.read_list(LISTED)
        self.assertEqual([row.name for row in rows], ["C1", "C2", "C28", "T1"])
        self.assertEqual(rows[0], hard_cases.Row("C1", "C Contact", "Two bodies part."))
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
                hard_cases.read_list(text)
            self.assertIn(told, str(refused.exception))

    def test_holes(self) -> None:
        """A row that nothing decides, a reason that has been overtaken, a row that is not there."""
        rows = hard_cases.read_list(LISTED)
        self.assertEqual(hard_cases.holes(rows, [case("collision.a", "C1", "C2")]), [])
        for tests, told in (([case("collision.a", "C1")], "C2 has neither"),
                            ([case("collision.a", "C1", "C2", "C28")], "C28 has a test, and the list says"),
                            ([case("collision.a", "C1", "C2", "C9")], "impulse.cpp:7: there is no row C9")):
            faults = hard_cases.holes(rows, tests)
            self.assertEqual(len(faults), 1)
            self.assertIn(told, faults[0])


class Tests(unittest.TestCase):
    """Which tests name rows."""

    def test_names(self) -> None:
        """In their names, however these are written, or in their tags."""
        found = hard_cases.cases_in("tests/collision/a/b.cpp", TESTED)
        self.assertEqual([(sorted(one.rows), one.line, one.template) for one in found],
                         [(["C1", "C2"], 2, False), (["W1", "W3"], 4, True), (["C6"], 7, False)])
        self.assertEqual(found[0].test, 'collision.C1, C2: bodies "part"; x1 and C3PO are no rows, and 2.C4 neither')
        self.assertEqual(found[2].test, "collision.in two pieces C6")

    def test_scripts(self) -> None:
        """In their first comment, in brackets."""
        text = "#!/usr/bin/env bash\n# A script (hard case N5), for N4.\n\necho '(hard case N3)'\n"
        self.assertEqual(hard_cases.cases_in("tests/performance/symbols.sh", text),
                         [hard_cases.Case(frozenset(["N5"]), "performance.symbols", "tests/performance/symbols.sh", 1, script=True)])
        self.assertEqual(hard_cases.cases_in("tests/performance/symbols.sh", "# N5\n"), [])


if __name__ == "__main__":
    unittest.main()
