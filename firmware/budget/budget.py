#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""What each algorithm of the core costs on an emulated Cortex-M: a table, and the bars that it must keep.

  budget.py BUILD                 prints the table (Markdown)
  budget.py BUILD --write PAGE    puts it into the page, between its two marks
  budget.py BUILD --check PAGE    compares: every figure within 3 %, every bar kept; exit code 1 if not

BUILD is the build folder of the preset `firmware`. Instructions are counted by the emulator: the same in
every run, and they change with the compiler alone. With another compiler than the page names, --check looks
at the bars only.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent

BOARDS = {"an500": ("M7", "mps2-an500"), "an386": ("M4", "mps2-an386")}
BEGIN, END = "<!-- budget: begin -->", "<!-- budget: end -->"
TOLERANCE = 0.03
# Most that something may cost: (algorithm, size or none) -> column -> limit.
BARS = {
    ("FusedCanny", "320x240"): {"M7 a pixel": 100, "bytes a pixel": 2.2},
    ("CannyRows", "320x240"): {"M7 a pixel": 100, "bytes a pixel": 0.7},
    ("HoughLines/progressive", "320x240"): {"workspace": 130 * 1024},
    ("RansacPlanes/first", "160x120"): {"M7": 8_000_000},
}


def run(program, machine, build):
    """The rows that a program prints, with the instructions that the plugin counted for each."""
    counts = program.with_suffix(".counts")
    counts.unlink(missing_ok=True)
    done = subprocess.run(
        ["qemu-system-arm", "-M", machine, "-nographic", "-monitor", "none", "-serial", "none",
         "-chardev", "stdio,id=semi,signal=off",
         "-semihosting-config", "enable=on,target=native,chardev=semi",
         "-plugin", str(build / "firmware/budget/libcount_instructions.so"), "-d", "plugin", "-D", str(counts),
         "-kernel", str(program)], capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        sys.exit(f"{program.name} ended with {done.returncode}: {done.stdout}{done.stderr}")
    rows = [line.split() for line in done.stdout.splitlines()]
    numbers = [int(line) for line in counts.read_text().splitlines()]
    if not rows or len(rows) != len(numbers):
        sys.exit(f"{program.name} printed {len(rows)} rows, {len(numbers)} were counted")
    return [(name, int(w), int(h), int(workspace), n) for (name, w, h, workspace), n in zip(rows, numbers)]


def code_and_constants(program):
    """Bytes of code and of constants of the library, and of what it needs of libgcc and the C library."""
    out = subprocess.run(["arm-none-eabi-nm", "-S", "--demangle", str(program)], check=True, capture_output=True,
                         text=True).stdout
    code = constants = 0
    not_the_library = re.compile(r"firmware::|\(anonymous namespace\)::|main$|vectors$|reset_handler|fault_handler"
                                 r"|count_(begin|end)")
    for row in re.finditer(r"^[0-9a-f]+ ([0-9a-f]+) (\w) (.*)$", out, re.M):
        if not_the_library.match(row[3]):
            continue
        if row[2] in "tTwWvV":
            code += int(row[1], 16)
        elif row[2] in "rR":
            constants += int(row[1], 16)
    return code, constants


def stack_rows(build, board):
    """The bounds of stack_bounds.py: public function -> bytes."""
    out = subprocess.run(
        [sys.executable, str(HERE.parent / "proofs/stack_bounds.py"),
         str(build / f"firmware/CMakeFiles/core_{board}.dir"), "--most", "1000000",
         "--headers", str(HERE.parent.parent / "include"), "--calls", str(HERE.parent / "proofs/pointer_calls.txt")],
        capture_output=True, text=True).stdout
    return [(int(size), name) for size, name in re.findall(r"^ *(\d+)  (\S+)$", out, re.M)]


def measure(build):
    """(algorithm, "") and (algorithm, size) -> column -> figure."""
    found = {}
    for board, (processor, machine) in BOARDS.items():
        stacks = stack_rows(build, board)
        programs = sorted((build / "firmware/budget").glob(f"budget_*_{board}.elf"))
        if not programs:
            sys.exit(f"no budget program for {board} in {build}")
        with concurrent.futures.ThreadPoolExecutor() as several:
            all_rows = list(several.map(lambda program: run(program, machine, build), programs))
        for program, rows in zip(programs, all_rows):
            code, constants = code_and_constants(program)
            for name, width, height, workspace, instructions in rows:
                owner = name.split("/")[0] + "::"
                pixels = width * height
                found.setdefault((name, ""), {}).update({
                    f"code {processor}": code, f"constants {processor}": constants,
                    f"stack {processor}": max((size for size, f in stacks if f.startswith(owner)), default=0)})
                found.setdefault((name, f"{width}x{height}"), {}).update({
                    "workspace": workspace, "bytes a pixel": round(workspace / pixels, 2),
                    processor: instructions, f"{processor} a pixel": round(instructions / pixels, 1)})
    return found


def compiler():
    line = subprocess.run(["arm-none-eabi-g++", "--version"], check=True, capture_output=True, text=True).stdout
    return "GCC " + re.search(r"(\d+\.\d+\.\d+)", line)[1]


def one_table(rows, heads):
    columns = list(next(iter(rows.values())))
    lines = ["| " + " | ".join(heads + columns) + " |", "|" + " --- |" * len(heads) + " ---: |" * len(columns)]
    lines += ["| " + " | ".join([*key[:len(heads)], *map(str, row.values())]) + " |" for key, row in rows.items()]
    return "\n".join(lines)


def tables(found):
    sizes = ["", "160x120", "320x240", "640x480"]
    ordered = dict(sorted(found.items(), key=lambda item: (item[0][0], sizes.index(item[0][1]))))
    return (f"Made by `firmware/budget/budget.py` with {compiler()} for Arm, `-O2`. Bytes:\n\n"
            + one_table({key: row for key, row in ordered.items() if not key[1]}, ["algorithm"])
            + "\n\nBytes of workspace, and instructions executed:\n\n"
            + one_table({key: row for key, row in ordered.items() if key[1]}, ["algorithm", "size"]))


def parsed(text):
    said = {}
    heads = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|") or cells[0].startswith("---"):
            continue
        if cells[0] == "algorithm":
            heads = cells
            continue
        names = 2 if heads[1] == "size" else 1
        key = (cells[0], cells[1] if names == 2 else "")
        said[key] = dict(zip(heads[names:], map(float, cells[names:])))
    return said


def differences(found, page):
    """What the page says otherwise."""
    said = parsed(page)
    for key, row in found.items():
        for column, figure in row.items():
            number = said.get(key, {}).pop(column, None)
            if number is None:
                yield f"{' '.join(key)}: {column} is not in the table"
            elif abs(figure - number) > TOLERANCE * max(number, 1):
                yield f"{' '.join(key)}: {column} is {figure}, the table says {number:g}"
    for key, rest in said.items():
        for column in rest if key in found else ["the row"]:
            yield f"{' '.join(key)}: {column} is in the table, but was not measured"


def broken_bars(found, bars):
    for key, limits in bars.items():
        for column, limit in limits.items():
            figure = found.get(key, {}).get(column)
            if figure is None:
                yield f"{' '.join(key)}: {column} was not measured"
            elif figure > limit:
                yield f"{' '.join(key)}: {column} is {figure}, the bar is {limit}"


def between_marks(path):
    page = path.read_text()
    if page.count(BEGIN) != 1 or page.count(END) != 1:
        sys.exit(f"{path} does not have the marks {BEGIN} and {END}")
    head, rest = page.split(BEGIN)
    old, tail = rest.split(END)
    return head, old, tail


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, metavar="PAGE")
    parser.add_argument("--check", type=pathlib.Path, metavar="PAGE")
    arguments = parser.parse_args()
    found = measure(arguments.build)
    text = tables(found)
    print(text)
    breaches = []
    if arguments.write:
        head, _, tail = between_marks(arguments.write)
        arguments.write.write_text(f"{head}{BEGIN}\n{text}\n{END}{tail}")
    if arguments.check:
        old = between_marks(arguments.check)[1]
        breaches = list(broken_bars(found, BARS))
        if compiler() in old:
            breaches += differences(found, old)
        else:
            print(f"The page's table is not of {compiler()}: the bars alone are checked.")
    for breach in breaches:
        print("breach: " + breach)
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
