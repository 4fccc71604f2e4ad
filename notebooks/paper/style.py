"""How figures look: the measures of a column of a paper, fonts, colours, the marks of methods.

A family of methods has a colour, a method of it a marker, both as the run's methods.csv says; a
preset is its method's, hollow.
"""

import logging
import re
from dataclasses import dataclass, field

import matplotlib
import pandas as pd
from matplotlib.colors import to_hex, to_rgb

from paper.runs import BASELINES, VOCABULARY, BadInput

MM_PER_IN = 25.4
PT_PER_IN = 72

# Colours are chosen by numbers, which a test holds: each has a contrast of 3 or more on white, so
# that lines a pixel wide survive, and those that stand in one figure keep apart in CIE L*a*b* for
# normal sight and for all three kinds of dichromatic sight (Machado, Oliveira and Fernandes 2009).
INK, FAINT, MIST, PAPER = "#20242a", "#5b6470", "#cdd1d6", "#ffffff"
CLASS_COLOURS = {each["name"]: each["figure"] for each in VOCABULARY["classes"]}
# Of differing lightness too, so that they are told apart in grey: drawn 14, false 33, missing 55.
MISSING, FALSE = VOCABULARY["marks"]["missing"], VOCABULARY["marks"]["false"]

# A family in methods.csv: its word in legends, and its colour.
FAMILIES = {each["name"]: (each["short"], each["figure"]) for each in VOCABULARY["families"]}
OTHERS = FAMILIES["other"][0]
# A marker there, and what Matplotlib calls it; within a family methods stand in this order.
SHAPES = {each["name"]: each["matplotlib"] for each in VOCABULARY["markers"]}
MARKERS = list(SHAPES.values())
_DASHES = ["-", (0, (4, 1.2)), (0, (1.2, 1.2)), (0, (5, 1.2, 1.2, 1.2)), (0, (2.5, 1))]

# The first that is there sets the text; the others have the same widths, for whoever opens an SVG
# elsewhere.
FONTS = ["Liberation Sans", "Arial", "Helvetica", "Nimbus Sans", "DejaVu Sans"]

# It warns of each font that is not there.
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)

_UNITS_PER_IN = {"mm": MM_PER_IN, "cm": MM_PER_IN / 10, "in": 1.0, "pt": PT_PER_IN}
_LEAST_WIDTH_IN, _MOST_WIDTH_IN = 40 / MM_PER_IN, 1000 / MM_PER_IN


def length_in(text, where="--width"):
    """A length such as 84mm, 8.4cm, 3.3in or 240pt, in inches; BadInput for anything else."""
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?|\.[0-9]+)\s*(mm|cm|in|pt)", text.strip())
    width_in = float(match[1]) / _UNITS_PER_IN[match[2]] if match else 0
    if not match or not _LEAST_WIDTH_IN - 1e-9 <= width_in <= _MOST_WIDTH_IN + 1e-9:
        raise BadInput(where, f"'{text}' is no width of a figure",
                       "40mm to 1000mm, in mm, cm, in or pt, as 84mm")
    return width_in


def mixed(colour, towards, share):
    """`colour` with `share` (0..1) of `towards` in it."""
    return to_hex([a + share * (b - a) for a, b in zip(to_rgb(colour), to_rgb(towards))])


