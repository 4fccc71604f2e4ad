"""Polylines as pixels, for engines that give lines and no image."""

import numpy

STEP_PX = 0.25


def draw_polyline(points, image):
    """Every pixel that holds one of a row of samples along the polyline."""
    height, width = image.shape
    for a, b in zip(points[:-1], points[1:]):
        steps = 2 + int(min(numpy.abs(b - a).max(), 1e5) / STEP_PX)
        p = numpy.floor(a + numpy.linspace(0, 1, steps)[:, None] * (b - a)).astype(int)
        p = p[((p >= 0) & (p < (width, height))).all(axis=1)]
        image[p[:, 1], p[:, 0]] = 255
