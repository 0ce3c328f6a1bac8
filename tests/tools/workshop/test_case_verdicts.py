# SPDX-License-Identifier: BSL-1.0
"""What came of the hard cases (tools/workshop/case_verdicts.py)."""

from __future__ import annotations

import unittest

from test_hard_cases import LISTED, case
from workshop import case_verdicts, hard_cases

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


class Logs(unittest.TestCase):
    """What ctest says."""

    def test_outcomes(self) -> None:
        """One that is not there is called passed by ctest, and is not."""
        outcomes = case_verdicts.read_log(LOG, 5.0)
        self.assertEqual({name: one.verdict for name, one in outcomes.items()},
                         {"collision.C1: parts": "passed", "collision.C2: fails": "failed", "collision.C3: gone": "not built",
                          "collision.C4: skipped": "skipped"})
        self.assertEqual(outcomes["collision.C2: fails"].said,
                         "tests/collision/impulse.cpp:9: CHECK( a <= b ) with expansion: 2 <= 1")
        self.assertEqual(outcomes["collision.C1: parts"].measured[2], case_verdicts.Measured("C1", "order", "1.98", ">= 1.95", "", True))

    def test_broken(self) -> None:
        """A bound that did not hold fails, whatever the test made of it; so does what crashed."""
        outcomes = case_verdicts.read_log(LOG.replace("1e-12 | m/s | held", "1e-16 | m/s | broken"), 5.0)
        self.assertEqual(outcomes["collision.C1: parts"].verdict, "failed")
        self.assertIn("it said nothing", case_verdicts.why_it_failed("\n"))
        self.assertEqual(case_verdicts.why_it_failed("a\nb\n\n"), "b")

    def test_summary(self) -> None:
        """The value next to the bound: the largest below one, the smallest above, both ends in between."""
        def told(bound: str, *values: str) -> case_verdicts.Measured:
            return case_verdicts.summary_of(tuple(case_verdicts.Measured("C1", "x", value, bound, "m", True) for value in values))[0]
        self.assertEqual(told("<= 1", "0.5", "2e-3").value, "0.5")
        self.assertEqual(told(">= 1", "12", "3").value, "3")
        self.assertEqual(told("1 to 9", "5", "3", "4").value, "3 to 5")
        self.assertEqual((told("1 to 9", "5").value, told("1 to 9", "5").what), ("5", "x"))
        self.assertEqual(told("<= 1", "0", "0").what, "x (of 2)")
        both = tuple(case_verdicts.Measured("C1", "x", value, "<= 1", "m", held) for value, held in (("nan", False), ("0.5", True)))
        self.assertEqual([(one.value, one.held) for one in case_verdicts.summary_of(both)], [("nan", False)])


class Verdicts(unittest.TestCase):
    """Of rows."""

    def setUp(self) -> None:
        self.rows = hard_cases.read_list(LISTED)
        self.tests = [case("collision.C1: parts", "C1"), case("collision.C2: fails", "C2")]

    def test_of_the_worst(self) -> None:
        """A row fails with one of its tests, and one that holds by others with one of these."""
        told = case_verdicts.judge(self.rows, self.tests, case_verdicts.read_log(LOG, 5.0))
        self.assertEqual([one.verdict for one in told], ["passed", "failed", "does not apply yet", "failed"])
        self.assertIn("2 <= 1", told[1].reason)
        self.assertEqual(told[3].reason, "C2 failed")
        self.assertEqual(case_verdicts.counts(told), "4 rows: 2 failed, 1 passed, 1 does not apply yet")

    def test_of_its_own(self) -> None:
        """A row that holds by others and has a test fails with that one; a number belongs to the row that it names."""
        log = LOG.replace("Test Failed.", "Test Passed.").replace("measured | C1 | order", "measured | C2 | order")
        outcomes = case_verdicts.read_log(log, 5.0)
        outcomes["collision.T1: own"] = case_verdicts.Outcome("failed", "why", (), 5.0)
        told = case_verdicts.judge(self.rows, self.tests + [case("collision.T1: own", "T1")], outcomes)
        self.assertEqual([one.verdict for one in told], ["passed", "passed", "does not apply yet", "failed"])
        self.assertEqual(told[3].reason, "collision.T1: own: why")
        self.assertEqual({one.what for one in told[0].measured}, {"error"})
        outcomes = {**case_verdicts.read_log(LOG, 5.0), "collision.T1: own": case_verdicts.Outcome("passed", "", (), 5.0)}
        told = case_verdicts.judge(self.rows, self.tests + [case("collision.T1: own", "T1")], outcomes)
        self.assertEqual((told[3].verdict, told[3].reason), ("failed", "C2 failed"))

    def test_without_a_run(self) -> None:
        """Nobody knows; what passed in part has not passed."""
        told = case_verdicts.judge(self.rows, self.tests, {})
        self.assertEqual([one.verdict for one in told], ["not run", "not run", "does not apply yet", "not run"])
        self.assertEqual(case_verdicts.worst(["passed", "not run"]), "not run")
        self.assertEqual(case_verdicts.worst(["passed", "skipped"]), "passed")
        self.assertEqual(case_verdicts.worst([]), "not run")


if __name__ == "__main__":
    unittest.main()
