"""Blender's Line Art of one OBJ: what make_fixtures runs inside Blender 3.4.

    blender -b --factory-startup -P draw_in_blender.py -- VIEW.json

VIEW.json names the model, the camera as rows right, up, back and an eye, the field of view, the
size, the crease angle and the file for the lines: a polyline a row, "x,y x,y ..." in px, y down.
"""

import json
import math
import sys

import bpy
from mathutils import Matrix, Vector


def load(path):
    """Every object of the file, flat-shaded, its corners at one place joined."""
    bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z")
    meshes = [o for o in bpy.context.scene.objects if o.type == "MESH"]
    for o in meshes:
        bpy.context.view_layer.objects.active = o
        o.data.use_auto_smooth = False
        for polygon in o.data.polygons:
            polygon.use_smooth = False
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.remove_doubles(threshold=0)
        bpy.ops.object.mode_set(mode="OBJECT")


def place_camera(view):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(view["fov_deg"])
    data.clip_start, data.clip_end = view["near"], view["far"]
    camera = bpy.data.objects.new("camera", data)
    placed = Matrix([view["right"], view["up"], view["back"]]).transposed().to_4x4()
    placed.translation = Vector(view["eye"])
    camera.matrix_world = placed
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = view["width_px"], view["height_px"]


def add_line_art(view):
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
    art.crease_threshold = math.pi - math.radians(view["crease_deg"])
    art.use_multiple_levels, art.level_start = False, 0
    art.use_overlap_edge_type_support = False
    art.chaining_image_threshold = 0
    art.use_geometry_space_chain = False
    art.stroke_depth_offset = 0
    art.use_clip_plane_boundaries = False
    return holder


def strokes_px(holder, view):
    """Polylines on the image, by this script's own projection."""
    shown = holder.evaluated_get(bpy.context.evaluated_depsgraph_get())
    right, up, back = (Vector(view[k]) for k in ("right", "up", "back"))
    focal = view["height_px"] / (2 * math.tan(math.radians(view["fov_deg"]) / 2))
    for layer in shown.data.layers:
        for stroke in layer.active_frame.strokes if layer.active_frame else []:
            points = [shown.matrix_world @ p.co - Vector(view["eye"]) for p in stroke.points]
            yield [(view["width_px"] / 2 + focal * (p @ right) / -(p @ back),
                    view["height_px"] / 2 - focal * (p @ up) / -(p @ back)) for p in points]


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
        view = json.load(file)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    load(view["model"])
    place_camera(view)
    holder = add_line_art(view)
    with open(view["lines"], "w", encoding="ascii") as file:
        file.write(f"# {view['name']}, {view['width_px']}x{view['height_px']}, creases from "
                   f"{view['crease_deg']} degrees: Line Art of Blender {bpy.app.version_string}\n")
        for points in strokes_px(holder, view):
            file.write(" ".join(f"{x:.3f},{y:.3f}" for x, y in points) + "\n")


if __name__ == "__main__":
    try:
        main()
    except Exception as error:  # Blender itself exits with 0 whatever a script raises
        print(f"draw_in_blender: {error!r}", file=sys.stderr)
        sys.exit(1)
