"""The scene of a view in Blender: run inside Blender 3.4, by the scripts of its two adapters.

Blender's axes are those of the file: it is imported without turning it, so a camera looks along its
own -z as it does in view.json.
"""

import json
import math
import sys
import time

import bpy
from mathutils import Matrix


def arguments():
    """The words behind `--` on Blender's command line."""
    return sys.argv[sys.argv.index("--") + 1:]


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


def set_up_render(path, samples):
    """Cycles, the one engine that needs no screen: objects and world as they are set, no tones."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 0
    scene.cycles.pixel_filter_type = "BOX"
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "BW"
    scene.render.filepath = path


def glow(white):
    """A material that is seen as white, or as black."""
    material = bpy.data.materials.new("glow")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    light, out = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    light.inputs["Color"].default_value = (white, white, white, 1)
    material.node_tree.links.new(light.outputs[0], out.inputs[0])
    return material


def set_world(white):
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (white, white, white, 1)
    bpy.context.scene.world = world


def render_mask(path):
    """The objects white on black, a sample in the middle of each pixel."""
    set_up_render(path, 1)
    bpy.context.scene.cycles.filter_width = 0.01
    bpy.context.view_layer.material_override = glow(1)
    set_world(0)
    bpy.ops.render.render(write_still=True)


def run(draw):
    """Reads the view, makes its scene and calls `draw(view, out)`, or draws the mask.

    Words: view.json, the file to write, and "mask" or "lines". `draw` returns its milliseconds.
    Blender exits with 0 whatever a script raises, so this exits with 1.
    """
    try:
        asked, model, out, what = arguments()
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
