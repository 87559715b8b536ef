# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the drivers in Python share: draw EXPRESSION BOX RESOLUTION FOLDER, with BOX as 'low high low high ...'."""
import pathlib
import sys

import numpy as np


class Drawing:
    def __init__(self):
        self.expression, box, resolution, folder = sys.argv[1:]
        numbers = [float(word) for word in box.split()]
        self.box = list(zip(numbers[::2], numbers[1::2]))
        self.resolution = [int(word) for word in resolution.split()]
        self.folder = pathlib.Path(folder)

    def corners(self):
        """The coordinates of the corners of the cells, for each axis."""
        return [np.linspace(low, high, count + 1) for (low, high), count in zip(self.box, self.resolution)]

    def values(self, indexing="ij"):
        """Doubles at the corners of the cells, as a user of numpy computes them."""
        grids = np.meshgrid(*self.corners(), indexing=indexing)
        return eval(self.expression.replace("^", "**"), dict(zip("xyz", grids)))

    def write_shapes(self, shapes):
        """Convex shapes, each a sequence of points in the coordinates of the box."""
        with open(self.folder / "shapes.csv", "w", encoding="ascii") as table:
            for shape in shapes:
                print(",".join(repr(float(value)) for point in shape for value in point), file=table)

    def write_lines(self, lines):
        self.write_shapes(pair for line in lines for pair in zip(line[:-1], line[1:]))
