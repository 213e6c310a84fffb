"""Pictures as arrays, and silhouette textures."""

import struct
import subprocess
import sys
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import silhouettes

pytestmark = pytest.mark.usefixtures("device")


def test_lines_only_leave_the_ground_transparent() -> None:
    mesh = silhouettes.load("builtin:torus")
    camera = silhouettes.Camera(view="iso", size=(120, 90))
    lines = silhouettes.render(mesh, "brute-force", camera, lines_only=True)
    paper = silhouettes.render(mesh, "brute-force", camera)
    assert lines.shape == (90, 120, 4) and lines.dtype == np.uint8
    assert (lines[..., 3] == 0).mean() > 0.5 and (lines[..., 3] == 255).sum() > 50
    assert (paper[..., 3] == 255).all() and (paper[..., :3] == 255).any()
    alpha = lines[..., 3:] / 255.0
    over = lines[..., :3] * alpha + 255 * (1 - alpha)
    assert np.abs(over - paper[..., :3]).max() <= 2


def read_png(path: Path) -> npt.NDArray[np.uint8]:
    """The pixels of a PNG of 8-bit RGBA, by the format's specification."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        (length,), kind = struct.unpack(">I", data[at : at + 4]), data[at + 4 : at + 8]
        chunk = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", chunk[:10])
            assert (depth, color) == (8, 6)
        elif kind == b"IDAT":
            packed += chunk
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 4 * width)
    out = np.zeros((height + 1, 4 + 4 * width), int)
    for y, (kind_of_row, row) in enumerate(zip(rows[:, 0], rows[:, 1:], strict=True), 1):
        for x, value in enumerate(row, 4):
            left, up, corner = out[y, x - 4], out[y - 1, x], out[y - 1, x - 4]
            near = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))
            predicted = [0, left, up, (left + up) // 2, near[2]][kind_of_row]
            out[y, x] = (value + predicted) % 256
    return out[1:, 4:].astype(np.uint8).reshape(height, width, 4)


def test_the_picture_is_that_of_the_command_line(tmp_path: Path) -> None:
    mesh = silhouettes.load("builtin:knot")
    program = Path(sys.executable).with_name("silhouettes")
    for method in ("brute-force", "image-precision", "smoothing"):
        for name, lines_only in (("paper", False), ("transparent", True)):
            drawn = silhouettes.render(mesh, method, silhouettes.Camera(view="iso", size=(64, 48)), lines_only=lines_only)
            path = tmp_path / f"{method}-{name}.png"
            words = ["render", "builtin:knot", "--method", method, "--view", "iso", "--size", "64x48", "-o", str(path)]
            subprocess.run([program, *words, *(["--transparent"] if lines_only else [])], check=True)
            np.testing.assert_array_equal(drawn, read_png(path), err_msg=path.name)
            assert np.ptp(drawn[..., 3 if lines_only else 0]) > 100


def test_what_cannot_be_drawn_is_refused() -> None:
    mesh = silhouettes.load("builtin:cube")
    options: list[tuple[dict[str, Any], str]] = [
        ({"width": 0}, "--width 0: give 0.1 to 100"),
        ({"samples": 3}, "samples=3: give 1 or 4"),
        ({"method": "interpolated-contours"}, "yields curves alone"),
        ({"size": (0, 9)}, "viewport must be"),
        ({"size": (99999, 9)}, "viewport must be"),
        ({"nothing": 1}, "no option 'nothing'"),
    ]
    for given, says in options:
        with pytest.raises(silhouettes.Error, match=says):
            silhouettes.render(mesh, **given)


def test_a_texture_survives_its_file(tmp_path: Path) -> None:
    mesh = silhouettes.load("builtin:icosphere:3")
    baked = silhouettes.bake(mesh, size=64, hull_vertices=50)
    baked.save(tmp_path / "sphere.siltex")
    read = silhouettes.Texture.load(tmp_path / "sphere.siltex")
    assert read.metadata["mesh"] == "builtin:icosphere:3"
    camera = silhouettes.Camera(view="iso", size=(96, 96))
    pictures = [silhouettes.render(texture.hull, "texture", camera, lines_only=True) for texture in (baked, read)]
    np.testing.assert_array_equal(pictures[0], pictures[1])
    # It covers what the mesh covers, not what its hull does.
    covered = (pictures[0][..., 3] > 127).sum()
    camera = silhouettes.look_at((9, 9, 9), size=(96, 96))
    of_mesh, of_hull, of_texture = (
        (silhouettes.render(of, method, camera, lines_only=True)[..., 3] > 127).sum()
        for of, method in ((mesh, "fine-mesh"), (baked.hull, "pn-triangles"), (baked.hull, "texture"))
    )
    assert covered > 1000 and abs(int(of_texture) - int(of_mesh)) < 0.5 * abs(int(of_hull) - int(of_mesh)) + 40
