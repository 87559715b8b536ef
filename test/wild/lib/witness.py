# SPDX-License-Identifier: LGPL-3.0-or-later
"""Points at which the signs of a polynomial prove that a cell is hit, checked with fractions."""
import fractions
import itertools
import math
import re

TOKEN = re.compile(r"\^\s*(\d+)|(\d+\.?\d*|\.\d+)|[-+*() xyz]")


def evaluate(polynomial, point):
    """The exact value of a polynomial in x, y, z with whole or decimal coefficients."""
    if TOKEN.sub("", polynomial):
        raise ValueError(f"witness: given {polynomial!r}; expected a polynomial in x, y and z with decimal coefficients")
    text = TOKEN.sub(_python_token, polynomial)
    return eval(text, {"__builtins__": {}, "Number": fractions.Fraction, **dict(zip("xyz", point))})


def _python_token(token):
    exponent, number = token.groups()
    return f"**{int(exponent)}" if exponent else f"Number('{number}')" if number else token.group()


def lost_cell_of_witness(witness, polynomial, box, resolution, lost):
    """A lost cell that the points {"x,y": sign} prove to be hit: a zero, or two opposite signs, in the closed cell."""
    points = {tuple(fractions.Fraction(word) for word in text.split(",")): sign for text, sign in witness.items()}
    for point, sign in points.items():
        value = evaluate(polynomial, point)
        if (value > 0) - (value < 0) != sign:
            raise ValueError(f"witness: {polynomial} at {', '.join(map(str, point))} is {value}; expected the sign {sign}")
    if 0 not in points.values() and len(set(points.values())) < 2:
        raise ValueError(f"witness: given {witness}; expected a zero or two signs")
    cells = set.intersection(*(_cells_of_point(point, box, resolution) for point in points))
    if not cells & lost:
        raise ValueError(f"witness: given {witness}; expected a lost cell that has them all")
    return min(cells & lost)


def _cells_of_point(point, box, resolution):
    sides = []
    for value, (low, high), count in zip(point, box, resolution):
        place = (value - low) / (high - low) * count
        sides.append([i for i in (math.ceil(place) - 1, math.floor(place)) if 0 <= i < count])
    return set(itertools.product(*sides))
