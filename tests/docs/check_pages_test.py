# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""The check of the pages finds each kind of trouble, and nothing in pages that are in order."""
import pathlib
import tempfile
import unittest

import check_pages

HEADER = """struct Options {
  double sigma = 1.4;  ///< pixels
  Norm norm = Norm::l1;
  std::uint64_t draws = 4'000'000;
};
"""
PAGE = """# A page

[here](#a-page) and [there](other.md#two-words) ![seen](pictures/a.png) [out](https://example.org/none)
[t](../tests/t.cpp) "it works"

<!-- options: include/o.hpp Options -->

| option | range | default |
| --- | --- | --- |
| `sigma` | a \\| b | `1.4` (px) |
| `norm` | | `l1` |
| `draws` | | `4000000` |
"""


class CheckPages(unittest.TestCase):
    def troubles(self, page=PAGE, header=HEADER, picture=b"png"):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("docs/pictures", "include", "tests"):
                (root / name).mkdir(parents=True)
            (root / "docs/page.md").write_text(page, encoding="utf-8")
            (root / "docs/other.md").write_text("## Two words\n", encoding="utf-8")
            (root / "docs/pictures/a.png").write_bytes(picture)
            (root / "include/o.hpp").write_text(header, encoding="utf-8")
            (root / "tests/t.cpp").write_text('TEST_CASE("it works") {}', encoding="utf-8")
            return list(check_pages.check(root))

    def test_order(self):
        self.assertEqual(self.troubles(), [])

    def test_each_trouble(self):
        for wrong in (
            PAGE.replace("other.md#two", "none.md#two"),
            PAGE.replace("#two-words", "#three-words"),
            PAGE.replace("#a-page", "#b-page"),
            PAGE.replace("![seen](pictures/a.png)", ""),
            PAGE.replace("`1.4`", "`1.5`"),
            PAGE.replace("`l1`", "`l2`"),
            PAGE.replace("`1.4` (px)", ""),
            PAGE.replace("`draws`", "`drows`"),
            PAGE.replace("| `norm` | | `l1` |\n", ""),
            PAGE.replace("Options -->", "Nothing -->"),
            PAGE.replace("| default |", "| standard |"),
            PAGE.replace("it works", "it does not"),
        ):
            self.assertNotEqual(wrong, PAGE)
            self.assertTrue(self.troubles(wrong), wrong)
        self.assertTrue(self.troubles(header=HEADER.replace("1.4", "1.6")))
        self.assertTrue(self.troubles(picture=b"x" * (check_pages.MOST_PICTURE_BYTES + 1)))


if __name__ == "__main__":
    unittest.main()
