#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Checks that an archive of the core keeps what docs/firmware.md promises.

  check_archive.py ARCHIVE [--tools PREFIX]

No writable memory of its own, nothing that runs before main, no unwind tables, and from outside nothing
but what ALLOWED names. Prints each breach; exit code 1 if there is one.
"""
import argparse
import re
import subprocess
import sys

# What a compiler calls without being asked. Every C library for Arm has the first, libgcc the second.
ALLOWED = re.compile(r"memcpy|memmove|memset|memcmp|__aeabi_\w+")
UNWANTED_SECTIONS = re.compile(r"\.(data|bss|tdata|tbss|init_array|fini_array|ctors|dtors|preinit_array"
                               r"|ARM\.extab|ARM\.exidx|eh_frame|gcc_except_table)\b")


def output_of(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def section_breaches(tools, archive):
    member = "?"
    for line in output_of([tools + "readelf", "-SW", archive]).splitlines():
        if line.startswith("File: "):
            member = line[6:]
        row = re.match(r"\s*\[\s*\d+\]\s+(\S+)\s+(\S+)\s+\S+\s+\S+\s+([0-9a-f]+)\s", line)
        if row and int(row[3], 16) > 0 and UNWANTED_SECTIONS.match(row[1]):
            yield f"{member}: section {row[1]} of {int(row[3], 16)} bytes"


def symbol_breaches(tools, archive):
    defined, wanted = set(), {}
    for line in output_of([tools + "nm", "-A", archive]).splitlines():
        row = re.match(r"(\S+):\s*[0-9a-f]*\s+(\w)\s+(\S+)$", line)
        if not row:
            continue
        member, kind, name = row.groups()
        if kind == "U":
            wanted.setdefault(name, member)
        else:
            defined.add(name)
    if not defined:
        yield f"{archive}: no symbol at all"
    for name, member in sorted(wanted.items()):
        if name not in defined and not ALLOWED.fullmatch(name):
            yield f"{member}: needs {name} from outside"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("archive")
    parser.add_argument("--tools", default="arm-none-eabi-", help="what the names of nm and readelf begin with")
    arguments = parser.parse_args()
    breaches = [*section_breaches(arguments.tools, arguments.archive),
                *symbol_breaches(arguments.tools, arguments.archive)]
    print("\n".join(breaches) if breaches else "no breach")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
