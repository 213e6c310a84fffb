#!/usr/bin/env python3
"""Outlines of meshes by Manifold and by trimesh: time, and the area enclosed.

The view is the orthographic three-quarter view of our benchmark of visible lines. Manifold projects along z, so the mesh is
turned into the view first, in float64, which is not timed. Timed are `Manifold.project` of a manifold that stands already,
and `trimesh.path.polygons.projected` of a loaded mesh. Manifold takes
manifold meshes only, and trimesh fails on some: those are left out, and a line says so. trimesh pads the regions that it
unites, so that its area is an approximation.

Usage:
    pip install manifold3d trimesh shapely networkx rtree scipy mapbox_earcut
    python3 outlines.py MESH... [--tools manifold,trimesh] [--runs 9] [-o rows.jsonl]
"""

import argparse
import json
import os
import sys
import time
from importlib.metadata import version
from pathlib import Path

from extraction_rows import describe_machine, load, np

# Constants of `crates/core/src/view/camera.rs`, `crates/core/src/view/preset.rs` and `benches/visible_lines/measure.rs`.
FRAMING_MARGIN = 0.05
THREE_QUARTER = (0.55, 0.35, 1.0)
SIZE = (1024, 1024)


def view_of(positions, triangles):
    """Eye and target (float32, held in float64), and the height of the picture in the mesh's units."""
    used = positions[np.unique(triangles)].astype(np.float64)
    center = (used.min(axis=0) + used.max(axis=0)) * 0.5
    radius = float(np.sqrt(((used - center) ** 2).sum(axis=1).max())) * (1.0 + FRAMING_MARGIN)
    toward = np.array(THREE_QUARTER) / np.linalg.norm(THREE_QUARTER)
    as_float32 = lambda point: np.asarray(point, dtype=np.float32).astype(np.float64)
    return as_float32(center + toward * (3.0 * radius)), as_float32(center), 2.0 * radius


def axes(eye, target):
    """Right, up and towards the viewer, as rows. The direction of an orthographic view is a difference of float32."""
    back = (eye.astype(np.float32) - target.astype(np.float32)).astype(np.float64)
    back /= np.linalg.norm(back)
    right = np.cross([0.0, 1.0, 0.0], back)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(back, right), back])


def manifold(points, triangles):
    """A function that yields the area of an outline, or None for a mesh that is no manifold."""
    import manifold3d

    solid = manifold3d.Manifold(manifold3d.Mesh64(points, triangles.astype(np.uint64)))
    if solid.status() != manifold3d.Error.NoError:
        return None

    def outline():
        section = solid.project()
        section.num_contour()  # It may be lazy.
        return section

    return outline, lambda section: section.area()


def trimesh_projected(points, triangles):
    import trimesh
    from trimesh.path import polygons

    mesh = trimesh.Trimesh(points, triangles, process=False)
    mesh.face_normals, mesh.face_adjacency  # noqa: B018 -- what trimesh caches is there before the clock runs.
    return lambda: polygons.projected(mesh, [0.0, 0.0, 1.0]), lambda polygon: polygon.area


TOOLS = {"manifold": ("manifold3d", manifold), "trimesh": ("trimesh", trimesh_projected)}


def measure(path, tool, runs):
    """The row of one mesh, or None."""
    package, prepare = TOOLS[tool]
    name, positions, triangles = load(path)
    eye, target, height = view_of(positions, triangles)
    points = np.ascontiguousarray((positions.astype(np.float64) - target) @ axes(eye, target).T)
    prepared = prepare(points, triangles)
    if prepared is None:
        print(f"{path}: no manifold for {tool}", file=sys.stderr)
        return None
    outline, area_of = prepared
    try:
        area, times = area_of(outline()), []
    except Exception as error:  # Of whatever library does the union.
        print(f"{path}: {tool} fails: {error}", file=sys.stderr)
        return None
    for _ in range(runs):
        wall, processor = time.perf_counter(), time.process_time()
        outline()
        times.append(((time.perf_counter() - wall) * 1e3, (time.process_time() - processor) * 1e3))
    walls, processors = zip(*times)
    return {
        "tool": package,
        "version": version(package),
        "mesh": name,
        "faces": len(triangles),
        "metric": "outline",
        "median_ms": float(np.median(walls)),
        "min_ms": min(walls),
        "cpu_ms": float(np.median(processors)),
        "runs": runs,
        "threads": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "area_px": area * (SIZE[1] / height) ** 2,
        "eye": shortest(eye),
        "target": shortest(target),
        "up": [0.0, 1.0, 0.0],
        "height": height,
        "size": list(SIZE),
        "machine": describe_machine(),
    }


def shortest(vector):
    """The shortest decimals that name the same float32."""
    return [float(str(number)) for number in vector.astype(np.float32)]


def main():
    parser = argparse.ArgumentParser(description="Outlines by Manifold and trimesh: time and area.")
    parser.add_argument("meshes", nargs="+", metavar="MESH", type=Path, help=".obj, or .ply by --export of our bench")
    parser.add_argument("--tools", default="manifold,trimesh", help="which (default: manifold,trimesh)")
    parser.add_argument("--runs", type=int, default=9, help="timed runs after a warm-up (default: 9)")
    parser.add_argument("-o", "--output", type=Path, help="JSON Lines file for the rows (default: standard output)")
    arguments = parser.parse_args()
    tools = arguments.tools.split(",")
    if arguments.runs < 1:
        parser.error("--runs must be at least 1")
    if any(tool not in TOOLS for tool in tools):
        parser.error(f"--tools knows {', '.join(TOOLS)}")
    rows = [measure(path, tool, arguments.runs) for path in arguments.meshes for tool in tools]
    text = "".join(json.dumps(row) + "\n" for row in rows if row)
    if arguments.output:
        arguments.output.write_text(text, encoding="utf-8")
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
