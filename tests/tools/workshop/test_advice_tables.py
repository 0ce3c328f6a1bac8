# SPDX-License-Identifier: BSL-1.0
"""Tables of figures on pages (tools/workshop/advice_tables.py)."""

from __future__ import annotations

import unittest
from typing import Optional

from workshop import advice_tables
from workshop.cost_rows import Row


def row(choice: str, problem: str, key: Optional[float], time: Optional[float], error: Optional[float] = 0.0,
        parameter: str = "") -> Row:
    """A row of an axis."""
    return Row("axis", problem, choice, key, key, time, 100.4, error, "ns", "", parameter)


ROWS = [row("Heap", "open ground", 1, 1234.0), row("Heap, uint32", "open ground", 1, 56.0, 3.2e-7),
        row("Heap", "rooms, of 12", 10, 2.5e6, 0.0382, "w = 10"), row("Heap", "rooms, of 12", 1000, None, None, "w = 1000")]


class Tables(unittest.TestCase):
    """By clauses."""

    def table(self, *clauses: str) -> list[str]:
        """Its lines behind the head."""
        return advice_tables.table(ROWS, list(clauses))[2:]

    def test_rows(self) -> None:
        """A line for each choice, policy, step, key or problem; of several figures all stand in the cell."""
        self.assertEqual(advice_tables.table(ROWS, ["rows key walkers", "a query = time us in open", "off = error % in rooms"]), [
            "| walkers | a query | off |", "|---|---|---|", "| 1 | 1.2, 0.056 |  |", "| 10 |  | 3.8 % |", "| 1000 |  | diverged |"])
        self.assertEqual(self.table("rows choice", "a query = time", "work = work"), [
            "| `Heap` | 1.2 us | 100 |", "| `Heap`, uint32 | 56 ns | 100 |", "| `Heap`, w = 10 | 2.5 ms | 100 |", "| `Heap`, w = 1000 |  | 100 |"])
        self.assertEqual(self.table("rows problem map", "h = time, error % of Heap", "only rooms", "keys 10"),
                         ["| rooms, of 12 | 2.5 ms, 3.8 % |"])
        self.assertEqual(self.table("rows policy", "h = time ns", "without rooms", "works 100.4"), [
            "| `Heap` | 1200 |", "| `Heap`, uint32 | 56 |"])
        self.assertEqual(self.table("rows step", "off = error", "without rooms", "only Heap, uint32"), ["| `Heap`, uint32, 100 | 3.2e-7 |"])

    def test_numbers(self) -> None:
        """Two digits; none of what is rounding alone."""
        self.assertEqual([advice_tables.digits(x) for x in (0, 5.4e-16, 0.00123, 0.0382, 3.75, 98.7, 1234)],
                         ["0", "5.4e-16", "0.0012", "0.038", "3.8", "99", "1200"])
        self.assertEqual([advice_tables.time_in(x, "") for x in (1.99, 996, 5.4e5, 1.5e6, 2e9)], ["2 ns", "1 us", "540 us", "1.5 ms", "2 s"])
        self.assertEqual(advice_tables.shown(row("A", "", 1, 1, 1e-14), "error %"), "0")
        self.assertEqual([advice_tables.label_of(x) for x in ("a search each", "Maximum<A, B>", "Maximum<A, B>, cold", "b::a_star, double")],
                         ["a search each", "`Maximum<A, B>`", "`Maximum<A, B>`, cold", "`b::a_star`, double"])

    def test_refusals(self) -> None:
        """A clause that is no column, a table without rows, a column that nobody fills."""
        for clauses in (["rows key", "x = length"], ["rows key", "x"], ["rows other", "x = time"], ["rows key"],
                        ["rows key", "x = time of Nobody"], ["rows key", "only nothing", "x = time"]):
            with self.subTest(clauses), self.assertRaises(ValueError):
                self.table(*clauses)


if __name__ == "__main__":
    unittest.main()
