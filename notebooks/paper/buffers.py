"""What methods have inside: packed codes and what the filter leaves of them, depth and normals."""

import hashlib
from functools import partial

import numpy as np

from paper import images
from paper.chart import Chart, Nothing
from paper.runs import file_name
from paper.sheet import GRID_DPI, Sheet, wrapped_name
from paper.style import MM_PER_IN

_LEAST_PANEL_MM = 26
_GAP_PX = 6
_LAYERS = [("packed", "filtered"), ("depth", "normal")]


def buffers(runs, style):
    """A chart a scene: each method's two buffers below each other, equal ones shown once.

    Raises Nothing if the run kept no buffers.
    """
    views = images.shown_views(runs, 1)
    charts = []
    for view in views:
        columns = _columns_of(view)
        if columns:
            charts.append(_chart(view, columns, style, runs, len(views) > 1))
    if not charts:
        raise Nothing("no method of the run has a packed or a full buffer, or the run is older than "
                      "images of buffers")
    return charts


def _columns_of(view):
    """(names of methods, names of layers, files) of each pair of layers; equal pairs once."""
    columns = {}
    for drawing in view.drawings:
        for pair in _LAYERS:
            files = [view.folder / f"{file_name(drawing.method)}.layer_{layer}.png"
                     for layer in pair]
            there = [(layer, file) for layer, file in zip(pair, files) if file.is_file()]
            if there:
                content = b"".join(file.read_bytes() for _, file in there)
                spot = hashlib.sha256(content).digest()
                columns.setdefault(spot, ([], there))[0].append(drawing.method)
    return list(columns.values())


def _chart(view, columns, style, runs, is_one_of_many):
    sheet = Sheet(style)
    most = max(1, int(sheet.width_px / (_LEAST_PANEL_MM / MM_PER_IN * GRID_DPI + _GAP_PX)))
    rows = -(-len(columns) // most)
    across = -(-len(columns) // rows)
    panel = int((sheet.width_px - (across - 1) * _GAP_PX - 1) // across)
    x, y, w, h = images.bounds(view)
    size = (panel, max(8, round(panel * h / w)))
    shared = []
    for row in range(rows):
        part = columns[row * across:(row + 1) * across]
        names = [wrapped_name(_title(methods), style.font_pt, panel) for methods, _ in part]
        top = sheet.height_px + (2 * _GAP_PX if row else 0)
        lines = max(len(name) for name in names)
        for i, ((methods, layers), name) in enumerate(zip(part, names)):
            left = i * (panel + _GAP_PX)
            at = top + (lines - len(name)) * sheet.line_px(style.font_pt)
            for text in name:
                sheet.text(left, at, text, style.font_pt)
                at += sheet.line_px(style.font_pt)
            at += 2
            for layer, file in layers:
                sheet.image(left, at, size, partial(_part_of, view, file, (x, y, w, h), size))
                at += size[1]
                sheet.text(left, at, layer)
                at += sheet.line_px() + 2
            if len(methods) > 1:
                shared.append(", ".join(methods))
    caption = (
        f"What methods have inside on {view.scene}, {view.name} ({view.labels.shape[1]}x"
        f"{view.labels.shape[0]} px, cropped to the lines): the packed codes and what the filter "
        "leaves of them (middle grey: the threshold), or depth (near is bright) and the normal in "
        "view space (-1..1 as dark..bright, x red, y green, z blue). "
        + (f"Equal buffers are shown once: {'; '.join(shared)}. " if shared else "")
        + f"Images: `images/` of the run {runs.folders[0].name}.")
    return Chart(sheet.figure(), caption, [], file_name(view.title) if is_one_of_many else "")


def _part_of(view, file, part, size):
    """The part (x, y, width, height) of a layer as colours of that size."""
    x, y, w, h = part
    image = images.read_image(file, view.labels.shape)
    if image.ndim == 2:
        image = np.repeat(image[:, :, None], 3, axis=2)
    return images.averaged(image[y:y + h, x:x + w], size)


def _title(methods):
    return methods[0] if len(methods) == 1 else f"{methods[0]} +{len(methods) - 1}"
