# SPDX-License-Identifier: LGPL-3.0-or-later
"""A picture of what a program drew beside the exact raster, where lost cells are red. Needs python3-pil."""
from PIL import Image, ImageDraw
from judgement import connected_parts

SIDE = 320  # pixels of a panel
GAP = 12
CAPTION = 18
INK, LOST, PAPER, FRAME = (0, 0, 0), (220, 20, 20), (255, 255, 255), (160, 160, 160)
MOST_RINGS = 4  # more would hide the picture


def write(path, program, case, folder, judgement):
    panels = [_own_picture(folder) or _panel(case, [(judgement.plotted, INK)]),
              _ringed(_panel(case, [(judgement.hit, INK), (judgement.lost, LOST)]), case, judgement)]
    sheet = Image.new("RGB", (2 * SIDE + GAP + 4, SIDE + CAPTION + 2), PAPER)
    text = ImageDraw.Draw(sheet)
    titles = (f"{program.title} {program.version}", "exact; lost cells red")
    for panel, title, left in zip(panels, titles, (2, SIDE + GAP + 2)):
        text.text((left, 2), title, fill=INK)
        text.rectangle((left - 2, CAPTION - 2, left + SIDE + 1, CAPTION + SIDE + 1), outline=FRAME)
        sheet.paste(panel, (left, CAPTION))
    sheet.quantize(16).save(path, optimize=True)


def _own_picture(folder):
    path = folder / "picture.png"
    return Image.open(path).convert("RGB").resize((SIDE, SIDE)) if path.exists() else None


def _panel(case, layers):
    """Each pixel has the colour of the last layer with a cell in it; in space, of one slice of cells."""
    image = Image.new("RGB", (SIDE, SIDE), PAPER)
    draw = ImageDraw.Draw(image)
    for cells, colour in layers:
        for cell in _in_plane(case, cells):
            (left, top), (right, bottom) = _pixel(case, cell, (0, 1)), _pixel(case, cell, (1, 0))
            draw.rectangle((left, top, max(left, right - 1), max(top, bottom - 1)), fill=colour)
    return image


def _ringed(image, case, judgement):
    """Rings around small clusters of lost cells, which one would not see."""
    draw = ImageDraw.Draw(image)
    clusters = connected_parts(set(_in_plane(case, judgement.lost_far or judgement.lost)))
    for cluster in clusters if len(clusters) <= MOST_RINGS else ():
        corners = [_pixel(case, cell, offset) for cell in cluster for offset in ((0, 0), (1, 1))]
        (left, right), (top, bottom) = ((min(side), max(side)) for side in zip(*corners))
        if max(right - left, bottom - top) < SIDE / 12:
            x, y, radius = (left + right) / 2, (top + bottom) / 2, SIDE / 20
            draw.ellipse((x - radius, y - radius, x + radius, y + radius), outline=LOST, width=2)
    return image


def _in_plane(case, cells):
    """The cells as pairs of indices; of three, those of case.slice = [axis, index]."""
    if len(case.counts) == 2:
        return cells
    axis, index = case.slice
    return {cell[:axis] + cell[axis + 1:] for cell in cells if cell[axis] == index}


def _pixel(case, cell, offset):
    """The pixel of the cell's corner at `offset`, rows downwards."""
    window = case.window or [(0, count) for axis, count in enumerate(case.counts)
                             if len(case.counts) == 2 or axis != case.slice[0]]
    (left, right), (low, high) = window
    return (int((cell[0] + offset[0] - left) * SIDE / (right - left)),
            int((high - cell[1] - offset[1]) * SIDE / (high - low)))
