"""Scenes on which a truth was wrong once: cases/*.obj, and the same made here.

Each says what is seen by arithmetic of its own, or by the pose in which nothing is rounded.
"""

import unittest
from pathlib import Path

import numpy as np

from camera import Camera, camera_round
from feature_edges import CREASE
from invariance import FREE_PX, MOST_SHARE, compare
from mesh import Mesh
from model_files import read_obj
from outline import CLASSES
from poses import POSES
from probe_view import View
from program import trace
from shapes import one_object, part, quad, rotation

CASES = Path(__file__).parent / "cases"
INTERSECTION = CLASSES.index("intersection")
BOUNDARY = CLASSES.index("boundary")


def camera(eye, target, fov_deg, up=(0.0, 1.0, 0.0)):
    return Camera(np.array(eye), np.array(target), np.array(up), fov_deg, 640, 480)


def bent_sheet(normal, other):
    """Two triangles on a common edge, with these integer normals: their bend is exact."""
    along = np.cross(normal, other)
    left, right = np.cross(along, normal), np.cross(other, along)
    return Mesh([part("bent", [-along, along, left, right], [(0, 1, 2), (1, 0, 3)])])


# Normals between which the angle is exact.
EXACT_BENDS = {30: ((1, 1, 0), (2, 1, 1)), 45: ((1, 0, 0), (1, 1, 0)), 60: ((1, 1, 0), (1, 0, 1)),
               90: ((1, 2, 0), (-2, 1, 0))}


