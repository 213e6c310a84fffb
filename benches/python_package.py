#!/usr/bin/env python3
"""Silhouette edges and visible lines from Python: this package, the Rust call within it, trimesh and PyVista, in one run.

    scripts/wheel && pip install target/wheels/*.whl trimesh rtree pyvista
    python3 benches/python_package.py bunny.obj [--views 100] [--threads 1]

All ways take their turn within each view of an orbit, each after an untimed call for the view before, so that caches hold its own
data. A time is that of the whole call, with the arrays that it returns; `Rust` is what the method took within that call, as `last_ms`
says. Medians over views.

trimesh's way for edges: the sign of each face's normal against the ray to the eye, and the pairs of `face_adjacency` that differ in it.
PyVista's: vtkPolyDataSilhouette, which `Plotter.add_silhouette` draws. Neither is exact, so that counts of edges may differ a little.
For visible lines there is no call in either. What can be done with trimesh is to cast a ray from the eye to the middle of each
silhouette edge; with PyVista, to render the mesh and look the same points up in the depth buffer. Both say whether whole edges are
visible; neither finds where visibility changes.
"""

import argparse
import os
import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import Any

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("mesh", help="a mesh file, or builtin:NAME")
parser.add_argument("--views", type=int, default=100, help="views over a turn (default: 100)")
parser.add_argument("--threads", type=int, help="threads of this package (default: as many as the machine runs)")
arguments = parser.parse_args()
if arguments.views < 1:
    parser.error("--views must be at least 1")
if arguments.threads:
    os.environ["RAYON_NUM_THREADS"] = str(arguments.threads)

sys.path.insert(0, str(Path(__file__).parent / "peers"))
import numpy as np  # noqa: E402
import pyvista  # noqa: E402
import silhouettes  # noqa: E402
import trimesh  # noqa: E402
from extraction_rows import describe_machine, orbit  # noqa: E402
from vtkmodules.vtkFiltersHybrid import vtkPolyDataSilhouette  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkSelectVisiblePoints  # noqa: E402

SIZE = (1024, 1024)
FOV_DEG = 40

# Without Embree they take half a minute for each view of the bunny.
MOST_VIEWS_OF_RAYS = 1

mesh = silhouettes.load(arguments.mesh)
vertices, faces = mesh.vertices, mesh.faces
eyes = orbit(vertices, faces, arguments.views)
target = (vertices.min(axis=0) + vertices.max(axis=0)) / 2

of_trimesh = trimesh.Trimesh(vertices, faces, process=False)
of_pyvista = pyvista.PolyData.from_regular_faces(vertices, faces)


def edges_by(method: str) -> Callable[[Any], tuple[int, float]]:
    extractor = silhouettes.Extractor(mesh, method)

    def find(eye: Any) -> tuple[int, float]:
        return len(extractor.update(eye)), extractor.last_ms

    return find


def edges_by_trimesh(eye: Any) -> Any:
    is_front = ((eye - of_trimesh.triangles[:, 0]) * of_trimesh.face_normals).sum(axis=1) > 0
    one, other = of_trimesh.face_adjacency.T
    return of_trimesh.face_adjacency_edges[is_front[one] != is_front[other]]


silhouette = vtkPolyDataSilhouette()
silhouette.SetInputData(of_pyvista)
silhouette.SetDirectionToSpecifiedOrigin()
silhouette.SetEnableFeatureAngle(0)


def edges_by_pyvista(eye: Any) -> Any:
    silhouette.SetOrigin(*eye)
    silhouette.Update()
    return pyvista.wrap(silhouette.GetOutput())


finder = silhouettes.LineFinder(mesh, no_boundaries=True)


def lines(eye: Any) -> tuple[int, float]:
    camera = silhouettes.look_at(eye, target, fov=FOV_DEG, size=SIZE)
    return sum(len(chain["edges"]) for chain in finder.find(camera)), finder.last_ms


def lines_by_trimesh(eye: Any) -> int:
    middles = of_trimesh.vertices[edges_by_trimesh(eye)].mean(axis=1)
    toward = eye - middles
    toward /= np.linalg.norm(toward, axis=1, keepdims=True)
    blocked = of_trimesh.ray.intersects_any(middles + 1e-4 * of_trimesh.scale * toward, toward)
    return int((~blocked).sum())


plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
plotter.add_mesh(of_pyvista)
plotter.show(auto_close=False)
selection = vtkSelectVisiblePoints()
selection.SetRenderer(plotter.renderer)
selection.SetToleranceWorld(1e-3 * of_pyvista.length)


def lines_by_pyvista(eye: Any) -> int:
    plotter.camera.position, plotter.camera.focal_point, plotter.camera.up = eye, target, (0, 1, 0)
    plotter.camera.view_angle = FOV_DEG
    plotter.reset_camera_clipping_range()
    plotter.render()
    found = edges_by_pyvista(eye)
    middles = found.points[found.lines.reshape(-1, 3)[:, 1:]].mean(axis=1)
    selection.SetInputData(pyvista.PolyData(middles))
    selection.Update()
    return selection.GetOutput().GetNumberOfPoints()


def compared(title: str, ways: dict[str, Callable[[Any], Any]]) -> None:
    """Prints the median milliseconds of each way: alone, over those of its Rust call if it has one, and over those of the first way."""
    times: dict[str, list[float]] = {}
    counts: dict[str, list[int]] = {}
    for number, eye in enumerate(eyes):
        for name, find in ways.items():
            if "rays" in name and number >= MOST_VIEWS_OF_RAYS:
                continue
            find(eyes[number - 1])
            begin = perf_counter()
            found = find(eye)
            took = (perf_counter() - begin) * 1e3
            times.setdefault(name, []).append(took)
            if isinstance(found, tuple):
                found, rust_ms = found
                times.setdefault(f"{name}, Rust", []).append(rust_ms)
            elif not isinstance(found, int):
                found = len(found) if isinstance(found, np.ndarray) else found.n_lines
            counts.setdefault(name, []).append(found)
    print(f"\n{title}\n{'':44}{'ms':>12}{'to Rust':>10}{'to first':>10}{'edges':>8}")
    first = np.median(times[next(iter(ways))])
    for name in ways:
        median, own = np.median(times[name]), times.get(f"{name}, Rust")
        to_rust = f"{median / np.median(own):10.2f}" if own else " " * 10
        print(f"{name:44}{median:12.3f}{to_rust}{median / first:10.2f}{np.median(counts[name]):8.0f}")


print(f"{mesh.name}: {len(faces)} faces, {arguments.views} views; {describe_machine()}")
print(f"silhouettes, numpy {np.__version__}, trimesh {trimesh.__version__}, PyVista {pyvista.__version__}")
extractors = ("brute-force-simd", "cluster-cones", "tracking-exact", "brute-force")
edge_ways: dict[str, Callable[[Any], Any]] = {f"silhouettes {name}": edges_by(name) for name in extractors}
edge_ways |= {"trimesh, face_adjacency": edges_by_trimesh, "PyVista, vtkPolyDataSilhouette": edges_by_pyvista}
compared("Silhouette edges", edge_ways)
line_ways: dict[str, Callable[[Any], Any]] = {"silhouettes LineFinder": lines}
line_ways |= {"PyVista, depth buffer": lines_by_pyvista, "trimesh, rays": lines_by_trimesh}
compared("Visible lines", line_ways)
