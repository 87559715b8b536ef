#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""No files go round in a circle by their includes. A header and the source of its name count as one.
usage: check_cycles.py PROJECT_FOLDER [KNOWN...]   a circle of KNOWN files alone is allowed"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)


def node_of(path):
    """include/corral/a/B.h and src/a/B.cpp are one; so is include/corral/internal/a/B.h."""
    return re.sub(r"^(include/corral/internal|include/corral|src)/", "", str(path.with_suffix("")))


def edges_of(project):
    """What each node includes of the others."""
    edges = {}
    for folder in ("include/corral", "src"):
        for path in sorted((project / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            inside = path.relative_to(project)
            included = edges.setdefault(node_of(inside), set())
            for kind, name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                target = pathlib.Path(name)
                if kind == '"':
                    beside = (path.parent / name).resolve()
                    if not beside.exists():
                        continue
                    target = beside.relative_to(project.resolve())
                elif target.parts[0] != "corral":
                    continue
                else:
                    target = pathlib.Path("include") / target
                included.add(node_of(target))
            included.discard(node_of(inside))
    return edges


def circles(edges):
    """The strongly connected components with more than one node (Tarjan 1972)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in edges.get(node, ()):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            cut = stack.index(node)
            if len(stack) - cut > 1:
                found.append(sorted(stack[cut:]))
            del stack[cut:]

    sys.setrecursionlimit(10000)
    for node in edges:
        if node not in index:
            visit(node)
    return found


def main():
    known = set(sys.argv[2:])
    found = circles(edges_of(pathlib.Path(sys.argv[1])))
    gone = known.difference(*found)
    if gone:
        print("No longer in a circle, and to be called known no more: " + ", ".join(sorted(gone)))
        return 1
    found = [circle for circle in found if not known.issuperset(circle)]
    for circle in found:
        print("These files go round in a circle: " + ", ".join(circle))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
