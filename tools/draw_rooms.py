#!/usr/bin/env python3
"""Draws which room of the source is built upon which, from its #include lines: docs/pictures/rooms.svg.

    tools/draw_rooms.py [OUT.svg]

Every folder of core/, ui/ and app/ with sources is a room. An arrow that follows from others is left out of the
picture, but stands as a comment in the file: tests/unit/architecture compares these comments with the tree. Python's
standard library only.
"""

import re
import sys
from collections import Counter, defaultdict
from functools import cache
from pathlib import Path
from random import Random

ROOT = Path(__file__).resolve().parent.parent
PARTS = ("core", "ui", "app")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)

LETTER, PAD, HEIGHT = 7.1, 10, 24  # px: of a letter, beside a label, of a box
GAP, THROUGH, LEVEL = 18, 14, 56   # px: between boxes, for an arrow that passes, from level to level
MARGIN, HEAD = 28, 7               # px: around the picture, an arrow's head
TRIES, SWEEPS = 40, 24             # orders to begin from; passes up and down over each


def read_tree():
    """The units of every room (a header with its source is one), and the includes from room to room, counted."""
    units, texts = defaultdict(set), {}
    for part in PARTS:
        for path in sorted((ROOT / part).rglob("*.[hc]pp")):
            room = path.parent.relative_to(ROOT).as_posix()
            units[room].add(path.stem)
            texts[path] = (room, path.read_text(encoding="utf-8"))

    def room_of(header):
        folder = header.rpartition("/")[0]
        return next((base + folder for base in ("core/", "ui/", "app/", "app/cli/") if base + folder in units), None)

    arrows = Counter()
    for room, text in texts.values():
        for header in INCLUDE.findall(text):
            lower = room_of(header)
            if lower and lower != room:
                arrows[room, lower] += 1
    return units, arrows


def without_implied(arrows):
    """The arrows that no longer way along others stands for."""
    lower = defaultdict(set)
    for a, b in arrows:
        lower[a].add(b)

    @cache
    def below(room):
        return frozenset().union(lower[room], *(below(b) for b in lower[room]))

    return sorted((a, b) for a, b in arrows if not any(b in below(c) for c in lower[a] if c != b))


def levels_of(rooms, arrows):
    """The height of each room: above all that it is built upon, and no farther from its users than need be."""
    lower, upper = defaultdict(list), defaultdict(list)
    for a, b in arrows:
        lower[a].append(b)
        upper[b].append(a)
    level = {}

    def height(room):
        if room not in level:
            level[room] = 1 + max((height(b) for b in lower[room]), default=-1)
        return level[room]

    for room in rooms:
        height(room)
    for _ in rooms:
        for room in sorted(rooms, key=lambda r: (-level[r], r)):
            if upper[room] and len(upper[room]) > len(lower[room]):
                level[room] = min(level[a] for a in upper[room]) - 1
    return level


