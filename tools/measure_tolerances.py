#!/usr/bin/env python3
"""Measures how far answers move when a tolerance is doubled or halved, and writes docs/tolerances.md.

    tools/measure_tolerances.py [--jobs N] [--build build/release] [--keep] [NAME...]

Each tolerance is a member of the structs in core/model/*tolerances.hpp; what it decides stands in the comment above or
behind it. bench_tolerances runs a sample of the hard cases with it doubled and halved. Rows that are not measured keep
what the page says of them; --keep measures none, and only takes the comments anew. Python's standard library only.
"""

import argparse
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "tolerances.md"
UNMEASURED = ["not measured"] + [""] * 5


def read_structs():
    """Of every struct its comment and its members: type, name, value, comment."""
    structs = {}
    for header in sorted((ROOT / "core" / "model").glob("*tolerances.hpp")):
        comment, current = [], None
        for line in header.read_text(encoding="utf-8").splitlines():
            text = line.strip()
            if text.startswith("///"):
                comment.append(text[3:].strip())
                continue
            if start := re.match(r"struct (\w+) \{", text):
                current = structs[start[1]] = {"comment": " ".join(comment), "members": []}
            elif (member := re.match(r"(\w+) (\w+)(?: = (.*?))?;\s*(?:///<\s*(.*))?$", text)) and current:
                words = " ".join(comment) or (member[4] or "")
                current["members"].append((member[1], member[2], member[3], words))
            elif text == "};":
                current = None
            comment = []
    return structs


def rows_of(structs, kind="Tolerances", prefix=""):
    """Groups of rows in the structs' order: a group's name and comment, and name, value and comment of its members."""
    members = structs[kind]["members"]
    own = [(prefix + name, value, words) for type_, name, value, words in members if type_ not in structs]
    groups = [(kind, structs[kind]["comment"], own)] if own else []
    for type_, name, _, _ in members:
        if type_ in structs:
            groups += rows_of(structs, type_, prefix + name + ".")
    return groups


def measured_before():
    """The cells of the page as it is, by the name of the tolerance."""
    cells = {}
    if PAGE.exists():
        for line in PAGE.read_text(encoding="utf-8").splitlines():
            if row := re.match(r"\| `([\w.]+)` \| (.*) \|$", line):
                parts = row[2].split(" | ")
                if len(parts) == 6 and parts[0] != UNMEASURED[0]:
                    cells[row[1]] = parts
    return cells


def measure(program, names, jobs):
    def run(part):
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        text = subprocess.run([program, *part], check=True, capture_output=True, text=True, env=environment).stdout
        return [line.strip("| \n").split(" | ") for line in text.splitlines()]

    parts = [part for part in (names[i::jobs] for i in range(jobs)) if part]
    with ThreadPoolExecutor(jobs) as pool:
        return {row[0]: row[1:] for rows in pool.map(run, parts) for row in rows}


HEAD = """# Tolerances

What decides what a run computes beside the project itself, and how much hangs on it. The values stand in one place,
`core/model/tolerances.hpp` and the headers that it includes; this page is made from their comments by
`tools/measure_tolerances.py`, which also measures how far answers move: a sample of the hard cases is run with each
value doubled and halved, alone. Said are

- **move**: the largest difference of where a block ends, over its mesh size, and the hard case in which that is;
- **iterations**: by how much the open–close iterations of the whole sample change;
- **fails**: hard cases that then do not hold what they must ([hard_cases.md](hard_cases.md)).

A zero says that no bit of a final position changed in this sample, not that it never does. In scenes where blocks
tumble or bounce any change of rounding moves the end by much: there a large move says that they are chaotic, and
whether they hold is what counts. h is the mesh size; – stands for a pure number, or for nothing.
"""


def write_page(groups, cells):
    out = [HEAD]
    for kind, comment, rows in groups:
        title = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind.removesuffix("Tolerances")).lower()
        out.append(f"## {title[0].upper()}{title[1:]}\n\n`{kind}`\n")
        out.append("| name | value | unit, what it decides, source |\n|---|--:|---|")
        out += [f"| `{name}` | {value} | {words} |" for name, value, words in rows]
        out.append("\n| name | ×2: move | iterations | fails | ÷2: move | iterations | fails |")
        out.append("|---|---|--:|---|---|--:|---|")
        out += [f"| `{name}` | " + " | ".join(cells.get(name, UNMEASURED)) + " |" for name, _, _ in rows]
        out.append("")
    PAGE.write_text("\n".join(out).rstrip() + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    groups = rows_of(read_structs())
    cells = measured_before()
    if not given.keep:
        program = str(ROOT / given.build / "tests" / "bench" / "bench_tolerances")
        known = subprocess.run([program, "--list"], check=True, capture_output=True, text=True).stdout.split()
        cells.update(measure(program, given.names or known, given.jobs))
    write_page(groups, cells)
    missing = [name for _, _, rows in groups for name, _, _ in rows if name not in cells]
    print(f"{PAGE}: {sum(len(rows) for _, _, rows in groups)} tolerances" +
          (f", not measured: {', '.join(missing)}" if missing else ""))


if __name__ == "__main__":
    main()
