#!/usr/bin/python3
"""Kills runs at random moments and resumes them: nothing that was announced is lost, and each ends as the undisturbed.

For every project, on one and on two threads, RUNS times: it is solved, with a checkpoint every 0.02 s, and killed with
SIGKILL, after what h5py had found announced in its results.h5 was noted; every other run is resumed and killed once
more. After each kill `info` must tell of as many frames as were announced, or more; h5py, as it is usually called, must
read all of them, and they must be those of a run that nobody disturbed, bit for bit; `render` must draw the last. Then
the run is resumed to its end: results.h5 must hold the same bits in every data set, history.csv the same bytes.

Usage: tests/kill_and_resume.py TALUS_CLI RUNS [PROJECT...] [--seed N]      needs python3-h5py
Without a project: six samples that take a second or two. Exit code 1 where something differs.
"""
import argparse
import collections
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

try:
    import h5py
except ImportError:
    print("python3-h5py is missing")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[1]
SAMPLES = ["free_fall", "incline_slide", "incline_stay", "spinning_block", "wedge", "block_ladder"]


class Fault(Exception):
    """What did not go as it must."""


def announced(results):
    """Frames that a reader of an open results.h5 is told of."""
    return int(results["VTKHDF/Steps"].attrs["NSteps"])


def rows_of(results, name, frames):
    """How many rows of a data set belong to the first frames; all of it where it does not grow."""
    if name in ("Talus/contacts", "Talus/motions"):
        return int(results[name[:-1] + "_end"][frames - 1]) if frames else 0
    if name.startswith(("VTKHDF/Steps/", "Talus/frame_")) or name.endswith("_end"):
        return frames
    each = {"VTKHDF/Points": "NumberOfPoints", "VTKHDF/PointData/displacement": "NumberOfPoints",
            "VTKHDF/PointData/velocity": "NumberOfPoints", "VTKHDF/CellData/stress": "NumberOfCells"}
    if name in each:
        return frames * int(results["VTKHDF"][each[name]][0])
    return frames * len(results["Talus/blocks/name"]) if name == "Talus/asleep" else len(results[name])


def contents(file, frames=None):
    """The bytes of every data set, of so many frames; without a number of those that are announced, and no more."""
    with h5py.File(file, "r") as results:
        count = announced(results) if frames is None else frames
        sets = {}

        def keep(name, item):
            if isinstance(item, h5py.Dataset):
                rows = rows_of(results, name, count)
                found = item[:rows]
                if len(found) != rows or (frames is None and len(item) != rows):
                    raise Fault(f"{name} has {len(item)} rows, not {rows}")
                sets[name] = found.tolist() if found.dtype == object else found.tobytes()
        results.visititems(keep)
        return count, sets


def need_same(found, expected, what):
    names = [name for name in expected if found.get(name) != expected[name]]
    if names or found.keys() != expected.keys():
        raise Fault(f"{what}: other bits in {names[0] if names else 'the names of the data sets'}")


