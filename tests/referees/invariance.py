"""How much of a truth changes when its scene and camera are moved together."""

from dataclasses import dataclass

import numpy as np

from outline import CLASSES, coverage
from poses import POSES
from program import trace

MOST_SHARE = 0.001  # of the truth's pixels
# Where a line ends, two meet, or a crack is as wide as the weld tolerance, float32's rounding moves
# a few pixels.
FREE_PX = 10


@dataclass
class Change:
    """What one pose changed."""

    scene: str
    pose: str
    truth_px: int  # pixels with a label before
    changed_px: int  # pixels whose label differs
    lengths_px: dict  # class name: (before, after), where they differ by over 1 px and .1 %

    @property
    def is_same(self):
        return self.changed_px <= max(FREE_PX, MOST_SHARE * self.truth_px)

    def __str__(self):
        lengths = ", ".join(f"{name} {a:.0f} -> {b:.0f} px"
                            for name, (a, b) in self.lengths_px.items())
        return (f"{self.scene:<18} {self.pose:<13} {self.changed_px:>6} of {self.truth_px:>6} truth px"
                + (f" ({lengths})" if lengths else ""))


def _lengths(before, after):
    changed = {}
    for number, name in enumerate(CLASSES[1:], 1):
        a, b = before.length_px(number), after.length_px(number)
        if abs(a - b) > max(1, 0.001 * a):
            changed[name] = (a, b)
    return changed


def compare(scene, pose, before, after):
    """The change between two truths of one size.

    The labels of a mirrored image are those of another thinning: there, the lines' own lengths that
    lie further than .25 px from a line of the same class stand for the pixels.
    """
    truth_px = int(np.count_nonzero(before.labels))
    outline = after.outline
    if pose == "mirror":
        outline = outline.mirrored(before.labels.shape[1])
        lost = (1 - coverage(before.outline, outline)) * before.outline.length_px()
        new = (1 - coverage(outline, before.outline)) * outline.length_px()
        changed = round(lost + new)
    else:
        changed = int(np.count_nonzero(before.labels != after.labels))
    return Change(scene, pose, truth_px, changed, _lengths(before.outline, outline))


def changes(scene, mesh, camera, poses, seed, crease_deg=40):
    """A Change for each name in `poses`; a name may stand there several times."""
    before = trace(mesh, camera, crease_deg)
    random = np.random.default_rng(seed)
    for pose in poses:
        moved, seen_from = POSES[pose](mesh, camera, random)
        yield compare(scene, pose, before, trace(moved, seen_from, crease_deg))
