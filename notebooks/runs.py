"""The tables of runs, as pandas frames. Nothing here scores or fits: columns, and sums of them.

`rows.csv` is complete in itself, and every other table names a cell of it, so that by hand it takes
three lines:

    rows = pd.read_csv("inkbench-out/quality/rows.csv")
    curves = pd.read_csv("inkbench-out/quality/curves.csv")
    curves = curves.merge(rows[["cell", "method", "scene", "view"]], on="cell")
"""

import functools
import io
import os
import subprocess
from pathlib import Path

import pandas as pd

ROOT = Path(os.environ.get("INKBENCH_RUNS", "../inkbench-out"))
PROGRAM = Path(os.environ.get("INKBENCH", "../build/release/inkbench"))

# What writes the files of a folder. `notebooks/execute` runs those that are missing.
COMMANDS = {
    name: f"build/release/inkbench run experiments/{name}.toml"
    for name in ("quality", "speed", "packing_ranges", "stress", "animation")
}
COMMANDS["bound"] = "build/release/inkbench bound --method mote4 --out inkbench-out/bound"
COMMANDS["scaling"] = ("build/release/inkbench compare --scenes sphere --no-sweep --scaling "
                       "--out inkbench-out/scaling")
COMMANDS["tune"] = (
    "build/release/inkbench tune mote4 --objective scenes --evaluations 1000 --seed 7 --size 640x360"
    " --out inkbench-out/tune/mote4"
)

CLASSES = ["contour", "boundary", "crease", "intersection", "seam"]


class MissingTable(Exception):
    """A file that a notebook cannot do without. Jupyter shows the message alone."""

    def _render_traceback_(self):
        return [str(self)]


def _advice(name, folders):
    commands = " or ".join(f"`{COMMANDS[folder]}`" for folder in folders)
    return f"{name} is in none of {', '.join(folders)} under INKBENCH_RUNS; make it with {commands}"


def find(name, *folders):
    """The path of a file in the first of the folders that has it with a line of data, or None."""
    for folder in folders:
        path = ROOT / folder / name
        if path.is_file():
            with path.open(encoding="utf-8") as file:
                if sum(1 for _, _ in zip(file, range(2))) == 2:
                    return path
    return None


def _read(path):
    """A table of a folder; one that names cells has the columns of their rows too."""
    if path.name == "rows.csv":
        frame = pd.read_csv(path, low_memory=False)
        is_main = frame["study"] == "compare"
        return frame[is_main] if is_main.any() else frame
    columns = pd.read_csv(path, nrows=0).columns
    swept = columns[list(columns).index("status") + 1 : list(columns).index("f_2px")] \
        if path.name == "sweep.csv" else []
    frame = pd.read_csv(path, low_memory=False, dtype={name: str for name in swept})
    if "cell" not in frame:
        return frame
    rows = pd.read_csv(path.parent / "rows.csv", low_memory=False)
    frame = frame.merge(rows[["cell"] + [c for c in rows if c not in frame]], on="cell", how="left")
    if path.name == "sweep.csv":
        frame["params"] = _settings(frame, swept)
    return frame


def _settings(sweep, swept):
    """The whole parameters of each setting: those of its cell with what the setting changes."""
    def whole(line):
        own = dict(pair.split("=", 1) for pair in line["params"].split(";"))
        own.update({name: line[name] for name in swept if name in own})
        return ";".join(f"{name}={value}" for name, value in own.items())

    return sweep.apply(whole, axis=1)


def table(name, *folders):
    """The table `name` of the first folder that has it; MissingTable says what command makes it.

    Tables beside rows.csv have the columns of their cells' rows, and their own where both have one.
    Rows of other studies than the main one (`study`) stand with their own tables alone. Rows that
    failed (status other than ok) are left out and counted in a printed line.
    """
    path = find(name, *folders)
    if path is None:
        raise MissingTable(_advice(name, folders))
    frame = _read(path)
    if "status" in frame:
        failed = frame[frame["status"] != "ok"]
        if len(failed):
            names = ", ".join(sorted(failed["method"].unique()))
            print(f"{name}: {len(failed)} of {len(frame)} cells failed ({names}), left out here")
        frame = frame[frame["status"] == "ok"]
    return frame.reset_index(drop=True)


def table_if_any(name, *folders):
    """The table, or None and a printed line that says what would make it."""
    if find(name, *folders) is None:
        print(f"Nothing to draw: {_advice(name, folders)}.")
        return None
    return table(name, *folders)


def _listed_methods():
    """methods.csv as the program itself has it, for runs without one."""
    try:
        return subprocess.run([PROGRAM, "list", "methods", "--csv"], check=True, text=True,
                              stdout=subprocess.PIPE).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise MissingTable("methods.csv is in no folder under INKBENCH_RUNS, and the program that "
                           f"would list its methods fails ({error}); ./bootstrap build makes it, "
                           "INKBENCH names another") from error


@functools.cache
def methods():
    """What is known of each method, by its name: family, marker, preset_of and more, all as text.

    From methods.csv of all runs that have it (the first line of a name counts), else from the
    program.
    """
    tables = sorted(ROOT.glob("**/methods.csv")) or [io.StringIO(_listed_methods())]
    frames = [pd.read_csv(table, dtype=str, keep_default_na=False) for table in tables]
    return pd.concat(frames).drop_duplicates("method").set_index("method")


def with_settings(frame):
    """The frame with a column for every parameter in `params` ("key=value;key=value"), as text."""
    settings = frame["params"].map(
        lambda text: dict(pair.split("=", 1) for pair in text.split(";")))
    columns = pd.DataFrame(list(settings), index=frame.index)
    return frame.join(columns[[c for c in columns if c not in frame]])


def pooled(frame, by, k="k_2px", n_pred="n_pred"):
    """F of summed counts per group, 2 k / (n_pred + n_truth) as summary.csv has it, and 1 - F."""
    sums = frame.groupby(by, sort=False)[[k, n_pred, "n_truth"]].sum()
    sums["f"] = 2 * sums[k] / (sums[n_pred] + sums["n_truth"])
    sums["error"] = 1 - sums["f"]
    return sums.reset_index()


def evaluations():
    """What `inkbench tune` tried, by the name of its folder; {} and a printed line if nothing."""
    found = {}
    for path in sorted((ROOT / "tune").glob("*/evaluations.csv")):
        frame = pd.read_csv(path)
        if len(frame):
            found[path.parent.name] = frame
    if not found:
        print(f"Nothing to draw: {_advice('evaluations.csv', ['tune'])}.")
    return found


def lives(lines, method):
    """How many of a method's false lines lived 1, 2, ... frames by lives.csv (or None), by frames."""
    own = [] if lines is None else lines[lines["method"] == method]
    if not len(own):
        return pd.Series(dtype=float)
    counts = own.groupby("frames")["count"].sum()
    return counts.reindex(range(1, int(counts.index.max()) + 1), fill_value=0).astype(float)


def views_of(rows):
    """One row per scene and view, for columns that tell of the truth and not of a method."""
    return rows.drop_duplicates(["scene", "view", "width", "height"])


def provenance(rows):
    """A sentence: how many of what, at which size, and by which program."""
    sizes = ", ".join(f"{w}x{h}" for w, h in rows[["width", "height"]].drop_duplicates().values)
    views = len(rows[["scene", "view"]].drop_duplicates())
    made_by = ""
    if "version" in rows:
        made_by = f"; Inkbench {', '.join(sorted(rows['version'].astype(str).unique()))}"
    return (f"{rows['method'].nunique()} methods and baselines, {rows['scene'].nunique()} scenes, "
            f"{views} views, {sizes}{made_by}")
