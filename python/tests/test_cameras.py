"""Cameras: where points appear, against 4 x 4 matrices multiplied by numpy."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import silhouettes

Matrix = npt.NDArray[np.float64]
SIZE = (320, 200)


def view_matrix(eye: Any, target: Any, up: Any) -> Matrix:
    back = np.subtract(eye, target) / np.linalg.norm(np.subtract(eye, target))
    right = np.cross(up, back) / np.linalg.norm(np.cross(up, back))
    matrix = np.eye(4)
    matrix[:3, :3] = [right, np.cross(back, right), back]
    matrix[:3, 3] = -matrix[:3, :3] @ np.asarray(eye, float)
    return matrix


def perspective(fov_deg: float) -> Matrix:
    scale = 1 / np.tan(np.radians(fov_deg) / 2)
    return np.array(
        [[scale * SIZE[1] / SIZE[0], 0, 0, 0], [0, scale, 0, 0], [0, 0, -1.002, -0.2], [0, 0, -1, 0]], dtype=float
    )


def orthographic(height: float) -> Matrix:
    return np.diag([2 / height * SIZE[1] / SIZE[0], 2 / height, -0.01, 1])


EYE, TARGET, UP = (4.0, 2.0, 3.0), (0.1, -0.2, 0.0), (0.1, 1.0, 0.0)
VIEW = view_matrix(EYE, TARGET, UP)


def check(camera: Any, projection: Matrix) -> None:
    """The camera sees points where the matrices have them."""
    chains = silhouettes.visible_lines(silhouettes.load("builtin:knot"), camera)
    assert len(chains) > 3
    for chain in chains:
        points = np.column_stack([chain["points"], np.ones(len(chain["points"]))])
        clip = points @ (projection @ VIEW).T
        ndc = clip[:, :2] / clip[:, 3:]
        expected = (ndc * [1, -1] + 1) / 2 * SIZE
        np.testing.assert_allclose(chain["pixels"], expected, rtol=0, atol=2e-3)


def test_look_at() -> None:
    check(silhouettes.look_at(EYE, TARGET, UP, fov=35, size=SIZE), perspective(35))
    check(silhouettes.look_at(EYE, TARGET, UP, ortho=5, size=SIZE), orthographic(5))
    with pytest.raises(AssertionError):
        check(silhouettes.look_at(EYE, TARGET, UP, fov=36, size=SIZE), perspective(35))


def test_matrices() -> None:
    check(silhouettes.from_matrices(VIEW, perspective(35), SIZE), perspective(35))
    check(silhouettes.from_matrices(VIEW, 7 * perspective(35), SIZE), perspective(35))
    check(silhouettes.from_matrices(VIEW, orthographic(5), SIZE), orthographic(5))


def broken(matrix: Matrix, row: int, column: int, value: float) -> Matrix:
    matrix = matrix.copy()
    matrix[row, column] = value
    return matrix


@pytest.mark.parametrize(
    ("view", "projection", "says"),
    [
        (2 * VIEW, perspective(35), "view: not a rotation"),
        (np.diag([-1.0, 1, 1, 1]), perspective(35), "view: not a rotation"),
        (VIEW[:3], perspective(35), "view: a 4 x 4 matrix"),
        (VIEW, broken(perspective(35), 0, 0, np.nan), "projection: a 4 x 4 matrix of finite"),
        (VIEW, "projection", "projection: a 4 x 4 matrix"),
        (VIEW, broken(perspective(35), 0, 2, 0.1), "not symmetric"),
        (VIEW, broken(perspective(35), 0, 0, 1.0), "does not fit a picture of 320x200"),
        (VIEW, perspective(35) @ np.diag([1.0, -1, 1, 1]), "mirrors it"),
        (VIEW, broken(orthographic(5), 3, 2, 0.5), "its last row"),
    ],
)
def test_matrices_that_are_no_camera_are_refused(view: Any, projection: Any, says: str) -> None:
    with pytest.raises(silhouettes.Error, match=says):
        silhouettes.from_matrices(view, projection, SIZE)


def vtk_camera(parallel: bool) -> SimpleNamespace:
    return SimpleNamespace(
        GetViewAngle=lambda: 35.0,
        GetParallelProjection=lambda: parallel,
        GetParallelScale=lambda: 2.5,
        GetUseHorizontalViewAngle=lambda: False,
        GetPosition=lambda: EYE,
        GetFocalPoint=lambda: TARGET,
        GetViewUp=lambda: UP,
    )


def test_objects_with_the_interface_of_pyvista_and_trimesh_are_cameras() -> None:
    for parallel, projection in ((False, perspective(35)), (True, orthographic(5))):
        plotter = SimpleNamespace(camera=vtk_camera(parallel), window_size=list(SIZE))
        check(plotter, projection)
        check(silhouettes.camera(vtk_camera(parallel), SIZE), projection)
    lens = SimpleNamespace(fov=np.array([50.0, 35.0]), resolution=np.array(SIZE))
    check(SimpleNamespace(camera_transform=np.linalg.inv(VIEW), camera=lens), perspective(35))


def test_a_real_scene_of_trimesh_is_a_camera() -> None:
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    scene.camera.resolution = SIZE
    scene.camera.fov = (50.0, 35.0)
    scene.camera_transform = np.linalg.inv(VIEW)
    check(scene, perspective(35))


def test_a_real_camera_and_a_real_plotter_of_pyvista_are_cameras(pyvista: Any) -> None:
    camera = pyvista.Camera()
    camera.position, camera.focal_point, camera.up, camera.view_angle = EYE, TARGET, UP, 35.0
    check(silhouettes.camera(camera, SIZE), perspective(35))
    camera.parallel_projection, camera.parallel_scale = True, 2.5
    check(silhouettes.camera(camera, SIZE), orthographic(5))
    # It is not shown, so that nothing is drawn.
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    plotter.camera.position, plotter.camera.focal_point = EYE, TARGET
    plotter.camera.up, plotter.camera.view_angle = UP, 35.0
    check(plotter, perspective(35))


def test_what_is_no_camera_is_refused() -> None:
    mesh = silhouettes.load("builtin:cube")
    for wrong in (3, "front", object(), [1, 2, 3]):
        with pytest.raises(silhouettes.Error, match="no camera can be made of"):
            silhouettes.edges(mesh, wrong)
    for words, says in [
        ({"view": "sideways"}, "--view.*three-quarter"),
        ({"fov": 200}, "--fov"),
        ({"fov": 30, "ortho": 2}, "--fov"),
        ({"ortho": "fill"}, "--ortho"),
        ({"up_axis": "x"}, "--up-axis"),
        ({"eye": (np.inf, 0, 0)}, "--eye"),
    ]:
        with pytest.raises(silhouettes.Error, match=says):
            silhouettes.Camera(**words)  # type: ignore[arg-type]
    with pytest.raises(silhouettes.Error, match="three numbers"):
        silhouettes.look_at((1, 2))
    with pytest.raises(silhouettes.Error, match="viewport must be"):
        silhouettes.visible_lines(mesh, silhouettes.Camera(size=(0, 5)))
    with pytest.raises(silhouettes.Error, match="same point"):
        silhouettes.visible_lines(mesh, silhouettes.look_at((1, 2, 3), (1, 2, 3)))
