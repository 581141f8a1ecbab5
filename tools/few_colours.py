#!/usr/bin/env python3
"""Rewrites pictures (PNG, 8 bits a channel, RGB or RGBA) with at most 256 colours: a third of the size, for the docs.

    tools/few_colours.py PICTURE...

Flat colours stay as they are; shades of a gradient that hardly differ become one.
"""
import struct
import sys
import zlib

def read(path):
    """Width, height, and the pixels as a list of (red, green, blue)."""
    data = open(path, "rb").read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path + " is no PNG"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    assert depth == 8 and colour in (2, 6), path + " is not RGB"
    step = 3 if colour == 2 else 4
    raw, stride, pixels = zlib.decompress(packed), width * step, []
    before = bytearray(stride)
    for row in range(height):
        start = row * (stride + 1)
        line = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], line, before, step)
        pixels.extend(zip(line[0::step], line[1::step], line[2::step]))
        before = line
    return width, height, pixels


def unfilter(kind, line, before, step):
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        if kind == 1:
            line[i] = (line[i] + left) & 255
        elif kind == 2:
            line[i] = (line[i] + before[i]) & 255
        elif kind == 3:
            line[i] = (line[i] + (left + before[i]) // 2) & 255
        elif kind == 4:
            corner = before[i - step] if i >= step else 0
            guess = left + before[i] - corner
            errors = abs(guess - left), abs(guess - before[i]), abs(guess - corner)
            line[i] = (line[i] + (left, before[i], corner)[errors.index(min(errors))]) & 255


def palette_of(pixels):
    """256 colours, by halving what is widest; and which of them each colour becomes."""
    counts = {}
    for pixel in pixels:
        counts[pixel] = counts.get(pixel, 0) + 1
    parts = [list(counts)]
    while len(parts) < 256:
        widths = [max(width(part, channel) for channel in range(3)) for part in parts]
        urgency = [w * sum(counts[c] for c in part) ** 0.25 for w, part in zip(widths, parts)]
        most = urgency.index(max(urgency))
        if widths[most] == 0:
            break
        part = parts.pop(most)
        channel = max(range(3), key=lambda k: width(part, k))
        low, high = min(c[channel] for c in part), max(c[channel] for c in part)
        parts.append([c for c in part if c[channel] <= (low + high) // 2])
        parts.append([c for c in part if c[channel] > (low + high) // 2])
    palette = [speaker(part, counts) for part in parts]
    return palette, {colour: place for place, part in enumerate(parts) for colour in part}


def speaker(part, counts):
    """The colour that a part is shown in: the one that most of it has, else the mean."""
    first, total = max(part, key=counts.get), sum(counts[c] for c in part)
    if 2 * counts[first] > total:
        return first
    return tuple(round(sum(c[k] * counts[c] for c in part) / total) for k in range(3))


def width(part, channel):
    values = [colour[channel] for colour in part]
    return max(values) - min(values)


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def write(path, width, height, pixels):
    palette, place = palette_of(pixels)
    rows = b"".join(b"\0" + bytes(place[p] for p in pixels[row * width:(row + 1) * width]) for row in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", bytes(sum(palette, ()))) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


for picture in sys.argv[1:]:
    write(picture, *read(picture))
