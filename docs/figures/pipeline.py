#!/usr/bin/env python3
"""Draws docs/figures/pipeline.svg, the picture of README. Needs nothing but Python; run it anywhere:

    python3 docs/figures/pipeline.py

The same bytes every time. The drawings are signs, not results: forces and cracks are made up.
"""

import math
import random
from pathlib import Path

# Colours that remain distinct for colour-blind readers [OkabeIto2008].
BLUE, ORANGE, RED, GREY, INK = "#0072b2", "#e69f00", "#d55e00", "#8a8f98", "#22262b"
DISC, DISC_EDGE, PANEL = "#e3e7ed", "#b4bcc8", "#f7f8fa"
WIDTH, HEIGHT, SIDE, GAP, TOP = 1174, 290, 172, 29, 8

parts = []


def line(points, colour=INK, width=1.6, fill="none"):
    where = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    parts.append(f'<polyline points="{where}" fill="{fill}" stroke="{colour}" stroke-width="{width}"'
                 ' stroke-linejoin="round" stroke-linecap="round"/>')


def circle(x, y, radius, fill=DISC, edge=DISC_EDGE):
    parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}" stroke="{edge}"/>')


def rectangle(x, y, width, height, fill, edge="none", corner=0):
    parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" rx="{corner}" fill="{fill}"'
                 f' stroke="{edge}"/>')


def text(x, y, words, size=14, colour=INK, weight="normal"):
    parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}" font-weight="{weight}"'
                 f' text-anchor="middle">{words}</text>')


def rock(x, y, columns, rows, radius, without=lambda u, v: False):
    draw = random.Random(1)
    for row in range(rows):
        for column in range(columns):
            u = x + (2 * column + row % 2) * radius
            v = y + row * radius * math.sqrt(3)
            size = radius * draw.uniform(0.82, 1.0)
            if not without(u, v):
                circle(u, v, size)


def core(x, y):
    rock(x - 24, y - 46, 4, 8, 8)
    for end in (-1, 1):
        rectangle(x - 40, y + end * 60 - 5, 72, 10, GREY)
        line([(x - 4, y + end * 92), (x - 4, y + end * 70)], BLUE, 3)
        line([(x - 10, y + end * 78), (x - 4, y + end * 69), (x + 2, y + end * 78)], BLUE, 3)
    line([(x - 14, y - 36), (x - 9, y - 14), (x - 15, y + 8), (x - 8, y + 34)], RED, 2.5)
    line([(x + 12, y - 20), (x + 7, y + 4), (x + 13, y + 28)], RED, 2.5)


def cut(x, y):
    rock(x - 66, y - 8, 9, 6, 8, lambda u, v: u < x + 2 and v < y + 14)
    line([(x + 4, y + 16), (x - 14, y - 58), (x - 40, y - 52), (x - 22, y + 16), (x + 4, y + 16)], INK, 1.6, "#c9ced6")
    for u, v in ((20, -30), (36, -42), (10, -44), (48, -24)):
        circle(x + u, y + v, 7)
    line([(x + 8, y + 12), (x + 26, y + 2), (x + 44, y - 14)], RED, 2.5)
    line([(x - 66, y - 30), (x - 42, y - 30)], BLUE, 3)
    line([(x - 50, y - 36), (x - 41, y - 30), (x - 50, y - 24)], BLUE, 3)


def peaks(x, y):
    draw = random.Random(5)
    points, at = [(x - 70, y + 56)], x - 70
    tops = []
    while at < x + 52:
        height, length = draw.choice((24, 34, 52, 60, 78, 96)), draw.uniform(9, 15)
        tops.append((at + length, y + 56 - height))
        points += [tops[-1], (at + length + 3, y + 56 - 0.15 * height)]
        at += length + 3
    line(points, BLUE, 1.8)
    line([(x - 70, y + 58), (x + 70, y + 58)], INK, 1.2)
    for u, v in tops:
        circle(u, v, 3.6, ORANGE, INK)


