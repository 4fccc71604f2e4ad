"""Run folders as pandas frames and images. Nothing here scores or fits: columns, and sums of them.

`rows.csv` is complete in itself, and every other table names a cell of it, so that by hand it takes
three lines:

    rows = pandas.read_csv("inkbench-out/compare/rows.csv")
    curves = pandas.read_csv("inkbench-out/compare/curves.csv")
    curves = curves.merge(rows[["cell", "method", "scene", "view"]], on="cell")
"""

import fnmatch
import json
import re
import tomllib
from pathlib import Path

import pandas as pd

from paper.chart import Nothing


def _vocabulary():
    """The words and colours of results: src/core/vocabulary.json, or its copy where it is installed."""
    here = Path(__file__).resolve().parent
    installed = here / "vocabulary.json"
    path = installed if installed.is_file() else here.parents[1] / "src/core/vocabulary.json"
    return json.loads(path.read_text(encoding="utf-8"))


VOCABULARY = _vocabulary()
CLASSES = [each["name"] for each in VOCABULARY["classes"]]
CLASS_PARTS = {part["name"]: part for part in VOCABULARY["class_parts"]}
# What recall is told of, and its name in figures: the classes, or the parts of those that have parts.
RECALL_GROUPS = {name: title for each in CLASSES for name, title in (
    {n: part["title"] for n, part in CLASS_PARTS.items() if part["class"] == each} or {each: each}).items()}
BASELINES = ["none", "sampled", "exact_corner", "oracle"]

# The baselines of one exact sample a pixel: what a legend says, and the dashes of their lines.
ONE_SAMPLE = {"sampled": ("sampled: one exact sample at pixel centres", ":"),
              "exact_corner": ("exact_corner: one exact sample at pixel corners", "--")}

# Columns that no figure reads as numbers, so that a version 1.10 stays one.
_TEXTS = ["method", "scene", "view", "params", "status", "version", "commit", "study"]


class BadInput(Exception):
    """What the user gave cannot be used: where, what is wrong, what would have been accepted."""

    def __init__(self, where, what, accepted):
        super().__init__(f"{where}: {what} (accepted: {accepted})")


class RunFolder:
    """One run folder. Raises BadInput if `path` is none, or if its run is not finished."""

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise BadInput(self.path, "there is no such folder", "the folder of a finished run")
        if not (self.path / "rows.csv").is_file():
            raise BadInput(self.path, "it holds no rows.csv", "the folder of a finished run")
        self.record = self._read_record()
        if self.record.get("progress", {}).get("state", "finished") == "unfinished":
            raise BadInput(self.path, "its run is not finished",
                           "a finished run (the command that began it goes on)")
        self._frames = {}

    def _read_record(self):
        path = self.path / "run.toml"
        if not path.is_file():
            return {}
        try:
            return tomllib.loads(path.read_text(encoding="utf-8"))
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise BadInput(path, f"it cannot be read ({error})", "as inkbench wrote it") from error

    @property
    def name(self):
        return self.path.resolve().name

    @property
    def command(self):
        """As it was typed, files without their folders, or "" if the folder does not say."""
        return re.sub(r"(?<![^\s,=])/[^\s,]*/", "", self.record.get("command", ""))

    def table(self, name):
        """The file `name` as a frame, or None if it is missing or has no line of data.

        Of rows.csv the cells of a comparison are here alone.
        """
        if name not in self._frames:
            self._frames[name] = self._read(name)
        frame = self._frames[name]
        return None if frame is None else frame.copy()

    def _read(self, name):
        path = self.path / name
        if not path.is_file():
            return None
        frame = _read_csv(path)
        if name == "rows.csv":
            frame = frame[frame["study"] == "compare"]
        return frame.reset_index(drop=True) if len(frame) else None

    def names(self, column):
        """All that rows.csv has in a column, baselines left out."""
        rows = _read_csv(self.path / "rows.csv")
        return [name for name in rows[column].unique() if name not in BASELINES]


def _read_csv(path):
    try:
        head = pd.read_csv(path, nrows=0)
        return pd.read_csv(path, low_memory=False, dtype={c: str for c in _TEXTS if c in head})
    except (OSError, ValueError) as error:
        raise BadInput(path, f"it is not the table it should be ({error})",
                       "as inkbench wrote it") from error


