#!/usr/bin/env python3
"""Measures what the solver's tolerance costs and is worth, and writes the table of docs/accuracy.md.

    tools/measure_solver_tolerance.py [--build build/release]

Six samples are studied at draft, standard and reference; the table stands between the lines of the page that name this
program. Python's standard library only.
"""

import argparse
import json
import os
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "accuracy.md"
SAMPLES = ["incline_slide", "wedge", "spinning_block", "cantilever", "arch", "jiweishan"]
TOLERANCES = {"draft": 1e-3, "standard": 1e-6, "reference": 1e-10}
BEGIN, END = (f"<!-- tools/measure_solver_tolerance.py: {word} -->" for word in ("begin", "end"))


def study(program, sample, folder):
    """The rows of a study of the sample, by tolerance, and what errors are measured against."""
    project = ROOT / "samples" / sample / f"{sample}.talus"
    command = [program, "study", "accuracy", project, "--out", folder / sample, "--jobs", "1", "--restart", "--values",
               "tolerance=draft,standard,reference"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    found = json.loads((folder / sample / "accuracy.json").read_text(encoding="utf-8"))
    return {run["tolerance"]: run for run in found["runs"]}, found["measured_against"]


def cell(run):
    """Error, seconds, iterations a step."""
    if run["status"] != "completed":
        return f"{run['status']} | {run['cpu_seconds']:.3g} | –"
    error = 100 * run["error"]
    return f"{error:.2g} % | {run['cpu_seconds']:.3g} | {run['iterations'] / max(1, run['steps']):.2f}"


def table(program):
    head = ["Sample", "Error against"]
    for name in TOLERANCES:
        head += [f"{name}: error", "s", "iterations a step"]
    lines = ["| " + " | ".join(head) + " |", "|---|---|" + "--:|" * (len(head) - 2)]
    with tempfile.TemporaryDirectory() as folder:
        for sample in SAMPLES:
            runs, against = study(program, sample, Path(folder))
            known = "known answer" if against == "expect" else "reference"
            cells = [cell(runs[tolerance]) for tolerance in TOLERANCES.values()]
            lines.append(f"| `{sample}` | {known} | " + " | ".join(cells) + " |")
    return lines


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("--build", default="build/release", type=Path)
    options = ask.parse_args()
    page = PAGE.read_text(encoding="utf-8")
    before, after = page[: page.index(BEGIN)], page[page.index(END):]
    rows = table(ROOT / options.build / "app" / "talus-cli")
    PAGE.write_text(before + "\n".join([BEGIN, "", *rows, "", ""]) + after, encoding="utf-8")


main()
