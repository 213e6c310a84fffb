"""Comparisons, recommendations and papers as records."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import silhouettes


def test_a_recommendation_begins_with_its_choice() -> None:
    mesh = silhouettes.load("builtin:torus")
    found = silhouettes.recommend(mesh, goal="loops", seconds=0.3, no_cache=True)
    assert found[0]["role"] == "chosen"
    measured = [record for record in found if record["role"] == "measured"]
    assert len(measured) >= 2
    assert all(record["ms"] > 0 and record["worst_error"] >= 0 for record in measured)


@pytest.mark.usefixtures("device")
def test_a_comparison_is_a_record_for_each_cell(tmp_path: Path) -> None:
    scene = tmp_path / "small.toml"
    text = (Path(__file__).parents[2] / "crates/compare/scenes/quick.toml").read_text()
    for key, value in {"frames": 4, "scored": 2, "width": 64, "height": 64}.items():
        text, replaced = re.subn(rf"^{key} = \d+", f"{key} = {value}", text, flags=re.MULTILINE)
        assert replaced == 1, key
    scene.write_text(text)
    meshes = [silhouettes.load("builtin:cube"), silhouettes.load("builtin:torus")]
    options: dict[str, Any] = {"methods": "brute-force,tracking", "scene": scene}
    cells = silhouettes.compare(meshes, **options)
    assert [(cell["mesh"], cell["method"]) for cell in cells] == [
        (mesh, method) for mesh in ("builtin:cube", "builtin:torus") for method in ("brute-force", "tracking")
    ]
    for cell in cells:
        assert isinstance(cell["faces"], int) and cell["frame_median_ms"] > 0
        assert cell["chamfer_px"] >= 0
    views = silhouettes.compare(meshes[:1], views=True, **options)
    assert len(views) == 4 and views[0]["edge_recall"] == 1
    with pytest.raises(silhouettes.Error, match="two meshes are named"):
        silhouettes.compare([meshes[0], meshes[0]], **options)
    with pytest.raises(silhouettes.Error, match="brute-farce"):
        silhouettes.compare(meshes, methods="brute-farce")
    with pytest.warns(UserWarning, match="tracking is left out"):
        cells = silhouettes.compare([moebius_strip()], **options)
    assert [cell["method"] for cell in cells] == ["brute-force"]


def moebius_strip(parts: int = 12) -> silhouettes.Mesh:
    """A surface with one side, on which loops have no direction."""
    turn = 2 * np.pi * np.arange(parts) / parts
    sides = np.array([-0.3, 0.3])[:, None]
    radius = 1 + sides * np.cos(turn / 2)
    vertices = np.stack([radius * np.cos(turn), radius * np.sin(turn), sides * np.sin(turn / 2)], axis=-1)
    faces = []
    for part in range(parts):
        a, b = part, part + parts
        c, d = (a + 1, b + 1) if part + 1 < parts else (parts, 0)
        faces += [(a, b, c), (c, b, d)]
    return silhouettes.Mesh(vertices.reshape(-1, 3).astype(np.float32), np.array(faces, dtype=np.uint32))
