"""experiments/brep/tessellate on prisms in STEP: the edges that it counts and marks are those of arithmetic."""

import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

import adapters
import numpy as np

ROOT = adapters.OUTSIDE.parents[1]
TESSELLATE = ROOT / "experiments" / "brep" / "tessellate"
HARD = 2  # a mark of EXT_mesh_primitive_edge_visibility


def marked_length(path):
    """The length of all edges of a .glb that are marked as hard."""
    gltf, binary = adapters.read_glb(path)

    def numbers(accessor, kind):
        view = gltf["bufferViews"][gltf["accessors"][accessor]["bufferView"]]
        return np.frombuffer(binary, kind, offset=view["byteOffset"], count=view["byteLength"] // kind().itemsize)

    length = 0
    for mesh in gltf["meshes"]:
        primitive = mesh["primitives"][0]
        triangles = numbers(primitive["indices"], np.uint32).reshape(-1, 3)
        packed = numbers(primitive["extensions"]["EXT_mesh_primitive_edge_visibility"]["visibility"], np.uint8)
        marks = (packed[:, None] >> np.arange(0, 8, 2) & 3).reshape(-1)[:triangles.size].reshape(-1, 3)
        points = numbers(primitive["attributes"]["POSITION"], np.float32).reshape(-1, 3).astype(float)
        points, place = np.unique(points, axis=0, return_inverse=True)
        sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2)[marks >= HARD]
        ends = np.unique(np.sort(place.reshape(-1)[sides], axis=1), axis=0)
        length += np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1).sum()
    return length


class Step:
    """A STEP file under construction."""

    def __init__(self):
        self.lines = []

    def add(self, text):
        self.lines.append(text)
        return f"#{len(self.lines)}"

    def triple(self, kind, p):
        return self.add(f"{kind}('',({','.join(f'{x:.9f}' for x in p)}))")

    def text(self):
        body = "\n".join(f"#{i + 1}={line};" for i, line in enumerate(self.lines))
        return ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
                f"FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n{body}\nENDSEC;\nEND-ISO-10303-21;\n")


def prism(sides):
    """STEP of a prism of height 1 over a regular polygon in the unit circle."""
    step = Step()
    corners = [(math.cos(a), math.sin(a)) for a in (2 * math.pi * i / sides for i in range(sides))]
    points = [(x, y, z) for z in (0, 1) for x, y in corners]
    vertices = [step.add(f"VERTEX_POINT('',{step.triple('CARTESIAN_POINT', p)})") for p in points]
    edges = {}

    def oriented(a, b):
        if (b, a) in edges:
            return step.add(f"ORIENTED_EDGE('',*,*,{edges[b, a]},.F.)")
        if (a, b) not in edges:
            along = [q - p for p, q in zip(points[a], points[b])]
            vector = step.add(f"VECTOR('',{step.triple('DIRECTION', along)},1.)")
            line = step.add(f"LINE('',{step.triple('CARTESIAN_POINT', points[a])},{vector})")
            edges[a, b] = step.add(f"EDGE_CURVE('',{vertices[a]},{vertices[b]},{line},.T.)")
        return step.add(f"ORIENTED_EDGE('',*,*,{edges[a, b]},.T.)")

    def face(loop, normal, along):
        ring = step.add(f"EDGE_LOOP('',({','.join(oriented(a, b) for a, b in zip(loop, loop[1:] + loop[:1]))}))")
        place = step.add(f"AXIS2_PLACEMENT_3D('',{step.triple('CARTESIAN_POINT', points[loop[0]])},"
                         f"{step.triple('DIRECTION', normal)},{step.triple('DIRECTION', along)})")
        plane = step.add(f"PLANE('',{place})")
        bound = step.add(f"FACE_OUTER_BOUND('',{ring},.T.)")
        return step.add(f"ADVANCED_FACE('',({bound}),{plane},.T.)")

    faces = [face(list(range(sides))[::-1], (0, 0, -1), (1, 0, 0)),
             face(list(range(sides, 2 * sides)), (0, 0, 1), (1, 0, 0))]
    for i in range(sides):
        a, b = i, (i + 1) % sides
        middle = 2 * math.pi * (i + 0.5) / sides
        faces.append(face([a, b, b + sides, a + sides], (math.cos(middle), math.sin(middle), 0), (0, 0, 1)))
    shell = step.add(f"CLOSED_SHELL('',({','.join(faces)}))")
    solid = step.add(f"MANIFOLD_SOLID_BREP('',{shell})")
    length = step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    angle = step.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    solid_angle = step.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    accuracy = step.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),{length},'','')")
    context = step.add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(("
                       f"{accuracy}))GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))"
                       "REPRESENTATION_CONTEXT('',''))")
    shape = step.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({solid}),{context})")
    application = step.add("APPLICATION_CONTEXT('')")
    field = step.add(f"PRODUCT_CONTEXT('',{application},'')")
    product = step.add(f"PRODUCT('','','',({field}))")
    formation = step.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    design = step.add(f"PRODUCT_DEFINITION_CONTEXT('',{application},'design')")
    definition = step.add(f"PRODUCT_DEFINITION('','',{formation},{design})")
    of = step.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    step.add(f"SHAPE_DEFINITION_REPRESENTATION({of},{shape})")
    return step.text()


class BrepTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def tessellate(self, text):
        source = self.folder / "prism.step"
        source.write_text(text)
        done = adapters.run(sys.executable, TESSELLATE, source, self.folder / "prism.glb")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def expect(self, sides, tangent):
        text = prism(sides)
        counts = self.tessellate(text)
        self.assertEqual(counts["edges"], text.count("EDGE_CURVE("))
        self.assertEqual((counts["sharp"], counts["tangent"], counts["free"], counts["seams"]),
                         (3 * sides - tangent, tangent, 0, 0))
        lids = 2 * sides * 2 * math.sin(math.pi / sides)
        self.assertAlmostEqual(marked_length(self.folder / "prism.glb"), lids + sides - tangent, places=4)

    def test_all_edges_of_a_box_are_sharp(self):
        self.expect(4, 0)

    def test_sides_that_bend_by_less_than_a_degree_are_tangent(self):
        self.expect(400, 400)
        self.expect(340, 0)  # 1.06 degrees

    def test_what_is_no_model_is_refused_in_one_line(self):
        self.tessellate(prism(4))
        for name, content in (("a.step", "Dear Anna"), ("a.obj", ""), ("a.brep", "")):
            (self.folder / name).write_text(content)
            done = adapters.run(sys.executable, TESSELLATE, self.folder / name, self.folder / "out.glb")
            self.assertEqual(done.returncode, 2)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(name, done.stderr)
            self.assertFalse((self.folder / "out.glb").exists())


if __name__ == "__main__":
    adapters.skip_without("brep")
    unittest.main()
