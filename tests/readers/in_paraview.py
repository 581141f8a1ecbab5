"""Opens results.xdmf as ParaView does, by its default reader and by each of the others, and holds times, moving points
and fields of every frame to those of the VTU files that are exported. Run by ParaView's own Python:

    pvpython tests/readers/in_paraview.py TALUS_CLI PROJECT
"""
import os
import subprocess
import sys
import tempfile

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

FIELDS = {"points": ("displacement", "velocity"), "cells": ("stress", "block")}


def grid_of(reader, time):
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    while data.IsA("vtkMultiBlockDataSet"):
        assert data.GetNumberOfBlocks() == 1, data.GetNumberOfBlocks()
        data = data.GetBlock(0)
    return data


def content(reader, time):
    """Of one frame, by name."""
    grid = grid_of(reader, time)
    found = {"points": vtk_to_numpy(grid.GetPoints().GetData()).astype(float)}
    for name in FIELDS["points"]:
        found[name] = vtk_to_numpy(grid.GetPointData().GetArray(name)).astype(float)
    for name in FIELDS["cells"]:
        found[name] = vtk_to_numpy(grid.GetCellData().GetArray(name)).astype(float)
    return found


def times_of(reader):
    reader.UpdatePipelineInformation()
    return [float(time) for time in reader.TimestepValues]


folder = tempfile.TemporaryDirectory()
results, grids = (os.path.join(folder.name, name) for name in ("slide.results", "vtu"))
cli, project = sys.argv[1:3]
subprocess.run([cli, "solve", project, "--out", results, "-q"], check=True, stdout=subprocess.DEVNULL)
subprocess.run([cli, "export", results, "--as", "vtu", "--out", grids], check=True, stdout=subprocess.DEVNULL)
exported = simple.OpenDataFile(os.path.join(grids, "frames.pvd"))
times = times_of(exported)
assert len(times) > 2, times
expected = [content(exported, time) for time in times]
assert numpy.abs(expected[-1]["points"] - expected[0]["points"]).max() > 0.01, "nothing moves"

index = os.path.join(results, "results.xdmf")
readers = {"default": lambda: simple.OpenDataFile(index)}
for name, files in (("XDMFReader", "FileNames"), ("Xdmf3ReaderS", "FileName"), ("Xdmf3ReaderT", "FileName")):
    if hasattr(simple, name):
        readers[name] = lambda make=getattr(simple, name), files=files: make(**{files: [index]})
wrong = 0
for name, make in readers.items():
    reader = make()
    try:
        found = times_of(reader)
        assert numpy.allclose(found, times, atol=1e-9), (found, times)
        for time, frame in zip(times, expected):
            for what, values in content(reader, time).items():
                scale = max(1e-12, numpy.abs(frame[what]).max())
                assert values.shape == frame[what].shape, (what, values.shape)
                assert numpy.abs(values - frame[what]).max() <= 1e-6 * scale, "%s at %g s" % (what, time)
        print("%s (%s): %d frames" % (name, reader.GetXMLName(), len(found)))
    except Exception as error:  # whatever a reader stumbles over
        wrong += 1
        print("%s: %s: %s" % (name, type(error).__name__, error))
sys.exit(1 if wrong else 0)
