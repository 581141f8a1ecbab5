#!/usr/bin/python3
"""Solves a small scene for very many steps and looks whether the program comes to hold more and more.

A cube slides with friction over a floor of boxes, past their seams, and never sleeps: contacts come and go. There is a
frame every thousandth of the run, and a checkpoint every five seconds, or none; what the process has in memory is read
ten times a second and told for each tenth of the steps. It fails where any later tenth holds over 5 % more than the
second. The first is left out: in it the run takes what it needs. So is the end of the run, which reads what was
written.

Usage: tests/memory_of_long_run.py TALUS_CLI [--steps N] [--no-checkpoints]
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

ALLOWED = 0.05  # of what the second tenth holds
TIME_STEP = 1e-5  # s: in 1e7 steps the cube comes to 2 m/s
LEAD = 0.02  # m/s² by which gravity along the floor exceeds what friction holds
BOX = 7  # m


def scene(steps):
    way = LEAD * (steps * TIME_STEP) ** 2 / 2
    floor = [{"name": f"floor {i}", "material": "rock", "body": "fixed",
              "box": {"min": [BOX * i - 3, -2, -1], "max": [BOX * (i + 1) - 3, 3, 0]}}
             for i in range(int(way // BOX) + 2)]
    cube = {"name": "cube", "box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": "rock", "body": "rigid"}
    return {
        "talus": 1,
        "name": "A cube slides over a floor of boxes",
        "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
        "joints": {"J": {"friction_angle": 11.3099324740202}},  # its tangent is 0.2
        "default_joint": "J",
        "gravity": [2 + LEAD, 0, -10],
        "solver": {"effects": {"sleep": "off"}},
        "solids": [*floor, cube],
        "monitors": [{"name": "P", "block": "cube", "at": [0.5, 0.5, 0.5]}],
        "stages": [{"name": "slide", "type": "dynamic", "time_step": TIME_STEP, "steps": steps}],
        "output": {"every": TIME_STEP * max(1, steps // 1000)}}


def resident(process):
    """MB; nothing once it has ended."""
    try:
        for line in pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii").splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) / 1024
    except OSError:
        pass
    return None


def steps_of(table, at, count):
    """How many lines a table has that grows, looked at behind `at` bytes."""
    try:
        with open(table, "rb") as stream:
            stream.seek(at)
            more = stream.read()
    except OSError:
        return at, count
    return at + len(more), count + more.count(b"\n")


def watched_run(cli, steps, checkpoints, folder):
    """How the run ended, its steps, and what it held in each tenth of them and at its end."""
    (folder / "scene.talus").write_text(json.dumps(scene(steps)), encoding="utf-8")
    command = [cli, "solve", str(folder / "scene.talus"), "--out", str(folder / "r"), "-q", "--checkpoint-every",
               "5" if checkpoints else "1e9"]
    held = [[] for _ in range(11)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as run:
        at, count = 0, -1  # the heading is no step
        while run.poll() is None:
            at, count = steps_of(folder / "r" / "steps.csv", at, count)
            now = resident(run)
            if now and count >= 0:
                held[10 * count // steps].append(now)
            time.sleep(0.1)
        _, count = steps_of(folder / "r" / "steps.csv", at, count)
    return run.returncode, count, held


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("cli")
    options.add_argument("--steps", type=int, default=1000000)
    options.add_argument("--no-checkpoints", action="store_true")
    chosen = options.parse_args()
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        code, steps, held = watched_run(chosen.cli, chosen.steps, not chosen.no_checkpoints, pathlib.Path(folder))
    if code != 0 or steps != chosen.steps:
        print(f"the run ended with {code} after {steps} steps")
        return 1
    for tenth, sizes in enumerate(held):
        if sizes:
            where = f"{10 * tenth:3d} to {10 * tenth + 10:3d} % of the steps" if tenth < 10 else "when all are done"
            print(f"{where}: {min(sizes):.1f} to {max(sizes):.1f} MB")
    if not all(held[1:10]):
        print("too few steps to tell")
        return 1
    growth = max(max(sizes) for sizes in held[2:10]) - max(held[1])
    print(f"{chosen.steps} steps in {time.monotonic() - begin:.0f} s; {growth:+.1f} MB after the second tenth")
    return int(growth > ALLOWED * max(held[1]))


if __name__ == "__main__":
    sys.exit(main())
