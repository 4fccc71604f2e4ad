#!/usr/bin/python3
"""Prints the tables of cad_edges.md: which edges of CAD models are lines, and what the crease angle finds of them.

    experiments/cad_edges.py build/release/inkbench [FOLDER]

The models are those of Debian's package occt-misc whose faces all meet others. Each is tessellated at three
tolerances by experiments/brep/tessellate into FOLDER (default: inkbench-out/brep) and kept there. Its truth of edges
is that of its BRep: two faces that meet other than tangentially. Shares are of lengths of edges between two triangles,
each model alike. Rules are found on one half of the families of models and judged on the other. The picture is
FOLDER/cad_edges.png.
"""

import importlib.machinery
import importlib.util
import json
import sys
from itertools import product
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

from run_tables import compared, pooled_f, print_heads, refuse, said, words_of

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "brep"), str(HERE / "models")]

from mesh_edges import read_edges  # noqa: E402
from packages import Missing, Package  # noqa: E402

PACKAGE = ("debian", "occt-misc", "7.6.3+dfsg1-7")
DATA = "usr/share/opencascade/data"
# By families: the rules' own half is every other one.
FAMILIES = [["Axis_of_bearing"], ["Ball"], ["Bottom", "Top"], ["CrankArm"], ["MODERN_Chair_1"],
            ["MODERN_Cooker_1", "MODERN_Cooker_1_opened"], ["MODERN_Exhaust_1"],
            ["MODERN_MVCooker_1", "MODERN_MVCooker_1_opened"],
            ["MODERN_Refrigerator_1", "MODERN_Refrigerator_1_opened"],
            ["MODERN_Sink_1", "MODERN_Sink_1_opened"], ["MODERN_Table_1"], ["Motor-c"],
            ["Pump_Nut", "Pump_TopCover"], ["bottle"], ["fuse"], ["hammer"], ["linkrods"],
            ["mal_ecrou", "mal_tige", "mal_vis"], ["wedge_ok"]]
# Name, tolerance (share of the diagonal), angle between facets (degrees).
TOLERANCES = [("coarse", 1e-2, 45), ("usual", 1e-3, 28.6), ("fine", 1e-4, 10)]
METHODS = "ids,surface8,surface_lookup,id_lookup,mote4,mote4_tuned"
SIZE = "640x360"
CREASE_DEG = 40


def tessellate_module():
    path = str(HERE / "brep" / "tessellate")
    spec = importlib.util.spec_from_loader("tessellate", importlib.machinery.SourceFileLoader("tessellate", path))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def own_edges(source):
    """How many edges a STEP or BRep file itself has."""
    lines = source.read_text(errors="replace").splitlines()
    if source.suffix == ".step":
        return sum("EDGE_CURVE(" in line.replace(" ", "") for line in lines)
    return sum(line.startswith("Ed") for line in lines)  # a record of the section TShapes


def made(folder):
    """By model its counts and own edges; and the .glb files, all written. Exits with 2 where a part is missing."""
    tool = tessellate_module()
    folder.mkdir(parents=True, exist_ok=True)
    try:
        package = Package(*PACKAGE, folder)
        counts = {}
        for name in [name for family in FAMILIES for name in family]:
            kind = "step" if name == "linkrods" else "brep"
            source = folder / f"{name}.{kind}"
            if not source.exists():
                source.write_bytes(package.read(f"{DATA}/{'step' if kind == 'step' else 'occ'}/{source.name}"))
            for tolerance, share, angle_deg in TOLERANCES:
                told = glb(folder, name, tolerance).with_suffix(".json")
                if not told.exists():
                    found = tool.tessellate(source, glb(folder, name, tolerance), share, angle_deg)
                    told.write_text(json.dumps({**found, "own": own_edges(source)}))
                counts[name, tolerance] = json.loads(told.read_text())
    except (Missing, tool.Absent, tool.Failed) as reason:
        refuse(str(reason))
    return pd.DataFrame.from_dict(counts, orient="index")


def glb(folder, name, tolerance):
    return folder / f"{name}_{tolerance}.glb"


def print_counts(counts):
    print("Edges of the models, and those of their files\n")
    heads = ["own", "edges", "degenerate", "seams", "tangent", "sharp", "free", "unmeshed"]
    print_heads(["model"], heads)
    usual = counts.xs("usual", level=1)
    for name, row in usual.iterrows():
        print(f"| {name} | " + " | ".join(str(row[head]) for head in heads) + " |")
    differing = usual[usual.own != usual.edges + usual.degenerate]
    print(f"\n{len(usual)} models, {usual.edges.sum()} edges; {len(differing)} models have other counts than their "
          "files\n")


# Rules: a rule says which edges are creases, from numbers of a table of them.

def by_angle(edges, angle_deg):
    return edges.bend_deg >= angle_deg


def beside(edges, least_deg, times, sure_deg):
    """Bends more than what lies along it on either side."""
    is_more = edges.bend_deg >= times * edges.beside_deg.max(axis=1)
    return (edges.bend_deg >= sure_deg) | (edges.bend_deg >= least_deg) & is_more