class Layout:
    """Rooms and the places where long arrows pass, in rows from the ground up (Sugiyama, Tagawa & Toda 1981)."""

    def __init__(self, rooms, arrows, level):
        self.rows = [[] for _ in range(1 + max(level.values()))]
        self.up, self.down, self.chains = defaultdict(list), defaultdict(list), {}
        for room in rooms:
            self.rows[level[room]].append(room)
        for a, b in arrows:
            chain = [a, *((a, b, h) for h in range(level[a] - 1, level[b], -1)), b]
            for place in chain[1:-1]:
                self.rows[place[2]].append(place)
            for high, low in zip(chain, chain[1:]):
                self.down[high].append(low)
                self.up[low].append(high)
            self.chains[a, b] = chain

    def crossings(self):
        count = 0
        for low, high in zip(self.rows, self.rows[1:]):
            at = {place: i for i, place in enumerate(low)}
            ends = [at[b] for a in high for b in sorted(self.down[a], key=at.get)]
            count += sum(ends[i] > ends[j] for i in range(len(ends)) for j in range(i + 1, len(ends)))
        return count

    def bends(self):
        """How far arrows go sideways, in places of a row: the lesser of two orders with as many crossings."""
        at = {place: i - len(row) / 2 for row in self.rows for i, place in enumerate(row)}
        return sum(abs(at[a] - at[b]) for a in self.down for b in self.down[a])

    def order(self):
        """Each row by the mean place of its neighbours, up and down and from several beginnings; the best stays."""
        best, random = None, Random(1)
        for _ in range(TRIES):
            for row in self.rows:
                random.shuffle(row)
            for sweep in range(SWEEPS):
                rows, beside = (self.rows, self.down) if sweep % 2 == 0 else (self.rows[::-1], self.up)
                for before, row in zip(rows, rows[1:]):
                    at = {place: i for i, place in enumerate(before)}
                    own = {place: i for i, place in enumerate(row)}
                    row.sort(key=lambda p: sum(at[n] for n in beside[p]) / len(beside[p]) if beside[p] else own[p])
                self.swap()
                score = (self.crossings(), self.bends())
                if best is None or score < best[0]:
                    best = score, [list(row) for row in self.rows]
        self.rows = best[1]
        return best[0][0]

    def swap(self):
        """Neighbours change places where that leaves fewer crossings."""
        for h, row in enumerate(self.rows):
            beside = [(near, {p: i for i, p in enumerate(other)})
                      for near, other in ((self.down, self.rows[h - 1] if h else []),
                                          (self.up, self.rows[h + 1] if h + 1 < len(self.rows) else []))]
            for i in range(len(row) - 1):
                def count(a, b):
                    return sum(at[x] > at[y] for near, at in beside for x in near[a] for y in near[b])
                if count(row[i + 1], row[i]) < count(row[i], row[i + 1]):
                    row[i], row[i + 1] = row[i + 1], row[i]

    def place(self, width):
        """x of every place: near the mean of its neighbours, as far apart as boxes are wide."""
        x = {}
        for row in self.rows:
            at = 0
            for place in row:
                at += width(place) / 2
                x[place] = at
                at += width(place) / 2
        for sweep in range(600):
            for row in self.rows if sweep % 2 == 0 else self.rows[::-1]:
                wish, pull = [], []
                for p in row:
                    # Arrows that pass rows pull more, so that they are straight.
                    near = [(x[n], 10 if isinstance(p, tuple) and isinstance(n, tuple) else 1)
                            for n in self.up[p] + self.down[p]]
                    pull.append(sum(w for _, w in near) or 0.1)
                    wish.append(sum(v * w for v, w in near) / pull[-1] if near else x[p])
                for p, v in zip(row, spread(wish, pull, [width(p) for p in row])):
                    x[p] = v
        left = min(v - width(p) / 2 for p, v in x.items())
        return {p: v - left for p, v in x.items()}


def spread(wish, pull, widths):
    """The numbers nearest to those wished for, in the weighted mean square, half of both widths apart at least."""
    offset, total = [], 0
    for i, w in enumerate(widths):
        total += w / 2 + (widths[i - 1] / 2 if i else 0)
        offset.append(total)
    groups = []  # mean, weight, count: those that touch move as one
    for value, weight, o in zip(wish, pull, offset):
        groups.append([value - o, weight, 1])
        while len(groups) > 1 and groups[-2][0] > groups[-1][0]:
            value, weight, count = groups.pop()
            low = groups[-1]
            groups[-1] = [(low[0] * low[1] + value * weight) / (low[1] + weight), low[1] + weight, low[2] + count]
    flat = [value for value, _, count in groups for _ in range(count)]
    return [f + o for f, o in zip(flat, offset)]


STYLE = """
    .paper { fill: #ffffff } text { font: 12px 'DejaVu Sans', Verdana, sans-serif; text-anchor: middle; fill: #22303a }
    rect { stroke-width: 1 } .core rect { fill: #e8f0f6; stroke: #7d9db5 } .ui rect { fill: #eef5e8; stroke: #93ad7c }
    .app rect { fill: #f9f0e2; stroke: #c3a473 } .arrow { fill: none; stroke: #64798a } .head { fill: #64798a }
    .note { text-anchor: start; fill: #5b6b77 } .units { font-size: 9px; fill: #6d7f8c }
    @media (prefers-color-scheme: dark) {
      .paper { fill: #14191d } text { fill: #dde5ea } .note, .units { fill: #93a3ae }
      .core rect { fill: #1e303d; stroke: #527490 } .ui rect { fill: #25331e; stroke: #66834f }
      .app rect { fill: #382d1c; stroke: #8f7343 } .arrow { stroke: #8496a3 } .head { fill: #8496a3 }
    }
"""


