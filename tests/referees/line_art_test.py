"""Blender's Line Art draws the same lines: fixtures of six catalogue scenes.

Of the length of either, at least .999 lies within .25 px of the other; what Line Art draws more is
flat by the ray probe. The fixtures are made by line_art/make_fixtures.
"""

import unittest
from pathlib import Path

import numpy as np

import catalogue_scenes
from outline import distances_px, make_outline
from probe_view import View
from program import trace

SCENES = ("blocks", "crystals", "letters", "staircase", "teapot", "knot")
CREASE_DEG = 40
NEAR_PX = 0.25
STEP_PX = 0.25
FIXTURES = Path(__file__).resolve().parent / "line_art"


def read_fixture(name):
    """Line Art's polylines of a scene, as an outline of one class."""
    lines = (FIXTURES / f"{name}.txt").read_text(encoding="ascii").splitlines()
    return make_outline((1, [tuple(map(float, p.split(","))) for p in line.split()])
                        for line in lines if line and not line.startswith("#"))


def inside(places, camera):
    """Which places lie in the frame, half a pixel from its borders."""
    return ((places > 0.5) & (places < np.array([camera.width_px, camera.height_px]) - 0.5)).all(1)


def uncovered(of, by, camera):
    """Places of one outline further than NEAR_PX from another, the px each stands for, and the px
    looked at in all."""
    places, piece, length = of.samples(STEP_PX)
    kept = inside(places, camera)
    places, piece, length = places[kept], piece[kept], length[kept]
    far = ~np.isfinite(distances_px(places, by, NEAR_PX)[0])
    return places[far], piece[far], length[far], length.sum()


class LineArtTest(unittest.TestCase):
    def judge(self, name):
        mesh, camera = catalogue_scenes.load(name)
        fixture, truth = read_fixture(name), trace(mesh, camera, CREASE_DEG).outline
        _, _, missed_px, truth_px = uncovered(truth, fixture, camera)
        places, piece, more_px, drawn_px = uncovered(fixture, truth, camera)
        along = fixture.pieces[piece, 1] - fixture.pieces[piece, 0]
        flat = View(mesh, camera, CREASE_DEG).are_flat(places, along, CREASE_DEG)
        wrong_px = more_px[~flat]
        print(f"{name:<10} truth {truth_px:7.1f} px, {missed_px.sum():6.2f} not in Line Art; "
              f"Line Art {drawn_px:7.1f} px, {more_px.sum():6.2f} more, {wrong_px.sum():.2f} of it "
              "not flat", flush=True)
        for x, y in places[~flat][:10]:
            print(f"    ({x:.2f}, {y:.2f}) not flat")
        return 1 - missed_px.sum() / truth_px, 1 - wrong_px.sum() / drawn_px

    def test_both_draw_the_same(self):
        for name in SCENES:
            with self.subTest(scene=name):
                of_truth, of_fixture = self.judge(name)
                self.assertGreaterEqual(of_truth, 0.999, "of the truth is in Line Art")
                self.assertGreaterEqual(of_fixture, 0.999, "of Line Art is in the truth or flat")


if __name__ == "__main__":
    unittest.main(verbosity=2)
