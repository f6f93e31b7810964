# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Does what the pages say: run_pages.py ROOT PROGRAM PAGE...

Commands: each `straightedge` command of a ```sh block runs, in a folder of the page's own with the fixtures in it. A
```text block holds the words that the first command of the block before it says, but for times in ms.
Options: each `straightedge SUBCOMMAND --option` in running text or a table is in the help of that subcommand.
Code: a ```cpp block with a main is tests/docs/readme_example.cpp, which is built and run by a test of its own.
Stages: below "<!-- stage options: HEADER -->", a row `canny.low` or `hough.threshold` has the default that the header
gives the stage.
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
SPAN = re.compile(r"(?<!`)`straightedge ([a-z]+)([^`\n]*)`")
STAGES = re.compile(r"<!-- stage options: (\S+) -->\n((?:\n|\|.*\n)+)")
STAGE_ROW = re.compile(r"^\| `(canny|hough)\.(\w+)` .*?\| `([^`]+)`", re.M)
EXAMPLE = "tests/docs/readme_example.cpp"


def run(program, words, folder):
    return subprocess.run(
        [program, *words], cwd=folder, capture_output=True, text=True, timeout=300, check=False
    )


def without_times(words):
    return None if words is None else re.sub(r"\b\d+(\.\d+)? ms\b", "... ms", words)


def commands(block):
    for line in block.splitlines():
        words = shlex.split(line, comments=True)
        if words and words[0] == "straightedge":
            yield line, words[1:]


def check_commands(text, root, program, folder):
    os.symlink(root / "fixtures", folder / "fixtures")
    said = None
    for language, block in BLOCK.findall(text):
        if language == "sh":
            said = None
            for line, words in commands(block):
                done = run(program, words, folder)
                said = done.stderr if said is None else said
                if done.returncode != 0:
                    yield f"{line}: code {done.returncode}, {done.stderr.strip()}"
        elif language == "text" and without_times(said) != without_times(block):
            yield f"says now:\n{said}"


def check_options(text, program):
    helps = {}
    for name, rest in SPAN.findall(BLOCK.sub("", text)):
        if name not in helps:
            done = run(program, [name, "--help"], None)
            helps[name] = done.stdout if done.returncode == 0 else ""
        if not helps[name]:
            yield f"there is no command {name}"
        for option in re.findall(r"(?<![\w-])--?[a-z][\w-]*", rest):
            if not re.search(rf"(?<![\w-]){option}(?![\w-])", helps[name]):
                yield f"{name} has no option {option}"


def check_code(text, root):
    example = (root / EXAMPLE).read_text(encoding="utf-8")
    for language, block in BLOCK.findall(text):
        if language == "cpp" and "int main" in block and block not in example:
            yield f"the code is not that of {EXAMPLE}"


def stage_defaults(header):
    """{"canny": {"low": "40", ...}, "hough": ...} from the initialisers in the header."""
    canny = re.search(r"CannyOptions canny\{([^}]*)\}", header)
    hough = re.search(r"HoughOptions line_map_hough\{([^}]*)\}", header)
    pairs = {"canny": canny, "hough": hough}
    return {
        stage: dict(re.findall(r"\.(\w+) = ([^,\s}]+)", found.group(1)))
        for stage, found in pairs.items()
        if found
    }


def check_stages(text, root):
    for header, table in STAGES.findall(text):
        real = stage_defaults((root / header).read_text(encoding="utf-8"))
        stated = {(stage, name): value for stage, name, value in STAGE_ROW.findall(table)}
        for stage, values in real.items():
            for name, value in values.items():
                if stated.get((stage, name)) != value:
                    yield f"{stage}.{name} is {value}, not {stated.get((stage, name))}"
        for stage, name in stated:
            if name not in real.get(stage, {}):
                yield f"{header} gives {stage}.{name} no value of its own"


def check(text, root, program, folder):
    yield from check_commands(text, root, program, folder)
    yield from check_options(text, program)
    yield from check_code(text, root)
    yield from check_stages(text, root)


def main(root, program, pages):
    troubles = []
    for page in pages:
        text = (root / page).read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            troubles += [f"{page}: {t}" for t in check(text, root, program, pathlib.Path(folder))]
    print("\n".join(troubles) or "every page does what it says")
    return bool(troubles)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), str(pathlib.Path(sys.argv[2]).resolve()), sys.argv[3:]))
