"""A camera: right-handed, y up; on the image x runs right, y down, from the top left."""

from dataclasses import dataclass, replace

import numpy as np


def unit(v):
    return v / np.linalg.norm(v)


@dataclass
class Camera:
    eye: np.ndarray
    target: np.ndarray
    up: np.ndarray
    fov_deg: float  # vertical
    width_px: int
    height_px: int
    parallel_height: float = 0.0  # that a parallel camera sees; 0: it is a pinhole

    def axes(self):
        """Rows: right, up, forward; world space, unit."""
        forward = unit(np.subtract(self.target, self.eye))
        right = unit(np.cross(forward, self.up))
        return np.array([right, np.cross(right, forward), forward])

    def focal_px(self):
        return self.height_px / (2 * np.tan(np.radians(self.fov_deg) / 2))

    def to_clip(self, points):
        """(x, y, w) of world points, of a pinhole; x/w and y/w are pixels, w the distance along the view."""
        x, y, w = np.moveaxis(np.subtract(points, self.eye) @ self.axes().T, -1, 0)
        f = self.focal_px()
        return np.stack([f * x + self.width_px / 2 * w, self.height_px / 2 * w - f * y, w], -1)

    def ray_matrix(self):
        """M with M @ (x_px, y_px, 1) the world direction of unit depth through that place."""
        right, up, forward = self.axes()
        f = self.focal_px()
        return np.stack([right / f, -up / f,
                         forward - right * self.width_px / 2 / f + up * self.height_px / 2 / f], -1)

    def moved(self, place, turn):
        """The camera that sees placed points as this one sees them: `place` moves points, `turn`
        directions."""
        eye, target = place(np.array([self.eye]))[0], place(np.array([self.target]))[0]
        growth = np.linalg.norm(target - eye) / np.linalg.norm(np.subtract(self.target, self.eye))
        return Camera(eye, target, turn(np.asarray(self.up, float)), self.fov_deg, self.width_px,
                      self.height_px, self.parallel_height * growth)

    def parallel(self):
        """The parallel camera that sees as much of what it looks at."""
        distance = np.linalg.norm(np.subtract(self.target, self.eye))
        height = 2 * distance * np.tan(np.radians(self.fov_deg) / 2)
        return replace(self, parallel_height=float(height))


def camera_round(mesh, width_px=640, height_px=360, azimuth_deg=37.3, height_deg=23.7, room=0.81,
                 fov_deg=38.9):
    """A camera whose frame holds the whole mesh, from odd angles so that nothing lies level."""
    low, high = mesh.box()
    middle, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    a, h = np.radians([azimuth_deg, height_deg])
    away = np.array([np.sin(a) * np.cos(h), np.sin(h), np.cos(a) * np.cos(h)])
    distance = room * radius / np.sin(np.radians(fov_deg) / 2)
    return Camera(middle + distance * away, middle + radius * np.array([0.0131, 0.0073, -0.0057]),
                  np.array([0.0, 1.0, 0.0]), fov_deg, width_px, height_px)
