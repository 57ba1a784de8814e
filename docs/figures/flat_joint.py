#!/usr/bin/env python3
"""Draws the two figures of docs/theory/flat_joint.md. Needs nothing but Python; run it anywhere:

    python3 docs/figures/flat_joint.py

It writes flat_joint_interface.svg and flat_joint_strength.svg beside itself, the same bytes every time. Rotation and gap
are exaggerated; everything else is to scale with the formulas of the page.
"""

import math
from pathlib import Path

# Colours that remain distinct for colour-blind readers [OkabeIto2008].
BLUE, ORANGE, GREEN, RED, GREY, INK = "#0072b2", "#e69f00", "#009e73", "#d55e00", "#8a8f98", "#22262b"
DISC, DISC_EDGE = "#eef1f5", "#b4bcc8"


class Drawing:
    """An SVG being written: x to the right, y down, in pixels."""

    def __init__(self, width, height, title):
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
            ' font-family="Helvetica, Arial, sans-serif" font-size="15">',
            f"<title>{title}</title>",
            f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
        ]

    def line(self, x1, y1, x2, y2, colour=INK, width=1.2, dash=""):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}"'
                          f' stroke-width="{width}" stroke-linecap="round"{dashes}/>')

    def polygon(self, points, fill, opacity=1.0, edge="none"):
        where = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polygon points="{where}" fill="{fill}" fill-opacity="{opacity}" stroke="{edge}"/>')

    def circle(self, x, y, radius, fill, edge="none"):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}" stroke="{edge}"'
                          ' stroke-width="1.4"/>')

    def head(self, x, y, angle, colour, size=8.0):
        """Arrow head with its tip at (x, y), pointing along `angle` (counter-clockwise, as seen)."""
        side = [(x - size * math.cos(angle + turn), y + size * math.sin(angle + turn)) for turn in (-0.42, 0.42)]
        self.polygon([(x, y), *side], colour)

    def arrow(self, x1, y1, x2, y2, colour=INK, width=1.8, both=False):
        angle = math.atan2(y1 - y2, x2 - x1)
        back = 5.0 if math.hypot(x2 - x1, y2 - y1) > 10.0 else 0.0
        dx, dy = back * math.cos(angle), -back * math.sin(angle)
        self.line(x1 + (dx if both else 0.0), y1 + (dy if both else 0.0), x2 - dx, y2 - dy, colour, width)
        self.head(x2, y2, angle, colour)
        if both:
            self.head(x1, y1, angle + math.pi, colour)

    def turning(self, x, y, radius, start, end, colour=INK):
        """Arc arrow about (x, y) from angle `start` to `end`, counter-clockwise as seen."""
        xs, ys = x + radius * math.cos(start), y - radius * math.sin(start)
        xe, ye = x + radius * math.cos(end), y - radius * math.sin(end)
        sweep = 0 if end > start else 1
        self.parts.append(f'<path d="M {xs:.1f} {ys:.1f} A {radius} {radius} 0 0 {sweep} {xe:.1f} {ye:.1f}" fill="none"'
                          f' stroke="{colour}" stroke-width="1.8"/>')
        self.head(xe, ye, end + math.copysign(math.pi / 2, end - start), colour)

    def text(self, x, y, content, colour=INK, anchor="start", size=15, turned=0.0):
        """`content` may hold *italics* and a _{subscript}; `turned` in degrees, clockwise."""
        out, rest, lowered = "", content, 0
        while rest:
            italic, below = rest[0] == "*", rest[:2] == "_{"
            if italic:
                inner, rest = rest[1:].split("*", 1)
            elif below:
                inner, rest = rest[2:].split("}", 1)
            else:
                end = min([k for k in (rest.find("*"), rest.find("_{")) if k >= 0], default=len(rest))
                inner, rest = rest[:end], rest[end:]
            wanted = 4 if below else 0
            attributes = f' dy="{wanted - lowered}"' if wanted != lowered else ""
            attributes += ' font-style="italic"' if italic else ""
            attributes += f' font-size="{size - 4}"' if below else ""
            lowered = wanted
            inner = inner.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
            out += f"<tspan{attributes}>{inner}</tspan>"
        turn = f' transform="rotate({turned:.1f} {x:.1f} {y:.1f})"' if turned else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size}"'
                          f"{turn}>{out}</text>")

    def save(self, name):
        path = Path(__file__).resolve().parent / name
        path.write_text("\n".join([*self.parts, "</svg>"]) + "\n", encoding="utf-8")


