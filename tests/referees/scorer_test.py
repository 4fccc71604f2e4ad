"""The scorer counts what tests/score/oracle counts, to the last integer, on random hard pairs.

    scorer_test.py [--pairs N] [--seed N]

Dots, chains that need long augmenting paths, thick and doubled lines, classes and ignored pixels.
Without scikit-image, which the oracle thins with, only pairs that are not thinned are compared.
"""

import argparse
import importlib.util
import json
import sys
import types
from pathlib import Path

import numpy as np
from PIL import Image

from program import DESK, ROOT, inkbench, skip

ORACLE = ROOT / "tests" / "score" / "oracle" / "score_oracle.py"
TOLERANCES_PX = (1, 1.5, 2, 3, 4)


def load_oracle():
    """The oracle as a module, and whether it can thin."""
    can_thin = importlib.util.find_spec("skimage") is not None
    if not can_thin:
        stand_in = types.ModuleType("skimage.morphology")
        stand_in.thin = None
        sys.modules["skimage"] = types.ModuleType("skimage")
        sys.modules["skimage.morphology"] = stand_in
    try:
        spec = importlib.util.spec_from_file_location("score_oracle", ORACLE)
        oracle = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(oracle)
    except ImportError as error:
        skip(f"the scoring oracle needs what is not installed ({error})")
    return oracle, can_thin


# ---- Images: bool maps of one size -----------------------------------------------------------


def dots(random, size, share=None):
    return random.random(size) < (share or random.choice([0.003, 0.03, 0.12, 0.4]))


def _draw(image, a, b):
    count = int(np.abs(b - a).max()) + 1
    for t in np.linspace(0, 1, count):
        y, x = np.rint(a + t * (b - a)).astype(int)
        if 0 <= y < image.shape[0] and 0 <= x < image.shape[1]:
            image[y, x] = True


def strokes(random, size):
    image = np.zeros(size, bool)
    for _ in range(random.integers(1, 14)):
        _draw(image, random.uniform(-5, size, 2), random.uniform(-5, size, 2))
    return image


def hatching(random, size):
    """Parallel lines closer than most tolerances."""
    image = np.zeros(size, bool)
    image[::random.integers(2, 5)] = True
    return image if random.random() < 0.5 else image & dots(random, size, 0.9)


def combs(random, size):
    """Rows of dots at a fixed pitch: the one matching of all pairs is far from the greedy one."""
    image = np.zeros(size, bool)
    image[::random.integers(3, 9), random.integers(0, 3)::random.integers(2, 5)] = True
    return image


def blobs(random, size):
    image = np.zeros(size, bool)
    for _ in range(random.integers(1, 6)):
        y, x = random.integers(0, size)
        h, w = random.integers(1, 12, 2)
        image[y:y + h, x:x + w] = True
    return image


def nothing(_, size):
    return np.zeros(size, bool)


KINDS = (dots, strokes, strokes, hatching, combs, blobs, nothing)


def shaken(random, image):
    """The same lines moved by a pixel or two, with losses and additions."""
    moved = np.roll(image, random.integers(-2, 3, 2), (0, 1))
    return (moved & (random.random(image.shape) > 0.1)) | dots(random, image.shape, 0.004)


def random_pair(random):
    """(prediction, truth), 8-bit."""
    size = tuple(random.integers(5, 90, 2))
    truth = KINDS[random.integers(len(KINDS))](random, size)
    drawn = (shaken(random, truth) if random.random() < 0.6
             else KINDS[random.integers(len(KINDS))](random, size))
    response = random.integers(1, 256, size) if random.random() < 0.5 else np.full(size, 255)
    has_classes = random.random() < 0.6
    labels = random.choice([1, 2, 3, 4, 5, 7], size) if has_classes else np.full(size, 255)
    return (drawn * response).astype(np.uint8), (truth * labels).astype(np.uint8)


# ---- Both scorers ----------------------------------------------------------------------------


def oracle_counts(oracle, prediction, truth, options):
    asked = types.SimpleNamespace(ignore=options["ignore"], thin=options["thin"],
                                  tol=options["tol"])
    score = oracle.ImageScore(prediction, truth, asked)
    k, n_pred, n_truth = score.counts(options["threshold"])
    _, thinned = score.binarise(options["threshold"])
    classes = {str(v): {"k": oracle.max_cardinality(thinned, of, options["tol"]),
                        "n_truth": int(of.sum())} for v, of in score.classes.items()}
    return {"k": k, "n_pred": n_pred, "n_truth": n_truth, "classes": classes}


def program_counts(prediction, truth, options):
    folder = Path(DESK.name)
    Image.fromarray(prediction).save(folder / "prediction.png")
    Image.fromarray(truth).save(folder / "truth.png")
    words = ["--tol", options["tol"], "--threshold", options["threshold"], "--json"]
    words += [] if options["thin"] else ["--no-thin"]
    words += ["--ignore", options["ignore"]] if options["ignore"] else []
    said = json.loads(inkbench("score", folder / "prediction.png", folder / "truth.png", *words))
    return {key: said[key] for key in ("k", "n_pred", "n_truth", "classes")}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pairs", type=int, default=80)
    parser.add_argument("--seed", type=int, default=839)
    args = parser.parse_args()
    oracle, can_thin = load_oracle()
    failed = 0
    for seed in range(args.seed, args.seed + args.pairs):
        random = np.random.default_rng(seed)
        prediction, truth = random_pair(random)
        options = {"tol": float(random.choice(TOLERANCES_PX)),
                   "threshold": int(random.choice([1, 60, 128, 255])),
                   "thin": bool(can_thin and random.random() < 0.5),
                   "ignore": 7 if random.random() < 0.4 else None}
        wanted = oracle_counts(oracle, prediction, truth, options)
        found = program_counts(prediction, truth, options)
        if wanted != found:
            failed += 1
            print(f"seed {seed} {prediction.shape} {options}:")
            print(f"  oracle  {wanted}\n  program {found}")
    print(f"{args.pairs} pairs{'' if can_thin else ', none thinned'}: {failed} differ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