@dataclass
class Style:
    """The measures of a figure, and how methods look in it.

    width_in: of the whole figure, kept exactly. font_pt: of names and numbers; nothing is smaller
    than 1 pt less. registry: methods.csv by method (Runs.registry). windows: of zoomed parts,
    (x, y, width, height) in pixels; none: the window of most difference.
    """

    width_in: float = 178 / MM_PER_IN
    font_pt: float = 8
    registry: pd.DataFrame = field(default_factory=lambda: pd.DataFrame(
        columns=["family", "marker", "preset_of"]))
    windows: list = field(default_factory=list)

    def __post_init__(self):
        self.small_pt = self.font_pt - 1
        # Marks and lines grow with the text, as on a poster.
        self.scale = self.font_pt / 8

    def columns(self, least_mm, most):
        """How many panels at least so wide stand beside each other, at most `most`."""
        return max(1, min(most, int(self.width_in * MM_PER_IN / least_mm)))

    def rc(self):
        """Settings of matplotlib for these measures."""
        s = self.scale
        return {
            "font.family": "sans-serif", "font.sans-serif": FONTS, "font.size": self.font_pt,
            "axes.titlesize": self.font_pt, "axes.labelsize": self.font_pt,
            "xtick.labelsize": self.small_pt, "ytick.labelsize": self.small_pt,
            "legend.fontsize": self.small_pt, "figure.titlesize": self.font_pt,
            "figure.labelsize": self.font_pt,
            "legend.frameon": False, "text.hinting": "none", "text.color": INK,
            "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": FAINT,
            "axes.linewidth": 0.6 * s, "axes.labelcolor": INK, "axes.titlelocation": "left",
            "xtick.color": FAINT, "ytick.color": FAINT, "xtick.labelcolor": INK,
            "ytick.labelcolor": INK, "xtick.major.width": 0.6 * s, "ytick.major.width": 0.6 * s,
            "axes.grid": True, "grid.color": "#e8eaed", "grid.linewidth": 0.6 * s,
            "axes.axisbelow": True, "lines.linewidth": 1.2 * s, "lines.markersize": 4 * s,
            "figure.dpi": 72, "savefig.dpi": 400,
            "figure.facecolor": PAPER, "svg.fonttype": "none", "svg.hashsalt": "inkbench",
            "pdf.fonttype": 42, "ps.fonttype": 42, "axes.unicode_minus": True,
        }

    def use(self):
        """Makes matplotlib draw so from now on."""
        matplotlib.rcParams.update(self.rc())

    def _fact(self, method, column):
        """A field of methods.csv; "" for a method that no run lists."""
        known = self.registry
        return known.at[method, column] if method in known.index and column in known else ""

    def base(self, method):
        """The method whose settings a preset changes; else the method itself."""
        return self._fact(method, "preset_of") or method.removesuffix("_tuned")

    def _family(self, method):
        name = self._fact(method, "family") or self._fact(self.base(method), "family")
        return name if name in FAMILIES else "other"

    def _place(self, method):
        """Where the method stands in its family, by its marker."""
        marker = self._fact(method, "marker") or self._fact(self.base(method), "marker")
        return list(SHAPES).index(marker) if marker in SHAPES else 0

    def family(self, method):
        """The word for the method's family in legends."""
        return FAMILIES[self._family(method)][0]

    def colour(self, method):
        """The colour of the method's family."""
        return FAINT if method in BASELINES else FAMILIES[self._family(method)][1]

    def text_colour(self, method):
        """The same, dark enough for small text."""
        return mixed(self.colour(method), INK, 0.4)

    def shade(self, method):
        """The method's own, darker or lighter, so that neighbours in a family differ in grey."""
        towards, share = [(INK, 0), (INK, 0.6), (PAPER, 0.3), (INK, 0.3), (PAPER, 0.15)][
            self._place(method) % 5]
        return mixed(self.colour(method), towards, share)

    def is_outside(self, method):
        """Whether its images come from elsewhere and its times are by its own clock."""
        return self._fact(method, "role") == "entrant"

    def look(self, method, is_shaded=False):
        """Keywords of `plot` that tell a method from others; shaded where a family has a panel."""
        tone = self.shade(method) if is_shaded else self.colour(method)
        hollow = self.base(method) != method
        dashes = _DASHES[self._place(method) % len(_DASHES)] if is_shaded else "-"
        return {"color": tone, "marker": MARKERS[self._place(method)],
                "markerfacecolor": PAPER if hollow else tone, "markeredgewidth": 0.9 * self.scale,
                "linestyle": "--" if hollow and not is_shaded else dashes}

    def by_family(self, methods):
        """The methods (no baselines) in the order of families, presets behind their own."""
        methods = [m for m in dict.fromkeys(methods) if m not in BASELINES]
        order = list(FAMILIES)
        return sorted(methods, key=lambda m: (order.index(self._family(m)), self._place(m),
                                              self.base(m), self.base(m) != m))

    def families_of(self, methods):
        """Family -> its methods, in order, families without one left out."""
        groups = {}
        for method in self.by_family(methods):
            groups.setdefault(self.family(method), []).append(method)
        return groups

