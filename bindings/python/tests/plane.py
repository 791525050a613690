"""Contact in the plane by rational arithmetic and square roots: slow and obvious."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt
from typing import NamedTuple, Optional


class Surd(NamedTuple):
    """The number ``u + v * sqrt(d)``."""

    u: Fraction
    v: Fraction
    d: Fraction

    def sign(self) -> int:
        """The sign of the number."""
        u, v = sign(self.u), sign(self.v) * sign(self.d)
        if u * v < 0:
            return u * sign(self.u**2 - self.v**2 * self.d)
        return u or v

    def __float__(self) -> float:
        return float(self.u) + float(self.v) * sqrt(self.d)


Quadratic = tuple[Fraction, Fraction, Fraction]
"""The coefficients of 1, t and t**2."""


def sign(x: Fraction) -> int:
    """The sign of a rational number."""
    return (x > 0) - (x < 0)


def at(f: Quadratic, t: Surd) -> Surd:
    """The value of a quadratic."""
    square = Surd(t.u**2 + t.v**2 * t.d, 2 * t.u * t.v, t.d)
    return Surd(f[0] + f[1] * t.u + f[2] * square.u, f[1] * t.v + f[2] * square.v, t.d)


def roots(f: Quadratic) -> list[Surd]:
    """The real roots of a quadratic that is not zero."""
    c, b, a = f
    if a == 0:
        return [Surd(-c / b, Fraction(0), Fraction(0))] if b != 0 else []
    d = b * b - 4 * a * c
    return [Surd(-b / (2 * a), part / (2 * a), d) for part in (Fraction(-1), Fraction(1))] if d >= 0 else []


def bilinear(x: list[list[Fraction]], y: list[list[Fraction]], axes: list[tuple[int, int, int]]) -> Quadratic:
    """The sum of s x_i y_j over the axes (s, i, j), for vectors in motion: at t = 0, and their change."""
    terms = [[sum(s * x[m][i] * y[n][j] for s, i, j in axes) for n in (0, 1)] for m in (0, 1)]
    return Fraction(terms[0][0]), Fraction(terms[0][1] + terms[1][0]), Fraction(terms[1][1])


def first_meeting(p, a, b) -> Optional[float]:
    """The first time at which a point meets a segment: each is two positions, at t = 0 and at t = 1.

    The point is on the segment iff x and y, the vectors from it to both ends, have x × y = 0 and x · y <= 0.
    """

    def motion(q) -> list[list[Fraction]]:
        start, end = ([Fraction(q[t][k]) - Fraction(p[t][k]) for k in (0, 1)] for t in (0, 1))
        return [start, [end[k] - start[k] for k in (0, 1)]]

    x, y = motion(a), motion(b)
    cross = bilinear(x, y, [(1, 0, 1), (-1, 1, 0)])
    dot = bilinear(x, y, [(1, 0, 0), (1, 1, 1)])
    events = [Surd(Fraction(0), Fraction(0), Fraction(0)), *roots(cross if any(cross) else dot)]
    meetings = [
        t
        for t in events
        if t.sign() >= 0 and Surd(t.u - 1, t.v, t.d).sign() <= 0
        if at(cross, t).sign() == 0 and at(dot, t).sign() <= 0
    ]
    return min(map(float, meetings), default=None)
