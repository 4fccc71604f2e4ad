#!/usr/bin/python3
"""Makes the tables of measurements in the pages of methods.

    methods/measured.py [PAGE.md...] [--program PATH] [--check]

A table stands between a comment that says what is measured and one that ends it:

    <!-- measured: --scenes figure --size 640x360 --methods polygon_offset
    factor=-0.5
    factor=-1 units=0
    columns: precision_2px recall_contour
    -->
    ...
    <!-- /measured -->

The first line holds options of `inkbench compare` that choose scenes, views, size and one method. Each
further line is one setting of that method, `-` its defaults. The columns are f_2px, precision_2px,
recall_2px and recall_GROUP with a class of rows.csv; counts of all views are pooled. Without pages,
all of methods/*/*.md are made again. Needs the built program. Prints each page whose text changes;
with --check nothing is written, and the exit code is 1 if a page would change. Exit code 2: a page
or the program is not as it must be; no page is then half-written.
"""

import argparse
import re
import shlex
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "experiments"))
from run_tables import BASELINES, compared  # noqa: E402

BLOCK = re.compile(r"<!-- measured: (?P<asked>.*?)-->\n(?P<table>.*?)<!-- /measured -->", re.DOTALL)


class BadPage(Exception):
    """What a page asks for cannot be had: where, what is wrong, what is accepted."""

    def __init__(self, where, what, accepted):
        super().__init__(f"{where}: {what} (accepted: {accepted})")


def value(rows, column, where):
    """One column over the scored rows of a method, as text; "-" where there is nothing to divide by."""
    group = column.removeprefix("recall_")
    under = {"f_2px": ["n_pred", "n_truth"], "precision_2px": ["n_pred"], "recall_2px": ["n_truth"]}.get(
        column, [f"truth_px_{group}"])
    over = f"k_{group}" if under[0] == f"truth_px_{group}" else "k_2px"
    if not {over, *under} <= set(rows):
        raise BadPage(where, f"there is no column {column}",
                      "f_2px, precision_2px, recall_2px, recall_CLASS")
    k, n = len(under) * rows[over].sum(), rows[under].sum().sum()
    return f"{k / n:.3f}" if n else "-"


def heading(column):
    return {"f_2px": "F", "precision_2px": "precision", "recall_2px": "recall"}.get(
        column, column.replace("recall_", "recall of ").replace("_", " "))


def measure(program, options, setting, where):
    """The scored rows of the method that `compare` draws with one setting."""
    sets = [] if setting == "-" else [part for pair in setting.split() for part in ("--set", pair)]

    def refuse(said):
        raise BadPage(where, said, "options and settings of inkbench compare")

    rows = compared(program, *options, *sets, on_refusal=refuse)
    return rows[~rows.method.isin(BASELINES)]


def table(program, asked, where):
    """The table that a block asks for, as Markdown."""
    lines = [line.strip() for line in asked.strip().splitlines()]
    last = lines.pop() if lines else ""
    if not last.startswith("columns:") or len(lines) < 2:
        raise BadPage(where, "a block must say options, settings and columns",
                      "options of compare, a line a setting, then columns: A B")
    columns = last.removeprefix("columns:").split()
    options = shlex.split(lines[0])
    text = "| setting | " + " | ".join(heading(c) for c in columns) + " |\n"
    text += "|---|" + "--:|" * len(columns) + "\n"
    for setting in lines[1:]:
        rows = measure(program, options, setting, where)
        shown = "defaults" if setting == "-" else " ".join(f"`{pair}`" for pair in setting.split())
        text += f"| {shown} | " + " | ".join(value(rows, c, where) for c in columns) + " |\n"
    return text


def remade(program, path):
    """A page's text with its tables made again, and its text as it is."""
    old = path.read_text(encoding="utf-8")
    if old.count("<!-- measured:") != len(BLOCK.findall(old)):
        raise BadPage(path, "a block does not end", "<!-- measured: ... --> and <!-- /measured -->")

    def block(match):
        line = old.count("\n", 0, match.start()) + 1
        new = table(program, match["asked"], f"{path}:{line}")
        return f"<!-- measured: {match['asked']}-->\n{new}<!-- /measured -->"

    return BLOCK.sub(block, old), old


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("pages", nargs="*", type=Path, help="pages (default: methods/*/*.md)")
    parser.add_argument("--program", default=str(ROOT / "build/release/inkbench"))
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 on a change")
    options = parser.parse_args()
    changed = {}
    try:
        for page in options.pages or sorted(ROOT.glob("methods/*/*.md")):
            new, old = remade(options.program, page)
            if new != old:
                changed[page] = new
        for page, text in changed.items():
            print(page)
            if not options.check:
                page.write_text(text, encoding="utf-8")
    except (OSError, BadPage) as error:
        print(f"measured.py: {error}", file=sys.stderr)
        return 2
    return 1 if changed and options.check else 0


if __name__ == "__main__":
    sys.exit(main())