HALF = 120.0  # R, in pixels
ROTATION, ZERO = 0.42, 0.30 * HALF  # theta, much exaggerated; the r where the gap is zero
ELEMENTS = 4
LENGTH = 2 * HALF / ELEMENTS
# Elements from the lower end: broken and open, bonded in tension, broken and partly open, bonded under pressure.
FILLS = (None, BLUE, ORANGE, BLUE)
STATES = ("broken, open: 0", "bonded: *k*_{n}*g*", "broken: *k*_{n} min(*g*, 0)", "bonded: *k*_{n}*g*")


def gap(r):
    return ROTATION * (ZERO - r)


def ends(e):
    return -HALF + LENGTH * e, -HALF + LENGTH * (e + 1)


def two_discs(d, xc, yc):
    radius1, radius2 = 130.0, 162.0
    x1, x2 = xc - radius1 - gap(0) / 2, xc + radius2 + gap(0) / 2
    for x, radius, side in ((x1, radius1, -1), (x2, radius2, 1)):
        face = [(xc + side * gap(r) / 2, yc - r) for r in (-HALF, HALF)]
        rims = [(x - side * 0.6 * radius, yc - above * 0.8 * radius) for above in (-1, 1)]  # on the disc's edge
        d.circle(x, yc, radius, DISC, DISC_EDGE)
        d.polygon([rims[0], face[0], face[1], rims[1]], DISC)
        d.line(*rims[0], *face[0], DISC_EDGE, 1.4)
        d.line(*rims[1], *face[1], DISC_EDGE, 1.4)

    for e, fill in enumerate(FILLS):
        a, b = ends(e)
        if e == 2:
            a = ZERO  # only the closed part touches
        if fill:
            d.polygon([(xc - gap(a) / 2, yc - a), (xc - gap(b) / 2, yc - b), (xc + gap(b) / 2, yc - b),
                       (xc + gap(a) / 2, yc - a)], fill, 0.55)
    for side in (-1, 1):
        d.line(xc + side * gap(-HALF) / 2, yc + HALF, xc + side * gap(HALF) / 2, yc - HALF, INK, 3.2)
    for e in range(1, ELEMENTS):
        r = ends(e)[0]
        d.line(xc - abs(gap(r)) / 2 - 5, yc - r, xc + abs(gap(r)) / 2 + 5, yc - r, INK, 1.0)
    r = -0.78 * HALF
    d.arrow(xc - gap(r) / 2 + 2, yc - r, xc + gap(r) / 2 - 2, yc - r, GREY, 1.2, both=True)
    d.text(xc, yc - r - 7, "*g*(*r*)", INK, "middle", 14)
    d.text(xc - 10, yc + HALF + 20, "face 1", anchor="end")
    d.text(xc + 10, yc + HALF + 20, "face 2")

    for x, index, turn in ((x1, 1, -1), (x2, 2, 1)):
        d.line(x, yc, xc, yc, GREY, 1.0, "4 4")
        d.circle(x, yc, 3.5, INK)
        d.text(x - 5, yc + 21, f"*x*_{{{index}}}", anchor="middle")
        start, end = math.radians(90 - 35 * turn), math.radians(90 + 35 * turn)
        d.turning(x, yc, 46, start, end)
        d.text(x, yc - 56, ("−" if turn < 0 else "+") + "*θ*/2", anchor="middle")
    level = yc + 186
    for x in (x1, xc, x2):
        d.line(x, yc + 8 if x != xc else yc + HALF + 4, x, level + 6, GREY, 0.8, "2 4")
    d.arrow(x1, level, xc, level, GREY, 1.2, both=True)
    d.arrow(xc, level, x2, level, GREY, 1.2, both=True)
    d.text((x1 + xc) / 2, level - 7, "*l*_{1}", anchor="middle")
    d.text((x2 + xc) / 2, level - 7, "*l*_{2}", anchor="middle")
    d.text(x1 - 0.62 * radius1, yc + 0.5 * radius1, "disc 1", GREY, "middle")
    d.text(x2 + 0.62 * radius2, yc + 0.5 * radius2, "disc 2", GREY, "middle")

    d.arrow(xc, yc, xc + 66, yc, RED, 2.2)
    d.text(xc + 60, yc - 9, "*n*", RED)
    d.arrow(xc, yc, xc, yc - HALF - 46, RED, 2.2)
    d.text(xc + 9, yc - HALF - 34, "*t*", RED)
    d.circle(xc, yc, 3.5, RED)
    d.text(xc + 12, yc + 19, "*x*_{c}", RED)