def draw(units, arrows):
    drawn = without_implied(arrows)
    rooms = sorted(units)
    layout = Layout(rooms, drawn, levels_of(rooms, drawn))
    crossings = layout.order()

    def label(room):
        return "/".join(room.split("/")[1:][-2:])

    def width(place):
        return THROUGH if isinstance(place, tuple) else len(label(place)) * LETTER + 2 * PAD + 12 + GAP

    x = {p: v + MARGIN for p, v in layout.place(width).items()}
    row_of = {p: h for h, row in enumerate(layout.rows) for p in row}
    top = len(layout.rows) - 1

    def y(place):
        return MARGIN + 40 + (top - row_of[place]) * LEVEL + HEIGHT / 2

    right = max(x[p] + width(p) / 2 for p in x) + MARGIN
    bottom = MARGIN + 40 + top * LEVEL + HEIGHT + MARGIN
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {right:.0f} {bottom:.0f}" width="{right:.0f}"'
           f' height="{bottom:.0f}" role="img" aria-label="Which room of the source is built upon which">',
           "  <!-- Made by tools/draw_rooms.py. All arrows, those that others imply too, with their numbers of"
           " includes: -->"]
    out += [f"  <!-- {a} -> {b} {count} -->" for (a, b), count in sorted(arrows.items())]
    out += [f"  <style>{STYLE}  </style>", '  <rect class="paper" width="100%" height="100%"/>']
    out.append(f'  <text class="note" x="{MARGIN}" y="{MARGIN + 4}">An arrow: is built upon; the thicker, the more'
               " includes. What follows from other arrows is left out.</text>")
    out.append(f'  <text class="note" x="{MARGIN}" y="{MARGIN + 21}">Blue core/, green ui/, brown app/;'
               " small: units in the room.</text>")
    for (a, b), chain in layout.chains.items():
        path = f"M {x[a]:.1f} {y(a) + HEIGHT / 2:.1f}"
        for high, low in zip(chain, chain[1:]):
            y0, y1 = y(high) + HEIGHT / 2, y(low) - HEIGHT / 2 - (HEAD if low == b else 0)
            bend = (y1 - y0) * 0.55
            path += f" C {x[high]:.1f} {y0 + bend:.1f} {x[low]:.1f} {y1 - bend:.1f} {x[low]:.1f} {y1:.1f}"
            if low != b:
                path += f" V {y1 + HEIGHT:.1f}"
        thick = 1 + min(3, (arrows[a, b] / 4) ** 0.5 * 0.6)
        tip = y(b) - HEIGHT / 2
        out.append(f'  <path class="arrow" stroke-width="{thick:.1f}" d="{path}"/>')
        out.append(f'  <path class="head" d="M {x[b]:.1f} {tip:.1f} l -3.5 -{HEAD} h 7 z"/>')
    for room in rooms:
        box = width(room) - GAP
        out.append(f'  <g class="{room.partition("/")[0]}"><title>{room}</title>'
                   f'<rect x="{x[room] - box / 2:.1f}" y="{y(room) - HEIGHT / 2:.1f}"'
                   f' width="{box:.1f}" height="{HEIGHT}" rx="5"/><text x="{x[room] - 6:.1f}" y="{y(room) + 4:.1f}">'
                   f'{label(room)}</text><text class="units" x="{x[room] + box / 2 - 10:.1f}" y="{y(room) + 4:.1f}">'
                   f"{len(units[room])}</text></g>")
    out.append("</svg>")
    return "\n".join(out) + "\n", len(drawn), crossings


def main():
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "pictures" / "rooms.svg"
    units, arrows = read_tree()
    text, drawn, crossings = draw(units, arrows)
    out.write_text(text, encoding="utf-8")
    print(f"{out}: {len(units)} rooms, {len(arrows)} arrows, {drawn} drawn, {crossings} crossings")


if __name__ == "__main__":
    main()
