#!/usr/bin/env python3
"""Figures for papers from run folders: strips, error against time, classes, stress, LaTeX.

As a program it writes every figure that the runs have data for, and figures.md with a caption for
each. Notebooks call `show`. The figures themselves are in the package `paper` beside this file.
"""

import argparse
import difflib
import os
import re
import sys
from pathlib import Path

if sys.version_info < (3, 11):
    sys.exit("figures: they need Python 3.11 or newer, and this is "
             + ".".join(map(str, sys.version_info[:2])))
try:
    import matplotlib
    import pandas  # noqa: F401  (asked here, so that one sentence names all that is missing)
    matplotlib.use("agg")
    import matplotlib.pyplot as plt
except Exception as error:  # noqa: BLE001  (what is half installed fails in its own ways)
    lacks = isinstance(error, ModuleNotFoundError) and error.name in ("matplotlib", "pandas")
    what = f"{error.name}, which {sys.executable} does not have" if lacks else \
        f"matplotlib and pandas, and {sys.executable} cannot load them " \
        f"({type(error).__name__}: {' '.join(str(error).split())})"
    print(f"figures: they need {what}; on Debian: apt-get install python3-pandas python3-matplotlib",
          file=sys.stderr)
    sys.exit(2)

from paper import catalogue  # noqa: E402
from paper.chart import Nothing, Table  # noqa: E402
from paper.output import FORMATS, encode, write_whole  # noqa: E402
from paper.runs import BadInput, RunFolder, Runs  # noqa: E402
from paper.style import Style, length_in  # noqa: E402

ROOT = Path(os.environ.get("INKBENCH_RUNS", "../inkbench-out"))

# What makes the folders that notebooks read. `notebooks/execute` runs what is missing.
COMMANDS = {name: f"build/release/inkbench run experiments/{name}.toml" for name in ("quality", "stress")}


# For notebooks.

def folders(*names):
    """The folders under INKBENCH_RUNS of these names or globs that are there."""
    return [path for name in names for path in sorted(ROOT.glob(name))
            if (path / "rows.csv").is_file()]


def show(name, figure, *names, width="178mm", **options):
    """Draws a figure of paper.catalogue from the runs of these names, and prints its facts.

    name: of the file under INKBENCH_FIGURES, if that is set. Prints a sentence where there is
    nothing to draw, with the command that makes what is missing. In a notebook the figure is shown
    as SVG and as PNG, of which each exporter takes what it can.
    """
    from IPython.display import display
    found = folders(*names)
    if not found:
        commands = " or ".join(f"`{COMMANDS[name]}`" for name in names)
        print(f"Nothing to draw: the run is missing; make it with {commands}.")
        return
    runs = Runs([RunFolder(path) for path in found])
    style = Style(width_in=length_in(width), registry=runs.registry(), **options)
    try:
        made = catalogue.draw(figure, runs, style)
    except Nothing as reason:
        print(f"Nothing to draw: {reason}.")
        return
    for chart in made:
        print("\n".join(chart.facts))
        stem = name + (f"_{chart.part}" if chart.part else "")
        if isinstance(chart, Table):
            print(chart.latex)
            continue
        svg = encode(chart.figure, "svg")
        display(_bundle(svg, encode(chart.figure, "png", 150)), raw=True)
        plt.close(chart.figure)
        if os.environ.get("INKBENCH_FIGURES"):
            folder = Path(os.environ["INKBENCH_FIGURES"])
            folder.mkdir(parents=True, exist_ok=True)
            write_whole(folder / f"{stem}.svg", svg)


def _bundle(svg, png):
    """A figure as nbconvert and Jupyter read it.

    The SVG goes as the source of an image: exporters that clean SVGs leave an empty one, and those
    without HTML take the PNG.
    """
    import base64
    source = "data:image/svg+xml;base64," + base64.b64encode(svg).decode()
    return {"text/html": f'<img style="max-width: 100%" alt="figure" src="{source}">',
            "image/png": base64.b64encode(png).decode()}


# The program.

def window_of(text):
    """"x,y,w,h" as four whole numbers of pixels; BadInput for anything else."""
    match = re.fullmatch(r"(\d+),(\d+),(\d+),(\d+)", text.replace(" ", ""))
    window = tuple(map(int, match.groups())) if match else (0, 0, 0, 0)
    if window[2] < 4 or window[3] < 4:
        raise BadInput("--window", f"'{text}' is no window",
                       "x,y,width,height in pixels from the top left, as 300,120,48,30, at least "
                       "4x4")
    return window


