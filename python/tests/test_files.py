"""Files of lines against those of the command line, and meshes as its options change them."""

import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import silhouettes

PROGRAM = Path(sys.executable).with_name("silhouettes")

# Two squares that meet in an edge, each with corners of its own, as parts of different names and materials.
TWO_SQUARES = """\
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 1 0 0
v 1 0 1
v 1 1 1
v 1 1 0
o floor
usemtl wood
f 1 2 3 4
o wall
usemtl stone
f 5 6 7 8
"""


# Sees both from the side that their faces have in front.
FRONT = silhouettes.look_at((-2, 0.5, 2), (0.5, 0.5, 0.5), size=(100, 100))


@pytest.fixture
def squares(tmp_path: Path) -> Path:
    path = tmp_path / "squares.obj"
    path.write_text(TWO_SQUARES)
    return path


def words_of(options: dict[str, Any]) -> list[str]:
    words = []
    for name, value in options.items():
        for one in value if isinstance(value, list) else [value]:
            text = ",".join(map(str, one)) if isinstance(one, tuple) else str(one)
            words.append(f"--{name.replace('_', '-')}" + ("" if one is True else f"={text}"))
    return words


@pytest.mark.parametrize("end", ["svg", "pdf", "dxf", "hpgl", "json", "gltf", "glb"])
def test_files_are_those_of_the_command_line(tmp_path: Path, end: str) -> None:
    path, expected = tmp_path / f"lines.{end}", tmp_path / f"expected.{end}"
    silhouettes.write_lines(silhouettes.load("builtin:knot"), path, silhouettes.Camera(view="iso"), hidden=True)
    subprocess.run([PROGRAM, "lines", "builtin:knot", "--view=iso", "--hidden", "-o", expected], check=True)
    assert path.read_bytes() == expected.read_bytes()
    silhouettes.write_lines(silhouettes.load("builtin:knot"), path, silhouettes.Camera(view="front"), hidden=True)
    assert path.read_bytes() != expected.read_bytes()


