"""Small scenes whose parts touch, cross or stand apart: what assemblies are made of."""

import numpy as np

from mesh import Mesh, Part, rounded

BOX_FACES = np.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
                      [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]])


def part(name, points, faces):
    return Part(name, rounded(points), np.asarray(faces))


def box(name, low, high):
    points = [[(low, high)[x][0], (low, high)[y][1], (low, high)[z][2]]
              for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    return part(name, points, BOX_FACES)


def quad(name, a, b, c, d):
    return part(name, [a, b, c, d], [[0, 1, 2], [0, 2, 3]])


def turned(of, axis, degrees, about=(0, 0, 0)):
    """The part turned about a line through `about`."""
    turn = rotation(np.asarray(axis, float), np.radians(degrees))
    points = (of.points.astype(np.float64) - about) @ turn.T + about
    return Part(of.name, rounded(points), of.faces)


def rotation(axis, angle_rad):
    """The matrix that turns about an axis through the origin."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle_rad) * cross + (1 - np.cos(angle_rad)) * cross @ cross


def torus(name, radius, tube, around, across):
    u, v = np.meshgrid(np.arange(around) / around, np.arange(across) / across, indexing="ij")
    u, v = 2 * np.pi * u.ravel(), 2 * np.pi * v.ravel()
    ring = radius + tube * np.cos(v)
    points = np.stack([ring * np.cos(u), tube * np.sin(v), ring * np.sin(u)], -1)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = i.ravel() * across, (i.ravel() + 1) % around * across
    j, k = j.ravel(), (j.ravel() + 1) % across
    faces = np.concatenate([np.stack(t, -1) for t in ((a + j, a + k, b + j),
                                                      (b + j, a + k, b + k))])
    return part(name, points, faces)


def icosphere(name, middle, radius, splits):
    g = (1 + 5 ** 0.5) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
              (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    points = [np.array(p) / np.linalg.norm(p) for p in points]
    for _ in range(splits):
        middles, split = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                p = points[a] + points[b]
                points.append(p / np.linalg.norm(p))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            split += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = split
    return part(name, np.asarray(middle) + radius * np.array(points), faces)


def cylinder(name, low_middle, radius, height, sides):
    """Upright, capped."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([radius * np.cos(angle), np.zeros(sides), radius * np.sin(angle)], -1)
    points = np.concatenate([ring, ring + [0, height, 0], [[0, 0, 0], [0, height, 0]]])
    faces = []
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(i, sides + i, j), (j, sides + i, sides + j), (i, j, 2 * sides),
                  (sides + j, sides + i, 2 * sides + 1)]
    return part(name, points + low_middle, faces)


def one_object(name, parts):
    """Their triangles in one part; places are not joined."""
    firsts = np.cumsum([0] + [len(p.points) for p in parts])
    return Part(name, np.concatenate([p.points for p in parts]),
                np.concatenate([p.faces + first for p, first in zip(parts, firsts)]))


def boxes_on_a_floor():
    return Mesh([quad("floor", (-3, 0, -3), (-3, 0, 3), (3, 0, 3), (3, 0, -3)),
                 box("crate", (-1.3, 0, -0.9), (0.2, 1.1, 0.4)),
                 turned(box("turned", (0.7, 0, 0.3), (1.6, 0.7, 1.4)), (0, 1, 0), 33, (1, 0, 1))])


def box_stack():
    return Mesh([box("low", (-1.5, 0, -1.5), (1.5, 0.8, 1.5)),
                 box("middle", (-1, 0.8, -1.1), (1.2, 1.7, 0.8)),
                 turned(box("high", (-0.5, 1.7, -0.5), (0.5, 2.4, 0.6)), (0, 1, 0), 20)])


def abutting_boxes():
    """Level tops: a seam between two objects, and nothing within one."""
    return Mesh([box("left", (-1.4, 0, -0.7), (0.1, 1, 0.6)),
                 box("right", (0.1, 0, -0.7), (1.7, 1, 0.6)),
                 one_object("pair", [box("", (-1.4, 0, 1.1), (0.1, 1, 1.7)),
                                     box("", (0.1, 0, 1.1), (1.7, 1, 1.7))])])


def t_joint():
    """A sheet that stands on a plate, within one object, and one between two objects."""
    plate = quad("", (-2, 0, -1.5), (-2, 0, 1.5), (2, 0, 1.5), (2, 0, -1.5))
    sheet = quad("", (-1.2, 0, -0.3), (0.9, 0, 0.5), (0.9, 1.2, 0.5), (-1.2, 1.2, -0.3))
    other = quad("other", (1.3, 0, -1), (1.7, 0, 0.9), (1.7, 0.8, 0.9), (1.3, 0.8, -1))
    return Mesh([one_object("plate", [plate, sheet]), other])


def t_joint_behind():
    """A sheet behind a plate, which it touches: the bare plate shows no line."""
    plate = quad("", (-1.5, 0, 0), (1.5, 0, 0), (1.5, 2, 0), (-1.5, 2, 0))
    sheet = quad("", (-0.8, 0.5, 0), (0.9, 1.3, 0), (0.9, 1.3, -1.4), (-0.8, 0.5, -1.4))
    return Mesh([one_object("plate", [plate, sheet])])


