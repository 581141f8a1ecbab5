#!/usr/bin/python3
"""Reads results.vtkhdf as the specification of VTKHDF 2 says a reader does (docs.vtk.org, "VTKHDF format
specification", temporal data): all of a step is found through /VTKHDF/Steps. Holds what it finds to the same frames as
VTU.

    tests/readers/vtkhdf.py TALUS_CLI PROJECT      ends with 77 where there is no h5py
"""
import base64
import os
import re
import struct
import subprocess
import sys
import tempfile

try:
    import h5py
    import numpy
except ImportError:
    sys.exit(77)


def scalar(dataset, step):
    """An entry of a table of Steps, of one topology."""
    assert dataset.shape[0] == steps_of(dataset), dataset.name
    return int(numpy.ravel(dataset[step])[0])


def steps_of(thing):
    return int(thing.file["/VTKHDF/Steps"].attrs["NSteps"])


def frame(grid, step):
    """Points, cells and data of a step."""
    steps = grid["Steps"]
    part, parts = scalar(steps["PartOffsets"], step), scalar(steps["NumberOfParts"], step)
    assert parts == 1
    points, cells = int(grid["NumberOfPoints"][part]), int(grid["NumberOfCells"][part])
    ids = int(grid["NumberOfConnectivityIds"][part])
    point, cell = scalar(steps["PointOffsets"], step), scalar(steps["CellOffsets"], step)
    first_id = scalar(steps["ConnectivityIdOffsets"], step)
    found = {
        "Points": grid["Points"][point:point + points],
        "connectivity": grid["Connectivity"][first_id:first_id + ids],
        "types": grid["Types"][cell:cell + cells],
        # of each part there is one offset more than cells
        "offsets": grid["Offsets"][cell + part:cell + part + cells + 1],
    }
    for place, count in (("Point", points), ("Cell", cells)):
        for name in grid[place + "Data"]:
            offset = scalar(steps[place + "DataOffsets"][name], step)
            found[name] = grid[place + "Data"][name][offset:offset + count]
            assert len(found[name]) == count, name
    return found


TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "Int32": "i4", "UInt8": "u1"}


def vtu(path):
    """Arrays of a VTU file with appended data in base64, each behind the number of its bytes."""
    text, arrays = open(path).read(), {}
    appended = text[text.index('encoding="base64">') :].split("_", 1)[1]
    for tag in re.findall(r"<DataArray([^>]*)/>", text):
        about = dict(re.findall(r'(\w+)="([^"]*)"', tag))
        at, parts = int(about["offset"]), int(about["NumberOfComponents"])
        size = struct.unpack("<Q", base64.b64decode(appended[at:at + 12])[:8])[0]
        raw = base64.b64decode(appended[at:at + 4 * ((8 + size + 2) // 3)])[8:8 + size]
        values = numpy.frombuffer(raw, TYPES[about["type"]])
        arrays[about["Name"]] = values.reshape(-1, parts) if parts > 1 else values
    return arrays


def main(cli, project):
    with tempfile.TemporaryDirectory() as folder:
        results, export = os.path.join(folder, "r.results"), os.path.join(folder, "vtu")
        subprocess.run([cli, "solve", project, "--out", results], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        subprocess.run([cli, "export", results, "--out", export, "--as", "vtu"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        times = [float(t) for t in re.findall(r'timestep="([^"]*)"', open(os.path.join(export, "frames.pvd")).read())]
        with h5py.File(os.path.join(results, "results.vtkhdf"), "r") as file:
            grid = file["VTKHDF"]
            assert list(grid.attrs["Version"]) == [2, 0], list(grid.attrs["Version"])
            assert grid.attrs["Type"] in (b"UnstructuredGrid", "UnstructuredGrid")
            assert steps_of(grid) == len(times) > 2
            assert numpy.allclose(grid["Steps/Values"][:len(times)], times, rtol=1e-12)
            first = frame(grid, 0)
            for step in range(len(times)):
                found, written = frame(grid, step), vtu(os.path.join(export, "frame_%05d.vtu" % step))
                assert numpy.array_equal(found["offsets"][1:], written["offsets"]), "offsets"
                for name in ("connectivity", "types", "displacement", "velocity", "block", "material"):
                    assert numpy.array_equal(found[name], written[name]), (step, name)
                assert numpy.array_equal(found["Points"], written["points"]), step
                assert numpy.array_equal(found["stress"], written["stress"]), (step, "stress")
            assert not numpy.allclose(found["Points"], first["Points"]), "the points move"
            print(len(times), "steps,", len(found["Points"]), "points,", len(found["types"]), "cells as in the VTU files")


main(*sys.argv[1:3])
