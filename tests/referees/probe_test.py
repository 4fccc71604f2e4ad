"""Rays in double precision agree with the truth on .999 of what they look at, over ten views."""

import unittest

import numpy as np

import catalogue_scenes
from camera import camera_round
from probe_view import Verdict, View
from program import trace
from shapes import SHAPES

SHAPE_VIEWS = ("boxes_on_a_floor", "abutting_boxes", "crossing_boxes", "smooth_shapes",
               "touching_solids")
CATALOGUE_VIEWS = ("staircase", "torus", "tiles", "crystals", "gear")
PLACES = 1500
MOST_LISTED = 12
MOST_PAIRED = 3000  # faces: each is tried with each


class ProbeTest(unittest.TestCase):
    def judge(self, name, mesh, camera):
        view, truth = View(mesh, camera), trace(mesh, camera)
        random = np.random.default_rng(10)
        return {
            "drawn": view.judge_drawn(truth.outline, PLACES, random),
            "missing": view.judge_missing(truth.outline, PLACES, random),
            "crossings": view.judge_crossings(truth.outline) if len(view.welded.faces) < MOST_PAIRED
            else Verdict(),
            "passed": view.judge_passed(truth.outline, step=4),
        }

    def check(self, views):
        totals = {}
        for name, mesh, camera in views:
            for question, verdict in self.judge(name, mesh, camera).items():
                totals.setdefault(question, Verdict()).add(verdict)
                print(f"{name:<18} {question:<9} {verdict}")
                for x, y, why in verdict.failed[:MOST_LISTED]:
                    print(f"    ({x:.2f}, {y:.2f}) {why}")
        for question, verdict in totals.items():
            with self.subTest(question=question):
                self.assertGreaterEqual(verdict.agreement, 0.999, str(verdict))

    def test_shapes(self):
        meshes = {name: SHAPES[name]() for name in SHAPE_VIEWS}
        self.check((name, mesh, camera_round(mesh)) for name, mesh in meshes.items())

    def test_catalogue(self):
        self.check((name, *catalogue_scenes.load(name)) for name in CATALOGUE_VIEWS)


if __name__ == "__main__":
    unittest.main(verbosity=2)