@pytest.mark.parametrize(
    "options",
    [
        {"weld": True},
        {"weld": 0.01, "creases": 30, "materials": True},
        {"heal": True},
        {"orient": True},
        {"section": (0.25, 0, 0, -1, 0, 0)},
        {"section": [(0.25, 0, 0, -1, 0, 0), (0, 0.5, 0, 0, 1, 0)]},
        {"only": "wall"},
        {"without": ["wall"], "layers": "object"},
        {"mask": "floor", "outline": True, "fill": "red"},
        {"smooth": True},
        {"views": "front,top,right"},
        {"page": "a4", "width": "0.3mm", "threads": 1},
    ],
    ids=str,
)
def test_every_option_means_the_same(squares: Path, tmp_path: Path, options: dict[str, Any]) -> None:
    path, expected = tmp_path / "lines.svg", tmp_path / "expected.svg"
    command = [str(PROGRAM), "lines", str(squares), *words_of(options), "-o", str(expected)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        silhouettes.write_lines(silhouettes.load(squares), path, **options)
    assert path.read_bytes() == expected.read_bytes()
    notes = [f"silhouettes: note: {warning.message}" for warning in caught]
    assert notes == done.stderr.splitlines()


def test_meshes_are_drawn_together(squares: Path, tmp_path: Path) -> None:
    path, expected = tmp_path / "lines.svg", tmp_path / "expected.svg"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        silhouettes.write_lines([silhouettes.load(squares), silhouettes.load("builtin:cube")], path)
        subprocess.run([PROGRAM, "lines", squares, "builtin:cube", "-o", expected], check=True, capture_output=True)
        assert path.read_bytes() == expected.read_bytes()
        with pytest.raises(silhouettes.Error, match="MESH"):
            silhouettes.write_lines([], path)


def test_what_cannot_be_written_is_refused_and_leaves_what_is_there(tmp_path: Path) -> None:
    mesh, path = silhouettes.load("builtin:cube"), tmp_path / "lines.svg"
    path.write_text("before")
    cases: list[tuple[Path, dict[str, Any], str]] = [
        (tmp_path / "lines.png", {}, "unknown kind of output"),
        (tmp_path / "nowhere" / "lines.svg", {}, "cannot be written"),
        (tmp_path, {}, "unknown kind of output|is a directory"),
        (path, {"width": "wide"}, "--width wide"),
        (path, {"only": "lid"}, "--only lid: no part of that name"),
        (path, {"section": (0, 0, 0, 0, 0, 0)}, "--section"),
        (path, {"nothing": 1}, "--nothing"),
        (path, {"views": "front,top", "fit": "view"}, "--fit"),
    ]
    for at, options, says in cases:
        with pytest.raises(silhouettes.Error, match=says) as raised:
            silhouettes.write_lines(mesh, at, **options)
        assert "\n" not in str(raised.value)
    assert path.read_text() == "before" and list(tmp_path.iterdir()) == [path]


def test_parts_are_known_by_their_names(squares: Path) -> None:
    mesh = silhouettes.load(squares)
    assert mesh.parts == ["floor", "wall"]
    wall = mesh.select(only=["wall"])
    np.testing.assert_array_equal(wall.faces, mesh.faces[2:])
    np.testing.assert_array_equal(mesh.select(without=["wall"]).faces, mesh.faces[:2])
    assert silhouettes.load("builtin:cube").parts == []
    with pytest.raises(silhouettes.Error, match="--only roof: no part of that name; there are floor"):
        mesh.select(only=["roof"])
    with pytest.raises(silhouettes.Error, match="leave nothing to draw"):
        mesh.select(only=["wall"], without=["wall"])


def test_welded_and_healed_meshes_are_closed_where_they_were_open(squares: Path) -> None:
    mesh = silhouettes.load(squares)
    assert mesh.inspect()["boundary_edges"] == 8
    for welded in (mesh.weld(), mesh.weld(0.1), mesh.heal(), mesh.heal(0.01)):
        assert (len(welded.vertices), welded.inspect()["boundary_edges"]) == (6, 6)
        assert welded.name == mesh.name and welded.parts == mesh.parts
    assert mesh.inspect()["boundary_edges"] == 8
    for distance in (-1.0, np.nan, 10.0):
        with pytest.raises(silhouettes.Error, match="--weld"):
            mesh.weld(distance)
    # The border between the materials is a line of the welded mesh.
    kinds = [chain["kind"] for chain in silhouettes.visible_lines(mesh, FRONT, weld=True, materials=True)]
    assert "material" in kinds
    assert "material" not in [chain["kind"] for chain in silhouettes.visible_lines(mesh, FRONT, weld=True)]


def test_a_mesh_inside_out_is_turned() -> None:
    cube = silhouettes.load("builtin:cube")
    inside_out = silhouettes.Mesh(cube.vertices, cube.faces[:, ::-1])
    turned = inside_out.orient()
    corners = turned.vertices[turned.faces].astype(float)
    volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert volume > 0
    assert turned.notes == ["mesh: 12 of 12 faces were turned, so that they point outwards"]
    np.testing.assert_array_equal(cube.orient().faces, cube.faces)


def test_a_cut_mesh_ends_at_the_plane() -> None:
    mesh = silhouettes.load("builtin:icosphere:3")
    half = mesh.cut((0.1, 0, 0), (1, 0, 0))
    used = half.vertices[np.unique(half.faces)]
    assert used[:, 0].max() == pytest.approx(0.1, abs=1e-6) and used[:, 0].min() < -0.9
    chains = silhouettes.visible_lines(mesh, silhouettes.look_at((5, 1, 0)), section=(0.1, 0, 0, 1, 0, 0))
    (cut,) = (chain for chain in chains if chain["kind"] == "section")
    np.testing.assert_allclose(cut["points"][:, 0], 0.1, atol=1e-6)
    # The mesh's edges cross the plane within the sphere and close to it.
    radii = np.linalg.norm(cut["points"][:, 1:], axis=1)
    assert np.all((radii < np.sqrt(1 - 0.01) + 1e-6) & (radii > 0.97))
    with pytest.raises(silhouettes.Error, match="leaves nothing"):
        mesh.cut((-2, 0, 0), (1, 0, 0))


def area(regions: list[list[npt.NDArray[np.float64]]]) -> float:
    """The area that rings enclose, those of holes being wound the other way."""
    rings = (ring.T for region in regions for ring in region)
    return abs(float(sum(0.5 * np.sum(np.roll(x, -1) * y - x * np.roll(y, -1)) for x, y in rings)))


def test_an_outline_is_that_of_what_is_drawn(squares: Path) -> None:
    mesh = silhouettes.load(squares)
    everything = area(silhouettes.outline(mesh, FRONT))
    wall = area(silhouettes.outline(mesh, FRONT, only="wall"))
    assert 0 < wall < 0.9 * everything
    # A mask is not drawn; here it hides nothing of the wall.
    assert area(silhouettes.outline(mesh, FRONT, mask="floor")) == pytest.approx(wall, rel=1e-9)
    assert area(silhouettes.outline(mesh.select(only=["wall"]), FRONT)) == pytest.approx(wall, rel=1e-9)


def test_options_that_would_be_ignored_are_refused() -> None:
    mesh = silhouettes.load("builtin:cube")
    cases: list[tuple[dict[str, Any], str]] = [
        ({"width": 2}, "--width: is an option of files"),
        ({"page": "a4"}, "--page: is an option of files"),
        ({"output": "x.svg"}, "--output: is an option of files"),
        ({"smooth": True}, "--smooth: is an option of files"),
        ({"view": "front"}, "--view: is an option of cameras"),
        ({"views": "front,top"}, "--views: is an option of cameras"),
        ({"outline": True}, "--outline: its rings are no chains; call outline"),
    ]
    for options, says in cases:
        for call in (silhouettes.visible_lines, silhouettes.LineFinder):
            with pytest.raises(silhouettes.Error, match=says):
                call(mesh, **options)
    finder = silhouettes.LineFinder(mesh, weld=True, section=(0, 0, 0, 1, 0, 0))
    assert "section" in {chain["kind"] for chain in finder.find(silhouettes.look_at((5, 2, 1)))}
    assert finder.last_ms > 0
