# SPDX-License-Identifier: BSL-1.0
"""The rows of cost tables (tools/workshop/cost_rows.py)."""

from __future__ import annotations

import json
import math
import unittest

from test_advice_blocks import LADDER, ROWS, RUN, WORDY
from workshop import cost_rows


class Kept(unittest.TestCase):
    """A run in the project."""

    def test_a_row_a_line(self) -> None:
        """What has no value is left out, and all the rest is there."""
        text = cost_rows.shortened(json.dumps(RUN))
        self.assertEqual(len(text.splitlines()), len(ROWS + LADDER + WORDY) + 3)
        table = cost_rows.Table(text)
        self.assertEqual(len(table.rows), len(ROWS + LADDER + WORDY))
        self.assertIsNone(table.of("steps")[-1].time, "diverged")
        self.assertEqual([one.key for one in table.of("steps")][:3], [1.0, 0.1, 0.01])
        self.assertEqual(table.of("search", "spread")[0].key, 10)

    def test_between_rows_by_powers(self) -> None:
        """On a line of logarithms there is no error at all."""
        points = [(math.log(n), math.log(3.0 * n**1.5)) for n in (1, 10, 100)]
        value = cost_rows.value_at(points, math.log(37))
        self.assertAlmostEqual(math.exp(value or 0), 3 * 37**1.5, places=9)
        self.assertIsNone(cost_rows.value_at(points, math.log(101)))

    def test_time_for_an_error(self) -> None:
        """A step of the error 0.05 lies between two; a smaller error than all is never reached."""
        rows = cost_rows.Table(cost_rows.shortened(json.dumps(RUN))).of("steps")
        self.assertAlmostEqual(cost_rows.time_for(rows, "ShortStep", 0.05) or 0, 20)
        self.assertAlmostEqual(cost_rows.time_for(rows, "LongStride", 0.0025) or 0, 100)
        self.assertAlmostEqual(cost_rows.time_for(rows, "LongStride", 10) or 0, 5, msg="its coarsest will do")
        self.assertIsNone(cost_rows.time_for(rows, "ShortStep", 1e-5))


if __name__ == "__main__":
    unittest.main()
