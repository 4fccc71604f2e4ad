"""Blender's Freestyle of a view: run inside Blender 3.4.

    blender -b --factory-startup -P strokes.py -- view.json model.obj out.png lines

Freestyle draws while a renderer renders. That is Cycles, which needs no screen; it renders white
objects before white, so that only the black strokes are seen.
"""

import math
import sys
import time
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "blender"))
import scene  # noqa: E402

CREASE_DEG = 40
WIDTH_PX = 2
SAMPLES = 8


def set_up_freestyle():
    """Visible silhouettes, borders and creases, as black strokes without any style."""
    bpy.context.scene.render.use_freestyle = True
    bpy.context.scene.render.line_thickness_mode = "ABSOLUTE"
    bpy.context.scene.render.line_thickness = 1
    settings = bpy.context.view_layer.freestyle_settings
    settings.crease_angle = math.pi - math.radians(CREASE_DEG)
    lines = settings.linesets[0] if settings.linesets else settings.linesets.new("lines")
    if lines.linestyle is None:
        lines.linestyle = bpy.data.linestyles.new("lines")
    lines.select_by_visibility, lines.visibility = True, "VISIBLE"
    lines.select_by_image_border = True  # else strokes that pass the eye take all memory
    for name in [p.identifier for p in lines.bl_rna.properties]:
        if name.startswith("select_") and not name.startswith("select_by_"):
            setattr(lines, name, name in ("select_silhouette", "select_border", "select_crease"))
    lines.linestyle.color = (0, 0, 0)
    lines.linestyle.thickness = WIDTH_PX
    lines.linestyle.use_chaining = True


def draw(view, out):
    set_up_freestyle()
    scene.set_up_render(out, SAMPLES)
    bpy.context.view_layer.material_override = scene.glow(1)
    scene.set_world(1)
    start = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    return 1e3 * (time.perf_counter() - start)


if __name__ == "__main__":
    scene.run(draw)
