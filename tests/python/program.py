"""The built program and module, for the tests of the module."""

import os
import subprocess
import sys
from pathlib import Path

try:
    import numpy as np

    import inkbench  # noqa: F401: what tests that follow import, or skip
except ImportError as reason:
    print(f"skipped: {reason} (apt-get install pybind11-dev python3-numpy, then build again)")
    sys.exit(77)

PROGRAM = os.environ["INKBENCH"]
SOURCE = Path(os.environ["INKBENCH_SOURCE"])
SIZE = {"size": (320, 180)}


def run(*arguments):
    """What the program prints; its complaint if it fails."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else done.stderr


def sentence(*arguments):
    """What the program complains of, in one line."""
    return run(*arguments).strip().removeprefix("inkbench: ")


def read_gray(path):
    """An 8-bit PNG as an array, by the library that the figures use."""
    from matplotlib import image

    return np.rint(image.imread(path) * 255).astype(np.uint8)
