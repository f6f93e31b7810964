# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Tests of bench/speed_page.py: it finds what a page lacks, and writes between the marks alone."""
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench"))
import speed_page  # noqa: E402

TABLE = "| job | size | ms |\n| --- | --- | ---: |\n| edges | 8x8 | 1.2 |\n| lines | 8x8 | 3.4 |"


def page(tables):
    return "# Page\n" + "\n".join(
        f"before {name}\n{speed_page.mark(name, 'begin')}\n{text}\n{speed_page.mark(name, 'end')}\nafter {name}"
        for name, text in tables.items())


def whole_page(jobs):
    tables = {name: TABLE for name in speed_page.COMPARED}
    return page({"machine": "a computer", **tables, "jobs": jobs})


class SpeedPage(unittest.TestCase):
    def breaches(self, jobs):
        return list(speed_page.breaches(whole_page(jobs), {"jobs": TABLE}))

    def test_times_do_not_matter(self):
        self.assertEqual(self.breaches(TABLE), [])
        self.assertEqual(self.breaches(TABLE.replace("1.2", "9.9")), [])

    def test_a_row_that_is_missing_new_or_elsewhere(self):
        rows = TABLE.splitlines()
        self.assertEqual(self.breaches("\n".join(rows[:3])), ["jobs: the page lacks lines | 8x8"])
        self.assertEqual(self.breaches(TABLE + "\n| planes | 8x8 | 5 |"),
                         ["jobs: the program does not have planes | 8x8"])
        self.assertEqual(self.breaches("\n".join([*rows[:2], rows[3], rows[2]])),
                         ["jobs: the rows stand in another order"])

    def test_a_column_that_is_missing(self):
        narrow = "| job | size |\n| --- | --- |\n| edges | 8x8 |\n| lines | 8x8 |"
        self.assertNotEqual(self.breaches(narrow), [])

    def test_marks_that_are_missing(self):
        found = list(speed_page.breaches(page({"machine": "a computer"}), {"jobs": TABLE}))
        self.assertTrue(any("jobs begin" in breach for breach in found))
        self.assertTrue(any("octree: the page has no rows" in breach for breach in found))

    def test_a_processor_without_the_instructions(self):
        head = "\n".join(TABLE.splitlines()[:2])
        with_fma = whole_page(TABLE) + page({"fma": TABLE})
        self.assertEqual(list(speed_page.breaches(with_fma, {"fma": head})), [])
        self.assertEqual(len(list(speed_page.breaches(with_fma, {"jobs": head}))), 2)

    def test_tables_are_split_by_name(self):
        found = speed_page.split_tables(f"table one\n{TABLE}\ntable two\nwords\n{TABLE}\n")
        self.assertEqual(found, {"one": TABLE, "two": TABLE})

    def test_only_what_is_between_the_marks_changes(self):
        old = whole_page(TABLE)
        new = speed_page.with_tables(old, {"jobs": "new"})
        self.assertEqual(speed_page.on_page(new, "jobs"), "new")
        self.assertEqual(new.replace("new", TABLE), old)


if __name__ == "__main__":
    unittest.main()
