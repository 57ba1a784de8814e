#!/usr/bin/python3
"""Draws docs/figures/mud_faces.svg: where mud presses on rock (docs/theory/mud.md).

The faces are walked here as the page says, by angles, apart from the program: what is drawn is the law, not its code.
"""
import math
import pathlib

R = 20.0  # radius of a disc [px]
SEAL = 0.05 * R
WIDTH, HEIGHT = 980, 400


def lattice():
    """A bed of rows, with a closed crack, an open crack and a chip that has come off."""
    discs = []
    for row in range(5):
        for column in range(20):
            x, y = 70.0 + 2 * R * column + R * (row % 2), 60.0 + math.sqrt(3) * R * row
            if row >= 3 and x > 640.0 and not (row == 3 and x < 700.0):
                continue  # cut away
            if x > 360.0:
                x += 1.6 * R  # an open crack
            discs.append((x, y))
    for dx, dy in ((0, 0), (2, 0), (4, 0), (1, math.sqrt(3)), (3, math.sqrt(3))):
        discs.append((745.0 + R * dx, 235.0 + R * dy))
    return discs


def neighbours(discs):
    found = {k: [] for k in range(len(discs))}
    for a, (xa, ya) in enumerate(discs):
        for b, (xb, yb) in enumerate(discs):
            if a != b and math.hypot(xb - xa, yb - ya) < 2 * R + SEAL:
                found[a].append(b)
    return found


def turn(discs, at, back, to):
    """Angle counter-clockwise from the way back to the way on; a whole turn for the way back itself."""
    angle = math.atan2(discs[to][1] - discs[at][1], discs[to][0] - discs[at][0]) - back
    angle %= 2 * math.pi
    return angle if angle > 1e-9 else 2 * math.pi


def walk(discs, near, start):
    path, at, back = [start], start, math.pi
    while True:
        on = min(near[at], key=lambda to: turn(discs, at, back, to))
        if len(path) > 2 and at == start and on == path[1]:
            return path[:-1]
        back = math.atan2(discs[at][1] - discs[on][1], discs[at][0] - discs[on][0])
        path.append(on)
        at = on


def pieces(near):
    left, found = set(near), []
    while left:
        todo, piece = [min(left)], set()
        while todo:
            k = todo.pop()
            if k in piece:
                continue
            piece.add(k)
            todo.extend(near[k])
        left -= piece
        found.append(piece)
    return found


def main():
    discs = lattice()
    near = neighbours(discs)
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="Helvetica, Arial, sans-serif" font-size="15">',
           '<title>Mud presses on the outer faces of connected pieces of rock</title>',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#dbe9f4"/>']
    flip = lambda y: HEIGHT - 30 - y
    for x, y in discs:
        svg.append(f'<circle cx="{x:.1f}" cy="{flip(y):.1f}" r="{R}" fill="#efe0c6" stroke="#b59b72"/>')
    arrows = []
    for piece in pieces(near):
        if len(piece) < 3:
            continue
        path = walk(discs, near, min(piece, key=lambda k: (discs[k][1], discs[k][0])))
        corners = " ".join(f"{discs[k][0]:.1f},{flip(discs[k][1]):.1f}" for k in path)
        svg.append(f'<polygon points="{corners}" fill="none" stroke="#0072b2" stroke-width="2.5"/>')
        for k, at in enumerate(path):
            before, after = discs[path[k - 1]], discs[path[(k + 1) % len(path)]]
            fx, fy = -(after[1] - before[1]) / 2, (after[0] - before[0]) / 2  # p/2 perp(after - before), p = 1
            size = math.hypot(fx, fy)
            if size < 1.0:
                continue
            x, y = discs[at]
            arrows.append((x - fx, y - fy, x - 0.1 * fx, y - 0.1 * fy))
    for x1, y1, x2, y2 in arrows:
        angle = math.atan2(y2 - y1, x2 - x1)
        svg.append(f'<line x1="{x1:.1f}" y1="{flip(y1):.1f}" x2="{x2:.1f}" y2="{flip(y2):.1f}" stroke="#d55e00" '
                   'stroke-width="2"/>')
        tip = [(x2, y2)] + [(x2 - 9 * math.cos(angle + s), y2 - 9 * math.sin(angle + s)) for s in (0.4, -0.4)]
        svg.append('<polygon points="' + " ".join(f"{x:.1f},{flip(y):.1f}" for x, y in tip) + '" fill="#d55e00"/>')
    for x, y, anchor, text in ((90, 110, "start", "mud presses on the surface,"),
                               (300, 90, "start", "in a crack wider than the seal gap,"),
                               (965, 40, "end", "and all round a chip: no net force"),
                               (60, 388, "start", "What is bonded, or closed to less than the seal gap, is one piece. "
                                                  "Its outer face is the blue polygon.")):
        svg.append(f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="#22262b">{text}</text>')
    svg.append("</svg>")
    pathlib.Path(__file__).with_name("mud_faces.svg").write_text("\n".join(svg) + "\n")


main()
