"""What the peer scripts share: meshes, views, timing, rows.

Everything here is done the same way as in `benches/extractors`: vertex ids of the file, polygons fanned, the orbit of
`silhouette_compare::camera_path::Orbit::eyes`, the fields of `silhouette_compare::scaling::ExtractionRow`. Meshes are
Wavefront OBJ files, or binary PLY files as `cargo bench --bench extractors -- --export DIR` writes them, which load in
seconds at ten million faces and carry the name that the mesh has in our rows.
"""

import argparse
import json
import os
import platform
import time
from pathlib import Path

# One core: libraries read these when they are first imported.
for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VTK_SMP_MAX_THREADS"):
    os.environ[_name] = "1"

import numpy as np

# Constants of `crates/compare/src/camera_path.rs`.
FIRST_AZIMUTH_RAD = 0.417
ELEVATION_RAD = 0.31
SWING_RAD = 0.23

# Constant of `benches/extractors/measure.rs`.
DISTANCE_RADII = 3.0


def load(path):
    """Name in rows, positions (V x 3, float32) and triangles (F x 3, int64) of a mesh file."""
    reader = {".obj": load_obj, ".ply": load_ply}.get(path.suffix)
    if reader is None:
        raise SystemExit(f"{path}: neither .obj nor .ply")
    try:
        name, positions, triangles = reader(path)
    except (OSError, ValueError) as error:
        raise SystemExit(f"{path}: {error}") from error
    if len(triangles) == 0:
        raise SystemExit(f"{path}: no face")
    return name, positions, triangles


