#!/usr/bin/python3
"""Reads what a window handed over, by programs and rules that know nothing of Talus: Python's own readers of XML, CSV and
JSON, the formats' own rules where there is none, and ffprobe, pdftotext, xmllint and assimp where they are installed.

    tests/readers/read_back.py FOLDER     of tests/gui/handing_over_test.cpp; ends with 1 and says what is wrong
"""
import csv
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree as xml
from html.parser import HTMLParser

FRAMES, BLOCKS, SECONDS = 11, 2, 0.2
SLID = 0.5 * (4.905 - 8.496 * math.tan(math.pi / 18)) * SECONDS ** 2  # m: g (sin 30° − tan 10° cos 30°) t² / 2
RATE, WIDTH = 25, 1280  # of a film that nobody has asked otherwise of
folder = sys.argv[1]


def place(name):
    return os.path.join(folder, name)


def content(name):
    with open(place(name), "rb") as file:
        return file.read()


def said_by(*command):
    """What a program prints; None where it is not installed."""
    if shutil.which(command[0]) is None:
        return None
    return subprocess.run(command, check=True, capture_output=True, text=True, errors="replace").stdout


def picture():
    data = content("picture.png")
    assert data[:8] == b"\x89PNG\r\n\x1a\n" and data[12:16] == b"IHDR"
    width, height = struct.unpack(">II", data[16:24])
    assert width == 1920 and height > 500, (width, height)


def filmed(name, codec, pictures):
    """What ffprobe finds in a film, where it is installed: as many pictures, of one size, each for its time."""
    told = said_by("ffprobe", "-v", "error", "-count_frames", "-of", "json", "-show_streams", "-show_format", place(name))
    if told is None:
        return
    stream = json.loads(told)["streams"][0]
    assert stream["codec_name"] == codec and int(stream["nb_read_frames"]) == pictures, stream
    assert stream["width"] == WIDTH and stream["height"] % 2 == 0 and 300 < stream["height"] < WIDTH, stream
    assert stream["r_frame_rate"] == "%d/1" % RATE, stream["r_frame_rate"]
    duration = float(json.loads(told)["format"]["duration"])
    assert abs(duration - pictures / RATE) < 1e-3 and 0 <= duration - SECONDS < 2 / RATE, duration


def film():
    """An MP4 with its index in front, which names a picture for each moment of the film; by ffprobe, where it is."""
    data, at, boxes = content("film.mp4"), 0, []
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        boxes.append(kind)
        at += size
    assert at == len(data) and {b"ftyp", b"moov", b"mdat"} <= set(boxes), boxes
    where = data.index(b"stsz")
    pictures = struct.unpack(">I", data[where + 12:where + 16])[0]
    assert pictures >= 3, pictures
    filmed("film.mp4", "h264", pictures)


def animation():
    """The blocks of a GIF, to its end."""
    data = content("film.gif")
    assert data[:6] == b"GIF89a"
    at = 13 + (3 << ((data[10] & 7) + 1) if data[10] & 128 else 0)
    pictures = 0

    def skip(at):
        while data[at]:
            at += data[at] + 1
        return at + 1

    while data[at] != 0x3B:
        if data[at] == 0x21:
            at = skip(at + 2)
        else:
            assert data[at] == 0x2C
            pictures += 1
            local = data[at + 9]
            at = skip(at + 11 + (3 << ((local & 7) + 1) if local & 128 else 0))
    assert pictures >= 3 and at == len(data) - 1, pictures
    filmed("film.gif", "gif", pictures)


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.headings, self.svgs = [], 0, 0

    def handle_starttag(self, tag, attributes):
        self.svgs += tag == "svg"
        self.headings += tag in ("h1", "h2")
        if tag not in ("meta", "br", "img", "link", "hr"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):  # "<path …/>"
        self.svgs += tag == "svg"

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, tag


