#!/usr/bin/python3
"""Prints how often intervals of F hold what they say, simulated from the scenes of a run.

    experiments/intervals.py RUN [--methods A,B] [--samples N] [--resamples N] [--seed N]

The scenes of the run (rows.csv, study `compare`) are taken for the whole world, so that the F of all of them is the
truth. From them 6, 16 and 36 scenes are drawn with replacement, again and again, and every way to make an interval
makes one from each sample. Tables in Markdown: the share of intervals that hold the truth, for every way and method;
the same for paired differences; how often a test calls a lead, rightly and in the wrong direction. A method is heavy
if more than half of its error sits in one scene. Ways and tests are described in intervals.md. Needs numpy alone.
Exit code 2: no such run.
"""

import argparse
import csv
import itertools
import math
import sys
from pathlib import Path

import numpy as np

SIZES = (6, 16, 36)
NAMED = ("decaudin", "mote4", "surface8", "id_lookup")
METHODS = ("decaudin", "roberts_tuned", "sobel", "mote4", "two_sums", "ids", "surface8", "id_lookup")
BASELINES = ("none", "sampled", "exact_corner", "oracle")
OURS = "studentised, floor 1/4"
WAYS = ("percentile", "wide percentile", "BCa", "Student, log error", "studentised, log error", "studentised", OURS)
PAIR_WAYS = ("percentile", "wide percentile", "BCa", "Student", "studentised", OURS,
             "together, one error", "together, floor 1/2")
LEAST_OWN, LEAST_OF_ALL = 0.25, 0.5  # as src/statistics/simultaneous.cpp has them
HEAVY = 0.5  # share of the error in one scene


