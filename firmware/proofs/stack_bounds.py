#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Bounds the stack of every public function of the core, from GCC's call graphs (-fcallgraph-info=su).

  stack_bounds.py FOLDER --calls FILE --headers FOLDER [--most BYTES]

FOLDER is searched for *.ci, the other one for the private functions, which get no row. FILE says what is called through pointers: `PLACE TARGET`, where PLACE is the
end of the calling line's path and TARGET a regular expression of function names, or `caller` for a hook whose
stack is the caller's own matter. Prints a row for each public function: bytes and name.
Exit code 1 for a recursion, a frame of unknown size, a call through a pointer that FILE does not
know, a line of FILE that fits nothing, or a function that needs more than BYTES.
"""
import argparse
import pathlib
import re
import subprocess
import sys

# For functions of libgcc and the C library, which have no call graph. The deepest that the core calls is a
# division of 64-bit integers, 56 bytes with what it calls itself; the rest is room for other versions.
OUTSIDE = 128
PUBLIC = re.compile(r"straightedge::(?:([A-Z]\w*)::)?(\w+)(?:<.*>)?\(")


class Graph:
    def __init__(self):
        self.bytes = {}
        self.calls = {}
        self.dynamic = set()
        self.pointer_calls = {}  # function -> places

    def read(self, path):
        for line in path.read_text().splitlines():
            node = re.match(r'node: \{ title: "([^"]+)" label: "([^"]*)"', line)
            if node:
                size = re.search(r"(\d+) bytes \(([\w,]+)\)", node[2])
                if size:
                    self.bytes[node[1]] = max(int(size[1]), self.bytes.get(node[1], 0))
                    if size[2] == "dynamic":
                        self.dynamic.add(node[1])
                continue
            edge = re.match(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]+)")?', line)
            if not edge:
                continue
            if edge[2] == "__indirect_call":
                self.pointer_calls.setdefault(edge[1], set()).add(edge[3])
            else:
                self.calls.setdefault(edge[1], set()).add(edge[2])


def linker_name(title):
    """Functions of one file carry the file's name before a colon."""
    return title.rsplit(":", 1)[-1]


def demangled(titles):
    names = [re.sub(r"\.(isra|part|constprop|cold)\.?\d*", "", linker_name(title)) for title in titles]
    out = subprocess.run(["c++filt"], input="\n".join(names), check=True, capture_output=True, text=True).stdout
    return dict(zip(titles, out.splitlines()))


def private_functions(folder):
    found = set()
    for header in folder.rglob("*.hpp"):
        for owner, private in re.findall(r"^class (\w+) \{.*?^ private:(.*?)^\};", header.read_text(), re.M | re.S):
            found.update((owner, name) for name in re.findall(r"\b(\w+)\(", private))
    return found


def public_rows(worst, names, private):
    rows = []
    for title, size in worst.items():
        match = PUBLIC.match(names[title])
        if ":" not in title and match and (match[1], match[2]) not in private:
            rows.append((size, match[0].rstrip("(").removeprefix("straightedge::")))
    return sorted(rows, key=lambda row: (-row[0], row[1]))


def read_calls(path):
    rules = []
    for line in path.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            place, target = line.split(None, 1)
            rules.append((place, target.strip()))
    return rules


def resolve_pointer_calls(graph, rules, names):
    """Adds an edge for every function that may stand behind a pointer."""
    problems, used = [], set()
    for function, places in graph.pointer_calls.items():
        for place in sorted(places):
            path = place.split(":")[0]
            fitting = [rule for rule in rules if path.endswith(rule[0])]
            used.update(fitting)
            if not fitting:
                problems.append(f"{place}: call through a pointer to nobody knows what, in {names[function]}")
            for _, target in fitting:
                if target == "caller":
                    continue
                found = [title for title in graph.bytes if re.search(target, names[title])]
                graph.calls.setdefault(function, set()).update(found)
                if not found:
                    problems.append(f"{place}: nothing is called {target}")
    problems += [f"no call through a pointer at {rule[0]}" for rule in rules if rule not in used]
    return problems


def worst_paths(graph, names):
    """Bytes from each function down, without recursion on the way (this program must not overflow either)."""
    worst, problems = {}, []
    for start in graph.bytes:
        stack = [(start, False)]
        open_ones = set()
        while stack:
            title, done = stack.pop()
            if done:
                open_ones.discard(title)
                below = [worst.get(callee, OUTSIDE) for callee in graph.calls.get(title, ())]
                worst[title] = graph.bytes[title] + max(below, default=0)
            elif title not in worst:
                open_ones.add(title)
                stack.append((title, True))
                for callee in graph.calls.get(title, ()):
                    if callee in open_ones:
                        problems.append(f"recursion: {names[title]} calls {names[callee]}")
                    elif callee in graph.bytes and callee not in worst:
                        stack.append((callee, False))
    return worst, sorted(set(problems))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--calls", type=pathlib.Path, required=True)
    parser.add_argument("--headers", type=pathlib.Path, required=True)
    parser.add_argument("--most", type=int, default=4096)
    arguments = parser.parse_args()
    graph = Graph()
    for path in sorted(arguments.folder.rglob("*.ci")):
        graph.read(path)
    names = demangled(list(graph.bytes))
    problems = [] if graph.bytes else [f"no call graph in {arguments.folder}"]
    problems += resolve_pointer_calls(graph, read_calls(arguments.calls), names)
    problems += [f"a frame of unknown size: {names[title]}" for title in sorted(graph.dynamic)]
    worst, cycles = worst_paths(graph, names)
    problems += cycles
    rows = public_rows(worst, names, private_functions(arguments.headers))
    for size, name in rows:
        print(f"{size:6d}  {name}")
    problems += [f"{name} needs {size} bytes of stack, more than {arguments.most}"
                 for size, name in rows if size > arguments.most]
    for problem in problems:
        print("breach: " + problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
