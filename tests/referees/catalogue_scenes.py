"""The program's own scenes as meshes, through the small program `write_scene`."""

import json
import subprocess
from pathlib import Path

import numpy as np

from camera import Camera
from model_files import read_obj
from program import DESK, WRITE_SCENE


def load(name, width_px=640, height_px=360):
    """The scene, points rounded to float32, and its first camera."""
    path = Path(DESK.name) / f"{name}.obj"
    said = subprocess.run([WRITE_SCENE, name, path], capture_output=True, text=True, check=True)
    view = json.loads(said.stdout)
    eye, forward = np.array(view["eye"]), np.array(view["forward"])
    return read_obj(path), Camera(eye, eye + forward, np.array(view["up"]), view["fov_deg"],
                                  width_px, height_px)
