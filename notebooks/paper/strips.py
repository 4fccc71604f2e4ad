"""Strips: truth and methods beside each other, errors in colour, zoomed windows below."""

from functools import partial

import numpy as np
from matplotlib.collections import LineCollection

from paper import images
from paper.chart import Chart, Nothing
from paper.runs import CLASSES, BadInput, counted, file_name, ms
from paper.sheet import GRID_DPI, Sheet, colours_of, ink_table, text_width_px, wrapped_name
from paper.style import CLASS_COLOURS, FALSE, INK, MISSING, MIST, MM_PER_IN, PAPER

USUAL_SCENES = 4        # of a run with more, evenly taken
_LEAST_PANEL_MM = 19
_MOST_HEIGHT_MM = 235   # a page of a journal; more is a file a scene
_GAP_PX = 6
_HIT_IN_ZOOM = "#8b929b"
_CLASS_RANK = np.array([0, 6, 5, 4, 3, 2, 0, 1])  # contour first; ignore before blank
_CLASS_TABLE = colours_of([PAPER] + [CLASS_COLOURS[c] for c in CLASSES] + [PAPER, MIST])


def mark_table(hit=INK):
    """Colours of images.marks, by code."""
    return colours_of([PAPER, MIST, hit] + [FALSE] * len(images.FALSE_CODES) + [MISSING] * len(images.MISSING_CODES))


def drawn_colours(drawing, codes, response, hit=INK):
    """What a drawing shows where its marks and responses are these: ink is grey wherever it is not wrong."""
    colours = mark_table(hit)[codes]
    if drawing.is_ink:
        is_grey = (codes == images.BLANK) | (codes == images.HIT)
        colours[is_grey] = ink_table(hit)[response[is_grey]]
    return colours


_MARK_RANK = np.arange(images.WRONG + images.MISSING_CODES.stop)


def strips(runs, style):
    """One strip a scene below each other; charts of one scene each where they fill over a page.

    Raises Nothing if the run kept no images.
    """
    views = [view for view in images.shown_views(runs, USUAL_SCENES) if view.drawings]
    if not views:
        raise Nothing("no method has a score on the views of which images were kept")
    whole = _sheet_of(views, style, runs)
    if len(views) == 1 or whole.height_px / GRID_DPI * MM_PER_IN <= _MOST_HEIGHT_MM:
        return [_chart(whole, views, style, runs)]
    charts = []
    for view in views:
        chart = _chart(_sheet_of([view], style, runs), [view], style, runs)
        chart.part = file_name(view.title)
        charts.append(chart)
    return charts


def _chart(sheet, views, style, runs):
    methods = list(dict.fromkeys(d.method for view in views for d in view.drawings))
    height, width = views[0].labels.shape
    windows = "the windows given" if style.windows else \
        "the window in which the methods' errors differ most"
    caption = (
        f"The true outline by class of line, and what {counted(len(methods), 'method')} drew of "
        f"{', '.join(view.title for view in views)} ({width}x{height} px, cropped to the lines), "
        f"missing and false pixels in two colours. Below each: {windows}; grey pixels are drawn and right, outlined ones are true. "
        "In the whole images a wrong pixel is drawn larger than it is, to be seen in print. F at "
        "2 px and the time of a frame are of this view. " + runs.source("rows.csv"))
    if any(drawing.is_ink for view in views for drawing in view.drawings):
        caption += " Ink is as dark as its share of a pixel."
    facts = []
    for view in views:
        best = max(view.drawings, key=lambda d: d.row["f_2px"])
        worst = min(view.drawings, key=lambda d: d.row["f_2px"])
        facts.append(f"{view.scene}, {view.name}: F {worst.row['f_2px']:.3f} ({worst.method}) to "
                     f"{best.row['f_2px']:.3f} ({best.method}); windows x,y,w,h: "
                     + "; ".join(",".join(map(str, w)) for w in _windows(view, style)))
    return Chart(sheet.figure(), caption, facts)


