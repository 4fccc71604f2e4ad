"""Random scenes on a lattice of small integers: bends of exactly 30, 45, 60 and 90 degrees, faces
in one plane, edges that end on faces, eyes in the planes of faces.

All coordinates are integers, so that doubles decide everything exactly.
"""

import numpy as np

from camera import Camera
from mesh import Mesh, Part
from shapes import box, one_object, part

# Normals of two faces that meet at these angles.
BENDS = {30: [((1, 1, 0), (2, 1, 1)), ((0, 1, 1), (1, 1, 2))],
         45: [((1, 0, 0), (1, 1, 0)), ((0, 1, 0), (0, 1, 1)), ((0, 0, 1), (1, 0, 1))],
         60: [((1, 1, 0), (1, 0, 1)), ((0, 1, 1), (1, 1, 0)), ((1, 0, 1), (0, 1, 1))],
         90: [((1, 0, 0), (0, 1, 0)), ((1, 1, 0), (1, -1, 0)), ((1, 1, 1), (1, -1, 0))]}
CLUSTER = 16  # distance between the scenes that share one image
EYE_HEIGHTS = (-4, -2, 0, 1, 2, 3, 5, 9, 14)


def _random_box(random):
    low = random.integers(-3, 3, 3)
    return box("", low, low + random.integers(1, 4, 3))


def _bent_sheet(random, bend_deg):
    """Two triangles on one edge."""
    pairs = BENDS[bend_deg]
    normal, other = pairs[random.integers(len(pairs))]
    along = np.cross(normal, other)
    left, right = np.cross(along, normal), np.cross(other, along)
    scale = 1 if np.abs([along, left, right]).max() > 2 else 2
    at = random.integers(-1, 2, 3)
    points = at + scale * np.array([-along, along, left, right])
    return part("", points, [(0, 1, 2), (1, 0, 3)])


def _triangles(random, count):
    corners = random.integers(-3, 4, (count, 3, 3))
    area = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).sum(1)
    corners = corners[area > 0]
    return part("", corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def _cluster(random, bend_deg):
    """One small scene, of one to three objects."""
    parts = [_random_box(random) for _ in range(random.integers(1, 4))]
    parts += [_bent_sheet(random, bend_deg) for _ in range(random.integers(1, 3))]
    if random.random() < 0.5:
        parts.append(_triangles(random, random.integers(1, 6)))
    objects = random.integers(0, 3, len(parts))
    return [[p for p, o in zip(parts, objects) if o == k] for k in np.unique(objects)]


def lattice_scene(seed):
    """Four small scenes before one camera: (mesh, camera, crease angle in degrees)."""
    random = np.random.default_rng(seed)
    bend_deg = int(random.choice(list(BENDS)))
    parts = []
    for place in [(0, 0, 0), (CLUSTER, 0, 0), (0, 0, -CLUSTER), (CLUSTER, 0, -CLUSTER)]:
        for group in _cluster(random, bend_deg):
            whole = one_object(f"part{len(parts)}", group)
            parts.append(Part(whole.name, (whole.points + place).astype(np.float32), whole.faces))
    # Before them and level with planes of faces as often as not.
    eye = np.array([random.integers(-9, 28), random.choice(EYE_HEIGHTS), random.integers(11, 17)])
    target = np.array([CLUSTER / 2 + 0.137, 0.071, -CLUSTER / 2 + 0.113])
    return Mesh(parts), Camera(eye.astype(float), target, np.array([0.03, 1.0, 0.02]), 47.3, 320,
                               240), bend_deg