def profile_axes(d, x, yc, title, left, right):
    d.text(x, yc - HALF - 56, title, anchor="middle")
    for e in range(ELEMENTS + 1):
        d.line(x - 92, yc + HALF - LENGTH * e, x + 92, yc + HALF - LENGTH * e, GREY, 0.6, "2 4")
    d.arrow(x, yc + HALF + 24, x, yc - HALF - 30, INK, 1.2)
    d.text(x + 8, yc - HALF - 26, "*r*")
    d.text(x - 10, yc + HALF + 22, "− " + left, BLUE, "end", 14)
    d.text(x + 10, yc + HALF + 22, right + " +", GREY, size=14)


def interface():
    d = Drawing(1180, 480, "Two discs, the two faces between them, and gap and stress along the interface")
    yc = 256.0
    d.text(56, 42, "on disc 1:")
    d.arrow(132, 37, 168, 37, GREEN, 2.2)
    d.text(174, 42, "*N* > 0 pulls,")
    d.arrow(282, 50, 282, 22, GREEN, 2.2)
    d.text(292, 42, "*T* > 0 lifts;  on disc 2 the opposite")
    two_discs(d, 318.0, yc)

    x, scale = 790.0, 1.12
    profile_axes(d, x, yc, "gap  *g*(*r*) = *g*_{s} − *θr*", "closed", "open")
    d.polygon([(x, yc + HALF), (x + scale * gap(-HALF), yc + HALF), (x, yc - ZERO)], GREY, 0.18)
    d.polygon([(x, yc - HALF), (x + scale * gap(HALF), yc - HALF), (x, yc - ZERO)], BLUE, 0.22)
    d.line(x + scale * gap(-HALF), yc + HALF, x + scale * gap(HALF), yc - HALF, INK, 2.4)
    d.arrow(x, yc, x + scale * gap(0), yc, RED, 1.6)
    d.text(x + scale * gap(0) + 6, yc + 5, "*g*_{s}", RED)
    for r, label in ((HALF, "+*R*"), (0.0, "0"), (-HALF, "−*R*")):
        d.text(x - 100, yc - r + 5, label, anchor="end")

    x = 1030.0
    profile_axes(d, x, yc, "normal stress  *σ*(*r*)", "pressure", "tension")
    for e, (fill, state) in enumerate(zip(FILLS, STATES)):
        a, b = ends(e)
        stress = {0: [(a, 0.0), (b, 0.0)], 2: [(a, 0.0), (ZERO, 0.0), (b, gap(b))]}.get(e, [(a, gap(a)), (b, gap(b))])
        outline = [(x + scale * value, yc - r) for r, value in stress]
        if fill:
            d.polygon([(x, yc - a), *outline, (x, yc - b)], fill, 0.45)
        for start, end in zip(outline, outline[1:]):
            d.line(*start, *end, INK, 2.4)
        d.text(x - 105, yc - (a + b) / 2 + 5, f"*e* = {e + 1}", GREY, "end", 13)
        d.text(x + (62 if e == 1 else 12), yc - (a + b) / 2 + 5, state, size=13)
    d.save("flat_joint_interface.svg")