class Project:
    """Solved once undisturbed, and then killed again and again."""

    def __init__(self, cli, file, folder, counts):
        self.cli, self.file, self.folder, self.counts = cli, file, folder, counts
        self.whole, self.run = folder / "whole", folder / "run"
        begin = time.monotonic()
        with subprocess.Popen([cli, "solve", file, "--out", self.whole, "-q"], stdout=subprocess.DEVNULL) as run:
            self.wait_for_begin(run, self.whole)
            self.start = time.monotonic() - begin  # s; cutting and meshing
            if run.wait() != 0:
                raise SystemExit(f"{file} is not solved")
        self.computing = time.monotonic() - begin - self.start  # s
        _, self.expected = contents(self.whole / "results.h5")

    def talus(self, *arguments):
        done = subprocess.run([self.cli, *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Fault(f"{arguments[0]} ends with {done.returncode}: {(done.stderr or done.stdout).strip()[-300:]}")
        return done.stdout

    def solve(self, threads):
        return ["solve", self.file, "--out", self.run, "--threads", str(threads), "--checkpoint-every", "0.02",
                "--resume", "-q"]

    @staticmethod
    def wait_for_begin(run, folder):
        """Until it computes, or has ended."""
        while run.poll() is None and not (folder / "log.txt").exists():
            time.sleep(0.002)

    def killed_run(self, threads, draw):
        """Frames that were announced when it was killed; of four times three while it computes."""
        frames, after = 0, draw.uniform(0, self.start)
        # What a run left without a checkpoint the next one clears, its log before its frames.
        self.clears = (self.run / "results.h5").exists() and not (self.run / "checkpoint.h5").exists()
        with subprocess.Popen([self.cli, *self.solve(threads)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as run:
            if draw.randrange(4):
                self.wait_for_begin(run, self.run)
                after = draw.uniform(0, self.computing)
            try:
                run.wait(after)
                self.counts["runs that had ended"] += 1
            except subprocess.TimeoutExpired:
                self.counts["kills"] += 1
            if (self.run / "results.h5").exists():
                with h5py.File(self.run / "results.h5", "r") as results:
                    frames = announced(results)
            run.kill()
        return frames

    def look_at_what_was_announced(self, frames):
        if not (self.run / "log.txt").exists():  # nothing is announced before it is there
            if frames and not self.clears:
                raise Fault(f"{frames} frames were announced, and there is no log.txt")
            return
        told = json.loads(self.talus("info", self.run, "--json"))["frames"]
        with h5py.File(self.run / "results.h5", "r") as results:
            still = announced(results)
        if min(told, still) < frames:
            raise Fault(f"info tells of {told} frames and NSteps of {still}; {frames} were announced")
        if not told:
            return
        count, found = contents(self.run / "results.h5", told)
        self.counts["frames read"] += count
        _, expected = contents(self.whole / "results.h5", told)
        need_same(found, expected, f"{told} frames after a kill")
        self.talus("render", self.run, "--frame", str(told - 1), "--size", "64x48", "--out",
                   self.folder / "last.png", "-q")
        self.counts["frames drawn"] += 1

    def kill_and_resume(self, threads, draw, kills):
        shutil.rmtree(self.run, ignore_errors=True)
        for _ in range(kills):
            self.look_at_what_was_announced(self.killed_run(threads, draw))
        resumes = (self.run / "checkpoint.h5").exists()
        self.counts["resumed from a checkpoint" if resumes else "begun anew"] += 1
        if not (self.run / "results.h5").exists():  # killed while its folder was being made
            shutil.rmtree(self.run, ignore_errors=True)
        self.talus(*self.solve(threads))
        need_same(contents(self.run / "results.h5")[1], self.expected, "after the resumed run")
        if (self.run / "history.csv").read_bytes() != (self.whole / "history.csv").read_bytes():
            raise Fault("history.csv has other bytes")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("cli")
    options.add_argument("runs", type=int)
    options.add_argument("projects", nargs="*", type=pathlib.Path)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    projects = chosen.projects or [ROOT / "samples" / name / f"{name}.talus" for name in SAMPLES]
    counts, faults = collections.Counter(), 0
    for file in projects:
        with tempfile.TemporaryDirectory() as folder:
            project = Project(chosen.cli, file, pathlib.Path(folder), counts)
            for threads in (1, 2):
                for number in range(chosen.runs):
                    draw = random.Random(f"{chosen.seed} {file.name} {threads} {number}")
                    try:
                        project.kill_and_resume(threads, draw, 1 + number % 2)
                    except (Fault, OSError, KeyError) as fault:
                        faults += 1
                        print(f"{file.name}, {threads} threads, run {number} of seed {chosen.seed}: {fault}", flush=True)
        print(f"{file.name}: {dict(counts)}, {faults} faults so far", flush=True)
    print(", ".join(f"{count} {what}" for what, count in counts.items()) + f"; {faults} faults")
    return min(faults, 1)


if __name__ == "__main__":
    sys.exit(main())
