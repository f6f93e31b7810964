# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Checks the pages of a project: check_pages.py ROOT

Links: every relative link and picture of every Markdown file leads to a file, and its #part to a heading.
Pictures: every file in docs/pictures is shown on some page, and all of them together stay small.
Defaults: tables below "<!-- options: HEADER STRUCT -->" name members of that struct with their defaults, and each
member of such a struct is in some table.
Tests: a quoted name after a link to a test file is a test case of that file.
"""
import pathlib
import re
import sys

MOST_PICTURE_BYTES = 1_600_000
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]*(?:\([^()]*\)[^()\s]*)*)\)")
MARK = re.compile(r"<!-- options: (\S+) (\w+) -->")
MEMBER = re.compile(r"^\s+[\w:<>]+ (\w+)\s*=\s*([^;]+);", re.M)
TEST = re.compile(r"\]\(([^)]+\.cpp)\) \"([^\"]+)\"")


def pages(root):
    found = sorted(root.glob("*.md")) + sorted((root / "docs").rglob("*.md"))
    return {page: page.read_text(encoding="utf-8") for page in found}


def anchor(heading):
    """The name that a heading gets on GitHub."""
    text = re.sub(r"[`*]|\]\([^)]*\)|\[", "", heading.strip().lower())
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors(text):
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return {anchor(h) for h in re.findall(r"^#+ (.*)$", text, re.M)}


def check_links(texts):
    for page, text in texts.items():
        for target in LINK.findall(text):
            if re.match(r"[a-z]+:", target):
                continue
            file, _, part = target.partition("#")
            path = (page.parent / file).resolve() if file else page
            if not path.exists():
                yield f"{page}: {target} does not exist"
            elif part and path.suffix == ".md" and part not in anchors(path.read_text(encoding="utf-8")):
                yield f"{page}: {target} has no such heading"


def check_pictures(root, texts):
    shown = {
        (page.parent / target).resolve() for page, text in texts.items() for target in LINK.findall(text)
    }
    files = sorted(f for f in (root / "docs" / "pictures").rglob("*") if f.is_file())
    for file in files:
        if file.resolve() not in shown:
            yield f"{file}: is on no page"
    if sum(file.stat().st_size for file in files) > MOST_PICTURE_BYTES:
        yield f"docs/pictures: more than {MOST_PICTURE_BYTES / 1e6} MB"


def members(root, header, struct):
    text = (root / header).read_text(encoding="utf-8")
    body = re.search(rf"^struct {struct} {{\n(.*?)^}};", text, re.M | re.S)
    return dict(MEMBER.findall(body.group(1))) if body else {}


def same(stated, real):
    real = real.replace("'", "").rsplit("::", 1)[-1]
    try:
        # As many digits as the page gives.
        return abs(float(stated) - float(real)) <= 1e-3 * abs(float(real))
    except ValueError:
        return stated == real


def table_rows(text):
    """Cells of the table that begins after the blank lines."""
    for line in text.lstrip("\n").split("\n"):
        if not line.startswith("|"):
            return
        yield [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def check_defaults(root, texts):
    named = {}
    for page, text in texts.items():
        for mark in MARK.finditer(text):
            header, struct = mark.groups()
            real = members(root, header, struct)
            if not real:
                yield f"{page}: {header} has no struct {struct} with defaults"
                continue
            rows = list(table_rows(text[mark.end() :]))
            column = rows[0].index("default") if rows and "default" in rows[0] else None
            if column is None:
                yield f"{page}: no table with defaults below the mark for {struct}"
                continue
            for row in rows[2:]:
                name = row[0].strip("`")
                named.setdefault((header, struct), set()).add(name)
                stated = re.match(r"`([^`]*)`", row[column])
                if name not in real:
                    yield f"{page}: {struct} has no member {name}"
                elif stated is None or not same(stated.group(1), real[name]):
                    yield f"{page}: {struct}.{name} is {real[name]}, not {row[column]}"
    for (header, struct), names in named.items():
        for name in members(root, header, struct).keys() - names:
            yield f"{header}: {struct}.{name} is in no table"


def check_tests(texts):
    for page, text in texts.items():
        for file, name in TEST.findall(text):
            path = page.parent / file
            if path.exists() and f'TEST_CASE("{name}")' not in path.read_text(encoding="utf-8"):
                yield f'{page}: {file} has no test "{name}"'


def check(root):
    texts = pages(root)
    yield from check_links(texts)
    yield from check_pictures(root, texts)
    yield from check_defaults(root, texts)
    yield from check_tests(texts)


if __name__ == "__main__":
    troubles = list(check(pathlib.Path(sys.argv[1])))
    print("\n".join(troubles) or "every page is in order")
    sys.exit(bool(troubles))
