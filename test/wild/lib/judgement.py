# SPDX-License-Identifier: LGPL-3.0-or-later
"""What `corral audit raster` says of a raster, and which of the losses are of whole features."""
import dataclasses
import itertools
import json
import shlex
import subprocess

from raster import read_cells


@dataclasses.dataclass
class Judgement:
    plotted: set
    lost: set  # hit, not plotted
    false: set  # plotted, empty

    @property
    def hit(self):
        return (self.plotted - self.false) | self.lost

    @property
    def lost_far(self):
        """Lost cells with no plotted cell beside them: not the error of a chord or of a pen."""
        return self.lost - _thickened(self.plotted)

    @property
    def false_far(self):
        return self.false - _thickened(self.hit)

    @property
    def features(self):
        return connected_parts(self.hit)

    @property
    def features_lost(self):
        lost_far = self.lost_far
        return [feature for feature in self.features if feature <= lost_far]


def connected_parts(cells):
    """The connected sets of cells; cells that share a corner are connected."""
    rest, parts = set(cells), []
    while rest:
        part, front = set(), {rest.pop()}
        while front:
            part |= front
            front = {cell for known in front for cell in _block(known) if cell in rest}
            rest -= front
        parts.append(part)
    return parts


def judge(corral, polynomial, box, resolution, cells):
    """Judges a table of cells."""
    command = [corral, "audit", "raster", polynomial, "--box", box, "--resolution", resolution, "--cells", cells,
               "--format", "json"]
    audit = subprocess.run(command, capture_output=True, text=True)
    if audit.returncode not in (0, 1) or not audit.stdout:
        raise RuntimeError(f"{shlex.join(map(str, command))}: {audit.stderr.strip()}")
    report = json.loads(audit.stdout)
    if report["not_judged"]:
        raise RuntimeError(f"{polynomial}: {report['not_judged']} cells could not be judged")
    lost, false = ({tuple(entry["cell"]) for entry in report[name]} for name in ("lost_cells", "false_cells"))
    return Judgement(read_cells(cells), lost, false)


def _block(cell):
    return itertools.product(*((i - 1, i, i + 1) for i in cell))


def _thickened(cells):
    return {neighbour for cell in cells for neighbour in _block(cell)}