def names_of(text, option, known=None):
    """A comma list of names; BadInput for an empty one, or one that is not among `known`."""
    names = list(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    if not names:
        raise BadInput(option, f"'{text}' names nothing", "names, as a,b")
    for name in names:
        if known is not None and name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f" (did you mean {near[0]}?)" if near else ""
            raise BadInput(option, f"there is no '{name}'{hint}", ", ".join(known))
    return names


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        print(f"figures: {message} (see --help)", file=sys.stderr)
        sys.exit(2)


def parser():
    """The options of the program; `inkbench figures` passes them on."""
    out = _Parser(prog="figures.py", allow_abbrev=False,
                  formatter_class=argparse.RawDescriptionHelpFormatter,
                  description="Make figures for papers from run folders.",
                  epilog="figures: " + ", ".join(catalogue.FIGURES) + "\n\n"
                  "Example: python3 notebooks/figures.py inkbench-out/compare --format pdf --width 84mm\n"
                  "Exit codes: 0 done, 2 bad input.")
    out.add_argument("runs", metavar="RUN", nargs="*",
                     help="folder of a finished run; a figure is drawn from the first that has its "
                     "tables")
    out.add_argument("--out", metavar="DIR", default="inkbench-figures",
                     help="folder for figures and figures.md (inkbench-figures)")
    out.add_argument("--format", default="svg,png", help="of pdf, svg, png, as a,b (svg,png)")
    out.add_argument("--width", default="178mm",
                     help="of a figure, in mm, cm, in or pt (178mm: two columns of a journal)")
    out.add_argument("--font-size", default="8", metavar="PT", help="of text, in points (8)")
    out.add_argument("--window", action="append", default=[], metavar="X,Y,W,H",
                     help="zoomed part of strips in pixels; may be given again (the window in "
                     "which methods' errors differ most)")
    out.add_argument("--methods", metavar="A,B", help="these alone, in this order in strips")
    out.add_argument("--scenes", metavar="A,B", help="these alone, in this order in strips")
    out.add_argument("--tables-of-scenes", action="store_true",
                     help="summary.csv and differences.csv of --scenes are in --out already; "
                     "`inkbench figures` puts them there")
    out.add_argument("--views", choices=["first", "all"], default="first",
                     help="of each scene, shown in strips where the run kept images (first)")
    out.add_argument("--only", metavar="A,B", help="these figures alone")
    out.add_argument("--check", action="store_true",
                     help="say whether the options are good, and do nothing")
    return out


def font_size_of(text):
    try:
        size = float(text)
    except ValueError:
        size = 0
    if not 4 <= size <= 36:
        raise BadInput("--font-size", f"'{text}' is no size of text", "4 to 36, in points")
    return size


def options_of(words):
    """The parsed options, every text read; BadInput for one that means nothing."""
    args = parser().parse_args(words)
    args.format = names_of(args.format, "--format", FORMATS)
    args.width_in = length_in(args.width)
    args.font_pt = font_size_of(args.font_size)
    args.windows = [window_of(text) for text in args.window]
    args.only = names_of(args.only, "--only", list(catalogue.FIGURES)) if args.only is not None \
        else list(catalogue.FIGURES)
    args.methods = names_of(args.methods, "--methods") if args.methods is not None else None
    args.scenes = names_of(args.scenes, "--scenes") if args.scenes is not None else None
    if not args.runs and not args.check:
        raise BadInput("figures.py", "it needs a run", "the folder of a finished run, or several")
    return args


def make(args):
    """Writes all figures that the runs have data for; returns the names of the files."""
    runs = Runs([RunFolder(path) for path in args.runs], args.methods, args.scenes,
                args.views == "all", args.out if args.tables_of_scenes else None)
    style = Style(width_in=args.width_in, font_pt=args.font_pt, registry=runs.registry(),
                  windows=args.windows)
    out = Path(args.out)
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadInput(f"--out {out}", f"it cannot be made ({error.strerror})",
                       "a folder") from error
    older = _files_in(out / "figures.md")
    sections, missing, written = [], [], []
    for name in args.only:
        try:
            made = catalogue.draw(name, runs, style)
        except Nothing as reason:
            missing.append(f"- `{name}`: {reason}.")
            continue
        except KeyError as column:
            missing.append(f"- `{name}`: a table has no column {column}; another version of the "
                           "program wrote it.")
            continue
        for chart in made:
            files = _write(chart, name, args.format, out)
            written += files
            sections.append(_section(name, chart, files))
            for file in files:
                print(out / file, flush=True)
    for file in set(older) - set(written):
        (out / file).unlink(missing_ok=True)
    write_whole(out / "figures.md", _list(runs.folders, sections, missing))
    print(out / "figures.md")
    for line in missing:
        print("no " + line.removeprefix("- ").replace("`", ""))
    return written


def _write(chart, name, formats, out):
    stem = name + (f"_{chart.part}" if chart.part else "")
    if isinstance(chart, Table):
        write_whole(out / f"{stem}.tex", chart.latex)
        return [f"{stem}.tex"]
    for kind in formats:
        write_whole(out / f"{stem}.{kind}", encode(chart.figure, kind))
    plt.close(chart.figure)
    return [f"{stem}.{kind}" for kind in formats]


def _section(name, chart, files):
    title = name.replace("_", " ") + (f": {chart.part}" if chart.part else "")
    facts = "".join(f"\n- {fact}" for fact in chart.facts)
    links = ", ".join(f"[{file}]({file})" for file in files)
    return f"## {title}\n\n{chart.caption}\n\nFiles: {links}\n" + (facts + "\n" if facts else "")


def _files_in(page):
    """The files that an older page of figures lists."""
    if not page.is_file():
        return []
    text = page.read_text(encoding="utf-8", errors="replace")
    lines = re.findall(r"^Files: (.*)$", text, re.M)
    return [file for line in lines for file in re.findall(r"\[([\w.+-]+)\]", line)]


def _list(folders, sections, missing):
    text = "# Figures\n\n" + "\n".join(sections)
    if missing:
        text += "\n## Not made\n\n" + "\n".join(missing) + "\n"
    return text + "\n## Runs\n\n" + "".join(
        f"- {run.name}: `{run.command}`\n" if run.command else f"- {run.name}\n" for run in folders)


def main(words):
    """Runs the program; returns its exit code."""
    try:
        args = options_of(words)
        if not args.check:
            make(args)
    except BadInput as error:
        print(f"figures: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("figures: interrupted; the files that are there are whole", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
