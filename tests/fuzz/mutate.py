#!/usr/bin/env python3
"""Gives talus-cli thousands of damaged projects, results folders and files of solids and terrain; tells how it ends.

Every mutation is drawn from the seed, so that a failure can be made again. A run is a failure when it crashes, takes
more than 10 s of the processor or a minute, ends with exit code 3, or complains in more than one line, in 500
characters or more, or after more than a second.

The program and its mesher are started once and fork for each run, which saves 50 of the 60 to 180 ms that one takes
(served.py). What looks like a failure so is run again by the program as users start it, and judged by that.

Usage: tests/fuzz/mutate.py TALUS_CLI projects|results|solids [--count N] [--seed N] [--keep FOLDER]
"""
import argparse
import collections
import copy
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

from served import Served

ROOT = pathlib.Path(__file__).resolve().parents[2]
LONGEST = 10  # seconds of the processor: a busy machine makes no run a failure
SOON = 1  # seconds of the processor, until something is refused
PATIENCE = 60  # seconds
NUMBERS = [0, -0.0, -1, 1e-300, -1e-300, 5e-324, 1e300, -1e300, 1.7e308, 2**31, 2**53, 2**63, -(2**63), 2**64,
           2**70, 0.1, 89.9999999, 90, 1e9, -1e9, 1e17]
TEXTS = ["", " ", "\0", "a\0b", "é" * 300, "x" * 5000, "../../etc/passwd", "/dev/zero", ".", "\n\n", "\x1b[31m",
         "\ud83e\udea8", "%s%n", "~1", "a/b", '"', "\u202e", "step", "nan"]
# What is said before a run begins, and is no complaint.
NOTES = re.compile(rb"(Goes on at|No checkpoint in)[^\n]*\n")
RESULT_FILES = ["results.h5", "history.csv", "steps.csv", "summary.json", "checkpoint.h5", "project.talus"]


def places_in(value, above=()):
    """The paths of everything in a JSON value."""
    yield above
    if isinstance(value, dict):
        inner = value.items()
    elif isinstance(value, list):
        inner = enumerate(value)
    else:
        inner = ()
    for key, part in inner:
        yield from places_in(part, above + (key,))


