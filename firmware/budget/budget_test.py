#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""The comparison of budget.py can fail: each way in which a figure may be wrong is named."""
import copy
import unittest

import budget

FOUND = {("A", ""): {"code M7": 100, "stack M7": 40}, ("A", "320x240"): {"M7": 1000, "M7 a pixel": 10.0}}


class Comparison(unittest.TestCase):
    def setUp(self):
        self.page = budget.one_table({key: row for key, row in FOUND.items() if not key[1]}, ["algorithm"])
        self.page += "\n\n" + budget.one_table({key: row for key, row in FOUND.items() if key[1]},
                                               ["algorithm", "size"])

    def differences(self, change):
        found = copy.deepcopy(FOUND)
        change(found)
        return list(budget.differences(found, self.page))

    def test_equal_tables_agree(self):
        self.assertEqual(self.differences(lambda found: None), [])

    def test_small_changes_agree(self):
        self.assertEqual(self.differences(lambda found: found[("A", "320x240")].update({"M7": 1029})), [])

    def test_large_changes_are_named(self):
        for figure in (960, 1040):
            self.assertEqual(self.differences(lambda found: found[("A", "320x240")].update({"M7": figure})),
                             [f"A 320x240: M7 is {figure}, the table says 1000"])

    def test_a_new_row_is_named(self):
        self.assertEqual(self.differences(lambda found: found.update({("B", ""): {"code M7": 1}})),
                         ["B : code M7 is not in the table"])

    def test_a_row_that_is_gone_is_named(self):
        self.assertEqual(self.differences(lambda found: found.pop(("A", ""))),
                         ["A : the row is in the table, but was not measured"])

    def test_bars(self):
        bars = {("A", "320x240"): {"M7": 999}, ("B", ""): {"code M7": 1}}
        self.assertEqual(list(budget.broken_bars(FOUND, bars)),
                         ["A 320x240: M7 is 1000, the bar is 999", "B : code M7 was not measured"])
        self.assertEqual(list(budget.broken_bars(FOUND, {("A", ""): {"stack M7": 40}})), [])


if __name__ == "__main__":
    unittest.main()
