# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""The run of the pages finds each kind of trouble, and nothing in pages that are in order."""
import pathlib
import tempfile
import unittest

import run_pages

PROGRAM = """#!/bin/sh
case "$*" in
  "draw --help") echo "  -o,--output FILE"; echo "  --thin" ;;
  "draw fixtures/a "*) test -d fixtures && echo "three lines" >&2 ;;
  *) exit 2 ;;
esac
"""
HEADER = """inline constexpr HoughOptions line_map_hough{
    .threshold = 14, .max_gap = 4};
  CannyOptions canny{.low = 40, .high = 110};
"""
PAGE = """Use `straightedge draw FILE --thin`.

```sh
straightedge draw fixtures/a -o b   # a comment
```

```text
three lines
```

```cpp
int main() {}
```

<!-- stage options: o.hpp -->

| option | default |
| --- | --- |
| `canny.low` | `40` |
| `canny.high` | `110` |
| `hough.threshold` | `14` |
| `hough.max_gap` | `4` |
"""


class RunPages(unittest.TestCase):
    def troubles(self, page):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("fixtures", "tests/docs", "run"):
                (root / name).mkdir(parents=True)
            (root / "o.hpp").write_text(HEADER, encoding="utf-8")
            (root / run_pages.EXAMPLE).write_text("int main() {}\n", encoding="utf-8")
            program = root / "program"
            program.write_text(PROGRAM, encoding="utf-8")
            program.chmod(0o755)
            return list(run_pages.check(page, root, str(program), root / "run"))

    def test_order(self):
        self.assertEqual(self.troubles(PAGE), [])

    def test_each_trouble(self):
        for wrong in (
            PAGE.replace("draw fixtures/a", "draw fixtures/b"),
            PAGE.replace("draw FILE --thin", "draw FILE --thi"),
            PAGE.replace("draw FILE --thin", "paint FILE"),
            PAGE.replace("three lines", "four lines"),
            PAGE.replace("int main() {}", "int main() { }"),
            PAGE.replace("`40`", "`41`"),
            PAGE.replace("| `hough.max_gap` | `4` |\n", ""),
            PAGE.replace("canny.low", "canny.slow"),
        ):
            self.assertNotEqual(wrong, PAGE)
            self.assertTrue(self.troubles(wrong), wrong)


if __name__ == "__main__":
    unittest.main()
