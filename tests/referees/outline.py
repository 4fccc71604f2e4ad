"""The visible lines of a truth, as the program's SVG has them."""

import re
from dataclasses import dataclass

import numpy as np

CLASSES = ("none", "contour", "boundary", "crease", "intersection", "seam")


@dataclass
class Outline:
    """Straight pieces of lines on the image: (n, 2, 2) px, and the class (n,) of each."""

    pieces: np.ndarray
    classes: np.ndarray

    def lengths_px(self):
        return np.linalg.norm(self.pieces[:, 1] - self.pieces[:, 0], axis=1)

    def length_px(self, line_class=None):
        """Of all, or of the class with this number."""
        kept = slice(None) if line_class is None else self.classes == line_class
        return float(self.lengths_px()[kept].sum())

    def samples(self, step_px):
        """Places along the lines, each in the middle of a stretch of at most `step_px`.

        Returns (n, 2) px, the piece of each, and the length in px that it stands for.
        """
        counts = np.maximum(1, np.ceil(self.lengths_px() / step_px).astype(int))
        piece = np.repeat(np.arange(len(counts)), counts)
        nth = np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts)
        t = ((nth + 0.5) / counts[piece])[:, None]
        places = self.pieces[piece, 0] * (1 - t) + self.pieces[piece, 1] * t
        return places, piece, self.lengths_px()[piece] / counts[piece]

    def mirrored(self, width_px):
        pieces = self.pieces.copy()
        pieces[..., 0] = width_px - pieces[..., 0]
        return Outline(pieces, self.classes)

    def of_class(self, line_class):
        kept = self.classes == line_class
        return Outline(self.pieces[kept], self.classes[kept])


def make_outline(polylines):
    """From (class, [(x, y), ...]) pairs; points alone make no piece."""
    pieces, classes = [], []
    for line_class, points in polylines:
        for a, b in zip(points, points[1:]):
            pieces.append((a, b))
            classes.append(line_class)
    return Outline(np.array(pieces, float).reshape(-1, 2, 2), np.array(classes, int))


def read_outline(path):
    """The outline in an SVG that `inkbench truth --svg` wrote."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    polylines, line_class = [], 0
    for match in re.finditer(r'<g data-class="(\w+)"|<polyline points="([^"]*)"', text):
        if match[1]:
            line_class = CLASSES.index(match[1])
        else:
            points = [tuple(map(float, p.split(","))) for p in match[2].split()]
            polylines.append((line_class, points))
    return make_outline(polylines)


def distances_px(places, outline, most_px):
    """How far each place lies from the nearest line, infinity beyond `most_px`; and which piece."""
    nearest = np.full(len(places), np.inf)
    piece = np.full(len(places), -1)
    if len(places) == 0 or len(outline.pieces) == 0:
        return nearest, piece
    cell_px = max(8.0, 2 * most_px)
    cells = {}
    for i, (a, b) in enumerate(outline.pieces):
        low = np.floor((np.minimum(a, b) - most_px) / cell_px).astype(int)
        high = np.floor((np.maximum(a, b) + most_px) / cell_px).astype(int)
        for x in range(low[0], high[0] + 1):
            for y in range(low[1], high[1] + 1):
                cells.setdefault((x, y), []).append(i)
    keys = np.floor(places / cell_px).astype(int)
    order = np.lexsort(keys.T)
    starts = np.flatnonzero(np.r_[True, np.any(np.diff(keys[order], axis=0) != 0, axis=1)])
    for begin, end in zip(starts, np.r_[starts[1:], len(order)]):
        mine = order[begin:end]
        near = cells.get(tuple(keys[mine[0]]))
        if near is None:
            continue
        a, b = outline.pieces[near, 0], outline.pieces[near, 1]
        along = b - a
        square = np.maximum((along * along).sum(1), 1e-30)
        t = np.clip(((places[mine, None] - a) * along).sum(2) / square, 0, 1)
        d = np.linalg.norm(a + t[..., None] * along - places[mine, None], axis=2)
        best = d.argmin(axis=1)
        nearest[mine] = d[np.arange(len(mine)), best]
        piece[mine] = np.asarray(near)[best]
    nearest[nearest > most_px] = np.inf
    return nearest, piece


def coverage(of, by, most_px=0.25, step_px=0.5, same_class=True):
    """The share of the length of one outline that lies within `most_px` of another: 1 if empty.

    With `same_class`, of the same class there.
    """
    covered = total = 0.0
    for line_class in np.unique(of.classes):
        places, _, length = of.of_class(line_class).samples(step_px)
        other = by.of_class(line_class) if same_class else by
        near, _ = distances_px(places, other, most_px)
        covered += length[np.isfinite(near)].sum()
        total += length.sum()
    return covered / total if total else 1.0
