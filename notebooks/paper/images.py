"""The images of a run folder: truth, what methods drew, their errors.

`images/<scene>/<view>/` is written by `src/harness/images/view_images.h`, which says what each file holds.
"""

from dataclasses import dataclass

import matplotlib.image
import numpy as np

from paper.chart import Nothing
from paper.runs import BASELINES, BadInput, file_name

IGNORE = 7
BAND_PX = 6  # pixels this close to the frame do not count in a comparison
NEAR_PX = 2
FALSE_CODES = range(1, 6)  # codes of *.errors.png; those of missing pixels come after them
MISSING_CODES = range(6, 12)

# What a pixel of a drawing is. Codes of errors follow, as WRONG + code.
BLANK, IGNORED, HIT, WRONG = 0, 1, 2, 2


@dataclass
class Drawing:
    """What one method drew on a view.

    response: edge response 0..255; errors: codes of wrong pixels, 0 elsewhere; drawn: where the
    response counts as a line. row: its line of rows.csv. is_ink: the response is a share of the pixel.
    """

    method: str
    row: object
    response: np.ndarray
    errors: np.ndarray
    drawn: np.ndarray
    is_ink: bool = False


@dataclass
class View:
    """One view of a scene with all that its folder shows; labels: the truth's classes by pixel."""

    scene: str
    name: str
    folder: object
    labels: np.ndarray
    drawings: list
    title: str = ""  # the scene's name, and the view's where several are shown


def read_image(path, shape=None):
    """A PNG as bytes, grey (height, width) or colour (height, width, 3).

    Raises BadInput if it cannot be read or is not of `shape` (height, width).
    """
    try:
        image = matplotlib.image.imread(path)
    except (OSError, SyntaxError, ValueError) as error:
        raise BadInput(path, "it cannot be read as PNG", "as inkbench wrote it") from error
    if image.dtype != np.uint8:
        image = np.rint(image * 255).astype(np.uint8)
    if image.ndim == 3:
        image = image[:, :, :3]
    if shape is not None and image.shape[:2] != shape:
        raise BadInput(path, f"it is {image.shape[1]}x{image.shape[0]} px",
                       f"{shape[1]}x{shape[0]} px, as its truth.png")
    return image