def strength():
    d = Drawing(800, 450, "Strength of a bonded element and what it carries afterwards")
    ox, oy, unit = 560.0, 392.0, 8.2  # origin; pixels per MPa
    cohesion, tan_phi, tension, mu, residual, left = 20.0, 0.36, 12.0, 0.5, 6.0, -58.0  # [MPa] and [1]

    def at(sigma, tau):
        return ox + unit * sigma, oy - unit * tau

    def bonded(sigma):
        return cohesion - sigma * tan_phi

    d.polygon([at(left, 0), at(left, bonded(left)), at(tension, bonded(tension)), at(tension, 0)], BLUE, 0.11)
    d.polygon([at(left, 0), at(left, -mu * left), at(0, 0)], ORANGE, 0.20)
    d.line(*at(left, bonded(left)), *at(tension, bonded(tension)), BLUE, 2.8)
    d.line(*at(tension, bonded(tension)), *at(tension, 0), BLUE, 2.8)
    d.line(*at(left, -mu * left), *at(0, 0), ORANGE, 2.8)
    d.line(*at(left, residual - mu * left), *at(0, residual), RED, 2.2, "8 5")
    d.line(*at(0, residual), *at(0, 0), RED, 2.2, "8 5")
    d.arrow(*at(left - 2, 0), *at(tension + 12, 0), INK, 1.3)
    d.arrow(*at(0, -2), *at(0, 43), INK, 1.3)
    d.text(*at(tension + 12, -3.0), "*σ*  (tension +)", anchor="end")
    d.text(*at(1.0, 41.5), "|*τ*|")

    slope_bonded, slope_friction = (math.degrees(math.atan(value)) for value in (tan_phi, mu))
    d.text(*at(-52.0, bonded(-52.0) + 1.2), "*c* − *σ* tan *φ*:  breaks in shear", BLUE, turned=slope_bonded)
    d.text(*at(tension + 1.0, 9.0), "*σ*_{c}:  breaks", BLUE)
    d.text(*at(tension + 1.0, 6.6), "in tension", BLUE)
    d.text(*at(-52.0, residual + mu * 52.0 + 1.5), "*c*_{r} − *μσ*:  broken in shear", RED, turned=slope_friction)
    d.text(*at(-52.0, mu * 52.0 - 3.1), "−*μσ*:  broken in tension, or never bonded", INK, turned=slope_friction)
    d.circle(*at(0, cohesion), 3.5, BLUE)
    d.text(*at(0.9, cohesion + 0.7), "*c*", BLUE)
    d.text(*at(0.9, residual - 0.8), "*c*_{r}", RED)
    d.text(*at(1.6, 13.2), "bonded", BLUE)

    sigma = -13.0
    x, y = at(sigma, bonded(sigma))
    kept = at(sigma, residual - mu * sigma)[1]
    d.arrow(x, y, x, kept, RED, 2.2)
    d.arrow(x, kept, x, oy, INK, 2.2)
    d.circle(x, y, 5, INK)
    d.text(x + 8, (y + kept) / 2 - 4, "drop to the", RED, size=14)
    d.text(x + 8, (y + kept) / 2 + 14, "residual", RED, size=14)
    d.text(x - 8, oy - 9, "or to 0", INK, "end", 14)
    d.save("flat_joint_strength.svg")


if __name__ == "__main__":
    interface()
    strength()