def arc(edges, least_deg, height, sure_deg):
    """An arc over its facets would stand out by more than a share of the diagonal."""
    width = np.minimum(edges.width.min(axis=1), 1)
    is_high = np.radians(edges.bend_deg) * width / 8 >= height
    return (edges.bend_deg >= sure_deg) | (edges.bend_deg >= least_deg) & is_high


def plateau_deg(edges, share, low_deg, high_deg):
    """The geometric mean of the widest range of angles, as a ratio, in which at most a share of the length bends and
    below which more does: what inkbench explain proposes, with 0.01, 8 and 60."""
    bins = np.bincount(np.minimum(edges.bend_deg.astype(int), 179), edges.length, minlength=180)
    bins[0] = 0
    below = np.concatenate([[0], bins.cumsum()])
    most = share * below[-1]
    best = (1, CREASE_DEG)
    for begin in range(low_deg, high_deg):
        end = min(np.searchsorted(below, below[begin] + most, side="right") - 1, high_deg)
        if below[begin] > most and end / begin > best[0]:
            best = (end / begin, round((begin * end) ** 0.5))
    return best[1]


def plateau(edges, *values):
    return by_angle(edges, plateau_deg(edges, *values))


RULES = {
    "one angle": (by_angle, [(a,) for a in range(10, 65, 5)]),
    "more than beside it": (beside, list(product((10, 15, 20, 30), (1.2, 1.5, 2, 3), (40, 50, 60, 181)))),
    "height of an arc": (arc, list(product((10, 15, 20, 30), (3e-4, 1e-3, 3e-3, 1e-2), (40, 50, 60, 181)))),
    "gap of the model": (plateau, list(product((0.003, 0.01, 0.02, 0.05), (5, 8, 12), (50, 60, 80)))),
}


def judged(rule, values, edges):
    """Recall, precision and F of a rule on a model's edges."""
    chosen = rule(edges, *values)
    recall, precision = edges.share(chosen, edges.is_marked), edges.share(edges.is_marked, chosen)
    return recall, precision, 2 * recall * precision / (recall + precision) if recall + precision > 0 else 0


def f_of(rule, values, models):
    return np.array([judged(rule, values, edges)[2] for edges in models])


def print_angle(edges, counts):
    print("The angle, by tolerance\n")
    print_heads(["tolerance", "angle"], ["triangles", "recall", "precision", "F", "worst F"])
    for tolerance, share, _ in TOLERANCES:
        models = {name: of for (name, at), of in edges.items() if at == tolerance}
        triangles = counts.xs(tolerance, level=1).triangles.sum()
        for angle in (20, 25, 30, CREASE_DEG, 50):
            all_judged = {name: judged(by_angle, (angle,), of) for name, of in models.items()}
            worst = min(all_judged, key=lambda name: all_judged[name][2])
            recall, precision, f = np.mean(list(all_judged.values()), axis=0)
            print(f"| {tolerance} | {angle} deg | {triangles} | {recall:.3f} | {precision:.3f} | {f:.3f} | "
                  f"{all_judged[worst][2]:.3f} {worst} |")
    print()


def resampled_gain(gain, family, draws=2000):
    """The mean gain, and its 95 % interval when families are drawn anew."""
    of_family = [gain[family == each] for each in np.unique(family)]
    random = np.random.default_rng(1)
    means = [np.concatenate([of_family[i] for i in random.integers(0, len(of_family), len(of_family))]).mean()
             for _ in range(draws)]
    return gain.mean(), *np.percentile(means, [2.5, 97.5])


def print_rules(edges):
    """Each rule at the values that are best on the other families, for halves of them and for each left out."""
    family = np.array([next(i for i, of in enumerate(FAMILIES) if name in of) for name, _ in edges])
    models = list(edges.values())
    usual = f_of(by_angle, (CREASE_DEG,), models)
    first = family % 2 == 0
    print(f"Rules: mean F of {len(models)} meshes; {CREASE_DEG} degrees have {usual[first].mean():.3f} on the first "
          f"half, {usual[~first].mean():.3f} on the second\n")
    print_heads(["rule", "values of the first half"], ["first half", "second half", "gain there", "other way round",
                                                       "families left out", "95 %"])
    for name, (rule, grid) in RULES.items():
        of_grid = np.array([f_of(rule, values, models) for values in grid])
        best = of_grid[:, first].mean(axis=1).argmax()
        back = of_grid[:, ~first].mean(axis=1).argmax()
        left_out = np.empty(len(models))
        for each in np.unique(family):
            is_own = family == each
            left_out[is_own] = of_grid[of_grid[:, ~is_own].mean(axis=1).argmax(), is_own]
        mean, low, high = resampled_gain(left_out - usual, family)
        print(f"| {name} | {', '.join(f'{value:g}' for value in grid[best])} | {of_grid[best, first].mean():.3f} | "
              f"{of_grid[best, ~first].mean():.3f} | {(of_grid[best] - usual)[~first].mean():+.3f} | "
              f"{(of_grid[back] - usual)[first].mean():+.3f} | {mean:+.3f} | {low:+.3f} to {high:+.3f} |", flush=True)
    print()