def population(folder, methods):
    """Methods, names of scenes, and per scene and method twice the matches and the pixels of both sides."""
    with open(Path(folder) / "rows.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["study"] == "compare" and row["status"] == "ok"]
    scenes = sorted({row["scene"] for row in rows})
    found = [m for m in dict.fromkeys(row["method"] for row in rows) if m not in BASELINES]
    methods = [m for m in found if m in methods] if methods else found
    hits = np.zeros((len(scenes), len(methods)))
    pixels = np.zeros((len(scenes), len(methods)))
    for row in rows:
        if row["method"] not in methods or not row["k_2px"]:
            continue
        at = scenes.index(row["scene"]), methods.index(row["method"])
        hits[at] += 2 * int(row["k_2px"])
        pixels[at] += int(row["n_pred"]) + int(row["n_truth"])
    return methods, scenes, hits, pixels


def normal_below(z):
    """The share of the normal distribution below z."""
    return 0.5 * (1 + np.vectorize(math.erf)(np.asarray(z) / math.sqrt(2)))


def normal_quantile(share):
    """Where the normal distribution has `share` below, by halving."""
    low = np.full(np.shape(share), -9.0)
    high = np.full(np.shape(share), 9.0)
    for _ in range(50):
        middle = (low + high) / 2
        is_below = normal_below(middle) < share
        low, high = np.where(is_below, middle, low), np.where(is_below, high, middle)
    return (low + high) / 2


def students(z, freedom):
    """The quantile of Student's distribution at which the normal one has z (Abramowitz and Stegun 26.7.5)."""
    z2 = z * z
    first = (z2 + 1) / 4
    second = ((5 * z2 + 16) * z2 + 3) / 96
    third = (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384
    return z * (1 + (first + (second + third / freedom) / freedom) / freedom)


def quantiles(values, low, high):
    """The quantiles of each column; `low` and `high` are a share, or one for each column."""
    ordered = np.sort(values, axis=0)
    ends = []
    for share in (low, high):
        place = np.broadcast_to(np.asarray(share, float), values.shape[1:]) * (len(values) - 1)
        below = place.astype(int)
        above = np.minimum(below + 1, len(values) - 1)
        columns = np.arange(values.shape[1])
        ends.append(ordered[below, columns] + (place - below) * (ordered[above, columns] - ordered[below, columns]))
    return ends


def wide_share(n):
    """The share below the lower end of the wide percentile interval (Hesterberg 2015)."""
    return float(normal_below(-math.sqrt(n / (n - 1)) * students(1.959964, n - 1)))


def bca(values, value, jackknife):
    """Efron's bias-corrected and accelerated interval of each column."""
    share = np.clip((np.sum(values < value, axis=0) + 0.5 * np.sum(values == value, axis=0)) / len(values),
                    1e-4, 1 - 1e-4)
    bias = normal_quantile(share)
    away = jackknife.mean(axis=0) - jackknife
    squares = np.sum(away ** 2, axis=0)
    bend = np.sum(away ** 3, axis=0) / (6 * np.maximum(squares, 1e-30) ** 1.5)
    ends = [normal_below(bias + (bias + z) / (1 - bend * (bias + z))) for z in (-1.959964, 1.959964)]
    return quantiles(values, *ends)


class Sample:
    """Scenes that were drawn from the world, and what drawing from them again gives."""

    def __init__(self, hits, pixels, times):
        self.n, self.hits, self.pixels, self.times = len(hits), hits, pixels, times
        self.f = hits.sum(axis=0) / pixels.sum(axis=0)
        self.influence = (hits - self.f * pixels) / pixels.sum(axis=0)
        self.again_pixels = times @ pixels
        self.again = times @ hits / self.again_pixels
        self.jackknife = (hits.sum(axis=0) - hits) / (pixels.sum(axis=0) - pixels)

    def error(self, influence):
        """The standard error of a sum over scenes."""
        return np.sqrt(np.sum(influence ** 2, axis=0) * self.n / (self.n - 1))

    def products(self, a, b):
        """In each drawing, the sum over scenes of what methods a and b each add to their F."""
        f_a, f_b = self.again[:, a], self.again[:, b]
        hits_a, pixels_a, hits_b, pixels_b = self.hits[:, a], self.pixels[:, a], self.hits[:, b], self.pixels[:, b]
        sums = (self.times @ (hits_a * hits_b) - f_b * (self.times @ (hits_a * pixels_b))
                - f_a * (self.times @ (pixels_a * hits_b)) + f_a * f_b * (self.times @ (pixels_a * pixels_b)))
        return sums / (self.again_pixels[:, a] * self.again_pixels[:, b])

    def again_error(self, squares):
        return np.sqrt(np.maximum(squares, 0) * self.n / (self.n - 1))


def studentised(value, error, again, again_error, least):
    """Ends by how many errors of its own each drawing is away; an error counts for `least` of the measured one."""
    away = (again - value) / np.maximum(np.maximum(again_error, least * error), 1e-9)
    low, high = quantiles(away, 0.025, 0.975)
    return value - high * error, value - low * error


def percentiles(again, value, jackknife, n):
    share = wide_share(n)
    return {"percentile": quantiles(again, 0.025, 0.975), "wide percentile": quantiles(again, share, 1 - share),
            "BCa": bca(again, value, jackknife)}


def within(interval, least):
    return np.maximum(interval[0], least), np.minimum(interval[1], 1)


def f_intervals(sample):
    """The 95 % intervals of the pooled F of every method, by way."""
    f, again = sample.f, sample.again
    error = sample.error(sample.influence)
    every = np.arange(len(f))
    again_error = sample.again_error(sample.products(every, every))
    out = percentiles(again, f, sample.jackknife, sample.n)
    for way, least in (("studentised", 0), (OURS, LEAST_OWN)):
        out[way] = within(studentised(f, error, again, again_error, least), 0)
    wrong, again_wrong = np.maximum(1 - f, 1e-9), np.maximum(1 - again, 1e-9)
    log_error = error / wrong
    low, high = studentised(np.log(wrong), log_error, np.log(again_wrong), again_error / again_wrong, 0)
    out["studentised, log error"] = 1 - np.exp(np.minimum(high, 0)), 1 - np.exp(low)
    reach = students(1.959964, sample.n - 1) * log_error
    out["Student, log error"] = 1 - np.minimum(1, wrong * np.exp(np.minimum(reach, 50))), 1 - wrong * np.exp(-reach)
    return out


def macro_intervals(sample):
    """The same of the mean of the scenes' own F."""
    n = sample.n
    own = sample.hits / sample.pixels
    mean, again = own.mean(axis=0), sample.times @ own / n
    error = own.std(axis=0, ddof=1) / math.sqrt(n)
    again_error = np.sqrt(np.maximum(sample.times @ own ** 2 / n - again ** 2, 0) / (n - 1))
    out = percentiles(again, mean, (own.sum(axis=0) - own) / (n - 1), n)
    for way, least in (("studentised", 0), (OURS, LEAST_OWN)):
        out[way] = studentised(mean, error, again, again_error, least)
    return out


def pair_intervals(sample, a, b):
    """The intervals of the differences of F of methods a less b, by way; the last two are to hold all together."""
    value, again = sample.f[a] - sample.f[b], sample.again[:, a] - sample.again[:, b]
    error = sample.error(sample.influence[:, a] - sample.influence[:, b])
    again_error = sample.again_error(sample.products(a, a) + sample.products(b, b) - 2 * sample.products(a, b))
    out = percentiles(again, value, sample.jackknife[:, a] - sample.jackknife[:, b], sample.n)
    for way, least in (("studentised", 0), (OURS, LEAST_OWN)):
        out[way] = studentised(value, error, again, again_error, least)
    reaches = {"Student": students(1.959964, sample.n - 1)}
    for way, errors in (("together, one error", error),
                        ("together, floor 1/2", np.maximum(again_error, LEAST_OF_ALL * error))):
        away = np.where(error > 1e-12, np.abs(again - value) / np.maximum(errors, 1e-12), 0)
        reaches[way] = students(np.quantile(away.max(axis=1), 0.95), sample.n - 1)
    for way, reach in reaches.items():
        out[way] = value - reach * error, value + reach * error
    return {way: within(interval, -1) for way, interval in out.items()}


def permutation(sample, a, b, signs):
    """How often swapping a and b on scenes at random makes as large a difference, of each pair."""
    sums = [(sample.hits[:, m], sample.pixels[:, m]) for m in (a, b)]
    (hits_a, pixels_a), (hits_b, pixels_b) = sums
    hits, pixels = signs @ (hits_a - hits_b), signs @ (pixels_a - pixels_b)
    hits_both, pixels_both = (hits_a + hits_b).sum(axis=0), (pixels_a + pixels_b).sum(axis=0)
    swapped = (hits_both + hits) / (pixels_both + pixels) - (hits_both - hits) / (pixels_both - pixels)
    value = np.abs(sample.f[a] - sample.f[b])
    return (1 + np.sum(np.abs(swapped) >= value - 1e-12, axis=0)) / (1 + len(signs))


def table(heading, lines):
    """Prints lines under a heading as Markdown, numbers on the right."""
    print("| " + " | ".join(heading) + " |")
    print("|---" * 2 + "|--:" * (len(heading) - 2) + "|")
    for line in lines:
        print("| " + " | ".join(line) + " |")
    print()


def simulate(hits, pixels, n, samples, resamples, random, pairs):
    """Over samples of n scenes: the share of intervals that held, their widths, and what was called a lead."""
    truth = hits.sum(axis=0) / pixels.sum(axis=0)
    macro = (hits / pixels).mean(axis=0)
    a, b = pairs
    difference = truth[a] - truth[b]
    held, widths, leads = {}, {}, {}

    def judge(kind, made, target):
        for way, interval in made.items():
            is_held = (interval[0] <= target + 1e-12) & (interval[1] >= target - 1e-12)
            held.setdefault((kind, way), []).append(is_held)
            widths.setdefault((kind, way), []).append(interval[1] - interval[0])

    def call(test, is_lead, sign, has_best):
        wrong, right = is_lead & (sign * difference < 0), is_lead & (sign * difference > 0)
        leads.setdefault(test, []).append((right.mean(), wrong.mean(), wrong.any(), wrong[has_best].any()))

    for _ in range(samples):
        drawn = random.integers(0, len(hits), n)
        times = random.multinomial(n, np.full(n, 1 / n), resamples).astype(float)
        sample = Sample(hits[drawn], pixels[drawn], times)
        judge("pooled", f_intervals(sample), truth)
        judge("mean of scenes", macro_intervals(sample), macro)
        made = pair_intervals(sample, a, b)
        judge("pairs", made, difference)
        sign = np.sign(sample.f[a] - sample.f[b])
        best = sample.f.argmax()
        has_best = (a == best) | (b == best)
        for way in ("percentile", OURS, "together, one error", "together, floor 1/2"):
            call(f"0 outside: {way}", (made[way][0] > 0) | (made[way][1] < 0), sign, has_best)
        p = permutation(sample, a, b, random.choice((-1.0, 1.0), (2 * resamples, n)))
        for level in (0.05, 0.01):
            call(f"permutation of scenes, p < {level}", p < level, sign, has_best)
        call("permutation of scenes, 0.05 by Holm", holm(p), sign, has_best)
    return ({key: np.array(value) for key, value in held.items()},
            {key: np.median(value, axis=0) for key, value in widths.items()},
            {key: 100 * np.mean(value, axis=0) for key, value in leads.items()})


def holm(p):
    """Which of all p keep a level of 0.05 together."""
    order = np.argsort(p)
    is_small = p[order] < 0.05 / np.arange(len(p), 0, -1)
    kept = np.zeros(len(p), bool)
    kept[order] = np.cumprod(is_small).astype(bool)
    return kept


def print_coverage(kind, methods, heavy, results):
    """A line a way and size: coverage of the named methods and of the light ones, and the median width."""
    named = [methods.index(m) for m in NAMED if m in methods]
    lines = []
    for way in WAYS:
        for n in SIZES:
            held, widths, _ = results[n]
            if (kind, way) not in held:
                continue
            share = held[kind, way].mean(axis=0)
            lines.append([way, str(n)] + [f"{share[i]:.2f}" for i in named] + [f"{share[~heavy].mean():.2f}"]
                         + [f"{widths[kind, way][i]:.3f}" for i in named])
    print(f"Share of 95 % intervals that hold F, {kind}; on the right, their median width:\n")
    table(["interval", "scenes"] + [methods[i] for i in named] + ["all light"] + [f"width {methods[i]}" for i in named],
          lines)


def main(words):
    args = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    args.add_argument("run")
    args.add_argument("--methods", help="a,b, or all (those of the tables in intervals.md)", default=",".join(METHODS))
    args.add_argument("--samples", type=int, default=1500)
    args.add_argument("--resamples", type=int, default=1000)
    args.add_argument("--seed", type=int, default=1)
    args = args.parse_args(words)
    if not (Path(args.run) / "rows.csv").is_file():
        print(f"intervals.py: {args.run} has no rows.csv", file=sys.stderr)
        return 2
    methods, scenes, hits, pixels = population(args.run, None if args.methods == "all" else args.methods.split(","))
    share = (pixels - hits) / (pixels - hits).sum(axis=0)
    heavy = share.max(axis=0) > HEAVY
    print(f"{len(scenes)} scenes, {args.samples} samples of each size, {args.resamples} resamples.\n")
    table(["method", "scene with most of its error", "share", "F"],
          [[m, scenes[int(share[:, i].argmax())], f"{share[:, i].max():.2f}",
            f"{hits[:, i].sum() / pixels[:, i].sum():.3f}"] for i, m in enumerate(methods)])
    pairs = tuple(np.array(list(itertools.combinations(range(len(methods)), 2))).T)
    random = np.random.default_rng(args.seed)
    results = {n: simulate(hits, pixels, n, args.samples, args.resamples, random, pairs) for n in SIZES}
    for kind in ("pooled", "mean of scenes"):
        print_coverage(kind, methods, heavy, results)
    print(f"Share of 95 % intervals of the {len(pairs[0])} paired differences that hold, and their median width:\n")
    table(["interval", "scenes", "one pair", "all pairs at once", "width"],
          [[way, str(n), f"{results[n][0]['pairs', way].mean():.2f}",
            f"{results[n][0]['pairs', way].all(axis=1).mean():.2f}", f"{np.median(results[n][1]['pairs', way]):.3f}"]
           for way in PAIR_WAYS for n in SIZES])
    print("Leads that a test calls. Right and wrong: in % of pairs. Then in % of samples: one pair or more in the\n"
          "wrong direction, and one of those with the most exact method in it:\n")
    table(["test", "scenes", "right", "wrong", "any wrong", "any wrong with the best"],
          [[test, str(n)] + [f"{value:.1f}" for value in results[n][2][test]]
           for test in results[SIZES[0]][2] for n in SIZES])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
