#!/usr/bin/python3
"""Prints how far F depends on the crease angle that truth and methods share.

    experiments/crease_angle.py build/release/inkbench METHODS [SCENE | MODEL | OPTION ...]

The truth calls an edge a crease from an angle on, and methods that know the mesh use the same angle: a home
advantage. Two tables in Markdown, F at 2 px of all views pooled. In the first, methods follow the truth's angle; at
180 degrees there are no creases, and F is of contours, boundaries, intersections and seams alone. In the second,
methods keep 40 degrees while the truth's angle moves. Each table has a line for each part of the suite that took part.
METHODS is a list a,b as `inkbench compare` takes it, and so are scenes and options, such as --views 1. Without scenes:
the catalogue. Exit code 2: the program refused.
"""

import pandas as pd

from run_tables import compared, pooled_f, print_heads, words_of

ANGLES_DEG = (20, 30, 40, 50, 60, 180)


def measure(program, methods, scenes, angle_deg, settings):
    """F by method and part, in the order of rows, with the truth's creases from `angle_deg` on."""
    rows = compared(program, *scenes, "--methods", methods, "--crease", str(angle_deg), *settings)
    groups = rows.groupby(["method", "split"], sort=False)
    return pooled_f(groups[["k_2px", "n_pred", "n_truth"]].sum())


def main():
    program, methods, *scenes = words_of(__doc__, least=2)
    for settings in ([], ["--set", "crease_deg=40"]):
        print_heads(["method", "part"], [f"{angle} deg" for angle in ANGLES_DEG])
        found = pd.concat([measure(program, methods, scenes or ["catalogue"], angle, settings)
                           for angle in ANGLES_DEG], axis=1)
        for (method, part), values in zip(found.index, found.to_numpy()):
            print(f"| `{method}` | {part} | " + " | ".join(f"{value:.3f}" for value in values) + " |")
        print(flush=True)


if __name__ == "__main__":
    main()
