#!/usr/bin/env python3
"""Visible silhouette and boundary edges by Blender's Freestyle.

One line set of silhouettes and borders with invisibility 0, chained; no crease. All else is as Blender has it by default.
Freestyle runs only within a render, so timed is a render with Freestyle less a render without it just before. The engine
is one of this script that paints nothing, also no strokes: what is left is Freestyle's own work (reading the mesh, view
map, visibility, chaining, strokes as meshes) and the merging of one empty picture. With --engine cycles, Cycles draws
the picture and the strokes with one sample a pixel, as it does for a user without a GPU. (EEVEE needs one.)

The name of this file is not freestyle.py, which would hide Blender's module of that name.

Usage:
    pip install bpy
    python3 freestyle_lines.py MESH... [--engine none|cycles] [--eye X,Y,Z --target X,Y,Z --up X,Y,Z --fov DEG
        --size WxH] [-o rows.jsonl] [--svg FILE]
"""

from blender_lines import Cell, np, run, stopwatch

import bpy
import parameter_editor  # Blender's own, which runs the line set
from freestyle.types import StrokeShader

OTHER_EDGES = (
    "crease",
    "ridge_valley",
    "suggestive_contour",
    "material_boundary",
    "contour",
    "external_contour",
    "edge_mark",
)


class BlankEngine(bpy.types.RenderEngine):
    """Leaves the picture empty. Freestyle asks the scene's engine to draw the strokes where it says it can."""

    bl_idname = "BLANK"
    bl_label = "Blank"
    bl_use_custom_freestyle = True

    def render(self, depsgraph):
        settings = depsgraph.scene.render
        scale = settings.resolution_percentage / 100
        # Freestyle needs a result to look for passes in, an empty one too.
        self.end_result(self.begin_result(0, 0, int(settings.resolution_x * scale), int(settings.resolution_y * scale)))


class Recorder(StrokeShader):
    """Notes the points of each stroke and changes nothing."""

    def __init__(self, points):
        StrokeShader.__init__(self)
        self.points = points

    def shade(self, stroke):
        self.points.append(np.array([vertex.point for vertex in stroke], dtype=np.float64))


def prepare(scene, _mesh_object, camera, arguments):
    use_engine(scene, arguments.engine)
    layer = bpy.context.view_layer
    layer.use_freestyle = True
    line_sets = layer.freestyle_settings.linesets
    line_set = line_sets[0] if line_sets else line_sets.new("lines")
    line_set.linestyle = line_set.linestyle or bpy.data.linestyles.new("lines")
    line_set.select_by_visibility, line_set.visibility = True, "VISIBLE"
    line_set.select_silhouette = line_set.select_border = True
    for kind in OTHER_EDGES:
        setattr(line_set, f"select_{kind}", False)

    def render(with_freestyle):
        scene.render.use_freestyle = with_freestyle
        return stopwatch(bpy.ops.render.render)

    def once():
        (plain, plain_cpu), (lined, lined_cpu) = render(False), render(True)
        return lined - plain, lined_cpu - plain_cpu

    def strokes():
        points = []
        record = lambda *_: [Recorder(points)]
        parameter_editor.callbacks_modifiers_post.append(record)
        render(True)
        parameter_editor.callbacks_modifiers_post.remove(record)
        # Freestyle's y points up.
        return [np.array([0.0, camera.size[1]]) + stroke * [1.0, -1.0] for stroke in points]

    metric = {"none": "visible", "cycles": "visible, painted by Cycles"}[arguments.engine]
    return [Cell(metric, once, strokes)]


def use_engine(scene, engine):
    if engine == "none":
        scene.render.engine = BlankEngine.bl_idname
        return
    bpy.ops.preferences.addon_enable(module="cycles")
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False


def options(parser):
    parser.add_argument("--engine", choices=["none", "cycles"], default="none", help="who paints (default: none)")


if __name__ == "__main__":
    bpy.utils.register_class(BlankEngine)
    try:
        run("blender-freestyle", prepare, options)
    finally:
        # Blender does not end while a class of Python's is registered.
        bpy.utils.unregister_class(BlankEngine)