def load_obj(path):
    """A Wavefront OBJ, polygons fanned about their first corner, named after the file."""
    positions, triangles = [], []
    with open(path, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                positions.append([float(word) for word in words[1:4]])
            elif words[0] == "f":
                ids = [int(word.split("/")[0]) for word in words[1:]]
                ids = [index - 1 if index > 0 else len(positions) + index for index in ids]
                triangles += [(ids[0], b, c) for b, c in zip(ids[1:], ids[2:])]
    return path.name, np.array(positions, dtype=np.float32), np.array(triangles, dtype=np.int64)


# Lines of the header that `benches/extractors/export.rs` writes; NAME, V and F stand where `{}` is.
PLY_HEADER = (
    "ply",
    "format binary_little_endian 1.0",
    "comment mesh {}",
    "element vertex {}",
    "property float x",
    "property float y",
    "property float z",
    "element face {}",
    "property list uchar uint vertex_indices",
    "end_header",
)
PLY_TRIANGLE = np.dtype([("corners", "u1"), ("vertices", "<u4", 3)])


def load_ply(path):
    """An exported PLY, read in two pieces; any other layout is refused. Named by the header."""
    with open(path, "rb") as file:
        values = []
        for expected in PLY_HEADER:
            line = file.readline().decode("utf-8").rstrip("\n")
            fixed, slot, _ = expected.partition("{}")
            if not (line.startswith(fixed) if slot else line == fixed):
                raise ValueError(f"not as --export writes it: '{line}' in place of '{expected}'")
            if slot:
                values.append(line[len(fixed) :])
        name, vertices, faces = values[0], int(values[1]), int(values[2])
        positions = np.fromfile(file, dtype="<f4", count=3 * vertices)
        rows = np.fromfile(file, dtype=PLY_TRIANGLE, count=faces)
    if len(positions) != 3 * vertices or len(rows) != faces or (rows["corners"] != 3).any():
        raise ValueError("cut short, or a face is no triangle")
    return name, positions.reshape(-1, 3), rows["vertices"].astype(np.int64)


def orbit(positions, triangles, views):
    """Eyes (views x 3, rounded to float32, held in float64) around the bounding sphere of the vertices in use."""
    used = positions[np.unique(triangles)].astype(np.float64)
    center = (used.min(axis=0) + used.max(axis=0)) * 0.5
    radius = np.sqrt(((used - center) ** 2).sum(axis=1).max())
    azimuth = FIRST_AZIMUTH_RAD + 2.0 * np.pi / views * np.arange(views)
    elevation = ELEVATION_RAD + SWING_RAD * np.sin(azimuth + 1.0)
    toward = np.stack(
        [np.sin(azimuth) * np.cos(elevation), np.sin(elevation), np.cos(azimuth) * np.cos(elevation)], axis=1
    )
    return (center + DISTANCE_RADII * radius * toward).astype(np.float32).astype(np.float64)


def edge_table(triangles):
    """The distinct edges as `a << 32 | b` with a < b, sorted; for each half-edge of `triangles`, by faces, its edge.

    One integer an edge sorts many times faster than a row of two.
    """
    next_corner = np.roll(triangles, -1, axis=1)
    keys = np.minimum(triangles, next_corner) << 32 | np.maximum(triangles, next_corner)
    return np.unique(keys.ravel(), return_inverse=True)


def describe_machine():
    """Processor, hardware threads, system: as `silhouette_compare::machine::describe_machine` words it."""

    def field(file, name, separator):
        try:
            lines = Path(file).read_text(encoding="utf-8").splitlines()
        except OSError:
            return None
        pairs = (line.partition(separator) for line in lines)
        return next((value.strip().strip('"') for key, _, value in pairs if key.strip() == name), None)

    cpu = field("/proc/cpuinfo", "model name", ":") or "unknown"
    system = field("/etc/os-release", "PRETTY_NAME", "=") or platform.system().lower()
    threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{cpu}, {threads} threads, {system}, {platform.machine()}"


def run(tool, methods):
    """Measures the methods of one tool on the meshes that the command line names and writes their rows.

    `methods` maps a name to `prepare(positions, triangles)`, which yields `(extract, bytes)`: a function from an eye to
    the number of silhouette edges, whose time is taken, and the bytes prepared, or None where the tool does not tell.
    """
    parser = argparse.ArgumentParser(description=f"Extraction times of {tool}: {', '.join(methods)}; one core.")
    parser.add_argument("meshes", nargs="+", metavar="MESH", type=Path, help=".obj, or .ply by --export of our bench")
    parser.add_argument("--views", type=int, default=200, help="views over a turn (default: 200)")
    parser.add_argument("--output", type=Path, help="JSON Lines file for the rows (default: standard output)")
    arguments = parser.parse_args()
    if arguments.views < 1:
        parser.error("--views must be at least 1")
    rows = [row for path in arguments.meshes for row in measure(tool, methods, path, arguments.views)]
    text = "".join(json.dumps(row) + "\n" for row in rows)
    if arguments.output:
        arguments.output.write_text(text, encoding="utf-8")
    else:
        print(text, end="")


class Cell:
    """One method, prepared for one mesh, with its times and counts."""

    def __init__(self, method, prepare, positions, triangles, eye):
        self.method = method
        start = time.perf_counter()
        self.extract, self.bytes = prepare(positions, triangles)
        self.extract(eye)  # Some tools prepare at the first call.
        self.prepare_ms = (time.perf_counter() - start) * 1e3
        self.times, self.found = [], []

    def time(self, eye):
        start = time.perf_counter()
        count = self.extract(eye)
        self.times.append((time.perf_counter() - start) * 1e3)
        self.found.append(count)


def measure(tool, methods, path, views):
    """The rows of all methods on one mesh, timed in turn within each view.

    Where there are several, each is called for the view before first, as `benches/extractors` does: its data then lie
    in the caches where its own last view left them, and not where the other methods did.
    """
    name, positions, triangles = load(path)
    eyes = orbit(positions, triangles, views)
    edges = len(edge_table(triangles)[0])
    cells = [Cell(method, prepare, positions, triangles, eyes[-1]) for method, prepare in methods.items()]
    for before, eye in zip(np.roll(eyes, 1, axis=0), eyes):
        for cell in cells:
            if len(cells) > 1:
                cell.extract(before)
            cell.time(eye)
    return [row(tool, cell, name, len(triangles), edges) for cell in cells]


def row(tool, cell, mesh, faces, edges):
    times = sorted(cell.times)
    median = float(np.median(times))
    return {
        "tool": tool,
        "method": cell.method,
        "mesh": mesh,
        "faces": faces,
        "edges": edges,
        "silhouette_edges": float(np.median(cell.found)),
        "recall": None,
        "views": len(times),
        "threads": 1,
        "median_ms": median,
        "p95_ms": times[max(0, -(-len(times) * 95 // 100) - 1)],
        "edges_per_second": edges / median * 1e3,
        "prepare_ms": cell.prepare_ms,
        "bytes": cell.bytes,
        "bytes_per_edge": None if cell.bytes is None else cell.bytes / edges,
        "faces_tested": None,
        "edges_tested": None,
        "nodes_visited": None,
        "exact_fallbacks": None,
        "machine": describe_machine(),
    }
