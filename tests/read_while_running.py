#!/usr/bin/python3
"""Reads results.h5 as other programs do, with h5py, all the while that runs write it and after they were killed.

Each run is read by plain openings and by openings for a single writer and many readers (swmr=True), as often as they
can. A reading takes all that the file announces. It fails where h5py does not open the file, meets what is not there,
or finds other numbers in a frame than it found before. HDF5 reads a block that is being written up to a hundred times
for readers with swmr=True, and once for plain ones: these may open the file a second time, which is told. Then the run
is killed at a moment that the seed draws, and the file must open at once. Needs python3-h5py.

Usage: tests/read_while_running.py TALUS_CLI [--runs N] [--seconds S] [--seed N] [--project FILE]
"""
import argparse
import collections
import json
import pathlib
import random
import signal
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


def endless(project, folder):
    """The project with its last stage so long that it is killed before its end, and a frame each step."""
    lines = project.read_text(encoding="utf-8").splitlines()
    text = json.loads("\n".join(line for line in lines if not line.lstrip().startswith("//")))
    stage = text["stages"][-1]
    stage.pop("steps", None)
    stage["duration"] = 1e4
    text.pop("expect", None)
    text["output"] = {"every": stage["time_step"]}
    file = folder / "endless.talus"
    file.write_text(json.dumps(text), encoding="utf-8")
    return file


def read(file, swmr, known):
    """How many frames the file announces; all of them are read, and held to what was read before."""
    with h5py.File(file, "r", swmr=swmr) as results:
        grid = results["VTKHDF"]
        steps = int(grid["Steps"].attrs["NSteps"])
        times = grid["Steps/Values"][:steps]
        nodes = int(grid["NumberOfPoints"][0])
        assert len(times) == steps, "fewer moments than steps"
        for frame in {0, steps // 2, steps - 1} if steps else set():
            first = int(grid["Steps/PointOffsets"][frame])
            moved = grid["PointData/displacement"][first:first + nodes]
            assert moved.shape == (nodes, 3), f"frame {frame} is not whole"
            first = int(grid["Steps/CellDataOffsets/stress"][frame])
            assert len(grid["CellData/stress"][first:first + 1]) == 1, f"frame {frame} has no stress"
            end = int(results["Talus/contact_end"][frame])
            assert len(results["Talus/contacts"][max(0, end - 5):end]) == min(end, 5), f"frame {frame} lacks contacts"
            seen = (float(times[frame]), moved.tobytes())
            assert known.setdefault(frame, seen) == seen, f"frame {frame} has changed"
        return steps


def attempt(file, swmr, known, errors, again=None):
    """`again` counts the openings that may be tried a second time."""
    try:
        return read(file, swmr, known)
    except (OSError, KeyError) as error:
        # h5py says a block that does not fit its checksum by the one or the other, as it opens the file or what is in it.
        half_written = isinstance(error, OSError) or "metadata checksum" in str(error)
        if again is None or swmr or not half_written:
            errors[f"{'swmr' if swmr else 'plain'}: {str(error)[:100]}"] += 1
            return -1
        again[str(error)[:100]] += 1
        return attempt(file, swmr, known, errors)
    except (RuntimeError, ValueError, AssertionError) as error:
        errors[f"{'swmr' if swmr else 'plain'}: {str(error)[:100]}"] += 1
        return -1


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("cli")
    options.add_argument("--runs", type=int, default=20)
    options.add_argument("--seconds", type=float, default=3, help="that a run lasts at most before it is killed")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--project", type=pathlib.Path, default=ROOT / "samples/block_ladder/block_ladder.talus")
    chosen = options.parse_args()
    draw = random.Random(chosen.seed)
    readings, during, again, after = 0, collections.Counter(), collections.Counter(), collections.Counter()
    most = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        project = endless(chosen.project, folder)
        for number in range(chosen.runs):
            out = folder / f"{number}.results"
            file = out / "results.h5"
            run = subprocess.Popen([chosen.cli, "solve", str(project), "--out", str(out), "-q"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while not file.exists() and run.poll() is None:
                time.sleep(0.001)
            end, known, frames = time.monotonic() + draw.uniform(0.05, chosen.seconds), {}, 0
            while time.monotonic() < end:
                frames = max(frames, attempt(file, readings % 2 == 1, known, during, again))
                readings += 1
            run.send_signal(signal.SIGKILL)
            run.wait()
            for swmr in (False, True):
                seen = attempt(file, swmr, known, after)
                if 0 <= seen < frames:
                    after[f"{frames - seen} frames are lost"] += 1
            most = max(most, frames)
    for what, errors in (("opened again", again), ("during the runs", during), ("after a kill", after)):
        for error, count in errors.most_common():
            print(f"{what}, {count} times: {error}")
    print(f"{chosen.runs} runs, killed; up to {most} frames; {readings} readings meanwhile, "
          f"{sum(during.values())} failed; {2 * chosen.runs} afterwards, {sum(after.values())} failed")
    return min(1, sum(during.values()) + sum(after.values()))


if __name__ == "__main__":
    sys.exit(main())
