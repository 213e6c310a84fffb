"""What the peer scripts share: meshes, views, timing, rows.

Everything here is done the same way as in `benches/extractors`: vertex ids of the file, polygons fanned, the orbit of
`silhouette_compare::camera_path::Orbit::eyes`, the fields of `silhouette_compare::scaling::ExtractionRow`.
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


def load_obj(path):
    """Positions (V x 3, float32) and triangles (F x 3) of a Wavefront OBJ, polygons fanned about their first corner."""
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
    if not triangles:
        raise SystemExit(f"{path}: no face")
    return np.array(positions, dtype=np.float32), np.array(triangles, dtype=np.int64)


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
    """The distinct edges (E x 2, a < b), and for each half-edge of `triangles`, face by face, its edge."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    ends.sort(axis=1)
    return np.unique(ends, axis=0, return_inverse=True)


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


def run(tool, method, prepare):
    """Measures one tool on the meshes that the command line names and writes its rows.

    `prepare(positions, triangles)` yields `(extract, bytes)`: a function from an eye to the number of silhouette edges,
    whose time is taken, and the bytes prepared, or None where the tool does not tell.
    """
    parser = argparse.ArgumentParser(description=f"Extraction times of {tool}: {method}, one core.")
    parser.add_argument("meshes", nargs="+", metavar="MESH.obj", type=Path)
    parser.add_argument("--views", type=int, default=200, help="views over a turn (default: 200)")
    parser.add_argument("--output", type=Path, help="JSON Lines file for the rows (default: standard output)")
    arguments = parser.parse_args()
    if arguments.views < 1:
        parser.error("--views must be at least 1")
    rows = [measure(tool, method, prepare, path, arguments.views) for path in arguments.meshes]
    text = "".join(json.dumps(row) + "\n" for row in rows)
    if arguments.output:
        arguments.output.write_text(text, encoding="utf-8")
    else:
        print(text, end="")


def measure(tool, method, prepare, path, views):
    positions, triangles = load_obj(path)
    eyes = orbit(positions, triangles, views)
    edges = len(edge_table(triangles)[0])

    start = time.perf_counter()
    extract, size = prepare(positions, triangles)
    extract(eyes[-1])  # Some tools prepare at the first call; it also warms the caches as later calls find them.
    prepare_ms = (time.perf_counter() - start) * 1e3

    times, found = [], []
    for eye in eyes:
        start = time.perf_counter()
        count = extract(eye)
        times.append((time.perf_counter() - start) * 1e3)
        found.append(count)
    times.sort()
    median = float(np.median(times))
    return {
        "tool": tool,
        "method": method,
        "mesh": path.name,
        "faces": len(triangles),
        "edges": edges,
        "silhouette_edges": float(np.median(found)),
        "recall": None,
        "views": views,
        "threads": 1,
        "median_ms": median,
        "p95_ms": times[max(0, -(-len(times) * 95 // 100) - 1)],
        "edges_per_second": edges / median * 1e3,
        "prepare_ms": prepare_ms,
        "bytes": size,
        "bytes_per_edge": None if size is None else size / edges,
        "faces_tested": None,
        "edges_tested": None,
        "nodes_visited": None,
        "exact_fallbacks": None,
        "machine": describe_machine(),
    }
