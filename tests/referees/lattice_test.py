"""Random lattice scenes judged by rays, and the same seen with the axes permuted; and such scenes
before eyes in the planes of their faces and edges, judged by whole numbers and by the cross-check.

    lattice_test.py [--long] [--seed N]

200 small scenes, four to an image, and 60 before such eyes; with --long twenty times as many. A
scene that fails is named by its seed.
"""

import sys
import unittest

import numpy as np

from exact_view import ExactView
from invariance import compare
from lattice import lattice_scene, scene_in_a_plane
from poses import POSES
from probe_view import Verdict, View
from program import trace

SCENES_EACH = 4
IMAGES = 50
IN_PLANES = 60
LONG = 20  # times as many
FIRST_SEED = 1000


class LatticeTest(unittest.TestCase):
    images = IMAGES
    in_planes = IN_PLANES
    first_seed = FIRST_SEED

    def test_rays_agree_and_axes_do_not_matter(self):
        totals, moved = {}, []
        for seed in range(self.first_seed, self.first_seed + self.images):
            mesh, camera, crease_deg = lattice_scene(seed)
            truth = trace(mesh, camera, crease_deg)
            view, random = View(mesh, camera, crease_deg), np.random.default_rng(seed)
            for question, verdict in (
                    ("drawn", view.judge_drawn(truth.outline, 300, random)),
                    ("missing", view.judge_missing(truth.outline, 300, random)),
                    ("crossings", view.judge_crossings(truth.outline)),
                    ("passed", view.judge_passed(truth.outline, step=6))):
                totals.setdefault(question, Verdict()).add(verdict)
                for x, y, why in verdict.failed[:5]:
                    print(f"seed {seed} ({x:.2f}, {y:.2f}) {question}: {why}", flush=True)
            change = compare(f"seed {seed}", "permute", truth,
                             trace(*POSES["permute"](mesh, camera, random), crease_deg))
            if not change.is_same:
                moved.append(str(change))
                print(change, flush=True)
        self.expect_agreement(totals)
        with self.subTest(question="permuted axes"):
            self.assertEqual(moved, [])

    def expect_agreement(self, totals):
        for question, verdict in totals.items():
            print(f"{question:<9} {verdict}")
            with self.subTest(question=question):
                self.assertGreaterEqual(verdict.agreement, 0.999, str(verdict))

    def test_eyes_in_planes(self):
        totals, differ = {}, []
        for seed in range(self.first_seed, self.first_seed + self.in_planes):
            mesh, camera, crease_deg = scene_in_a_plane(seed)
            try:
                truth = trace(mesh, camera, crease_deg, crosscheck=True)
            except RuntimeError as error:
                differ.append(seed)
                print(f"seed {seed}: {error}", flush=True)
                truth = trace(mesh, camera, crease_deg)
            view, random = ExactView(mesh, camera, crease_deg), np.random.default_rng(seed)
            for question, verdict in (
                    ("drawn", view.judge_drawn(truth.outline, 300, random)),
                    ("missing", view.judge_missing(truth.outline, 300, random))):
                totals.setdefault(question, Verdict()).add(verdict)
                for x, y, why in verdict.failed[:5]:
                    print(f"seed {seed} ({x:.2f}, {y:.2f}) {question}: {why}", flush=True)
        self.expect_agreement(totals)
        with self.subTest(question="cross-check"):
            self.assertEqual(differ, [])


if __name__ == "__main__":
    if "--long" in sys.argv:
        sys.argv.remove("--long")
        LatticeTest.images *= LONG
        LatticeTest.in_planes *= LONG
    if "--seed" in sys.argv:
        at = sys.argv.index("--seed")
        LatticeTest.first_seed = int(sys.argv[at + 1])
        del sys.argv[at:at + 2]
    unittest.main(verbosity=2)
