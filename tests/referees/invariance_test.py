"""What is seen does not depend on where a scene stands: labels stay equal to .1 % of the pixels.

Scenes whose parts touch, catalogue scenes and small models, each moved with its camera in all the
ways of poses.py.
"""

import unittest

import catalogue_scenes
from camera import camera_round
from invariance import changes
from model_files import read_obj
from poses import POSES
from program import MODELS
from shapes import SHAPES

CATALOGUE = ("soup", "tiles")
FETCHED = {"penguin.obj": ["rotate", "shuffle", "double"], "bunny_coarse.obj": ["rotate", "double"]}
# Poses that round nothing; lattice_test and cases_test permute axes.
EXACT = ("shuffle", "flip", "double", "mirror")
SEED = 15


class InvarianceTest(unittest.TestCase):
    def judge(self, name, mesh, camera, poses):
        for change in changes(name, mesh, camera, poses, SEED):
            with self.subTest(scene=name, pose=change.pose):
                self.assertTrue(change.is_same, str(change))

    def test_shapes_that_touch(self):
        for name, make in SHAPES.items():
            mesh = make()
            self.judge(name, mesh, camera_round(mesh), ["rotate", "rotate", "assemble", *EXACT])

    def test_shapes_in_parallel(self):
        for name, make in SHAPES.items():
            mesh = make()
            self.judge(name, mesh, camera_round(mesh).parallel(), ["rotate", "assemble", *EXACT])

    def test_catalogue_scenes(self):
        for name in CATALOGUE:
            self.judge(name, *catalogue_scenes.load(name), list(POSES))

    def test_models(self):
        for name, poses in FETCHED.items():
            if not (MODELS / name).is_file():
                self.skipTest(f"{name} is not here: experiments/models/fetch gets it")
            mesh = read_obj(MODELS / name)
            for camera in (camera_round(mesh), camera_round(mesh).parallel()):
                self.judge(name, mesh, camera, poses)


if __name__ == "__main__":
    unittest.main(verbosity=2)
