"""Arrays in: what is taken, what is refused and how."""

import gc
from typing import Any

import numpy as np
import pytest
import silhouettes

TRIANGLE = [[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]


def test_a_mesh_of_arrays_is_the_mesh() -> None:
    loaded = silhouettes.load("builtin:knot")
    vertices, faces = loaded.vertices, loaded.faces
    assert vertices.dtype == np.float32 and faces.dtype == np.uint32
    for given in (vertices, vertices.astype(np.float64), np.asfortranarray(vertices), vertices[::1], vertices.tolist()):
        for corners in (faces, faces.astype(np.int64), faces.astype(np.int32), np.asfortranarray(faces), faces.tolist()):
            mesh = silhouettes.Mesh(given, corners)
            np.testing.assert_array_equal(mesh.vertices, vertices)
            np.testing.assert_array_equal(mesh.faces, faces)


def test_a_mesh_does_not_change_with_the_arrays_that_it_was_made_of() -> None:
    vertices, faces = np.array(TRIANGLE, np.float32), np.array([[0, 1, 2]], np.uint32)
    mesh = silhouettes.Mesh(vertices, faces)
    vertices[:] = 7
    faces[:] = 0
    np.testing.assert_array_equal(mesh.vertices, np.array(TRIANGLE, np.float32))
    np.testing.assert_array_equal(mesh.faces, [[0, 1, 2]])


def test_arrays_of_a_mesh_are_its_memory_and_outlive_it() -> None:
    mesh = silhouettes.load("builtin:knot")
    vertices, faces = mesh.vertices, mesh.faces
    assert np.shares_memory(vertices, mesh.vertices) and np.shares_memory(faces, mesh.faces)
    assert not np.shares_memory(vertices, vertices.copy())
    # What an array shows may not change under a method that runs meanwhile.
    for array in (vertices, faces):
        with pytest.raises(ValueError, match="read-only"):
            array[:] = 8
        with pytest.raises(ValueError, match="WRITEABLE"):
            array.setflags(write=True)
    before = vertices.copy(), faces.copy()
    del mesh
    gc.collect()
    # Takes the memory if it were free again.
    other = [silhouettes.load("builtin:torus") for _ in range(20)]
    np.testing.assert_array_equal(vertices, before[0])
    np.testing.assert_array_equal(faces, before[1])
    assert len(other) == 20


def test_vertices_far_from_zero_count_from_close_by() -> None:
    offset = np.array([4.5e6, 5.3e6, 0.0])
    far = silhouettes.Mesh(np.array(TRIANGLE) * 0.1 + offset, [[0, 1, 2]])
    np.testing.assert_allclose(far.origin + far.vertices, np.array(TRIANGLE) * 0.1 + offset, rtol=0, atol=1e-7)
    assert np.any(far.origin != 0)
    eye = offset + [0.02, 0.03, 1.0]
    assert len(silhouettes.edges(far, silhouettes.look_at(eye))) == 3


@pytest.mark.parametrize(
    ("vertices", "faces", "says"),
    [
        (np.zeros((3, 2), np.float32), [[0, 1, 2]], r"vertices: an array of shape \(3, 2\)"),
        (np.zeros(9, np.float32), [[0, 1, 2]], r"vertices: an array of shape \(9\)"),
        (np.zeros((3, 3), np.complex128), [[0, 1, 2]], "vertices: an array of complex128"),
        (np.array([["a", "b", "c"]]), [[0, 0, 0]], "vertices: an array of <U1"),
        (object(), [[0, 1, 2]], "vertices: an array of shape"),
        ([[1, 2, 3], [4]], [[0, 1, 2]], "vertices: not an array"),
        ([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], [[0, 1, 2]], "vertex 2 has a coordinate that is not a finite"),
        (np.array([[0, 0, 0], [1, 0, 0], [0, np.inf, 0]], np.float32), [[0, 1, 2]], "vertex 2"),
        ([[0, 0, 0], [1, 0, 0], [0, 1e300, 0]], [[0, 1, 2]], "vertex 2"),
        (TRIANGLE, [[0, 1, 3]], "face 0 names vertex 3, but there are only 3"),
        (TRIANGLE, [[0, 1, 2], [0, -1, 2]], "face 1 names vertex -1"),
        (TRIANGLE, [[0, 1, 2**40]], "face 0 names vertex"),
        (TRIANGLE, [[0.0, 1.0, 2.0]], "faces: an array of float64"),
        (TRIANGLE, [[0, 1, 2, 0]], r"faces: an array of shape \(1, 4\)"),
        (TRIANGLE, np.zeros((1, 3), np.uint64), "faces: an array of uint64"),
        (TRIANGLE, [[True, False, True]], "faces: an array of bool"),
    ],
)
def test_bad_arrays_raise_one_error_that_says_where(vertices: Any, faces: Any, says: str) -> None:
    with pytest.raises(silhouettes.Error, match=says) as raised:
        silhouettes.Mesh(vertices, faces)
    assert "\n" not in str(raised.value)
    assert isinstance(raised.value, ValueError)


def test_random_arrays_are_meshes_or_refused() -> None:
    random = np.random.default_rng(7)
    dtypes: list[Any] = [np.float16, np.float32, np.float64, np.int8, np.int32, np.int64, np.uint8, np.uint32, np.uint64]
    dtypes += [np.bool_, np.complex64, ">f4", ">i8", object]
    made = refused = 0
    for _ in range(2000):
        count = int(random.integers(0, 12))
        shape = (count, 3) if random.random() < 0.9 else tuple(random.integers(0, 5, random.integers(0, 4)))
        vertices: Any = (random.normal(size=shape) * 10.0 ** random.integers(-3, 4)).astype(random.choice(dtypes[:3]))
        if random.random() < 0.2:
            vertices = (random.normal(size=shape) * 100).astype(dtypes[random.integers(len(dtypes))])
        if random.random() < 0.05 and vertices.dtype.kind == "f" and vertices.size:
            vertices.flat[random.integers(vertices.size)] = random.choice([np.nan, np.inf])
        faces: Any = random.integers(-1 if random.random() < 0.1 else 0, max(count, 1), (int(random.integers(0, 20)), 3))
        faces = faces.astype(dtypes[random.integers(3, 8)]) if random.random() < 0.7 else faces
        if random.random() < 0.3:
            vertices, faces = vertices[::-1] if vertices.ndim else vertices, np.asfortranarray(faces)
        try:
            mesh = silhouettes.Mesh(vertices, faces)
        except silhouettes.Error:
            refused += 1
            continue
        made += 1
        assert mesh.inspect()["faces"] == len(faces)
        if len(faces):
            assert silhouettes.edges(mesh, silhouettes.look_at((1e3, 2e3, 3e3))).shape[1] == 2
    assert made > 200 and refused > 100


def test_an_empty_mesh_is_a_mesh_that_no_camera_sees() -> None:
    mesh = silhouettes.Mesh([], [])
    assert (mesh.vertices.shape, mesh.faces.shape) == ((0, 3), (0, 3))
    assert mesh.inspect()["faces"] == 0
    for call in (silhouettes.edges, silhouettes.visible_lines, silhouettes.outline, silhouettes.render, silhouettes.smooth):
        with pytest.raises(silhouettes.Error, match="mesh: has no face"):
            call(mesh)


def test_files_that_are_none_are_refused_in_the_command_lines_words(tmp_path: Any) -> None:
    broken = tmp_path / "broken.obj"
    broken.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    for path, says in [
        (broken, "broken.obj, line 4"),
        (tmp_path / "missing.obj", "missing.obj"),
        (tmp_path, "is a directory|name a file"),
        ("builtin:nothing", "builtin:nothing"),
        ("-", "standard input"),
    ]:
        with pytest.raises(silhouettes.Error, match=says):
            silhouettes.load(path)
    with pytest.raises(silhouettes.Error, match="missing.siltex"):
        silhouettes.Texture.load(tmp_path / "missing.siltex")


def test_files_are_named_not_given(tmp_path: Any) -> None:
    path = tmp_path / "cube.off"
    path.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    file: Any
    with path.open() as file:
        with pytest.raises(TypeError, match="PathLike"):
            silhouettes.load(file)
    for load in (silhouettes.load, silhouettes.Texture.load):
        with pytest.raises(TypeError, match="PathLike"):
            load(file)
    assert len(silhouettes.load(path).faces) == 1


def test_unknown_methods_and_options_are_refused_with_the_known_ones() -> None:
    mesh = silhouettes.load("builtin:cube")
    with pytest.raises(silhouettes.Error, match="no method 'brute-farce'; there are brute-force"):
        silhouettes.edges(mesh, method="brute-farce")
    with pytest.raises(silhouettes.Error, match="extracts no edges; choose brute-force"):
        silhouettes.edges(mesh, method="jump-flood")
    with pytest.raises(silhouettes.Error, match="no option 'levels'"):
        silhouettes.Tracker(mesh, levels=1)
    with pytest.raises(silhouettes.Error, match="concavity=400 does not fit"):
        silhouettes.Tracker(mesh, concavity=400)
    with pytest.raises(silhouettes.Error, match="--creases"):
        silhouettes.visible_lines(mesh, creases=1000)
    with pytest.raises(silhouettes.Error, match="there is no paper 'x'"):
        silhouettes.reproduce("x")
    with pytest.raises(silhouettes.Error, match="--goal"):
        silhouettes.recommend(mesh, goal="speed")
    with pytest.raises(TypeError):
        silhouettes.edges(None)  # type: ignore[arg-type]