def shown_views(runs, most):
    """The views of which a run has images (the first of each scene unless all are asked for), each
    with the drawings of all methods: those of the scenes that were asked for, else at most so many,
    taken at even distances.

    Raises Nothing if there are none.
    """
    folder = next((f for f in runs.folders
                   if (f.path / "images").is_dir() and f.table("rows.csv") is not None), None)
    if folder is None:
        raise Nothing("the run kept no images; `inkbench compare --images first` keeps them")
    rows = folder.table("rows.csv")
    rows = rows[rows["status"] == "ok"]
    methods = [m for m in dict.fromkeys(rows["method"]) if m not in BASELINES]
    if runs.methods is not None:
        methods = list(runs.methods)
    views = []
    for (scene, name), group in rows.groupby(["scene", "view"], sort=False):
        path = folder.path / "images" / file_name(scene) / file_name(name)
        is_asked = runs.scenes is None or scene in runs.scenes
        is_new = runs.is_every_view or all(known != scene for known, *_ in views)
        if is_asked and is_new and (path / "truth.png").is_file():
            views.append((scene, name, path, group))
    if not views:
        raise Nothing("the run kept no images of these scenes; `inkbench compare --images first` "
                      "keeps them")
    if runs.scenes is None and len(views) > most:
        views = [views[i * len(views) // most] for i in range(most)]
    registry = runs.registry()
    ink = set(registry.index[registry["ink"] == "true"]) if "ink" in registry else set()
    views = [_read_view(*view, methods, ink) for view in views]
    for view in views:
        is_one = sum(other.scene == view.scene for other in views) == 1
        view.title = view.scene if is_one else f"{view.scene} {view.name}"
    if runs.scenes is not None:
        views.sort(key=lambda view: runs.scenes.index(view.scene))
    return views


def _read_view(scene, name, path, rows, methods, ink):
    labels = read_image(path / "truth.png")
    drawings = []
    of_size = rows[(rows["width"] == labels.shape[1]) & (rows["height"] == labels.shape[0])]
    for method in methods:
        own = of_size[of_size["method"] == method]
        image = path / f"{file_name(method)}.png"
        if not len(own) or not image.is_file():
            continue
        row = own.iloc[0]
        response = read_image(image, labels.shape)
        errors = read_image(path / f"{file_name(method)}.errors.png", labels.shape)
        if errors.max(initial=0) >= MISSING_CODES.stop:
            raise BadInput(path / f"{file_name(method)}.errors.png",
                           f"a pixel holds {errors.max()}", f"0..{MISSING_CODES.stop - 1}")
        drawings.append(Drawing(method, row, response, errors, response >= row["threshold"],
                                method in ink))
    return View(scene, name, path, labels, drawings)


def _shifted(mask, dx, dy):
    """The mask moved by (dx, dy), False where nothing comes in."""
    height, width = mask.shape
    moved = np.zeros_like(mask)
    moved[max(0, dy):height + min(0, dy), max(0, dx):width + min(0, dx)] = \
        mask[max(0, -dy):height + min(0, -dy), max(0, -dx):width + min(0, -dx)]
    return moved


def near(mask, distance_px):
    """Where a pixel of `mask` lies within the distance, centre to centre."""
    reach = int(distance_px)
    found = np.zeros_like(mask)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dx * dx + dy * dy <= distance_px * distance_px:
                found |= _shifted(mask, dx, dy)
    return found


def marks(view, drawing):
    """What each pixel is: BLANK, IGNORED, HIT, or WRONG + its code.

    The run's errors are of thinned lines. A drawn pixel that thinning removed is what the nearest
    pixel of its own line is, so that lines keep their width.
    """
    is_true = (view.labels > 0) & (view.labels != IGNORE)
    is_false = (drawing.errors > 0) & (drawing.errors < MISSING_CODES.start)
    out = np.zeros(view.labels.shape, dtype=np.uint8)
    drawn = drawing.drawn
    out[is_false] = WRONG + drawing.errors[is_false]
    out[drawn & near(is_true, NEAR_PX) & ~is_false] = HIT
    for _ in range(12):  # lines wider than this are not drawn by any method
        open_px = drawn & (out == BLANK)
        if not open_px.any():
            break
        grown = np.zeros_like(out)
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            grown = np.maximum(grown, _shifted(out, dx, dy))
        out[open_px] = grown[open_px]
    out[drawn & (out == BLANK)] = HIT
    is_missing = drawing.errors >= MISSING_CODES.start
    out[is_missing] = WRONG + drawing.errors[is_missing]
    frame = np.ones(out.shape, dtype=bool)
    frame[BAND_PX:-BAND_PX, BAND_PX:-BAND_PX] = False
    out[(frame | (view.labels == IGNORE)) & drawn] = IGNORED
    return out


def bounds(view, margin=0.03):
    """The part of a view (x, y, width, height) that holds its lines and all errors.

    No wider than 2 : 1 and no taller than 1 : 1.15, unless the view is.
    """
    used = (view.labels > 0) & (view.labels != IGNORE)
    for drawing in view.drawings:
        used |= drawing.errors > 0
    height, width = used.shape
    ys, xs = np.nonzero(used)
    if not len(xs):
        return 0, 0, width, height
    pad = int(margin * max(width, height))
    x0, x1 = max(0, xs.min() - pad), min(width, xs.max() + 1 + pad)
    y0, y1 = max(0, ys.min() - pad), min(height, ys.max() + 1 + pad)
    x0, x1 = _widened(x0, x1, int((y1 - y0) / 1.15), width)
    y0, y1 = _widened(y0, y1, int((x1 - x0) / 2), height)
    return int(x0), int(y0), int(x1 - x0), int(y1 - y0)


def _widened(low, high, least, size):
    """The span grown round its middle to `least`, inside 0..size."""
    least = min(least, size)
    if high - low >= least:
        return low, high
    low = min(max(0, (low + high - least) // 2), size - least)
    return low, low + least


def telling_window(view, part, size_px):
    """The window (x, y, width, height) inside `part` in which methods' errors differ most.

    By the standard deviation over methods of the wrong pixels in it; with one method, where it has
    most of them; where that finds nothing, the window with most lines. size_px: (width, height).
    """
    x0, y0, width, height = part
    w, h = min(size_px[0], width), min(size_px[1], height)

    def sums_in_windows(marked):
        sums = np.zeros((height + 1, width + 1))
        sums[1:, 1:] = marked[y0:y0 + height, x0:x0 + width].cumsum(0).cumsum(1)
        return sums[h:, w:] - sums[:-h, w:] - sums[h:, :-w] + sums[:-h, :-w]

    counts = np.array([sums_in_windows(drawing.errors > 0) for drawing in view.drawings])
    spread = counts.std(axis=0) if len(counts) > 1 else counts[0]
    if not spread.any():
        spread = sums_in_windows((view.labels > 0) & (view.labels != IGNORE))
    y, x = np.unravel_index(int(spread.argmax()), spread.shape)
    return int(x0 + x), int(y0 + y), int(w), int(h)


def shrunk(codes, size_px, rank):
    """Codes in an image of size_px (width, height); of several in one pixel the highest ranks.

    rank: array from code to importance. Where the image is larger, pixels are repeated.
    """
    height, width = codes.shape
    out_w, out_h = size_px
    if out_w >= width or out_h >= height:
        ys = np.arange(out_h) * height // out_h
        xs = np.arange(out_w) * width // out_w
        return codes[np.ix_(ys, xs)]
    by_rank = np.argsort(rank)
    place = np.empty_like(by_rank)
    place[by_rank] = np.arange(len(by_rank))
    importance = place[codes]
    rows = np.zeros((out_h, width), dtype=importance.dtype)
    np.maximum.at(rows, np.arange(height) * out_h // height, importance)
    out = np.zeros((out_w, out_h), dtype=importance.dtype)
    np.maximum.at(out, np.arange(width) * out_w // width, rows.T)
    return by_rank[out.T]
