"""The referees object where a truth is wrong: faults planted in a good one are found."""

import unittest

import numpy as np

from camera import camera_round
from feature_edges import CREASE, SEAM
from invariance import compare
from outline import Outline, coverage
from probe_view import View
from program import Traced, trace
from shapes import SHAPES

PLACES = 1500


class PlantedFaultsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        mesh = SHAPES["crossing_boxes"]()
        camera = camera_round(mesh)
        cls.view, cls.truth = View(mesh, camera), trace(mesh, camera)

    def agreements(self, outline):
        """Of the four judges, with the outline as if it were the truth's."""
        random = np.random.default_rng(7)
        return {"drawn": self.view.judge_drawn(outline, PLACES, random).agreement,
                "missing": self.view.judge_missing(outline, PLACES, random).agreement,
                "crossings": self.view.judge_crossings(outline).agreement,
                "passed": self.view.judge_passed(outline, step=4).agreement}

    def without(self, is_dropped):
        kept = ~is_dropped
        return Outline(self.truth.outline.pieces[kept], self.truth.outline.classes[kept])

    def test_the_truth_as_it_is(self):
        self.assertEqual(set(self.agreements(self.truth.outline).values()), {1.0})

    def test_lines_moved_by_a_fifth_of_a_pixel(self):
        moved = Outline(self.truth.outline.pieces + 0.2, self.truth.outline.classes)
        found = self.agreements(moved)
        self.assertLess(max(found["drawn"], found["missing"], found["crossings"]), 0.5)

    def test_another_class(self):
        classes = np.where(self.truth.outline.classes == CREASE, SEAM, self.truth.outline.classes)
        found = self.agreements(Outline(self.truth.outline.pieces, classes))
        self.assertLess(found["drawn"], 0.9)

    def test_lines_left_out(self):
        lengths = self.truth.outline.lengths_px()
        for name, number in (("missing", 1), ("missing", 3), ("crossings", 4), ("passed", 1)):
            mine = np.flatnonzero(self.truth.outline.classes == number)
            dropped = np.zeros(len(lengths), bool)
            dropped[mine[np.argsort(lengths[mine])[len(mine) // 2]]] = True
            found = self.agreements(self.without(dropped))
            with self.subTest(judge=name, line_class=number):
                self.assertLess(found[name], 0.999)

    def test_a_hidden_line_drawn(self):
        edges = np.flatnonzero(self.view.edges.classes > 0)
        hidden, _, _ = self.view.edge_places(edges, np.full(len(edges), 0.5))
        edge = edges[hidden][0]
        ends = self.view.ends_px[edge]
        middle = ends.mean(0) + 0.1 * (ends - ends.mean(0))
        outline = Outline(np.concatenate([self.truth.outline.pieces, [middle]]),
                          np.append(self.truth.outline.classes, self.view.edges.classes[edge]))
        self.assertLess(self.agreements(outline)["drawn"], 1)

    def test_a_pixel_in_two_hundred_changed(self):
        labels = self.truth.labels.copy()
        marked = np.argwhere(labels > 0)[::200]
        labels[tuple(marked.T)] = 0
        change = compare("scene", "none", self.truth, Traced(labels, self.truth.outline))
        self.assertFalse(change.is_same)
        self.assertTrue(compare("scene", "none", self.truth, self.truth).is_same)

    def test_coverage_is_of_the_same_class(self):
        other = Outline(self.truth.outline.pieces, self.truth.outline.classes % 5 + 1)
        self.assertEqual(coverage(self.truth.outline, self.truth.outline), 1)
        self.assertLess(coverage(self.truth.outline, other), 0.05)
        self.assertEqual(coverage(self.truth.outline, other, same_class=False), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
