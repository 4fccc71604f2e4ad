"""What the scripts beside this file share: their words, and the tables of run folders."""

import subprocess
import sys
import tempfile
from pathlib import Path

import pandas as pd

BASELINES = {"none", "sampled", "exact_corner", "oracle"}

def refuse(message):
    """Ends the script: what it was given cannot be used."""
    print(message, file=sys.stderr)
    raise SystemExit(2)

def words_of(page, least=1):
    """The words of the command line; exit code 2 and the page where they are too few."""
    words = sys.argv[1:]
    return words if len(words) >= least else refuse(page.strip())

def read(folder, *names):
    """These tables of a run folder; exit code 2 where it has them not."""
    try:
        return [pd.read_csv(Path(folder) / name) for name in names]
    except (OSError, ValueError) as reason:
        refuse(f"{folder}: {reason} (accepted: a folder that inkbench compare wrote)")

def compared(program, *words):
    """The scored rows of `inkbench compare` with these words, without times, sweeps, checks and images."""
    with tempfile.TemporaryDirectory() as folder:
        ran = subprocess.run([program, "compare", *words, "--no-sweep", "--no-times", "--no-crosscheck", "--images", "none",
                              "--quiet", "--out", folder], capture_output=True, text=True)
        if ran.returncode not in (0, 1, 3):  # 1 and 3: all or some views have no score
            refuse(ran.stderr.strip())
        return scored(read(folder, "rows.csv")[0])

def scored(rows, without=("none", "oracle")):
    """The rows that have a score, but for some methods."""
    return rows[(rows.status == "ok") & ~rows.method.isin(without)]

def pooled_f(counts):
    """F at 2 px of summed counts: a number, or one a line."""
    return 2 * counts.k_2px / (counts.n_pred + counts.n_truth)

def print_heads(texts, numbers):
    """The two lines above a table in Markdown."""
    print(f"| {' | '.join([*texts, *numbers])} |\n|{'---|' * len(texts)}{'--:|' * len(numbers)}", flush=True)
