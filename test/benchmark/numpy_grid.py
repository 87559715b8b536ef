#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Times what a user of numpy would do: values at all grid points, then cells whose corners differ in sign.

usage: numpy_grid.py RUN_ONCE SET RESOLUTION...   (prints one JSON object)

It proves nothing and loses cells. Values are computed in the two usual ways, by products of power matrices and by
Horner's rule on whole arrays, and the faster way counts.
"""
import json
import statistics
import subprocess
import sys
import time

import numpy as np


def problems(run_once, name):
    result = []
    for line in subprocess.run([run_once, name, "0"], capture_output=True, text=True, check=True).stdout.splitlines():
        if line.startswith("#"):
            title, dimension, lower = line[2:].split(";")
            result.append((title, int(dimension), float(lower), []))
        else:
            result[-1][3].append([float(word) for word in line.split()])
    return result


def tensor(dimension, terms):
    exponents = np.array([term[1:] for term in terms], dtype=int)
    dense = np.zeros(exponents.max(axis=0) + 1)
    for term, index in zip(terms, exponents):
        dense[tuple(index)] = term[0]
    return dense


def by_products(dense, axis):
    powers = [axis[:, None] ** np.arange(size) for size in dense.shape]
    if dense.ndim == 2:
        return powers[0] @ dense @ powers[1].T
    return np.einsum("abc,ia,jb,kc->ijk", dense, *powers, optimize=True)


def by_horner(dense, axis):
    grids = np.meshgrid(*[axis] * dense.ndim, indexing="ij", sparse=True)

    def value(part, variables):
        if not variables:
            return part
        result = value(part[-1], variables[1:])
        for coefficient in part[-2::-1]:
            result = result * variables[0] + value(coefficient, variables[1:])
        return result

    return np.broadcast_to(value(dense, grids), [axis.size] * dense.ndim)


def plotted(values):
    positive = values > 0
    negative = values < 0
    for axis in range(values.ndim):
        lower = [slice(None)] * values.ndim
        upper = list(lower)
        lower[axis] = slice(None, -1)
        upper[axis] = slice(1, None)
        positive = positive[tuple(lower)] & positive[tuple(upper)]
        negative = negative[tuple(lower)] & negative[tuple(upper)]
    return int(np.count_nonzero(~(positive | negative)))


def seconds(method, cases, n):
    start = time.process_time()
    cells = 0
    for _, dimension, lower, terms in cases:
        cells += plotted(method(tensor(dimension, terms), np.linspace(lower, 1, n + 1)))
    return time.process_time() - start, cells


def main():
    run_once, name, *sizes = sys.argv[1:]
    cases = problems(run_once, name)
    report = {}
    for n in map(int, sizes):
        best = None
        for method in (by_products, by_horner):
            first, cells = seconds(method, cases, n)
            if first > 60 or (best and first > 20 * best[0]):
                times = [first]
            else:
                times = [seconds(method, cases, n)[0] for _ in range(3 if first > 1 else 7)]
            if best is None or statistics.median(times) < best[0]:
                best = (statistics.median(times), cells, method.__name__, min(times))
        report[n] = {"seconds": best[0], "seconds_min": best[3], "cells": best[1], "evaluation": best[2]}
    json.dump(report, sys.stdout)


main()
