#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A second checker of certificates, written from doc/certificate.md alone, on Python's standard library.

usage: check_certificate.py FILE...

Prints for each file, in order, a line `accepted: N cells, E empty, H hit, U unknown` or `rejected: why`. Ends with 0 if all
were accepted, with 1 otherwise.
"""
import json
import math
import re
import sys
import zlib
from fractions import Fraction
from itertools import product

KEYS = {"format", "version", "dimension", "variables", "polynomials", "square_free", "box", "resolution", "method",
        "tree", "witnesses", "reasons", "empty", "hit", "unknown"}
KEYS_OF_2 = KEYS | {"multipliers", "critical"}
EXACT = re.compile(r"0|-?[1-9][0-9]*(/[1-9][0-9]*)?", re.ASCII)
MAX_TEXT = 1 << 28


class Rejected(Exception):
    pass


def need(condition, why):
    if not condition:
        raise Rejected(why)


# ---- section 1: the file ----------------------------------------------------------------------------------------

def unpack(data):
    if data[:2] == b"\x1f\x8b":
        stream = zlib.decompressobj(31)
        try:
            data = stream.decompress(data, MAX_TEXT + 1)
        except zlib.error as error:
            raise Rejected("gzip: " + str(error)) from None
        need(stream.eof and not stream.unused_data, "gzip: cut off, too long or followed by something")
    need(len(data) <= MAX_TEXT, "too long")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        raise Rejected("not UTF-8") from None


def no_duplicates(pairs):
    result = dict(pairs)
    need(len(result) == len(pairs), "a key appears twice")
    return result


def natural(digits):
    need(digits[0] != "-" and len(digits) <= 19 and int(digits) < 1 << 63, "a JSON number out of range")
    return int(digits)


def no_number(text):
    raise Rejected("a JSON number is no integer: " + text[:20])


def read_json(text):
    depth = 0
    for bracket in re.findall(r'"(?:[^"\\]|\\.)*"|[\[\]{}]', text, re.DOTALL):
        depth += (bracket in "[{") - (bracket in "]}")
        need(depth <= 16, "nested too deep")
    try:
        value = json.loads(text, object_pairs_hook=no_duplicates, parse_int=natural, parse_float=no_number,
                           parse_constant=no_number)
        json.dumps(value, ensure_ascii=False).encode("utf-8")  # refuses half a surrogate pair
        return value
    except (json.JSONDecodeError, UnicodeEncodeError, RecursionError) as error:
        raise Rejected("not a JSON text: " + str(error)[:60]) from None


def number(value, least, most):
    need(type(value) is int and least <= value <= most, "expected a number from %d to %d" % (least, most))
    return value


def items(value, size=None):
    need(type(value) is list and (size is None or len(value) == size), "expected a list of the right length")
    return value


def exact(value):
    need(type(value) is str and len(value) <= 100000 and EXACT.fullmatch(value), "expected an exact text")
    result = Fraction(value)
    need("/" not in value or str(result.denominator) == value[value.index("/") + 1:] and result.denominator > 1,
         "a fraction not in lowest terms")
    return result


def read_polynomial(value, dimension):
    """A dictionary from exponents to coefficients."""
    result, last = {}, ()
    need(items(value), "a polynomial without terms")
    for term in value:
        items(term, dimension + 1)
        exponents = tuple(number(e, 0, 1000) for e in term[1:])
        coefficient = exact(term[0])
        need(coefficient != 0, "a coefficient is 0")
        need(exponents > last, "terms not sorted")
        result[exponents] = coefficient
        last = exponents
    need(math.prod(n + 1 for n in degrees(result, dimension)) <= 1 << 16, "degrees too high")
    return result


# ---- polynomials ------------------------------------------------------------------------------------------------

def degrees(f, dimension):
    return [max((e[k] for e in f), default=0) for k in range(dimension)]


def add_to(f, exponents, coefficient):
    f[exponents] = f.get(exponents, 0) + coefficient
    if f[exponents] == 0:
        del f[exponents]


def multiply(f, g):
    result = {}
    for e, a in f.items():
        for d, b in g.items():
            add_to(result, tuple(map(sum, zip(e, d))), a * b)
    return result


def divide(f, g):
    """Quotient and remainder in the lexicographic order of the exponents."""
    f, lead, quotient, kept = dict(f), max(g), {}, {}
    while f:
        top = max(f)
        shift = tuple(a - b for a, b in zip(top, lead))
        if min(shift) < 0:
            kept[top] = f.pop(top)
            continue
        factor = quotient[shift] = f[top] / g[lead]
        for e, c in g.items():
            add_to(f, tuple(map(sum, zip(e, shift))), -factor * c)
    return quotient, kept


def divides_power(f, g, k):
    """Whether f divides g^k; no factor of f has a multiplicity above the total degree."""
    rest = {(0,) * len(next(iter(f))): Fraction(1)}
    degree = max(map(sum, f))
    for _ in range(min(k, degree)):
        rest = divide(multiply(rest, g), f)[1]
    return degree == 0 or not rest


def derivative(f, axis):
    return {e[:axis] + (e[axis] - 1,) + e[axis + 1:]: c * e[axis] for e, c in f.items() if e[axis] > 0}


def remainder(f, t, axis):
    """f modulo t, which is monic in the variable of the axis."""
    f, degree = dict(f), max(e[axis] for e in t)
    while f:
        top = max(f, key=lambda e: e[axis])
        if top[axis] < degree:
            break
        factor = f[top]
        shift = top[:axis] + (top[axis] - degree,) + top[axis + 1:]
        for e, c in t.items():
            add_to(f, tuple(map(sum, zip(e, shift))), -factor * c)
    return f


def evaluate(f, point):
    return sum(c * math.prod(x ** n for x, n in zip(point, e)) for e, c in f.items())


def restrict(f, axis, value):
    result = {}
    for e, c in f.items():
        add_to(result, e[:axis] + (0,) + e[axis + 1:], c * value ** e[axis])
    return result


# ---- section 4: Bernstein coefficients --------------------------------------------------------------------------

class Bernstein:
    """Integers that are a positive multiple of the Bernstein coefficients, the last axis running fastest."""

    def __init__(self, sizes, values):
        self.sizes = sizes
        common = 0
        for v in values:
            common |= v
        shift = (common & -common).bit_length() - 1
        self.values = [v >> shift for v in values] if shift > 0 else values

    def lines(self, axis):
        """The slices of the values along an axis."""
        stride = math.prod(self.sizes[axis + 1:])
        for outer in range(0, len(self.values), stride * self.sizes[axis]):
            for start in range(outer, outer + stride):
                yield slice(start, start + stride * self.sizes[axis], stride)

    def halves(self, axis):
        n = self.sizes[axis] - 1
        low, high = list(self.values), list(self.values)
        for line in self.lines(axis):
            row = self.values[line]
            left, right = [], []
            for step in range(n + 1):
                left.append(row[0] << n - step)
                right.append(row[-1] << n - step)
                row = [a + b for a, b in zip(row, row[1:])]
            low[line], high[line] = left, right[::-1]
        return Bernstein(self.sizes, low), Bernstein(self.sizes, high)

    def is_free(self, axis):
        return self.sizes[axis] > 1

    def facet(self, axis, upper):
        values = [self.values[line][-1 if upper else 0] for line in self.lines(axis)]
        return Bernstein(self.sizes[:axis] + [1] + self.sizes[axis + 1:], values)

    def corners(self):
        for ends in product(*[(0, n - 1) for n in self.sizes]):
            index = 0
            for n, i in zip(self.sizes, ends):
                index = index * n + i
            yield self.values[index]

    def excludes_zero(self):
        corners = list(self.corners())
        return (min(corners) > 0 and min(self.values) >= 0) or (max(corners) < 0 and max(self.values) <= 0)

    def corners_show_zero(self):
        corners = list(self.corners())
        return not (min(corners) > 0 or max(corners) < 0)

    def strict_sign(self):
        return 1 if min(self.values) > 0 else -1 if max(self.values) < 0 else 0


def bernstein(f, box):
    """The Bernstein form on a box, by the power form in u and the sums of binomial ratios."""
    sizes = [n + 1 for n in degrees(f, len(box))]
    dense = [f.get(e, Fraction(0)) for e in product(*map(range, sizes))]
    form = Bernstein(sizes, [])
    form.values = dense
    for axis, (low, high) in enumerate(box):
        n = sizes[axis] - 1
        for line in form.lines(axis):
            power = form.values[line]
            shifted = [sum(power[j] * math.comb(j, i) * low ** (j - i) for j in range(i, n + 1)) * (high - low) ** i
                       for i in range(n + 1)]
            form.values[line] = [sum(Fraction(math.comb(i, j), math.comb(n, j)) * shifted[j] for j in range(i + 1))
                                 for i in range(n + 1)]
    common = math.lcm(*[v.denominator for v in form.values])
    return Bernstein(sizes, [v.numerator * (common // v.denominator) for v in form.values])


def strict_sign(f, box):
    for axis, (low, high) in enumerate(box):
        if low == high:
            f = restrict(f, axis, low)
    return bernstein(f, box).strict_sign() if f else 0


# ---- section 5: witnesses ---------------------------------------------------------------------------------------

def check_points(value, gs, cell):
    points = []
    for entry in items(value):
        u = [exact(c) for c in items(entry, len(cell))]
        need(all(0 <= c <= 1 for c in u), "a point outside the cell")
        points.append([a + c * (b - a) for c, (a, b) in zip(u, cell)])
    if len(points) == 1:
        need(all(evaluate(g, points[0]) == 0 for g in gs), "the point is no zero")
    else:
        need(len(points) == 2 and len(gs) == 1, "expected one point, or two for one polynomial")
        need(evaluate(gs[0], points[0]) * evaluate(gs[0], points[1]) < 0, "no opposite signs")


def read_box(value, dimension):
    box = [tuple(exact(end) for end in items(side, 2)) for side in items(value, dimension)]
    need(all(p <= q for p, q in box), "a side of a box is empty")
    return box


def changes_sign(f, axis, box):
    return strict_sign(f, box[:axis] + [(box[axis][0],) * 2] + box[axis + 1:]) * \
        strict_sign(f, box[:axis] + [(box[axis][1],) * 2] + box[axis + 1:]) < 0


def check_triangular(value, gs, cell):
    need(type(value) is dict and set(value) == {"order", "chain", "box"}, "triangular: wrong keys")
    d = len(cell)
    order = [number(o, 0, d - 1) for o in items(value["order"], d)]
    need(len(set(order)) == d, "order is no permutation")
    chain = [read_polynomial(t, d) for t in items(value["chain"], d)]
    box = read_box(value["box"], d)
    need(all(a <= p and q <= b for (p, q), (a, b) in zip(box, cell)), "the box is not in the cell")
    for r, (axis, t) in enumerate(zip(order, chain)):
        need(all(e[later] == 0 for e in t for later in order[r + 1:]), "the chain is not triangular")
        degree = max(e[axis] for e in t)
        top = {e: c for e, c in t.items() if e[axis] == degree}
        need(degree >= 1 and top == {tuple(degree * (k == axis) for k in range(d)): 1}, "the chain is not monic")
        p, q = box[axis]
        if p == q:
            expected = {tuple(int(k == axis) for k in range(d)): Fraction(1)}
            add_to(expected, (0,) * d, -p)
            need(t == expected, "the chain does not fix a flat side")
        else:
            need(changes_sign(t, axis, box), "the chain does not change sign")
    for g in gs:
        for axis, t in reversed(list(zip(order, chain))):
            g = remainder(g, t, axis)
        need(not g, "a polynomial does not reduce to zero")


def determinant(matrix):
    if not matrix:
        return 1
    return sum((-1) ** k * matrix[0][k] * determinant([row[:k] + row[k + 1:] for row in matrix[1:]])
               for k in range(len(matrix)))


def check_miranda(value, gs, cell):
    need(type(value) is dict and set(value) == {"box", "matrix"}, "miranda: wrong keys")
    box = read_box(value["box"], len(cell))
    need(all(0 <= p and q <= 1 for p, q in box), "the box is not in the cell")
    box = [(a + p * (b - a), a + q * (b - a)) for (p, q), (a, b) in zip(box, cell)]
    axes = [k for k, (p, q) in enumerate(box) if p < q]
    need(len(axes) == len(gs), "the box has not as many sides as there are polynomials")
    matrix = [[exact(c) for c in items(row, len(gs))] for row in items(value["matrix"], len(gs))]
    need(determinant(matrix) != 0, "a singular matrix")
    for axis, row in zip(axes, matrix):
        combination = {}
        for factor, g in zip(row, gs):
            for e, c in g.items():
                add_to(combination, e, factor * c)
        need(changes_sign(combination, axis, box), "no change of sign between facets")


WITNESSES = {"points": check_points, "triangular": check_triangular, "miranda": check_miranda}


# ---- section 6: leaves c -----------------------------------------------------------------------------------------

class Multipliers:
    """One entry of `multipliers`, with its check; appends its factors to the polynomials."""

    def __init__(self, entry, polynomials, dimension):
        need(type(entry) is dict and set(entry) == {"of", "a", "b", "factors"}, "multipliers: wrong keys")
        self.of = number(entry["of"], 0, len(polynomials) - 1)
        q, rest, self.slopes, self.factors = polynomials[self.of], {}, [], []

        def add_product(factor, polynomial):
            for e, c in multiply(factor, polynomial).items():
                add_to(rest, e, c)

        if entry["a"] is not None:
            add_product(read_polynomial(entry["a"], dimension), q)
        for axis, value in enumerate(items(entry["b"], dimension)):
            if value is not None:
                slope = derivative(q, axis)
                need(slope, "multipliers: a derivative that is zero")
                add_product(read_polynomial(value, dimension), slope)
                self.slopes.append(axis)
        need(rest, "multipliers: the combination is zero")
        for part in items(entry["factors"]):
            factor = read_polynomial(items(part, 2)[0], dimension)
            need(any(map(sum, factor)), "multipliers: a factor is a number")
            for _ in range(number(part[1], 1, 1000)):
                rest, left = divide(rest, factor)
                need(not left, "multipliers: not a factor")
            self.factors.append(len(polynomials))
            polynomials.append(factor)
        need(not any(map(sum, rest)), "multipliers: a factor is missing")


class Critical:
    """Proves that boxes hold no zero, by the entries of `critical` in their order."""

    def __init__(self, entries, multipliers, polynomials):
        self.entries, self.multipliers, self.polynomials = iter(entries), multipliers, polynomials

    def prove(self, index, form, box, depth):
        """`index`, `form`: a polynomial and its form on the box; or None and all those of the input."""
        entry = next(self.entries, None)
        need(entry is not None, "critical: no entry left")
        which, h, trees = items(entry, 3)
        need(self.multipliers and type(trees) is str, "critical: no multipliers or no trees")
        m = self.multipliers[number(which, 0, len(self.multipliers) - 1)]
        need(number(h, 0, len(box) - 1) not in m.slopes, "critical: the axis is one of a derivative")
        if index is None:
            need(m.of < len(form), "critical: multipliers of another polynomial")
            index, form = m.of, form[m.of]
        need(m.of == index, "critical: multipliers of another polynomial")
        need(all(form.is_free(axis) for axis in [h] + m.slopes), "critical: an axis is not free")
        characters = iter(trees)
        for axis in range(len(box)):
            for upper in (0, 1) if axis in m.slopes else (0,) if axis == h else ():
                facet = box[:axis] + [(box[axis][upper],) * 2] + box[axis + 1:]
                self.prove_tree(index, form.facet(axis, upper), facet, characters, depth + 1)
        for factor in m.factors:
            p = self.polynomials[factor]
            for axis, (low, high) in enumerate(box):
                if low == high:
                    p = restrict(p, axis, low)
            need(p, "critical: a factor is zero on a whole face")
            self.prove_tree(factor, bernstein(p, box), box, characters, depth + 1)
        need(next(characters, None) is None, "critical: a tree goes on after its end")

    def prove_tree(self, index, form, box, characters, depth):
        need(depth <= 1100, "critical: nested too deep")
        symbol = next(characters, None)
        if symbol == "e":
            need(form.excludes_zero(), "critical: not excluded")
        elif symbol == "c":
            self.prove(index, form, box, depth)
        else:
            need(symbol == "s", "critical: a character out of place")
            pieces = [(form, box)]
            for axis in filter(form.is_free, range(len(box))):
                middle = sum(box[axis]) / 2
                halves = [(f.halves(axis), b) for f, b in pieces]
                pieces = [(f[k], b[:axis] + [((b[axis][0], middle), (middle, b[axis][1]))[k]] + b[axis + 1:])
                          for k in (0, 1) for f, b in halves]
            need(len(pieces) > 1, "critical: a point is split")
            for piece_form, piece_box in pieces:
                self.prove_tree(index, piece_form, piece_box, characters, depth + 1)


# ---- sections 2 and 3: the claims --------------------------------------------------------------------------------

class Certificate:
    def __init__(self, root):
        need(type(root) is dict and root.get("format") == "corral-certificate", "another format")
        version = number(root.get("version"), 1, 2)
        need(set(root) == (KEYS if version == 1 else KEYS_OF_2), "wrong keys")
        need(root["method"] == "bernstein", "another method")
        d = self.dimension = number(root["dimension"], 1, 6)
        names = items(root["variables"], d)
        need(all(type(name) is str for name in names) and len(set(names)) == d, "variables")
        need(1 <= len(items(root["polynomials"])) <= d, "1 to D polynomials")
        self.polynomials = [read_polynomial(f, d) for f in root["polynomials"]]
        self.reduced = [self.square_free(f, entry) for f, entry in zip(
            self.polynomials, [None] * len(self.polynomials) if root["square_free"] is None else
            items(root["square_free"], len(self.polynomials)))]
        proved = list(self.reduced)
        multipliers = [Multipliers(entry, proved, d) for entry in items(root.get("multipliers", []))]
        entries = items(root.get("critical", []))
        self.critical = Critical(entries, multipliers, proved)
        self.box = [tuple(exact(end) for end in items(side, 2)) for side in items(root["box"], d)]
        need(all(a < b for a, b in self.box), "a side of the box is empty")
        self.resolution = [number(n, 1, 1 << 30) for n in items(root["resolution"], d)]
        need(math.prod(self.resolution) < 1 << 62, "too many cells")
        self.step = [(b - a) / n for (a, b), n in zip(self.box, self.resolution)]
        self.tree, self.witnesses, self.reasons = root["tree"], items(root["witnesses"]), items(root["reasons"])
        need(type(self.tree) is str, "tree")
        need(len(self.reasons) <= 10 and all(type(r) is str and r for r in self.reasons), "reasons")
        self.claimed = {v: number(root[v], 0, (1 << 63) - 1) for v in ("empty", "hit", "unknown")}

    def square_free(self, f, entry):
        if entry is None:
            return f
        need(type(entry) is dict and set(entry) == {"polynomial", "power"}, "square_free: wrong keys")
        g = read_polynomial(entry["polynomial"], self.dimension)
        need(not divide(f, g)[1], "the square-free part does not divide the polynomial")
        need(divides_power(f, g, number(entry["power"], 1, 1000)),
             "the polynomial does not divide the power of its square-free part")
        return g

    def check(self):
        self.exponent = [(n - 1).bit_length() for n in self.resolution]
        self.counts = dict.fromkeys(self.claimed, 0)
        self.used, position = 0, 0
        whole = [(a, a + w * 2 ** k) for (a, _), w, k in zip(self.box, self.step, self.exponent)]
        # A stack of nodes (level, corner, forms), the next one last; a node's children are pushed in reverse.
        forms = [bernstein(g, whole) for g in self.reduced]
        stack = [(max(self.exponent), [0] * self.dimension, forms, whole, 1)]
        reasons_used = set()
        while stack:
            node = stack.pop()
            need(position < len(self.tree), "the tree ends early")
            symbol = self.tree[position]
            position += 1
            if symbol == "s":
                stack.extend(reversed(self.children(*node)))
            elif symbol == "c":
                self.critical.prove(None, node[2], node[3], node[4])
                self.counts["empty"] += self.cells(node) if node[0] >= 0 else 0
            elif symbol in "0123456789":
                need(node[0] >= 0 and int(symbol) < len(self.reasons), "an unknown leaf out of place")
                reasons_used.add(symbol)
                self.counts["unknown"] += self.cells(node)
            else:
                self.check_leaf(symbol, *node)
        need(position == len(self.tree), "the tree goes on after its end")
        need(next(self.critical.entries, None) is None, "an entry of critical is left over")
        need(self.used == len(self.witnesses), "a witness is left over")
        need(len(reasons_used) == len(self.reasons), "a reason is left over")
        need(self.counts == self.claimed, "the counts differ")

    def children(self, level, corner, forms, box, depth):
        if level == 0:
            self.counts["empty"] += 1  # only e or c can follow, which proves it
        need(level > -1000, "the tree is too deep")
        nodes = [(corner, forms, box)]
        for axis in range(self.dimension):  # bit 0 varies fastest, so it is split first and interleaved last
            if level > self.exponent[axis] and level >= 1:
                continue
            half = 2 ** (level - 1) if level >= 1 else 0
            middle = sum(box[axis]) / 2
            lower, upper = [], []
            for c, fs, b in nodes:
                pairs = [f.halves(axis) for f in fs]
                lower.append((c, [p[0] for p in pairs], b[:axis] + [(b[axis][0], middle)] + b[axis + 1:]))
                if c[axis] + half < self.resolution[axis]:
                    upper.append((c[:axis] + [c[axis] + half] + c[axis + 1:], [p[1] for p in pairs],
                                  b[:axis] + [(middle, b[axis][1])] + b[axis + 1:]))
            nodes = lower + upper
        return [(level - 1, c, fs, b, depth + 1) for c, fs, b in nodes]

    def check_leaf(self, symbol, level, corner, forms, cell, _):
        where = "cell %s level %d: " % (corner, level)
        if symbol == "e":
            need(any(f.excludes_zero() for f in forms), where + "not excluded")
            self.counts["empty"] += self.cells((level, corner)) if level >= 0 else 0
            return
        need(symbol in "hw" and level == 0, where + "a character out of place")
        self.counts["hit"] += 1
        if symbol == "h":
            need(len(forms) == 1 and forms[0].corners_show_zero(), where + "the corners show no zero")
            return
        need(self.used < len(self.witnesses), where + "no witness left")
        witness = self.witnesses[self.used]
        self.used += 1
        need(type(witness) is dict and len(witness) == 1, where + "a witness has one key")
        (kind, value), = witness.items()
        need(kind in WITNESSES, where + "an unknown kind of witness")
        try:
            WITNESSES[kind](value, self.reduced, cell)
        except Rejected as error:
            raise Rejected(where + str(error)) from None

    def cells(self, node):
        level, corner = node[:2]
        return math.prod(min(2 ** min(level, k), n - c) for k, n, c in zip(self.exponent, self.resolution, corner))


def check(data):
    certificate = Certificate(read_json(unpack(data)))
    certificate.check()
    counts = certificate.claimed
    return "accepted: %d cells, %d empty, %d hit, %d unknown" % (
        sum(counts.values()), counts["empty"], counts["hit"], counts["unknown"])


def main(paths):
    if not paths:
        sys.stderr.write(__doc__)
        return 2
    sys.setrecursionlimit(20000)
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    status = 0
    for path in paths:
        try:
            with open(path, "rb") as file:
                print(check(file.read()))
        except Rejected as error:
            print("rejected: " + re.sub(r"[^ -~]", "?", str(error)))
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
