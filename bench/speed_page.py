#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""The tables of docs/speed.md, measured.

  speed_page.py BUILD                prints them
  speed_page.py BUILD --write PAGE   puts them into the page, each between its two marks (about four minutes)
  speed_page.py BUILD --check PAGE   says whether the page has the rows that the programs have today, without
                                     measuring; exit code 1 if not

BUILD is a build folder with bench_speed and bench_targets. The tables against other libraries are made when it
has bench_compare (-DSTRAIGHTEDGE_BUILD_COMPARE=ON), and stay as they are when not. Let nothing else run.
"""
import argparse
import pathlib
import re
import subprocess
import sys

# A processor without AVX2 or fused multiply-add has fewer rows here.
OF_THE_MACHINE = {"floor", "fma"}
COMPARED = ["edges", "lines", "first", "planes", "octree", "threads"]
ROUNDS = "15"


def mark(name, what):
    return f"<!-- speed: {name} {what} -->"


def output_of(program, *arguments):
    done = subprocess.run([str(program), *arguments], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{program.name} ended with {done.returncode}")
    return done.stdout


def rows_of(text):
    return "\n".join(line for line in text.splitlines() if line.startswith("|"))


def split_tables(text):
    """What follows each line "table NAME"."""
    parts = re.split(r"^table (\w+)\n", text, flags=re.M)[1:]
    return {name: rows_of(body) for name, body in zip(parts[::2], parts[1::2])}


def processor():
    try:
        found = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    except OSError:
        found = None
    return found[1] if found else "an unnamed processor"


def compiler(build):
    cache = (build / "CMakeCache.txt").read_text()
    path = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.M)[1]
    return subprocess.run([path, "--version"], capture_output=True, text=True).stdout.splitlines()[0]


def measured(build):
    """Name of a table -> its text."""
    tables = {"machine": f"Measured on {processor()}, one thread, with {compiler(build)}."}
    tables.update(split_tables(output_of(build / "bench/bench_speed")))
    tables["targets"] = rows_of(output_of(build / "bench/bench_targets"))
    compare = build / "bench/compare/bench_compare"
    for part in COMPARED if compare.exists() else []:
        tables[part] = rows_of(output_of(compare, ROUNDS, part))
    return tables


def shapes(build):
    """The same without times."""
    tables = split_tables(output_of(build / "bench/bench_speed", "--shape"))
    tables["targets"] = rows_of(output_of(build / "bench/bench_targets", "--shape"))
    return tables


def names(table):
    """Of each row the cells of the columns whose line in the head is `---`: the others hold figures."""
    cells = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in table.splitlines()]
    if len(cells) < 2:
        return []
    kept = [i for i, rule in enumerate(cells[1]) if rule == "---"]
    return [cells[0]] + [[row[i] for i in kept] for row in cells[2:]]


def on_page(page, name):
    """Text between the marks of a table, or None."""
    begin, end = mark(name, "begin"), mark(name, "end")
    if page.count(begin) != 1 or page.count(end) != 1:
        return None
    return page.split(begin)[1].split(end)[0].strip()


def with_tables(page, tables):
    for name, text in tables.items():
        begin, end = mark(name, "begin"), mark(name, "end")
        head, rest = page.split(begin)
        page = f"{head}{begin}\n{text}\n{end}{rest.split(end)[1]}"
    return page


def breaches(page, expected):
    for name in ["machine", *COMPARED, *expected]:
        if on_page(page, name) is None:
            yield f"the page does not have the marks {mark(name, 'begin')} and {mark(name, 'end')}"
    for name in COMPARED:
        if len(names(on_page(page, name) or "")) < 2:
            yield f"{name}: the page has no rows"
    for name, table in expected.items():
        have, want = names(on_page(page, name) or ""), names(table)
        if name in OF_THE_MACHINE:
            have = [row for row in have if row in want]
        for row in [row for row in want if row not in have]:
            yield f"{name}: the page lacks {' | '.join(row)}"
        for row in [row for row in have if row not in want]:
            yield f"{name}: the program does not have {' | '.join(row)}"
        if have != want and sorted(have) == sorted(want):
            yield f"{name}: the rows stand in another order"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, metavar="PAGE")
    parser.add_argument("--check", type=pathlib.Path, metavar="PAGE")
    arguments = parser.parse_args()
    if arguments.check:
        found = list(breaches(arguments.check.read_text(encoding="utf-8"), shapes(arguments.build)))
        for breach in found:
            print("breach: " + breach)
        return 1 if found else 0
    page = arguments.write.read_text(encoding="utf-8") if arguments.write else ""
    tables = measured(arguments.build)
    for name, text in tables.items():
        print(f"{name}\n\n{text}\n")
    if arguments.write:
        missing = [name for name in tables if on_page(page, name) is None]
        if missing:
            sys.exit(f"{arguments.write} lacks the marks of {', '.join(missing)}")
        arguments.write.write_text(with_tables(page, tables), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
