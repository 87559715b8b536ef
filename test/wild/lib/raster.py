# SPDX-License-Identifier: LGPL-3.0-or-later
"""The closed cells of a grid that a drawing meets."""
import itertools
import math

# A shape within this share of a cell's side meets the cell: the plotter has the benefit of our rounding.
SLACK = 1e-9


def cells_of_shape(shape, resolution):
    """The cells that meet the convex hull of the points of `shape`, which are in units of cells.

    The points of a polygon are in order around it. Cuts the shape by slabs of one cell's thickness, axis by axis.
    """
    return _cells(shape, resolution, ())


def _cells(shape, resolution, index):
    axis = len(index)
    if axis == len(resolution):
        yield index
        return
    values = [point[axis] for point in shape]
    first = max(0, math.ceil(min(values) - SLACK) - 1)
    last = min(resolution[axis] - 1, math.floor(max(values) + SLACK))
    for i in range(first, last + 1):
        part = _halved(shape, axis, 1, i - SLACK)
        part = _halved(part, axis, -1, -(i + 1 + SLACK))
        if part:
            yield from _cells(part, resolution, (*index, i))


def _halved(polygon, axis, sign, bound):
    """The part of a convex polygon, segment or point where sign * coordinate >= bound."""
    kept = []
    closed = itertools.chain(polygon[1:], polygon[:1])
    for point, following in zip(polygon, closed):
        here, there = sign * point[axis] - bound, sign * following[axis] - bound
        if here >= 0:
            kept.append(point)
        if here * there < 0:
            share = here / (here - there)
            kept.append(tuple(a + share * (b - a) for a, b in zip(point, following)))
    return kept


def read_shapes(path, box, resolution):
    """Reads a table with one convex shape a row, its points one after another, in units of cells."""
    dimension = len(box)
    with open(path, encoding="ascii") as lines:
        for number, line in enumerate(lines, 1):
            values = [float(word) for word in line.split(",")]
            if not values or len(values) % dimension or not all(map(math.isfinite, values)):
                raise ValueError(f"{path}, line {number}: given {line.strip()!r}; expected points of {dimension} numbers")
            points = zip(*[iter(values)] * dimension)
            yield [tuple((value - float(low)) / float(high - low) * count
                         for value, (low, high), count in zip(point, box, resolution)) for point in points]


def cells_of_drawing(path, box, resolution):
    cells = set()
    for shape in read_shapes(path, box, resolution):
        cells.update(cells_of_shape(shape, resolution))
    return cells


def write_cells(path, cells, dimension):
    with open(path, "w", encoding="ascii") as table:
        print(*"ijk"[:dimension], sep=",", file=table)
        for cell in sorted(cells):
            print(*cell, sep=",", file=table)


def read_cells(path):
    with open(path, encoding="ascii") as table:
        next(table)
        return {tuple(map(int, line.split(","))) for line in table}