def report():
    page = Page()
    page.feed(content("report.html").decode())
    assert not page.open and page.headings > 5, (page.open, page.headings)
    pdf = content("report.pdf")
    assert pdf.startswith(b"%PDF-") and pdf.rstrip().endswith(b"%%EOF")
    text = said_by("pdftotext", "-layout", place("report.pdf"), "-")
    if text is not None:
        for words in ("Sliding cube", "Energy", "cube"):
            assert words in text, words


def tables():
    found = {}
    for name in sorted(os.listdir(place("tables"))):
        if name.endswith(".csv"):
            with open(place("tables/" + name), newline="") as file:
                rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
            assert len({len(row) for row in rows}) == 1, name + ": rows of several lengths"
            found[name] = rows
    assert len(found["blocks.csv"]) == 1 + BLOCKS, found["blocks.csv"][:1]


def grids():
    index = xml.parse(place("vtu/frames.pvd")).getroot()
    entries = index.findall("Collection/DataSet")
    times = [float(entry.get("timestep")) for entry in entries]
    assert len(times) == FRAMES and times == sorted(times), times
    for entry in entries:
        name = "vtu/" + entry.get("file")
        said_by("xmllint", "--noout", "--huge", place(name))
        piece = xml.parse(place(name)).getroot().find("UnstructuredGrid/Piece")
        assert int(piece.get("NumberOfCells")) > 50
        names = {array.get("Name") for array in piece.iter("DataArray")}
        assert {"displacement", "velocity", "stress", "block"} <= names, names


def deposit():
    data = content("deposit.stl")
    triangles = struct.unpack("<I", data[80:84])[0]
    assert len(data) == 84 + 50 * triangles > 84
    corners = [struct.unpack("<9f", data[84 + 50 * i + 12:84 + 50 * i + 48]) for i in range(triangles)]
    edges = {}
    for corner in corners:
        points = [corner[k:k + 3] for k in (0, 3, 6)]
        for a, b in zip(points, points[1:] + points[:1]):
            edges[a, b] = edges.get((a, b), 0) + 1
    assert all(edges.get((b, a)) == count for (a, b), count in edges.items()), "the surface is not closed"


KHRONOS = """
const check = require('gltf-validator');
check.validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1]))).then(
    (told) => console.log(JSON.stringify(told.issues)));
"""


def judged_by_khronos(name):
    """What the validator of those who write glTF's specification finds, where npm's gltf-validator is installed."""
    if node_has("gltf-validator"):
        issues = json.loads(said_by("node", "-e", KHRONOS, place(name)))
        assert issues["numErrors"] + issues["numWarnings"] + issues["numInfos"] + issues["numHints"] == 0, issues


def node_has(module):
    try:
        return said_by("node", "-e", "require.resolve('%s')" % module) is not None
    except subprocess.CalledProcessError:
        return False


def numbers_of(tree, binary, index):
    """The numbers of an accessor, a tuple an element."""
    accessor = tree["accessors"][index]
    view = tree["bufferViews"][accessor["bufferView"]]
    letter, width = LETTERS[accessor["componentType"]], PARTS[accessor["type"]]
    at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    stride = view.get("byteStride", width * SIZES[accessor["componentType"]])
    return [struct.unpack_from("<%d%s" % (width, letter), binary, at + i * stride) for i in range(accessor["count"])]