def long_array(draw, old):
    """Mostly wrong: what an export or a script that went astray would leave."""
    entry = draw.choice([0, "x", None, [], {}, old, [1, 2, 3]])
    size = draw.choice([1000, 30000, 100000])
    return [entry] * min(size, 10**7 // len(json.dumps(entry)))


def other_value(draw, old):
    """Something else where `old` stood."""
    kind = draw.randrange(10)
    if isinstance(old, (int, float)) and not isinstance(old, bool) and kind < 7:
        return draw.choice(NUMBERS)
    if isinstance(old, str) and kind < 7:
        return draw.choice(TEXTS)
    if isinstance(old, list) and kind < 4:
        # Fifty times fifty times a long array would take all memory here.
        return old * min(draw.choice([0, 2, 3, 50]), 1 + 10**6 // len(json.dumps(old))) if kind else old[:-1]
    if kind == 7:
        return long_array(draw, old)
    return draw.choice([None, True, False, [], {}, [[]], draw.choice(NUMBERS), draw.choice(TEXTS), [old], {"a": old}])


def mutated_value(draw, value):
    """One thing of a project is removed, doubled, renamed or replaced."""
    path = draw.choice(list(places_in(value))[1:])
    # The entries of a long array are one: what is changed is copied first, or all of them would grow at once.
    value = copy.copy(value)
    holder = value
    for key in path[:-1]:
        holder[key] = copy.copy(holder[key])
        holder = holder[key]
    key, kind = path[-1], draw.randrange(6)
    if kind == 0:
        del holder[key]
    elif kind == 1 and isinstance(holder, list):
        holder.insert(key, copy.deepcopy(holder[key]))
    elif kind == 1:
        holder[draw.choice(TEXTS)] = copy.deepcopy(holder[key])
    else:
        holder[key] = other_value(draw, holder[key])
    return value


def mutated_bytes(draw, data):
    """Bits flipped, bytes overwritten, a piece cut out or doubled, the end cut off."""
    data, kind = bytearray(data), draw.randrange(6)
    if not data:
        return b"\xff"
    at = draw.randrange(len(data))
    if kind == 0:
        return bytes(data[:at])
    if kind == 1:
        del data[at:at + draw.choice([1, 2, 8, 100])]
    elif kind == 2:
        data[at:at] = data[at:at + draw.choice([1, 8, 100])]
    elif kind == 3:
        size = draw.choice([1, 4, 8, 64, 1000])
        data[at:at + size] = draw.choice([b"\0", b"\xff", b"9", b"\n"]) * size
    else:
        for _ in range(draw.choice([1, 1, 3, 20])):
            data[draw.randrange(len(data))] ^= 1 << draw.randrange(8)
    return bytes(data)


# Before what HDF5 keeps of a file's parts; numbers that it believes stand behind it.
PARTS_OF_HDF5 = re.compile(rb"\x89HDF|TREE|SNOD|HEAP|GCOL|OHDR|OCHK|FRHP|FHDB|FHIB|FSHD|BTHD|BTLF|BTIN|FAHD|FADB|"
                           rb"EAHD|EAIB|EADB")


def mutated_words(draw, data):
    """Some aligned words of 4 or 8 bytes become a power of two, one less than it, or 0: wrong sizes and places."""
    data = bytearray(data)
    parts = [part.start() for part in PARTS_OF_HDF5.finditer(data)]
    for _ in range(draw.choice([1, 1, 1, 2, 4])):
        size = draw.choice([4, 8])
        begin, end = 0, len(data)
        if parts and draw.randrange(2):
            begin = draw.choice(parts)
            end = min(end, begin + 512)
        if end - begin < size:
            continue
        at = draw.randrange(begin, end - size + 1) // size * size
        power = 1 << draw.randrange(8 * size)
        data[at:at + size] = draw.choice([power, power - 1, 0]).to_bytes(size, "little")
    return bytes(data)


def without_comments(text):
    return re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', lambda found: found.group(1) or "", text, flags=re.S)


def coarser(value):
    """The same project with few tetrahedra: what is asked is how it is read, not how long meshing takes."""
    if isinstance(value, list):
        return [coarser(part) for part in value]
    if not isinstance(value, dict):
        return value
    return {key: 10 * part if key == "mesh_size" else coarser(part) for key, part in value.items()}


def mutated_project(draw, text):
    value = coarser(json.loads(without_comments(text)))
    if draw.randrange(3) == 0:
        return mutated_bytes(draw, json.dumps(value, indent=1, ensure_ascii=False).encode())
    for _ in range(draw.choice([1, 1, 1, 2, 3])):
        if isinstance(value, dict) and value:
            value = mutated_value(draw, value)
    return json.dumps(value, ensure_ascii=draw.random() < 0.5).encode("utf-8", "surrogatepass")


class Program:
    """talus-cli with its mesher, as users start it and served; `folder` is for what serving needs."""

    def __init__(self, cli, folder):
        self.cli, self.served = cli, None
        forks = cli.parents[1] / "tests/fuzz"
        library, mesher = forks / "fork_server.so", cli.parents[1] / "core/talus-mesher"
        if not library.exists() or not mesher.exists():
            return
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        meshers = folder / "meshers"
        self.mesher = Served(mesher, library, meshers, environment)
        environment.update(LD_BIND_NOW="1", TALUS_MESHER=str(forks / "fork_case"), TALUS_CASES_AT=str(meshers))
        self.served = Served(cli, library, folder / "programs", environment)
        self.errors = open(folder / "errors", "w+b")

    def processor_time(self):
        """Of all programs that were started and have ended, s."""
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        served = self.served.processor_time() + self.mesher.processor_time() if self.served else 0
        return used.ru_utime + used.ru_stime + served

    def run(self, arguments, served):
        """How it ended: exit code or "hang", what it said on standard error, seconds of the processor."""
        before = self.processor_time()
        if served:
            self.errors.seek(0)
            self.errors.truncate()
            code = self.served.run(arguments, self.errors, PATIENCE)
            self.errors.seek(0)
            said = self.errors.read()
        else:
            try:
                done = subprocess.run([self.cli, *arguments], capture_output=True, timeout=PATIENCE, check=False)
                code, said = done.returncode, done.stderr
            except subprocess.TimeoutExpired:
                code, said = None, b""
        took = self.processor_time() - before
        return "hang" if code is None or took > LONGEST else code, NOTES.sub(b"", said), took


def faults_of(code, said, took):
    """What is wrong with how a run ended."""
    if code in (0, 1):
        return []
    wrong = []
    if code != 2:
        wrong.append(f"ends with {code}")
    elif len(said) >= 500:
        wrong.append(f"says {len(said)} characters")
    if said.count(b"\n") > 1:
        wrong.append(f"says {said.count(bytes([10]))} lines")
    if took > SOON:
        wrong.append(f"takes {took:.1f} s")
    return wrong


class Watch:
    """Runs the program and counts how it ended."""

    def __init__(self, program, keep):
        self.program, self.keep, self.ends = program, keep, collections.Counter()
        self.failures, self.slowest, self.longest = 0, 0, 0

    def run(self, name, inputs, arguments, again=lambda: None):
        """`again` makes the inputs anew where a run changes them."""
        arguments = [*arguments, "-q"]
        code, said, took = self.program.run(arguments, self.program.served)
        wrong = faults_of(code, said, took)
        if self.program.served and wrong:
            as_served = (code, wrong)
            again()
            code, said, took = self.program.run(arguments, False)
            wrong = faults_of(code, said, took)
            if code != as_served[0]:
                wrong.append(f"served: {', '.join(as_served[1])}")
        self.slowest = max(self.slowest, took)
        self.ends["crash" if code != "hang" and code < 0 else code] += 1
        if code == 2:
            self.longest = max(self.longest, len(said.decode("utf-8", "replace")))
        if not wrong:
            return
        self.failures += 1
        print(f"{name} ({' '.join(arguments[:1])}): {', '.join(wrong)}: {said[:300].decode('utf-8', 'replace')!r}",
              flush=True)
        if self.keep:
            target = self.keep / name
            again()
            shutil.copytree(inputs, target, dirs_exist_ok=True) if inputs.is_dir() else shutil.copy(inputs, target)


def try_projects(watch, count, seed, folder):
    samples = sorted(ROOT.glob("samples/*/*.talus"))
    for number in range(count):
        draw = random.Random(f"{seed} {number}")
        sample = draw.choice(samples)
        file = folder / f"{number}.talus"
        file.write_bytes(mutated_project(draw, sample.read_text(encoding="utf-8")))
        watch.run(f"{number}-{sample.stem}.talus", file, ["info", str(file)])
        file.unlink()


def try_results(watch, count, seed, folder):
    whole = folder / "whole.results"
    sample = ROOT / "samples/wedge/wedge.talus"
    text = json.loads(without_comments(sample.read_text(encoding="utf-8")))
    for stage in text["stages"]:
        stage.pop("duration", None)
        stage["steps"] = 5
    text.pop("expect", None)
    small = folder / "small.talus"
    small.write_text(json.dumps(text), encoding="utf-8")
    subprocess.run([watch.program.cli, "solve", str(small), "--out", str(whole), "-q"], capture_output=True, check=False)
    damaged, picture, exported = folder / "damaged.results", folder / "p.png", folder / "exported"
    resume = ["solve", str(small), "--out", str(damaged), "--resume"]
    commands = [
        ["info", str(damaged)], ["info", str(damaged), "--json"],
        ["plot", str(damaged), "--out", str(picture), "--size", "160x100"],
        ["export", str(damaged), "--out", str(exported), "--as", "csv"],
        ["export", str(damaged), "--out", str(exported), "--as", "vtu"],
        ["render", str(damaged), "--out", str(picture), "--size", "64x64"],
        resume,
    ]
    for number in range(count):
        draw = random.Random(f"{seed} {number}")
        victim = draw.choice(RESULT_FILES + ["results.h5"] * 6 + ["checkpoint.h5"] * 2)
        data = (whole / victim).read_bytes()
        if victim.endswith(".h5"):
            data = draw.choice([mutated_bytes, mutated_words, mutated_words])(draw, data)
        else:
            data = mutated_file(draw, data)
        command = resume if victim == "checkpoint.h5" and draw.randrange(2) else draw.choice(commands)

        def damage(victim=victim, data=data):
            shutil.rmtree(damaged, ignore_errors=True)
            shutil.copytree(whole, damaged)
            (damaged / victim).write_bytes(data)

        damage()
        watch.run(f"{number}-{victim}", damaged, command, damage)
        shutil.rmtree(exported, ignore_errors=True)


def mutated_file(draw, data):
    """Of text, mostly a number or word is another one: what is damaged byte by byte is seldom read far."""
    words = list(re.finditer(rb"[-+0-9.eE]+|#[0-9]+|[A-Z_a-z]+", data)) if b"\0" not in data else []
    if not words or draw.randrange(3) == 0:
        return mutated_bytes(draw, data)
    word = draw.choice(words)
    other = draw.choice([str(draw.choice(NUMBERS)).encode(), draw.choice(words).group(), b"", word.group() * 2])
    return data[:word.start()] + other + data[word.end():]


def try_solids(watch, count, seed, folder):
    heights = "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 5\n" + "7 8 9 8\n" * 3
    (folder / "grid.asc").write_text(heights, encoding="ascii")
    corpus = ROOT / "tests/fuzz/corpus"
    originals = [folder / "grid.asc", *sorted(corpus.glob("terrain/*")), *sorted(corpus.glob("stl/*"))]
    breps = [ROOT / "tests/gui/box.brep", *sorted(corpus.glob("brep/*"))]
    originals += [ROOT / "samples/step_slope/slope.step"] * len(breps) + breps
    for number in range(count):
        draw = random.Random(f"{seed} {number}")
        original = draw.choice(originals)
        file = folder / f"damaged{original.suffix}"
        file.write_bytes(mutated_file(draw, original.read_bytes()))
        solid = {"name": "rock", "material": "rock", "mesh_size": 1000, "body": "rigid"}
        if original.suffix in (".asc", ".csv", ".xyz"):
            solid["terrain"] = {"file": file.name, "base": -100, "tolerance": draw.choice([0, 1])}
        else:
            solid["file"] = file.name
        project = folder / "project.talus"
        project.write_text(json.dumps({
            "talus": 1, "name": "damaged", "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.2}},
            "joints": {"J": {"friction_angle": 30}}, "default_joint": "J", "solids": [solid],
            "stages": [{"name": "s", "type": "dynamic", "time_step": 0.01, "steps": 1}]}), encoding="utf-8")
        watch.run(f"{number}-{original.name}", file, ["mesh", str(project)])
        file.unlink()


TRIES = {"projects": try_projects, "results": try_results, "solids": try_solids}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("cli")
    options.add_argument("what", choices=list(TRIES))
    options.add_argument("--count", type=int, default=1000)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--keep", type=pathlib.Path, help="a folder for the inputs of failures")
    chosen = options.parse_args()
    if chosen.keep:
        chosen.keep.mkdir(parents=True, exist_ok=True)
    in_memory = "/dev/shm" if os.path.isdir("/dev/shm") else None
    with tempfile.TemporaryDirectory(dir=in_memory) as folder:
        watch = Watch(Program(pathlib.Path(chosen.cli).resolve(), pathlib.Path(folder)), chosen.keep)
        TRIES[chosen.what](watch, chosen.count, chosen.seed, pathlib.Path(folder))
    print(f"{chosen.count} runs: " + ", ".join(f"{n} end with {code}" for code, n in watch.ends.most_common()))
    print(f"{watch.failures} failures; the slowest run took {watch.slowest:.1f} s of the processor, the longest message "
          f"has {watch.longest} characters")
    return min(watch.failures, 1)


if __name__ == "__main__":
    sys.exit(main())
