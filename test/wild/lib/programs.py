# SPDX-License-Identifier: LGPL-3.0-or-later
"""The programs under audit and their cases, as program.toml says; their packages."""
import dataclasses
import fractions
import json
import os
import pathlib
import shutil
import subprocess
import tomllib

WILD = pathlib.Path(__file__).parents[1]


@dataclasses.dataclass(frozen=True, kw_only=True)
class Problem:
    name: str = "control"
    polynomial: str  # as corral reads it
    expression: str = ""  # in the language of the program, where that differs
    box: str
    resolution: str

    @property
    def sides(self):
        return [tuple(map(fractions.Fraction, side.split(":"))) for side in self.box.split(",")]

    @property
    def counts(self):
        counts = [int(count) for count in self.resolution.split(",")]
        return counts * len(self.sides) if len(counts) == 1 else counts


@dataclasses.dataclass(frozen=True, kw_only=True)
class Case(Problem):
    loss: str  # what a user misses
    witness: dict  # points as "x,y" with the sign of the polynomial there
    lost: int
    lost_far: int
    features: int
    features_lost: int
    false: int
    false_far: int
    window: tuple = ()  # of the picture, in cells: low and high for each of its axes
    slice: tuple = ()  # of the picture in space: axis and index


@dataclasses.dataclass(frozen=True)
class Program:
    folder: pathlib.Path
    title: str
    promise: str  # of the program to its users, and what became of it
    control: Problem  # an ellipse or ellipsoid of no symmetry, which the program must not lose
    cases: list
    debian: list = dataclasses.field(default_factory=list)
    npm: list = dataclasses.field(default_factory=list)  # name@version

    @property
    def version(self):
        """Of the first package."""
        if self.npm:
            return self.npm[0].rpartition("@")[2]
        return _debian_version(self.debian[0]).partition("-")[0].partition("+")[0].rpartition(":")[2]

    def missing(self, node_modules):
        """The names of the packages that are not there."""
        return ([name for name in self.debian if not _debian_version(name)]
                + [package for package in self.npm if not _has_package(node_modules, *package.rsplit("@", 1))])

    def draw(self, problem, folder, node_modules):
        """Runs the program, which leaves shapes.csv in the folder."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        ends = [end for side in problem.sides for end in side]
        box = " ".join(str(end if end.denominator == 1 else float(end)) for end in ends)
        resolution = " ".join(map(str, problem.counts))
        command = [self.folder / "draw", problem.expression or problem.polynomial, box, resolution, folder]
        environment = {**os.environ, "NODE_PATH": str(node_modules)}
        with open(folder / "log", "w", encoding="utf-8") as log:
            subprocess.run(command, check=True, cwd=folder, stdout=log, stderr=log, timeout=600, env=environment)


def read_programs(names):
    known = {path.parent.name: path for path in sorted(WILD.glob("*/program.toml"))}
    if unknown := set(names) - set(known):
        raise ValueError(f"given {', '.join(sorted(unknown))}; expected some of {', '.join(known)}")
    return [_read(known[name]) for name in names or known]


def install(programs, node_modules):
    """Asks apt-get and npm for what is missing; what they cannot give stays missing."""
    missing = [package for program in programs for package in program.missing(node_modules)]
    as_root = [] if os.geteuid() == 0 else ["sudo"]
    if debian := sorted({name for name in missing if "@" not in name}):
        apt = [*as_root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "--quiet", "--yes"]
        subprocess.run([*apt, "update"])
        for name in debian:
            subprocess.run([*apt, "install", "--no-install-recommends", name])
    if npm := sorted({name for name in missing if "@" in name}):
        node_modules.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", node_modules.parent, *npm])


def _read(path):
    with open(path, "rb") as text:
        values = tomllib.load(text)
    cases = [Case(**case) for case in values.pop("case")]
    return Program(path.parent, control=Problem(**values.pop("control")), cases=cases, **values)


def _has_package(node_modules, name, version):
    description = node_modules / name / "package.json"
    return description.exists() and json.loads(description.read_text(encoding="utf-8"))["version"] == version


def _debian_version(name):
    query = ["dpkg-query", "--show", "--showformat=${db:Status-Status} ${Version}", name]
    status, _, version = subprocess.run(query, capture_output=True, text=True).stdout.partition(" ")
    return version if status == "installed" else ""
