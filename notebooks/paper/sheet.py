"""Sheets of images: panels at exact places, texts that are measured before they are set."""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from paper.style import FONTS, INK, MIST, PAPER

# Images are made for a grid of 200 pixels an inch, so that a line one pixel wide has a third of a
# point on paper; PNGs of 400 take each as two by two.
GRID_DPI = 200
_PT = GRID_DPI / 72


def text_width_px(text, size_pt, weight="normal"):
    """Width of a text on the grid."""
    font = FontProperties(family=FONTS, weight=weight)
    return TextPath((0, 0), text, size=size_pt, prop=font).get_extents().width * _PT \
        if text.strip() else 0


def wrapped_name(name, size_pt, width_px):
    """The name in as few lines as fit into the width, broken behind "_" or where it must be."""
    parts = [part for part in name.replace("_", "_\0").replace(" ", " \0").split("\0") if part]
    lines = [""]
    for part in parts:
        if lines[-1] and text_width_px(lines[-1] + part, size_pt) > width_px:
            lines.append("")
        lines[-1] += part
    out = []
    for line in lines:
        while text_width_px(line, size_pt) > width_px and len(line) > 4:
            cut = len(line) - 1
            while cut > 3 and text_width_px(line[:cut] + "-", size_pt) > width_px:
                cut -= 1
            out.append(line[:cut] + "-")
            line = line[cut:]
        out.append(line.rstrip())
    return out


def colours_of(table):
    """A list of colours, one a code, as an array to index with codes."""
    return np.array([[round(255 * part) for part in to_rgb(colour)] for colour in table],
                    dtype=np.uint8)


def ink_table(colour):
    """The colour on paper by its share of a pixel, 0..255, mixed in linear light as
    `src/shade/compose.cpp` does."""
    paper, ink = np.array([to_rgb(PAPER), to_rgb(colour)])
    light = [np.where(of <= 0.04045, of / 12.92, ((of + 0.055) / 1.055) ** 2.4) for of in (paper, ink)]
    mixed = light[0] + np.linspace(0, 1, 256)[:, None] * (light[1] - light[0])
    value = np.where(mixed <= 0.0031308, 12.92 * mixed, 1.055 * mixed ** (1 / 2.4) - 0.055)
    return np.rint(255 * value).astype(np.uint8)


class Sheet:
    """A figure that is filled from the top in pixels of the grid, origin at the top left.

    Nothing is drawn until `figure()`: only then the height is known.
    """

    def __init__(self, style):
        self.style = style
        self.width_px = style.width_in * GRID_DPI
        self.height_px = 0
        self._jobs = []

    def line_px(self, size_pt=None):
        """Height of a line of text."""
        return math.ceil(1.25 * (size_pt or self.style.small_pt) * _PT)

    def _reach(self, bottom_px):
        self.height_px = max(self.height_px, math.ceil(bottom_px))

    def text(self, x_px, y_px, text, size_pt=None, weight="normal", colour=INK, align="left"):
        """A line of text whose top is at y_px."""
        size = size_pt or self.style.small_pt
        self._reach(y_px + self.line_px(size))

        def draw(figure, at):
            x, y = at(x_px, y_px + 1.0 * size * _PT)
            figure.text(x, y, text, fontsize=size, fontweight=weight, color=colour, ha=align,
                        va="baseline")
        self._jobs.append(draw)

    def turned_text(self, x_px, y_px, text, size_pt=None):
        """A line of text that runs upwards, its middle at (x_px, y_px)."""
        size = size_pt or self.style.font_pt

        def draw(figure, at):
            x, y = at(x_px, y_px)
            figure.text(x, y, text, fontsize=size, color=INK, ha="center", va="center",
                        rotation=90)
        self._jobs.append(draw)

    def image(self, x_px, y_px, size_px, colours, after=None):
        """What `colours()` gives (height, width, 3) in a frame of size_px; `after(ax)` draws over it,
        in pixels of the image."""
        self._reach(y_px + size_px[1] + 1)

        def draw(figure, at):
            coarse = colours()
            height, width = coarse.shape[:2]
            repeat = max(1, -(-2 * size_px[0] // width))
            fine = np.repeat(np.repeat(coarse, repeat, axis=0), repeat, axis=1)
            x0, y0 = at(x_px, y_px + size_px[1])
            x1, y1 = at(x_px + size_px[0], y_px)
            ax = figure.add_axes((x0, y0, x1 - x0, y1 - y0))
            ax.set_in_layout(False)
            ax.imshow(fine, interpolation="none", extent=(0, width, height, 0), aspect="auto")
            ax.set_xlim(0, width)
            ax.set_ylim(height, 0)
            ax.set_xticks([])
            ax.set_yticks([])
            ax.grid(visible=False)
            for spine in ax.spines.values():
                spine.set(visible=True, color=MIST, linewidth=0.5)
            if after is not None:
                after(ax)
        self._jobs.append(draw)

    def key(self, entries, gap_px=None):
        """A legend in lines as wide as the sheet: (label, colour, is_outline) each."""
        style, x, top = self.style, 0, self.height_px + (gap_px or 2 * _PT)
        box = 0.75 * style.small_pt * _PT
        for label, colour, is_outline in entries:
            width = 1.5 * box + text_width_px(label, style.small_pt) + 1.6 * box
            if x > 0 and x + width - 1.6 * box > self.width_px:
                x, top = 0, top + self.line_px()
            self._swatch(x, top + 0.3 * style.small_pt * _PT, box, colour, is_outline)
            self.text(x + 1.5 * box, top, label)
            x += width
        self._reach(self.height_px + _PT)

    def _swatch(self, x_px, y_px, size_px, colour, is_outline):
        def draw(figure, at):
            x0, y0 = at(x_px + 1, y_px + size_px)
            x1, y1 = at(x_px + 1 + size_px, y_px)
            figure.add_artist(plt.Rectangle(
                (x0, y0), x1 - x0, y1 - y0, transform=figure.transFigure,
                facecolor="none" if is_outline else colour, edgecolor=colour,
                linewidth=0.7 if is_outline else 0))
        self._jobs.append(draw)

    def figure(self):
        """The figure with all that was put on the sheet."""
        self.style.use()
        height = max(1, self.height_px)
        figure = plt.figure(figsize=(self.style.width_in, height / GRID_DPI))

        def at(x_px, y_px):
            return x_px / self.width_px, 1 - y_px / height

        for job in self._jobs:
            job(figure, at)
        return figure