class CasesTest(unittest.TestCase):
    def assert_agrees(self, mesh, seen_from, crease_deg=40, truth=None):
        """What rays find and what the truth draws is the same."""
        view = View(mesh, seen_from, crease_deg)
        outline = (truth or trace(mesh, seen_from, crease_deg)).outline
        random = np.random.default_rng(1)
        for verdict in (view.judge_drawn(outline, 400, random),
                        view.judge_missing(outline, 400, random)):
            self.assertGreaterEqual(verdict.agreement, 0.999, f"{verdict} {verdict.failed[:3]}")

    # ---- Creases at exactly their angle ------------------------------------------------------

    def assert_crease_in_every_pose(self, mesh, seen_from, bend_deg):
        random = np.random.default_rng(2)
        at, above = (trace(mesh, seen_from, angle) for angle in (bend_deg, bend_deg + 0.01))
        self.assertGreater(at.outline.length_px(CREASE), 10, "at its angle an edge is a crease")
        self.assertEqual(above.outline.length_px(CREASE), 0, "below the angle it is none")
        self.assert_agrees(mesh, seen_from, bend_deg, at)
        for pose in ("permute", "mirror", "scale_by_two", "shuffle", "flip", "double"):
            moved = POSES[pose](mesh, seen_from, random)
            change = compare("bent", pose, at, trace(*moved, bend_deg))
            self.assertTrue(change.is_same, str(change))

    def test_an_exact_bend_is_a_crease_however_it_stands(self):
        for bend_deg, normals in EXACT_BENDS.items():
            with self.subTest(bend_deg=bend_deg):
                mesh = bent_sheet(*normals)
                n = np.add(*normals) / np.linalg.norm(np.add(*normals))
                # Before the fold's outer side, so that both faces are seen.
                seen_from = camera(9.1 * n + (0.31, 0.17, 0.23), (0.0, 0.0, 0.0), 40, (0.1, 0.3, 1))
                self.assert_crease_in_every_pose(mesh, seen_from, bend_deg)

    def test_crease60(self):
        seen_from = camera((6.06, 12.1, 6.0), (0.0, 0.0, 0.0), 30)
        for name in ("crease60_a", "crease60_b"):
            with self.subTest(name=name):
                mesh = read_obj(CASES / f"{name}.obj")
                truth = trace(mesh, seen_from, 60)
                self.assertGreater(truth.outline.length_px(CREASE), 10)
                self.assert_agrees(mesh, seen_from, 60, truth)

    # ---- A gap that the image shows ----------------------------------------------------------

    def assert_both_borders(self, mesh):
        """Two sheets, 1.5e-3 apart at z = 0, have their borders drawn beside a triangle that is
        far and large."""
        seen_from = camera((0.0, 0.0, 0.2), (0.0, 0.0, 0.0), 40)
        truth = trace(mesh, seen_from)
        for side in (-1, 1):
            x = side * 0.00075
            ends = seen_from.to_clip(np.array([[x, -0.03, 0], [x, 0.03, 0]]))
            ends = ends[:, :2] / ends[:, 2:]
            length = np.linalg.norm(ends[1] - ends[0])
            near = np.abs(truth.outline.pieces[:, :, 0] - ends[0, 0]).max(1) < 0.05
            is_border = near & (truth.outline.classes == BOUNDARY)
            drawn = truth.outline.lengths_px()[is_border].sum()
            self.assertAlmostEqual(drawn, length, delta=0.5, msg=f"at {ends[0, 0]:.1f} px")
        self.assert_agrees(mesh, seen_from, truth=truth)

    def test_a_gap_of_five_pixels_beside_a_far_triangle(self):
        inner, outer, top = 0.00075, 0.05, 0.03
        left = quad("", (-outer, -top, 0), (-inner, -top, 0), (-inner, top, 0), (-outer, top, 0))
        right = quad("", (inner, -top, 0), (outer, -top, 0), (outer, top, 0), (inner, top, 0))
        far = part("", [(-1000, -5, -1000), (1000, -5, -1000), (0, 900, -1000)], [(0, 1, 2)])
        for name, parts in (("one object", [one_object("all", [left, right, far])]),
                            ("three", [left, right, far])):
            with self.subTest(parts=name):
                for i, p in enumerate(parts):
                    p.name = f"part{i}"
                self.assert_both_borders(Mesh(parts))

    def test_gap(self):
        self.assert_both_borders(read_obj(CASES / "gap.obj"))

    # ---- Surfaces that touch -----------------------------------------------------------------

    def assert_bare(self, plate, whole, seen_from):
        """What stands behind the plate and touches it is not seen."""
        bare, truth = trace(plate, seen_from), trace(whole, seen_from)
        self.assertEqual(truth.outline.length_px(INTERSECTION), 0)
        change = compare("plate", "with what touches it", bare, truth)
        self.assertTrue(change.is_same, str(change))

    def test_a_sheet_behind_a_plate_that_it_touches(self):
        random = np.random.default_rng(3)
        for trial in range(6):
            with self.subTest(trial=trial):
                corners = np.array([(-1, -1.2, 0), (1, -1.2, 0), (1, 1, 0), (-1, 1, 0)])
                a, b = [*random.uniform(-0.7, 0.2, 2), 0], [*random.uniform(0.3, 0.7, 2), 0]
                plate = quad("plate", *corners)
                sheet = quad("", a, b, np.add(b, (0, 0, -0.6)), np.add(a, (0, 0, -0.6)))
                turn = rotation(random.normal(size=3), 1.1)
                seen_from = camera(turn @ (0.3, 0.2, 5), turn @ (0.1, 0, 0), 40, turn @ (0, 1, 0.1))
                self.assert_bare(Mesh([plate]).moved(lambda p, m=turn: p @ m.T),
                                 Mesh([one_object("plate", [plate, sheet])]).moved(
                                     lambda p, m=turn: p @ m.T), seen_from)

    def test_tj1(self):
        mesh = read_obj(CASES / "tj1.obj")
        points, faces = mesh.parts[0].points.astype(float), mesh.parts[0].faces
        plate = Mesh([part("plate", points, faces[:2])])
        normal = np.cross(points[1] - points[0], points[2] - points[0])
        normal /= np.linalg.norm(normal)
        middle = points[:4].mean(0)
        if ((points[4:] - middle) @ normal).sum() > 0:
            normal = -normal
        up = points[3] - points[0]
        self.assert_bare(plate, mesh, camera(middle + 6 * normal + 0.2 * up, middle, 40, up))

    def assert_flat(self, mesh, seen_from):
        """Coplanar sheets of one object cross nowhere, whatever the rounding."""
        truth = trace(mesh, seen_from)
        self.assertEqual(truth.outline.length_px(INTERSECTION), 0)

    def test_a_hidden_border_along_a_crossing(self):
        """Two surfaces pierce each other exactly where a third, behind them, ends."""
        wall = quad("wall", (-2, -2, 0), (2, -2, 0), (2, 1, 0), (-2, 1, 0))
        slope = quad("slope", (-2, -2, 1), (2, -2, 1), (2, 1, -2), (-2, 1, -2))
        for step in (-1, 1):  # the third lies behind either of the two
            third = quad("third", (-3, -1, 0), (3, -1, 0), (3, -1, step), (-3, -1, step))
            pair = one_object("slope", [slope, third])
            for name, parts in (("of three", [wall, slope, third]), ("of two", [wall, pair]),
                                ("the other first", [pair, wall])):
                with self.subTest(objects=name, step=step):
                    mesh, seen_from = Mesh(parts), camera((-3.1, 6.2, 9.3), (0, -0.6, 0), 30)
                    truth = trace(mesh, seen_from)
                    verdict = View(mesh, seen_from).judge_passed(truth.outline, step=2)
                    self.assertEqual(len(verdict.failed), 0, verdict.failed[:3])

    def test_cop0(self):
        mesh = read_obj(CASES / "cop0.obj")
        self.assert_flat(mesh, camera_round(mesh, 640, 480))

    def test_coplanar_sheets_are_the_same_in_every_rotation(self):
        first = quad("", (-1, -1, 0), (0.4, -1.1, 0), (0.5, 0.6, 0), (-0.9, 0.7, 0))
        second = quad("", (-0.3, -0.4, 0), (1.2, -0.2, 0), (1.1, 1.2, 0), (-0.4, 1.0, 0))
        seen_from = camera((0.4, 0.3, 5), (0.1, 0, 0), 40)
        random = np.random.default_rng(4)
        for name, mesh in (("one object", Mesh([one_object("sheets", [first, second])])),
                           ("two", Mesh([part("first", first.points, first.faces),
                                         part("second", second.points, second.faces)]))):
            still = trace(mesh, seen_from)
            self.assertEqual(still.outline.length_px(INTERSECTION), 0)
            for trial in range(4):
                with self.subTest(parts=name, trial=trial):
                    moved = POSES["rotate"](mesh, seen_from, random)
                    change = compare(name, "rotate", still, trace(*moved))
                    self.assertLessEqual(change.changed_px,
                                         max(FREE_PX, MOST_SHARE * change.truth_px), str(change))


if __name__ == "__main__":
    unittest.main(verbosity=2)