def networks(x, y):
    columns = [[(x - 62 + 41 * k, y + 4 + 22 * (i - (n - 1) / 2)) for i in range(n)]
               for k, n in enumerate((3, 4, 6, 1))]
    for left, right in zip(columns, columns[1:]):
        for a in left:
            for b in right:
                line([a, b], DISC_EDGE, 0.9)
    for k, column in enumerate(columns):
        for u, v in column:
            circle(u, v, 7, (ORANGE, "#ffffff", "#ffffff", BLUE)[k], INK)


def bit(x, y):
    line([(x - 16, y - 62), (x - 16, y - 30), (x - 52, y - 8), (x - 50, y + 26), (x - 26, y + 44), (x, y + 34),
          (x + 26, y + 44), (x + 50, y + 26), (x + 52, y - 8), (x + 16, y - 30), (x + 16, y - 62)], INK, 1.8, "#c9ced6")
    for u, v in ((-48, 26), (-36, 38), (-22, 42), (-8, 38), (8, 38), (22, 42), (36, 38), (48, 26)):
        circle(x + u, y + v, 6.5, INK, INK)
    for u in (-30, 0, 30):
        line([(x + u, y + 76), (x + u, y + 56)], BLUE, 3)
        line([(x + u - 6, y + 64), (x + u, y + 55), (x + u + 6, y + 64)], BLUE, 3)
    line([(x + 30 * math.cos(a), y - 46 + 9 * math.sin(a)) for a in [0.1 * i - 0.6 for i in range(42)]], RED, 2.5)
    line([(x - 31, y - 56), (x - 26, y - 44), (x - 15, y - 51)], RED, 2.5)


def string(x, y):
    rectangle(x - 22, y - 74, 44, 14, GREY, INK, 3)
    for k, (top, bottom) in enumerate(((-60, -34), (-12, 12))):
        coil = [(x, y + top)] + [(x + (9 if i % 2 else -9), y + top + (bottom - top) * (i + 1) / 8) for i in range(7)]
        line(coil + [(x, y + bottom)], INK, 1.8)
        rectangle(x - 15, y + bottom, 30, 22, DISC, INK, 3)
    line([(x, y + 34), (x, y + 46)], INK, 1.8)
    line([(x - 18, y + 46), (x + 18, y + 46), (x + 14, y + 62), (x - 14, y + 62), (x - 18, y + 46)], INK, 1.8, "#c9ced6")
    rectangle(x - 70, y + 62, 140, 16, DISC)
    speed = [(x + 26 + 0.5 * i, y - 8 - 16 * max(-0.9, math.sin(0.23 * i))) for i in range(90)]
    line(speed, BLUE, 1.8)


STEPS = ((core, "1 Rock", "strength tests give", "a synthetic rock"), (cut, "2 Cuts", "one cutter, many speeds,", "depths and rakes"),
         (peaks, "3 Peaks", "each force history", "becomes five numbers"),
         (networks, "4 Networks", "learn the numbers", "over the conditions"),
         (bit, "5 Bit", "the force and torque", "on all its cutters"),
         (string, "6 Drill string", "stick-slip, bounce, or", "your own program"))

for place, (draw, name, first, second) in enumerate(STEPS):
    left = 6 + place * (SIDE + GAP - 4)
    middle = left + SIDE / 2
    rectangle(left, TOP, SIDE, HEIGHT - TOP - 10, PANEL, DISC_EDGE, 8)
    draw(middle, TOP + 106)
    text(middle, HEIGHT - 54, name, 17, INK, "bold")
    text(middle, HEIGHT - 36, first, 13)
    text(middle, HEIGHT - 20, second, 13)
    if place + 1 < len(STEPS):
        start, middle_height = left + SIDE + 3, TOP + 106
        line([(start, middle_height), (start + GAP - 10, middle_height)], INK, 2.5)
        line([(start + GAP - 17, middle_height - 7), (start + GAP - 9, middle_height), (start + GAP - 17, middle_height + 7)],
             INK, 2.5)

Path(__file__).with_name("pipeline.svg").write_text(
    f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}"'
    ' font-family="Helvetica, Arial, sans-serif">\n<title>From laboratory numbers of a rock to a drill string: rock, cuts,'
    f' peaks, networks, bit, drill string</title>\n<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>\n'
    + "\n".join(parts) + "\n</svg>\n", encoding="utf-8")
