#!/usr/bin/python3
"""Solves a small scene for very many steps and looks whether the program comes to hold more and more.

A cube stands on a tilted floor and never sleeps (contact, friction, a frame every thousandth of the run, checkpoints);
what the process has in memory is read ten times a second and told for each tenth of the steps. The last tenth has the
end of the run in it. It fails where the ninth tenth holds over 5 % more than the second.

Usage: tests/memory_of_long_run.py TALUS_CLI [--steps N]
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

SCENE = {
    "talus": 1,
    "name": "A cube on a floor",
    "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
    "joints": {"J": {"friction_angle": 30}},
    "default_joint": "J",
    "gravity": [2, 0, -9.6],
    "solver": {"effects": {"sleep": "off"}},
    "solids": [
        {"name": "floor", "box": {"min": [-2, -2, -1], "max": [3, 3, 0]}, "material": "rock", "body": "fixed"},
        {"name": "cube", "box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": "rock", "body": "rigid"}],
    "monitors": [{"name": "P", "block": "cube", "at": [0.5, 0.5, 0.5]}],
    "stages": [{"name": "rest", "type": "dynamic", "time_step": 0.001}],
}


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


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("cli")
    options.add_argument("--steps", type=int, default=1000000)
    chosen = options.parse_args()
    tenths = [[] for _ in range(10)]
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        SCENE["stages"][0]["steps"] = chosen.steps
        SCENE["output"] = {"every": 0.001 * max(1, chosen.steps // 1000)}
        (folder / "scene.talus").write_text(json.dumps(SCENE), encoding="utf-8")
        run = subprocess.Popen([chosen.cli, "solve", str(folder / "scene.talus"), "--out", str(folder / "r"), "-q",
                                "--checkpoint-every", "5"], stdout=subprocess.DEVNULL)
        at, steps = 0, -1  # the heading is no step
        while run.poll() is None:
            at, steps = steps_of(folder / "r" / "steps.csv", at, steps)
            held = resident(run)
            if held and steps >= 0:
                tenths[min(9, 10 * steps // chosen.steps)].append(held)
            time.sleep(0.1)
        at, steps = steps_of(folder / "r" / "steps.csv", at, steps)
    if run.returncode != 0 or steps != chosen.steps:
        print(f"the run ended with {run.returncode} after {steps} steps")
        return 1
    for tenth, held in enumerate(tenths):
        if held:
            print(f"{10 * tenth:3d} to {10 * tenth + 10:3d} % of the steps: {min(held):.1f} to {max(held):.1f} MB")
    if not (tenths[1] and tenths[8]):
        print("too few steps to tell")
        return 1
    growth = max(tenths[8]) - max(tenths[1])
    print(f"{chosen.steps} steps in {time.monotonic() - begin:.0f} s; {growth:+.1f} MB from the second tenth to the ninth")
    return int(growth > 0.05 * max(tenths[1]))


if __name__ == "__main__":
    sys.exit(main())