def _windows(view, style):
    """The zoomed windows of a view in pixels; BadInput for one that leaves the image."""
    if not style.windows:
        part = images.bounds(view)
        width = max(20, min(64, part[2] // 8))
        return [images.telling_window(view, part, (width, max(12, round(0.62 * width))))]
    height, width = view.labels.shape
    for x, y, w, h in style.windows:
        if x + w > width or y + h > height:
            raise BadInput("--window", f"{x},{y},{w},{h} leaves the image of {view.scene}",
                           f"x,y,w,h inside {width}x{height} px")
    return list(style.windows)


def _sheet_of(views, style, runs):
    sheet = Sheet(style)
    for i, view in enumerate(views):
        if i:
            sheet.height_px += 2 * _GAP_PX
        _Band(sheet, view, style).draw(is_first=i == 0)
    sheet.height_px += _GAP_PX
    sheet.key(_key_entries(views))
    return sheet


def _key_entries(views):
    classes = np.unique(np.concatenate([np.unique(view.labels) for view in views]))
    entries = [(name, CLASS_COLOURS[name], False)
               for i, name in enumerate(CLASSES) if i + 1 in classes]
    if images.IGNORE in classes:
        entries.append(("does not count", MIST, False))
    return entries + [("drawn, right", INK, False), ("missing", MISSING, False), ("false", FALSE, False),
                      ("true pixel, enlarged", INK, True)]


class _Band:
    """One scene: the truth, then the methods, in as many rows as needed."""

    def __init__(self, sheet, view, style):
        self._sheet, self._view, self._style = sheet, view, style
        self._left = sheet.line_px(style.font_pt) + 2
        count = 1 + len(view.drawings)
        room = sheet.width_px - self._left
        most = max(2, int(room / (_LEAST_PANEL_MM / MM_PER_IN * GRID_DPI + _GAP_PX)))
        self._rows = -(-count // most)
        self._columns = -(-count // self._rows)
        self._panel = int((room - (self._columns - 1) * _GAP_PX - 1) // self._columns)
        self._part = images.bounds(view)
        self._windows = _windows(view, style)
        self._known = {}  # marks by method

    def draw(self, is_first):
        sheet = self._sheet
        top = sheet.height_px
        panels = [None] + self._view.drawings
        for row in range(self._rows):
            if row:
                sheet.height_px += 2 * _GAP_PX
            self._draw_row(panels[row * self._columns:(row + 1) * self._columns],
                           has_names=is_first or self._rows > 1)
        sheet.turned_text(sheet.line_px(self._style.font_pt) / 2, (top + sheet.height_px) / 2,
                          self._view.title)

    def _draw_row(self, panels, has_names):
        sheet, style = self._sheet, self._style
        top = sheet.height_px
        if has_names:
            names = [wrapped_name("truth" if d is None else d.method, style.font_pt, self._panel)
                     for d in panels]
            lines = max(len(name) for name in names)
            for i, name in enumerate(names):
                for j, text in enumerate(name):
                    down = (lines - len(name) + j) * sheet.line_px(style.font_pt)
                    sheet.text(self._x(i), top + down, text, style.font_pt)
            top += lines * sheet.line_px(style.font_pt) + 2
        bottom = top
        for i, drawing in enumerate(panels):
            bottom = max(bottom, self._panel_at(self._x(i), top, drawing))
        for i, drawing in enumerate(panels):
            if drawing is not None:
                self._numbers(self._x(i), bottom + 1, drawing)

    def _x(self, column):
        return self._left + column * (self._panel + _GAP_PX)

    def _panel_at(self, x_px, y_px, drawing):
        """The whole image and its zoomed windows; returns where they end."""
        px, py, pw, ph = self._part
        size = (self._panel, max(8, round(self._panel * ph / pw)))
        self._sheet.image(x_px, y_px, size, partial(self._whole, drawing, size), self._frames)
        y_px += size[1]
        for n, window in enumerate(self._windows):
            y_px = self._zoom_at(x_px, y_px + 3, window, drawing, n)
        return y_px

    def _whole(self, drawing, size):
        """The part of the view that holds lines, as colours of that size."""
        px, py, pw, ph = self._part
        part = np.s_[py:py + ph, px:px + pw]
        if drawing is None:
            return _CLASS_TABLE[images.shrunk(self._view.labels[part], size, _CLASS_RANK)]
        small = images.shrunk(self._marks(drawing)[part], size, _MARK_RANK)
        if pw > 1.2 * size[0]:
            small = _enlarged_errors(small)
        darkest = images.shrunk(drawing.response[part], size, np.arange(256))
        return drawn_colours(drawing, small, darkest)

    def _marks(self, drawing):
        if drawing.method not in self._known:
            self._known[drawing.method] = images.marks(self._view, drawing)
        return self._known[drawing.method]

    def _frames(self, ax):
        """Draws where the windows are."""
        px, py, pw, ph = self._part
        right, low = ax.get_xlim()[1], ax.get_ylim()[0]
        for n, (x, y, w, h) in enumerate(self._windows):
            x0, x1 = (x - px) / pw * right, (x + w - px) / pw * right
            y0, y1 = (y - py) / ph * low, (y + h - py) / ph * low
            for tone, width in ((PAPER, 1.6), (INK, 0.7)):  # apart from the lines it lies on
                ax.plot([x0, x1, x1, x0, x0], [y0, y0, y1, y1, y0], color=tone, linewidth=width)
            if len(self._windows) > 1:
                ax.text(x1, y0, _letter(n), fontsize=self._style.small_pt, ha="left", va="bottom",
                        clip_on=True)

    def _zoom_at(self, x_px, y_px, window, drawing, n):
        x, y, w, h = window
        size = (self._panel, max(8, round(self._panel * h / w)))
        part = np.s_[y:y + h, x:x + w]
        truth = self._view.labels[part]
        is_true = (truth > 0) & (truth != images.IGNORE)
        label = _letter(n) if len(self._windows) > 1 else ""

        def colours():
            if drawing is None:
                return _CLASS_TABLE[truth]
            return drawn_colours(drawing, self._marks(drawing)[part], drawing.response[part], _HIT_IN_ZOOM)

        def outline(ax):
            if drawing is not None:
                ax.add_collection(LineCollection(_outlines(is_true), colors=INK, linewidths=0.5))
            for spine in ax.spines.values():
                spine.set(color=INK, linewidth=0.6)
            if label:
                ax.text(0.03, 0.95, label, fontsize=self._style.small_pt, va="top",
                        transform=ax.transAxes)
        self._sheet.image(x_px, y_px, size, colours, outline)
        return y_px + size[1]

    def _numbers(self, x_px, y_px, drawing):
        """F and the time, F bold if it is the best and no other shows the same digits."""
        sheet, size = self._sheet, self._style.small_pt
        f_text, draw_ns = f"F {drawing.row['f_2px']:.3f}", drawing.row["draw_ns"]
        time_text = f"{ms(draw_ns / 1e6)} ms" if draw_ns > 0 else ""
        shown = sorted((f"{d.row['f_2px']:.3f}" for d in self._view.drawings), reverse=True)
        is_best = f_text[2:] == shown[0] and shown.count(shown[0]) == 1 and len(shown) > 1
        weight = "bold" if is_best else "normal"
        sheet.text(x_px, y_px, f_text, weight=weight)
        if not time_text:
            return
        needed = text_width_px(f_text, size, weight) + text_width_px(time_text, size) + 12
        if needed <= self._panel:
            sheet.text(x_px + self._panel, y_px, time_text, align="right")
        else:
            sheet.text(x_px, y_px + sheet.line_px(), time_text)


def _letter(n):
    return chr(ord("a") + n)


def _enlarged_errors(codes):
    """Wrong pixels grown by one to each side; missing ones lie over false ones."""
    out = codes.copy()
    for kind in (images.FALSE_CODES, images.MISSING_CODES):
        for code in kind:
            mask = codes == images.WRONG + code
            if mask.any():
                grown = images.near(mask, 1)
                out[grown & (out < images.WRONG + kind.start)] = images.WRONG + code
    return out


def _outlines(mask):
    """The edges round the pixels of a mask, as segments in its pixels."""
    segments = []
    padded = np.pad(mask, 1)
    ys, xs = np.nonzero(padded[1:-1, 1:] != padded[1:-1, :-1])
    segments += [((x, y), (x, y + 1)) for x, y in zip(xs, ys)]
    ys, xs = np.nonzero(padded[1:, 1:-1] != padded[:-1, 1:-1])
    segments += [((x, y), (x + 1, y)) for x, y in zip(xs, ys)]
    return segments