def print_proposal(program, edges, folder):
    """What inkbench explain proposes, beside the usual angle and the best of each mesh."""
    print("The angle that explain proposes\n")
    print_heads(["tolerance"], ["F at 40", "F at the proposal", "F at each mesh's best", "least proposal", "largest"])
    for tolerance, *_ in TOLERANCES:
        of = {name: each for (name, at), each in edges.items() if at == tolerance}
        proposed = {name: json.loads(said([program, "explain", str(glb(folder, name, tolerance)), "--methods", "ids",
                                           "--views", "1", "--json"]))["statistics"]["crease_proposal"] for name in of}
        best = [max(judged(by_angle, (angle,), each)[2] for angle in range(5, 90)) for each in of.values()]
        own = [judged(by_angle, (proposed[name],), each)[2] for name, each in of.items()]
        print(f"| {tolerance} | {f_of(by_angle, (CREASE_DEG,), of.values()).mean():.3f} | {np.mean(own):.3f} | "
              f"{np.mean(best):.3f} | {min(proposed.values()):.0f} | {max(proposed.values()):.0f} |", flush=True)
    print()


def exact_counts(program, model, folder):
    """How the exact lines of the usual angle score against those of the faces."""
    image = folder / "angle.png"
    said([program, "truth", str(model), "--size", SIZE, "--intersections", "above_crease", "-o", str(image), "--quiet"])
    told = json.loads(said([program, "score", str(image), "--model", str(model), "--creases", "file", "--threshold",
                            "1", "--polarity", "light", "--band", "6", "--json", "--quiet"]))
    crease = told["classes"].get("3", {"k": 0, "n_truth": 0})
    return {"k_2px": told["k"], "n_pred": told["n_pred"], "n_truth": told["n_truth"], "k_crease": crease["k"],
            "truth_px_crease": crease["n_truth"]}


def print_methods(program, counts, folder):
    """F of methods against the truth of the faces and against that of the angle."""
    print(f"Methods at {CREASE_DEG} degrees, one view of each model at {SIZE}, pixels pooled\n")
    exact = "the exact lines of the angle"
    found = {}
    for tolerance, *_ in TOLERANCES:
        paths = [glb(folder, name, tolerance) for name in counts.xs(tolerance, level=1).index]
        for creases in ("angle", "file"):
            rows = compared(program, "--scenes", ",".join(map(str, paths)), "--methods", METHODS, "--views", "1",
                            "--size", SIZE, "--creases", creases)
            found[tolerance, creases] = rows.groupby("method")[
                ["k_2px", "n_pred", "n_truth", "k_crease", "truth_px_crease"]].sum()
        found[tolerance, "file"].loc[exact] = pd.DataFrame(
            [exact_counts(program, path, folder) for path in paths]).sum()
    print_heads(["method"], ["F by angle, usual", *[f"F by faces, {tolerance}" for tolerance, *_ in TOLERANCES],
                             "recall, usual", "precision, usual", "recall of creases, usual"])
    usual = found["usual", "file"]
    for method in [exact, *METHODS.split(",")]:
        row = usual.loc[method]
        own = 1 if method == exact else pooled_f(found["usual", "angle"].loc[method])
        by_faces = [pooled_f(found[tolerance, "file"].loc[method]) for tolerance, *_ in TOLERANCES]
        values = [own, *by_faces, row.k_2px / row.n_truth, row.k_2px / row.n_pred, row.k_crease / row.truth_px_crease]
        print(f"| {method if method == exact else f'`{method}`'} | {' | '.join(f'{value:.3f}' for value in values)} |")
    print()


def draw_picture(program, folder):
    """cad_edges.png: two models, each with the lines of its faces and with those of the angle."""
    panels = []
    for name, tolerance in (("Pump_Nut", "usual"), ("linkrods", "coarse")):
        for creases in ("file", "angle"):
            image = folder / f"{name}_{creases}.png"
            said([program, "truth", str(glb(folder, name, tolerance)), "--size", "480x400", "--fit", "box", "--creases",
                  creases, "--image", str(image), "--quiet"])
            panels.append(plt.imread(image)[:, :, :3])
    plt.imsave(folder / "cad_edges.png", np.hstack(panels))


def main():
    program, *rest = words_of(__doc__, most=2)
    folder = Path(rest[0]) if rest else Path("inkbench-out/brep")
    counts = made(folder)
    print_counts(counts)
    edges = {key: read_edges(glb(folder, *key)) for key in counts.index}
    print_angle(edges, counts)
    print_rules(edges)
    print_proposal(program, edges, folder)
    print_methods(program, counts, folder)
    draw_picture(program, folder)


if __name__ == "__main__":
    main()