LETTERS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def scene():
    """A .glb by the rules of glTF 2.0: chunks, and that all that is pointed to is there and large enough."""
    data = content("slide.glb")
    magic, version, length = struct.unpack("<4sII", data[:12])
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack("<I4s", data[12:20])
    assert kind == b"JSON" and size % 4 == 0
    tree = json.loads(data[20:20 + size])
    binary_size, binary_kind = struct.unpack("<I4s", data[20 + size:28 + size])
    assert binary_kind == b"BIN\0" and 28 + size + binary_size == len(data)
    assert tree["asset"]["version"] == "2.0" and tree["buffers"][0]["byteLength"] <= binary_size
    binary = data[28 + size:]
    for view in tree["bufferViews"]:
        assert view.get("byteOffset", 0) + view["byteLength"] <= tree["buffers"][0]["byteLength"]
    for accessor in tree["accessors"]:
        width = SIZES[accessor["componentType"]] * PARTS[accessor["type"]]
        view = tree["bufferViews"][accessor["bufferView"]]
        stride = view.get("byteStride", width)
        offset = accessor.get("byteOffset", 0)
        assert offset + stride * (accessor["count"] - 1) + width <= view["byteLength"], accessor
        assert (view.get("byteOffset", 0) + offset) % SIZES[accessor["componentType"]] == 0, "not aligned"
    for mesh in tree["meshes"]:
        for primitive in mesh["primitives"]:
            accessor = tree["accessors"][primitive["attributes"]["POSITION"]]
            points = numbers_of(tree, binary, primitive["attributes"]["POSITION"])
            assert accessor["min"] == [min(point[k] for point in points) for k in range(3)], "bounds are those of points"
            assert accessor["max"] == [max(point[k] for point in points) for k in range(3)], "bounds are those of points"
            corners = numbers_of(tree, binary, primitive["indices"])
            assert len(corners) % 3 == 0 and max(corners)[0] < len(points), "corners are points"
            assert primitive["material"] < len(tree["materials"])
    for node in tree["nodes"]:
        assert node.get("mesh", 0) < len(tree["meshes"])
        assert all(child < len(tree["nodes"]) for child in node.get("children", []))
    moments = set()
    for animation in tree["animations"]:
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            assert channel["target"]["node"] < len(tree["nodes"])
            inputs = tree["accessors"][sampler["input"]]
            assert len(inputs["min"]) == len(inputs["max"]) == 1, "times have their limits"
            view = tree["bufferViews"][inputs["bufferView"]]
            at = view.get("byteOffset", 0) + inputs.get("byteOffset", 0)
            times = struct.unpack("<%df" % inputs["count"], binary[at:at + 4 * inputs["count"]])
            assert all(a < b for a, b in zip(times, times[1:])), "times grow"
            moments.add(len(times))
            values = numbers_of(tree, binary, sampler["output"])
            assert len(values) == len(times), "a value a moment"
            if channel["target"]["path"] == "rotation":
                assert all(abs(math.hypot(*value) - 1) < 1e-5 for value in values), "rotations have unit length"
    assert moments and max(moments) <= FRAMES, moments
    judged_by_khronos("slide.glb")
    dumped = place("slide.assxml")
    if said_by("assimp", "dump", place("slide.glb"), dumped) is not None:
        moved(xml.parse(dumped).getroot().find("Scene"))


def moved(read):
    """The same as assimp reads it: a mesh a block, and the cube as far along the slope as it slides in that time."""
    assert len(read.findall("MeshList/Mesh")) == BLOCKS
    names = [node.get("name") for node in read.iter("Node")]
    assert names[1:] == ["base", "cube"], names
    animation, = read.findall("AnimationList/Animation")
    assert abs(float(animation.get("duration")) / float(animation.get("tick_cnt")) - SECONDS) < 1e-6, animation.attrib
    channel, = animation.findall("NodeAnimList/NodeAnim")
    assert channel.get("node") == "cube", channel.attrib
    way = [[float(part) for part in key.text.split()] for key in channel.iter("PositionKey")]
    slid = math.dist(way[0], way[-1])
    assert abs(slid - SLID) < 0.02 * SLID, (slid, SLID)


WITHOUT = [name for name in ("ffprobe", "pdftotext", "xmllint", "assimp") if shutil.which(name) is None]
WITHOUT += [] if node_has("gltf-validator") else ["gltf-validator of npm"]
wrong = 0
for check in (picture, film, animation, report, tables, grids, deposit, scene):
    try:
        check()
    except Exception as error:  # whatever a reader stumbles over
        wrong += 1
        print("%s: %s: %s" % (check.__name__, type(error).__name__, error))
print("read back%s" % (", without " + ", ".join(WITHOUT) if WITHOUT else ""))
sys.exit(1 if wrong else 0)
