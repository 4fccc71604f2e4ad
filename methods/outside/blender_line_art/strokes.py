"""Blender's Line Art of a view: run inside Blender 3.4.

    blender -b --factory-startup -P strokes.py -- view.json model.obj strokes.txt lines
    blender -b --factory-startup -P strokes.py -- view.json model.obj mask.png mask

Writes the visible strokes as polylines on the image, one a row: "x,y x,y ..." in px, y down. Their
points are projected here, because strokes are curves in space and need a screen to be rendered.

Blender's axes are those of the file: it is imported without turning it, so a camera looks along its
own -z as it does in view.json.
"""

import json
import math
import sys
import time

import bpy
from mathutils import Matrix, Vector

CREASE_DEG = 40


def load_model(path):
    """Every object of an OBJ, flat-shaded, its corners at one place joined."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z")
    models = [o for o in bpy.context.scene.objects if o.type == "MESH"]
    for model in models:
        model.select_set(True)
        model.data.use_auto_smooth = False
        model.data.polygons.foreach_set("use_smooth", [False] * len(model.data.polygons))
    if not models:
        return
    bpy.context.view_layer.objects.active = models[0]
    bpy.ops.object.mode_set(mode="EDIT")  # of all that are selected
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.remove_doubles(threshold=0)  # within each object
    bpy.ops.object.mode_set(mode="OBJECT")


def place_camera(view):
    """The camera of a view, and the size of its image."""
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    if view["camera"]["projection"] == "parallel":
        data.type, data.ortho_scale = "ORTHO", view["camera"]["height"]
    else:
        data.angle = math.radians(view["camera"]["fov_y_deg"])
    data.clip_start, data.clip_end = view["camera"]["near"], view["camera"]["far"]
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = Matrix(view["view_from_world"]).inverted()
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = view["width_px"], view["height_px"]
    scene.render.resolution_percentage = 100


def render_mask(path):
    """The objects white on black, a sample in the middle of each pixel. By Cycles, the one engine that needs no screen."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 0
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "BW"
    scene.render.filepath = path
    material = bpy.data.materials.new("glow")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    light, out = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    light.inputs["Color"].default_value = (1, 1, 1, 1)
    material.node_tree.links.new(light.outputs[0], out.inputs[0])
    bpy.context.view_layer.material_override = material
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0, 0, 0, 1)
    bpy.ops.render.render(write_still=True)


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


def main():
    """Reads the view, makes its scene and draws; prints the milliseconds.

    Words: view.json, the model, the file to write, and "mask" or "lines". Blender exits with 0 whatever a script raises, so
    this exits with 1.
    """
    try:
        asked, model, out, what = sys.argv[sys.argv.index("--") + 1:]
        with open(asked, encoding="utf-8") as file:
            view = json.load(file)
        load_model(model)
        place_camera(view)
        if what == "mask":
            start = time.perf_counter()
            render_mask(out)
            draw_ms = 1e3 * (time.perf_counter() - start)
        else:
            draw_ms = draw(view, out)
        print(f"\ndraw_ms {draw_ms:.4f}", flush=True)
    except Exception as error:  # noqa: BLE001
        print(f"\nfailed: {error!r}", flush=True)
        sys.exit(1)


if __name__ == "__main__":
    main()
