"""Blender's Line Art of a view: run inside Blender 3.4.

    blender -b --factory-startup -P strokes.py -- view.json model.obj strokes.txt lines

Writes the visible strokes as polylines on the image, one a row: "x,y x,y ..." in px, y down. Their
points are projected here, because strokes are curves in space and need a screen to be rendered.
"""

import math
import sys
import time
from pathlib import Path

import bpy
from mathutils import Matrix, Vector

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "blender"))
import scene  # noqa: E402

CREASE_DEG = 40


def add_line_art():
    """A Line Art modifier over the whole scene: visible contours, creases and intersections."""
    lines = bpy.data.grease_pencils.new("lines")
    holder = bpy.data.objects.new("lines", lines)
    bpy.context.scene.collection.objects.link(holder)
    layer = lines.layers.new("lines")
    layer.frames.new(bpy.context.scene.frame_current)
    material = bpy.data.materials.new("black")
    bpy.data.materials.create_gpencil_data(material)
    lines.materials.append(material)
    art = holder.grease_pencil_modifiers.new("art", "GP_LINEART")
    art.source_type = "SCENE"
    art.target_layer, art.target_material = layer.info, material
    art.use_contour = art.use_crease = art.use_intersection = True
    art.use_edge_mark = art.use_material = art.use_loose = False
    art.crease_threshold = math.pi - math.radians(CREASE_DEG)
    art.use_multiple_levels, art.level_start = False, 0
    art.use_overlap_edge_type_support = False
    art.chaining_image_threshold = 0
    art.use_geometry_space_chain = False
    art.stroke_depth_offset = 0
    art.use_clip_plane_boundaries = False
    return holder


def project(p, view_from_world, view):
    """A point in px; nothing if it is not in front of the eye."""
    x, y, z = view_from_world @ p
    if z >= 0:
        return None
    if view["camera"]["projection"] == "parallel":
        scale = view["height_px"] / view["camera"]["height"]
    else:
        scale = view["height_px"] / (2 * math.tan(math.radians(view["camera"]["fov_y_deg"]) / 2)) / -z
    return view["width_px"] / 2 + scale * x, view["height_px"] / 2 - scale * y


def strokes_px(shown, view):
    view_from_world = Matrix(view["view_from_world"])
    for layer in shown.data.layers:
        for stroke in layer.active_frame.strokes if layer.active_frame else []:
            points = [project(shown.matrix_world @ Vector(p.co), view_from_world, view)
                      for p in stroke.points]
            yield [p for p in points if p is not None]


def draw(view, out):
    bpy.context.evaluated_depsgraph_get().update()  # the models alone
    holder = add_line_art()
    start = time.perf_counter()
    shown = holder.evaluated_get(bpy.context.evaluated_depsgraph_get())
    draw_ms = 1e3 * (time.perf_counter() - start)
    with open(out, "w", encoding="ascii") as file:
        for points in strokes_px(shown, view):
            file.write(" ".join(f"{x:.3f},{y:.3f}" for x, y in points) + "\n")
    return draw_ms


if __name__ == "__main__":
    scene.run(draw)
