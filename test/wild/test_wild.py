#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Tests of the audit's own parts: mapping to cells, features, witnesses, and controls by exact rasters.

usage: test_wild.py CORRAL
"""
import dataclasses
import fractions
import itertools
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent / "lib"))

import programs
import table
from judgement import Judgement, connected_parts, judge
from raster import cells_of_shape, write_cells
from witness import evaluate, lost_cell_of_witness

CORRAL = sys.argv.pop() if len(sys.argv) > 1 else "corral"
CUBIC = ("x^3 - x^2 - y^2", "-2:2,-2:2", "16")
CUBIC_GRID = ([(-2, 2)] * 2, [16, 16])


def meets(shape, cell):
    """Whether a segment or triangle of exact points meets a closed cell: no axis or normal separates them."""
    edges = [tuple(b - a for a, b in zip(*pair)) for pair in itertools.combinations(shape, 2)]
    units = [tuple(int(i == axis) for i in range(len(cell))) for axis in range(len(cell))]
    if len(cell) == 2:
        axes = units + [(-v, u) for u, v in edges]
    else:
        axes = units + [cross(a, b) for a, b in itertools.product(edges, units + edges)]
    corners = list(itertools.product(*((i, i + 1) for i in cell)))
    return not any(separates(axis, shape, corners) for axis in axes if any(axis))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def separates(axis, one, other):
    one, other = ([sum(a * b for a, b in zip(axis, point)) for point in points] for points in (one, other))
    return max(one) < min(other) or max(other) < min(one)


class Mapping(unittest.TestCase):
    def test_agrees_with_separating_axes(self):
        source = random.Random(1)
        for dimension, points in itertools.product((2, 3), (1, 2, 3)):
            resolution = [5] * dimension
            for _ in range(30):
                shape = [tuple(fractions.Fraction(source.randrange(-7, 43), 7) for _ in resolution) for _ in range(points)]
                expected = {cell for cell in itertools.product(range(5), repeat=dimension) if meets(shape, cell)}
                self.assertEqual(set(cells_of_shape([tuple(map(float, p)) for p in shape], resolution)), expected, shape)

    def test_a_corner_is_in_all_closed_cells_around_it(self):
        self.assertEqual(set(cells_of_shape([(1.0, 2.0)], [4, 4])), {(0, 1), (0, 2), (1, 1), (1, 2)})


class Features(unittest.TestCase):
    def test_a_loss_beside_the_drawing_is_no_lost_feature(self):
        plotted = {(0, 0), (1, 1)}
        judgement = Judgement(plotted, lost={(2, 2), (3, 3), (6, 6)}, false={(1, 1)})
        self.assertEqual(judgement.hit, {(0, 0), (2, 2), (3, 3), (6, 6)})
        self.assertEqual(judgement.lost_far, {(3, 3), (6, 6)})
        self.assertEqual(judgement.features_lost, [{(6, 6)}])
        self.assertEqual(judgement.false_far, set())

    def test_cells_that_share_a_corner_are_connected(self):
        self.assertEqual(len(connected_parts({(0, 0, 0), (1, 1, 1), (3, 3, 3)})), 2)


class Figures(unittest.TestCase):
    def test_each_figure_that_differs_is_named(self):
        program = programs.read_programs(["surf"])[0]
        case = dataclasses.replace(program.cases[0], lost=1, lost_far=1, features=1, features_lost=1, false=0, false_far=0)
        right, other = Judgement(set(), {(0, 0)}, set()), Judgement({(5, 5)}, {(0, 0)}, {(5, 5)})
        self.assertEqual(table.complaints(program, case, right), [])
        self.assertEqual([text.split(": ")[1] for text in table.complaints(program, case, other)],
                         ["false is 1; expected 0", "false_far is 1; expected 0"])


class Witness(unittest.TestCase):
    def test_values_are_exact(self):
        self.assertEqual(evaluate("0.1*x + 0.2*y - 0.3", (1, 1)), 0)
        self.assertEqual(evaluate("(x - 2)^3*y^2", (fractions.Fraction(1, 3), 3)), fractions.Fraction(-125, 3))
        with self.assertRaises(ValueError):
            evaluate("x + open", (1, 1))

    def test_only_true_witnesses_of_lost_cells_pass(self):
        lost = {(7, 7), (8, 8)}
        self.assertEqual(lost_cell_of_witness({"0,0": 0}, CUBIC[0], *CUBIC_GRID, lost), (7, 7))
        for witness in ({"0,0": 1}, {"1,0": 0}, {"1/8,0": -1}, {"0,0": 0, "1,0": 0}):
            with self.subTest(witness), self.assertRaises(ValueError):
                lost_cell_of_witness(witness, CUBIC[0], *CUBIC_GRID, lost)


class Controls(unittest.TestCase):
    def judged(self, cells):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "cells.csv"
            write_cells(path, cells, 2)
            return judge(CORRAL, *CUBIC, path)

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "exact.csv"
            subprocess.run([CORRAL, "localize", CUBIC[0], "--box", CUBIC[1], "--resolution", CUBIC[2], "--exact",
                            "--output", path], check=True, capture_output=True)
            rows = [line.split(",") for line in path.read_text(encoding="ascii").splitlines()]
            cls.exact = {(int(row[0]), int(row[1])) for row in rows if row[0].isdigit()}

    def test_the_exact_raster_has_no_fault(self):
        judgement = self.judged(self.exact)
        self.assertEqual((judgement.lost, judgement.false), (set(), set()))
        self.assertEqual(judgement.hit, self.exact)

    def test_a_doctored_raster_is_caught(self):
        point = {(7, 7), (7, 8), (8, 7), (8, 8)}
        judgement = self.judged(self.exact - point | {(0, 0)})
        self.assertEqual((judgement.lost, judgement.false), (point, {(0, 0)}))
        self.assertEqual(judgement.features_lost, [point])

    def test_an_empty_raster_loses_everything(self):
        self.assertEqual(self.judged(set()).lost, self.exact)


unittest.main()
