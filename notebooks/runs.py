"""The tables of runs, as pandas frames. Nothing here scores or fits: columns, and sums of them."""

import os
from pathlib import Path

import pandas as pd

ROOT = Path(os.environ.get("INKBENCH_RUNS", "../inkbench-out"))

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


def table(name, *folders):
    """The table `name` of the first folder that has it; MissingTable says what command makes it.

    Rows that failed (status other than ok) are left out and counted in a printed line.
    """
    path = find(name, *folders)
    if path is None:
        raise MissingTable(_advice(name, folders))
    frame = pd.read_csv(path, low_memory=False)
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


def lives(motion):
    """How many false lines lived 1, 2, ... frames over these rows of motion.csv, by frames."""
    written = motion["lives"].dropna().astype(str)
    if written.empty:
        return pd.Series(dtype=float)
    counts = written.str.split(";", expand=True).astype(float).sum()
    return counts.set_axis(counts.index + 1)


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
    return (f"{rows['method'].nunique()} methods and brackets, {rows['scene'].nunique()} scenes, "
            f"{views} views, {sizes}{made_by}")