class Runs:
    """Some run folders: a table is that of the first folder that has it.

    methods, scenes: names or globs to which every table is narrowed; None for all. is_every_view:
    images of all views are shown, not of the first of each scene alone. tables_of_scenes: a folder
    with summary.csv of these scenes, which a run has of all. Raises BadInput for a name that no row
    has.
    """

    def __init__(self, folders, methods=None, scenes=None, is_every_view=False, tables_of_scenes=None):
        self.folders = folders
        self.methods = self._known("method", methods)
        self.scenes = self._known("scene", scenes)
        self.is_every_view = is_every_view
        is_every_scene = scenes is None or set(self.scenes) == set(self._all("scene"))
        self._of_scenes = None if is_every_scene else {
            "summary.csv": _read_csv(Path(tables_of_scenes) / "summary.csv") if tables_of_scenes else None}

    def _all(self, column):
        return list(dict.fromkeys(name for f in self.folders for name in f.names(column)))

    def _known(self, column, names):
        if names is None:
            return None
        known, found = self._all(column), []
        for name in names:
            fitting = [k for k in known if k == name] or fnmatch.filter(known, name)
            if not fitting:
                raise BadInput(f"--{column}s", f"no row is of '{name}'", ", ".join(known))
            found += fitting
        return list(dict.fromkeys(found))

    def folder_with(self, *names):
        """The first folder that has all these tables, or None."""
        for folder in self.folders:
            if all(folder.table(name) is not None for name in names):
                return folder
        return None

    def table(self, name, advice=""):
        """The table `name`, cells without a score and what was not asked for left out.

        Raises Nothing, with `advice`, if no folder has it or nothing of it is left.
        """
        folder = self.folder_with(name)
        if folder is None and name == "rows.csv":
            raise Nothing("no cell of a comparison in it; `inkbench compare` makes one")
        if folder is None:
            where = "it" if len(self.folders) == 1 else "them"
            raise Nothing(f"no {name} in {where}" + (f"; {advice}" if advice else ""))
        frame = folder.table(name)
        if self._of_scenes and name in self._of_scenes:
            frame = self._of_scenes[name]
            if frame is None:
                raise Nothing(f"{name} is over all scenes of a run, and --scenes asks for some; "
                              "`inkbench figures RUN --scenes` makes it of these")
        if "status" in frame:
            frame = frame[frame["status"] == "ok"]
        if self.methods is not None and "method" in frame:
            frame = frame[frame["method"].isin(list(self.methods) + BASELINES)]
        if self.scenes is not None and "scene" in frame:
            frame = frame[frame["scene"].isin(self.scenes)]
        if not len(frame):
            raise Nothing(f"{name} has no line with a score of what was asked for")
        return frame.reset_index(drop=True)

    def table_of_methods(self, name, advice=""):
        """The same without baselines."""
        frame = self.table(name, advice)
        return frame[~frame["method"].isin(BASELINES)]

    def table_if_any(self, name):
        """The same, or None."""
        try:
            return self.table(name)
        except Nothing:
            return None

    def summary(self):
        """summary.csv by method."""
        return self.table("summary.csv", "only a comparison of one size and number of threads has "
                          "it").set_index("method")

    def source(self, *names):
        """Where tables are from, as the end of a caption."""
        folder = self.folder_with(*names) or self.folders[0]
        files = " and ".join(f"`{name}`" for name in names)
        part = f" made of {', '.join(self.scenes)}" if self._of_scenes and names[0] in self._of_scenes else ""
        return f"Numbers: {files} of the run {folder.name}{part}."

    def registry(self):
        """methods.csv of all folders (the first line of a name counts), by method, as text."""
        frames = [pd.read_csv(folder.path / "methods.csv", dtype=str, keep_default_na=False)
                  for folder in self.folders if (folder.path / "methods.csv").is_file()]
        if not frames:
            return pd.DataFrame(columns=["family", "marker", "preset_of"])
        return pd.concat(frames).drop_duplicates("method").set_index("method")


def file_name(text):
    """The name of a scene, a view or a method in the paths of images, as the program writes it."""
    return re.sub(r"[^A-Za-z0-9.\-_+]", "_", text)


def counted(number, noun):
    """"1 scene", "2 scenes"."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def extent(rows):
    """How much was measured, as part of a caption: "4 scenes, 12 views, 640x360 px"."""
    sizes = ", ".join(f"{w}x{h}" for w, h in rows[["width", "height"]].drop_duplicates().values)
    views = len(rows[["scene", "view"]].drop_duplicates())
    return f"{counted(rows['scene'].nunique(), 'scene')}, {counted(views, 'view')}, {sizes} px"


def ms(value):
    """Milliseconds with three digits that count, as the program's verdict has them."""
    digits = 3 if value < 0.0995 else 2 if value < 9.995 else 1 if value < 99.95 else 0
    return f"{value:.{digits}f}"


class Judged:
    """What the program answers by: columns of summary.csv, the soft F of a run that scored ink, else F."""

    def __init__(self, lines):
        is_soft = "soft_f" in lines
        self.f, self.low, self.high = ("soft_f", "soft_lo", "soft_hi") if is_soft else ("f_2px", "f_lo", "f_hi")
        self.name, self.title = ("soft F", "soft F") if is_soft else ("F", "F at 2 px")
        self.error_scene = "soft_error_scene" if is_soft else "error_scene"


def answer_of(lines):
    """The method that the program answers with, or None; and that and the most exact as facts."""
    by = Judged(lines)

    def fact(what, name):
        line = lines.loc[name]
        return f"{what}: {name}, {by.name} {line[by.f]:.3f}" + \
            ("" if pd.isna(line["draw_ms"]) else f" in {ms(line['draw_ms'])} ms")

    places = lines["answer"].fillna("") if "answer" in lines else pd.Series("", lines.index)
    found = list(places.index[places.isin(["answer", "both"])])
    facts = [fact("the answer", name) for name in found] + \
        [fact("the most exact", name) for name in places.index[places == "best"]]
    share = by.error_scene + "_share"
    if share in lines:
        facts += [f"{name}: {100 * line[share]:.0f} % of its error in "
                  f"{line[by.error_scene]}" for name, line in lines.iterrows()
                  if line["kind"] == "method" and line["scenes"] >= 6 and line[share] > 0.5]
    return next(iter(found), None), facts
