#!/usr/bin/python3
"""Holds the numbers of pages equal to the tables of named runs, which lie in experiments/kept.

    experiments/kept.py [--write] [PAGE.md ...]    checks pages (README.md, experiments and methods), or writes them
    experiments/kept.py --keep NAME RUN            keeps what pages quote of a run folder

A number in a text has its source behind it: the run, a method or two, and a column.

    F rises to 0.989<!-- = catalogue surface8 f_2px -->, by +0.028<!-- = catalogue surface8-label8 difference -->

A table has a comment above it, a word for each of its columns: `key` for the one that names the method, `-` for one
that is not held, else RUN.COLUMN, or RUN.LOW..HIGH for two; `:2` behind it asks for two digits in place of three.

    <!-- numbers: key catalogue.f_2px catalogue.f_lo..f_hi catalogue.draw_ms:2 -->

Columns are those of summary.csv and differences.csv (experiments/columns.md), a scene's name for F over its views,
`kind_NAME` for F over a kind's scenes, `least` for the scene with the lowest F, and `width_px`, the mean width of drawn lines over views. Exit code 1: a page would change; 2: a page asks for what no kept run has.
"""

import argparse
import re
import sys
import tomllib
from pathlib import Path

import pandas as pd

from run_tables import pooled_f, read, scored

ROOT = Path(__file__).resolve().parent.parent
KEPT = ROOT / "experiments/kept"
PAGES = ["README.md", "experiments/*.md", "methods/**/*.md"]
INLINE = re.compile(r"(?P<shown>[+-]?\d*\.?\d+)(?P<mark><!-- = (?P<run>\w+) (?P<row>[\w-]+) (?P<column>\w+) -->)")
TABLE = re.compile(r"<!-- numbers: (?P<words>.*?) -->\n(?P<heads>\|.*\n\|.*\n)(?P<lines>(?:\|.*\n)+)")


class NoSource(Exception):
    """A page asks for a number that no kept run has: where, what, what there is."""

    def __init__(self, where, what, accepted):
        super().__init__(f"{where}: {what} (accepted: {accepted})")


class Kept:
    """The tables of one folder of kept runs, each read once."""

    def __init__(self, folder):
        self.folder = folder
        self._frames = {}

    def number(self, where, run, row, column):
        name = run + (".differences" if "-" in row else "")
        path = self.folder / f"{name}.csv"
        if not path.is_file():
            kept = ", ".join(sorted(p.stem for p in self.folder.glob("*.csv")))
            raise NoSource(where, f"no run is kept as '{name}'", kept)
        if name not in self._frames:
            self._frames[name] = pd.read_csv(path, index_col=0)
        frame = self._frames[name]
        for what, names in ((row, frame.index), (column, frame.columns)):
            if what not in names:
                raise NoSource(where, f"{name}.csv has no '{what}'", ", ".join(map(str, names)))
        return frame.loc[row, column]


def text_of(value, digits, sign=""):
    return "-" if pd.isna(value) else f"{value:{sign}.{digits}f}"


def rewritten(text, page, kept):
    """The page's text with every number that has a source as that source has it."""
    def where(match):
        return f"{page}:{text.count(chr(10), 0, match.start()) + 1}"

    def inline(match):
        shown = match["shown"]
        value = kept.number(where(match), match["run"], match["row"], match["column"])
        digits = len(shown.partition(".")[2])
        return text_of(value, digits, "+" if shown[0] in "+-" else "") + match["mark"]

    def cell_of(cell, word, key, place):
        """The cell with its number made anew; what stands behind that stays."""
        word, _, digits = word.partition(":")
        run, _, columns = word.partition(".")
        numbers = (text_of(kept.number(place, run, key, column), digits or 3) for column in columns.split(".."))
        return re.sub(r"^[\d.-]*", "-".join(numbers), cell, count=1)

    def table(match):
        words, place = match["words"].split(), where(match)
        lines = []
        for line in match["lines"].splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if len(cells) != len(words) or "key" not in words:
                raise NoSource(place, f"'{match['words']}' is not of {len(cells)} columns", "a word for each, one of them key")
            named = cells[words.index("key")]
            key = (re.search(r"`(\w+)`", named) or re.match(r"(\w+)", named))[1]
            lines.append("| " + " | ".join(cell if word in ("key", "-") else cell_of(cell, word, key, place)
                                           for cell, word in zip(cells, words)) + " |\n")
        return f"<!-- numbers: {match['words']} -->\n{match['heads']}{''.join(lines)}"

    for mark, pattern in (("<!-- = ", INLINE), ("<!-- numbers:", TABLE)):
        if text.count(mark) != len(pattern.findall(text)):
            raise NoSource(page, f"a mark '{mark}...' is not as it must be", "see experiments/kept.py --help")
    return TABLE.sub(table, INLINE.sub(inline, text))


def keep(name, run):
    """Writes what pages quote of a run folder: methods with F by scene, and who leads whom."""
    summary, differences, rows = read(run, "summary.csv", "differences.csv", "rows.csv")
    by_scene = pooled_f(scored(rows, ()).groupby(["method", "scene"])[["k_2px", "n_pred", "n_truth"]].sum()).unstack()
    width = rows.groupby("method").mean_width_px.mean().rename("width_px")
    summary = summary.set_index("method").join([by_scene, width]).assign(least=by_scene.min(axis=1))
    if (Path(run) / "kinds.csv").is_file():
        summary = summary.join(read(run, "kinds.csv")[0].pivot(index="method", columns="scene_kind", values="f_2px").add_prefix("kind_"))
    leads = differences[differences.difference > 0]
    leads = leads.assign(pair=leads.method + "-" + leads.other).drop(columns=["method", "other"]).set_index("pair")
    with open(Path(run) / "run.toml", "rb") as file:
        record = tomllib.load(file)
    KEPT.mkdir(exist_ok=True)
    summary.round(5).to_csv(KEPT / f"{name}.csv")
    leads.round(5).to_csv(KEPT / f"{name}.differences.csv")
    print(f"{name}: {record['command']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*", type=Path)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--keep", nargs=2, metavar=("NAME", "RUN"))
    parser.add_argument("--kept", type=Path, default=KEPT, help="folder of kept runs")
    options = parser.parse_args()
    if options.keep:
        keep(*options.keep)
        return 0
    kept, changed = Kept(options.kept), 0
    try:
        for page in options.pages or [path for glob in PAGES for path in sorted(ROOT.glob(glob))]:
            old = page.read_text(encoding="utf-8")
            new = rewritten(old, page, kept)
            for i, (was, now) in enumerate(zip(old.splitlines(), new.splitlines()), 1):
                if was != now:
                    print(f"{page}:{i}: {was}\n  the kept run has: {now}")
                    changed = 1
            if options.write and new != old:
                page.write_text(new, encoding="utf-8")
    except (OSError, NoSource) as error:
        print(f"kept.py: {error}", file=sys.stderr)
        return 2
    return 0 if options.write else changed


if __name__ == "__main__":
    sys.exit(main())