def decal():
    """Flat marks in the plane of a wall: one of its own, and of two other objects the one that is
    listed first, which is seen, and the one that is listed last, which is not."""
    wall = quad("", (-2, 0, 0), (2, 0, 0), (2, 2.4, 0), (-2, 2.4, 0))
    own = quad("", (-1.5, 0.4, 0), (-0.4, 0.7, 0), (-0.6, 1.7, 0), (-1.4, 1.5, 0))
    mark = quad("mark", (0.3, 0.5, 0), (1.6, 0.8, 0), (1.4, 1.9, 0), (0.5, 1.6, 0))
    seen = quad("seen", (-0.5, 1.9, 0), (0.4, 1.8, 0), (0.5, 2.2, 0), (-0.3, 2.3, 0))
    return Mesh([seen, one_object("wall", [wall, own]), mark])


def stacked_sheets():
    """Three sheets of thin stock, one on the other."""
    def sheet(name, level, turn):
        return turned(box(name, (-1.6, level, -1.1), (1.6, level + 0.05, 1.1)), (0, 1, 0), turn)
    return Mesh([sheet("first", 0, 0), sheet("second", 0.05, 14), sheet("third", 0.1, 31)])


def touching_solids():
    """A pin in its hole's bottom, a collar round it, and a block that its side touches."""
    return Mesh([box("base", (-1.6, -0.5, -1.2), (1.6, 0, 1.2)),
                 cylinder("pin", (-0.5, 0, 0), 0.4, 1.5, 24),
                 cylinder("collar", (-0.5, 0, 0), 0.7, 0.4, 24),
                 box("block", (0.2, 0, -0.6), (1.1, 1.1, 0.6))])


def overlapping_boxes():
    """Level tops and one level side, one through the other: within one object and of two."""
    def cross(name, x, other):
        return [box(name, (x - 1, 0, -0.4), (x + 1, 0.7, 0.4)),
                box(other, (x - 0.3, 0, -0.4), (x + 0.45, 0.7, 1.1))]
    return Mesh([*cross("bar", -1.3, "beam"), one_object("pair", cross("", 1.4, ""))])


def lying_cylinder():
    """On a floor, one of its sides level with it; another touches that one along an edge."""
    first = turned(cylinder("first", (0, -1, 0), 0.6, 2.2, 16), (1, 0, 0), 90)
    first = turned(first, (0, 0, 1), 180 / 16)
    level = float(first.points[:, 1].min())
    beside = first.points.astype(np.float64) + [2 * first.points[:, 0].max(), 0, 0.3]
    second = part("second", beside, first.faces)
    return Mesh([first, second,
                 quad("floor", (-2, level, -2), (-2, level, 2), (3, level, 2), (3, level, -2))])


def inlay():
    """A block let into a plate's hole, level with it, and one that stands out of such a hole."""
    def frame(x):
        low, high = (x - 1, -0.3, -1), (x + 1, 0, 1)
        return [box("", low, (x - 0.5, 0, 1)), box("", (x + 0.5, -0.3, -1), high),
                box("", (x - 0.5, -0.3, -1), (x + 0.5, 0, -0.4)),
                box("", (x - 0.5, -0.3, 0.4), (x + 0.5, 0, 1))]
    return Mesh([one_object("plate", frame(-1.2) + frame(1.2)),
                 box("level", (-1.7, -0.3, -0.4), (-0.7, 0, 0.4)),
                 box("proud", (0.7, -0.3, -0.4), (1.7, 0.35, 0.4))])


def roof_under_a_plate():
    """A ridge that touches a plate's lower side, and a tip that touches its upper one."""
    ridge = part("roof", [(-0.9, 0, 0.1), (0.8, 0, 0.1), (-0.9, -0.8, 0.9), (0.8, -0.8, 0.9),
                          (-0.9, -0.8, -0.7), (0.8, -0.8, -0.7)],
                 [(0, 2, 1), (1, 2, 3), (0, 1, 4), (1, 5, 4)])
    tip = part("tip", [(0.2, 0, 0.3), (-0.2, 0.9, 0), (0.7, 0.8, 0.1), (0.1, 0.9, 0.8)],
               [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)])
    return Mesh([quad("plate", (-1.5, 0, -1.2), (-1.5, 0, 1.2), (1.5, 0, 1.2), (1.5, 0, -1.2)),
                 ridge, tip])


def crossing_boxes():
    return Mesh([box("level", (-1, -0.6, -0.8), (1, 0.6, 0.8)),
                 turned(box("askew", (-0.7, -1, -0.5), (0.9, 0.9, 0.6)), (1, 2, 3), 37)])


def smooth_shapes():
    """What no tie decides: a torus and a ball that cross, apart from all planes."""
    return Mesh([torus("torus", 1.3, 0.45, 48, 24), icosphere("ball", (0.9, 0.2, 0.6), 0.7, 3)])


def folded_sheets():
    """Open sheets bent by 20 to 70 degrees, borders all round."""
    parts = []
    for i, bend in enumerate((20, 35, 45, 70)):
        c, s = np.cos(np.radians(bend)), np.sin(np.radians(bend))
        x = 1.1 * i
        parts.append(part(f"bent_{bend}", [(x, 0, -1), (x, 0, 1), (x + 0.5, 0, -1), (x + 0.5, 0, 1),
                                           (x + 0.5 + 0.5 * c, 0.5 * s, -1),
                                           (x + 0.5 + 0.5 * c, 0.5 * s, 1)],
                          [(0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4)]))
    return Mesh(parts)


SHAPES = {make.__name__: make for make in (
    boxes_on_a_floor, box_stack, abutting_boxes, t_joint, t_joint_behind, decal, stacked_sheets,
    touching_solids, overlapping_boxes, lying_cylinder, inlay, roof_under_a_plate, crossing_boxes,
    smooth_shapes, folded_sheets)}
