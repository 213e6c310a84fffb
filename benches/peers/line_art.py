#!/usr/bin/env python3
"""Visible silhouette and boundary edges by Blender's Line Art, on as many threads as Blender takes.

A Grease Pencil object with the Line Art modifier draws the mesh: its contour edges, which for Line Art are silhouette
and boundary edges alike, and no crease, intersection, material or loose edge. All else is as Blender has it by default.
Timed is one evaluation of the dependency graph after the object is tagged: Line Art begins anew, the mesh itself is
evaluated already. Two metrics: "visible" (occlusion level 0 alone) and "levels 0-128", visible and hidden lines alike.

Line Art decides occlusion in floating point, joins chains over gaps that are small in the picture, and takes the
boundary edges of back faces too.

Usage:
    pip install bpy
    python3 line_art.py MESH... [--eye X,Y,Z --target X,Y,Z --up X,Y,Z --fov DEG --size WxH] [-o rows.jsonl] [--svg FILE]
"""

from blender_lines import Cell, np, run, stopwatch

import bpy

LAYER = "lines"
LEVELS = {"visible": (0, 0), "levels 0-128": (0, 128)}
OTHER_EDGES = ("loose", "crease", "material", "edge_mark", "intersection", "light_contour", "shadow")


def prepare(scene, mesh_object, camera, _arguments):
    pencils = getattr(bpy.data, "grease_pencils_v3", None) or bpy.data.grease_pencils  # Blender 4's name, and 5's.
    data = pencils.new(LAYER)
    data.layers.new(LAYER)
    material = bpy.data.materials.new(LAYER)
    bpy.data.materials.create_gpencil_data(material)
    data.materials.append(material)
    pencil = bpy.data.objects.new(LAYER, data)
    scene.collection.objects.link(pencil)

    modifier = pencil.modifiers.new(LAYER, "LINEART")
    modifier.source_type, modifier.source_object = "OBJECT", mesh_object
    modifier.target_layer, modifier.target_material = LAYER, material
    modifier.use_contour = True
    for kind in OTHER_EDGES:
        setattr(modifier, f"use_{kind}", False)
    modifier.use_clip_plane_boundaries = False
    modifier.stroke_depth_offset = 0.0  # Lines stay where the edges are.

    def cell(metric, levels):
        def evaluate():
            modifier.level_start, modifier.level_end = levels
            modifier.use_multiple_levels = levels[0] != levels[1]
            pencil.update_tag(refresh={"DATA"})
            return stopwatch(bpy.context.evaluated_depsgraph_get)

        def strokes():
            evaluate()
            return read_strokes(pencil, camera)

        return Cell(metric, evaluate, strokes)

    return [cell(metric, levels) for metric, levels in LEVELS.items()]


def read_strokes(pencil, camera):
    """The strokes of the evaluated object, in pixels."""
    evaluated = pencil.evaluated_get(bpy.context.evaluated_depsgraph_get())
    drawing = evaluated.data.layers[LAYER].current_frame().drawing
    if len(drawing.strokes) == 0:
        return []
    offsets = np.zeros(len(drawing.curve_offsets), dtype=np.int32)
    drawing.curve_offsets.foreach_get("value", offsets)
    points = np.zeros((offsets[-1], 3), dtype=np.float32)
    drawing.attributes["position"].data.foreach_get("vector", points.reshape(-1))
    return np.split(camera.project(points.astype(np.float64)), offsets[1:-1])


if __name__ == "__main__":
    run("blender-line-art", prepare)
