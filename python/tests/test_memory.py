"""The memory that a mesh of a million faces takes: the peak of a process of its own, as Linux states it."""

import os
import subprocess
import sys

import pytest

SCRIPT = """
import gc
import sys
from pathlib import Path

import numpy as np
import silhouettes

def peak() -> int:
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) << 10

def forget_peak() -> None:
    gc.collect()
    Path("/proc/self/clear_refs").write_text("5")

def taken(work):
    "Megabytes beyond what was there before, at most, and what the work yields."
    forget_peak()
    before = peak()
    result = work()
    return (peak() - before) / 1e6, result

SIDE = 708
row = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
a, b, c, d = row[:-1, :-1].ravel(), row[:-1, 1:].ravel(), row[1:, 1:].ravel(), row[1:, :-1].ravel()
faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])[:1_000_000]
x, y = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
vertices = np.stack([x, y, np.sin(x * 0.1)], axis=-1).reshape(-1, 3)
vertices, faces = vertices.astype(sys.argv[1]), faces.astype(sys.argv[2])
del a, b, c, d, row, x, y
# The first call loads what it needs.
silhouettes.Mesh(vertices[:3], faces[:1] * 0).vertices

made, mesh = taken(lambda: silhouettes.Mesh(vertices, faces))
seen, arrays = taken(lambda: (mesh.vertices, mesh.faces))
copied, _ = taken(lambda: (vertices.copy(), faces.copy()))
print(made, seen, copied, (vertices.nbytes + faces.nbytes) / 1e6)
"""


def measured(vertices: str, faces: str) -> tuple[float, ...]:
    """Megabytes taken by a mesh of these types of arrays, by its own arrays, by copies of the given ones; and the size of those."""
    # Arrays in mappings of their own, so that none takes the place of one that was let go before.
    environment = {**os.environ, "MALLOC_MMAP_THRESHOLD_": "65536"}
    command = [sys.executable, "-c", SCRIPT, vertices, faces]
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    print(vertices, faces, done.stdout.strip())
    return tuple(float(word) for word in done.stdout.split())


# 501,264 vertices and a million faces, of 12 bytes each: what a mesh holds.
HELD = (708 * 708 * 12 + 1_000_000 * 12) / 1e6


@pytest.mark.skipif(sys.platform != "linux", reason="peaks of memory as Linux states them")
@pytest.mark.parametrize(
    ("vertices", "faces"),
    [("float32", "uint32"), ("float64", "int64"), ("float32", "int32")],
)
def test_a_mesh_takes_one_copy_and_its_arrays_take_none(vertices: str, faces: str) -> None:
    made, seen, copied, given = measured(vertices, faces)
    # Pages and the allocator's own take some.
    assert 0.9 * HELD < made < HELD + 2
    assert seen < 1
    # The measure sees a copy where there is one.
    assert copied > 0.9 * given
