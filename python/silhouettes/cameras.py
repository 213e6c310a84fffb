"""Cameras from eyes, matrices, and objects of trimesh and PyVista, of which neither need be installed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ._silhouettes import Camera, Error

# How far entries of a matrix may be from what a rotation or a projection has there, relative to its scale.
_TOLERANCE = 1e-4

_Point = Sequence[float] | npt.NDArray[Any]


def look_at(
    eye: _Point,
    target: _Point | None = None,
    up: _Point | None = None,
    *,
    fov: float | None = None,
    ortho: float | str | None = None,
    size: tuple[int, int] = (1024, 1024),
) -> Camera:
    """A camera at ``eye`` that looks at ``target``.

    eye, target, up: three numbers each, in the coordinates of the mesh's file. Without a target the camera looks at the middle of
        the mesh; without an up, y is up.
    fov: vertical field of view in degrees, 40 by default. ortho: for an orthographic view, its height in units of the mesh.
    size: width and height of the picture in pixels.
    """
    return Camera(
        eye=_point("eye", eye),
        target=None if target is None else _point("target", target),
        up=None if up is None else _point("up", up),
        fov=fov,
        ortho=ortho,
        size=size,
    )


def from_matrices(view: npt.ArrayLike, projection: npt.ArrayLike, size: tuple[int, int]) -> Camera:
    """A camera from 4 x 4 matrices that multiply columns, as OpenGL and most renderers have them.

    view: from the coordinates of the mesh's file to those of the eye, which looks along -z with y up: a rotation and a translation.
    projection: from there to clip space, symmetric about the axis. Its near and far planes play no part.
    size: width and height of the picture in pixels, of the projection's aspect.
    """
    v, p = _matrix("view", view), _matrix("projection", projection)
    rotation = v[:3, :3]
    is_rigid = np.allclose(rotation @ rotation.T, np.eye(3), atol=_TOLERANCE) and np.linalg.det(rotation) > 0
    if not (is_rigid and np.allclose(v[3], [0, 0, 0, 1], atol=_TOLERANCE)):
        raise Error("view: not a rotation and a translation; put scaling and projecting into projection")
    width, height = size
    scale = p[1, 1]
    if not (scale > 0 and abs(p[0, 0] * width - scale * height) <= _TOLERANCE * scale * height):
        raise Error(f"projection: does not fit a picture of {width}x{height} pixels, or mirrors it")
    off_axis = [p[0, 1], p[1, 0], p[0, 2], p[1, 2], p[0, 3], p[1, 3]]
    if np.max(np.abs(off_axis)) > _TOLERANCE * scale:
        raise Error("projection: not symmetric about the axis; such cameras are not supported")
    eye = -rotation.T @ v[:3, 3]
    bottom = p[3] / max(np.max(np.abs(p[3])), np.finfo(float).tiny)
    if np.allclose(bottom, [0, 0, -1, 0], atol=_TOLERANCE):
        lens: dict[str, Any] = {"fov": float(np.degrees(2 * np.arctan(abs(p[3, 2]) / scale)))}
    elif np.allclose(bottom, [0, 0, 0, 1], atol=_TOLERANCE):
        lens = {"ortho": float(2 * p[3, 3] / scale)}
    else:
        raise Error("projection: its last row is neither (0, 0, -1, 0) nor (0, 0, 0, 1)")
    return _along(eye, -rotation[2], rotation[1], size, **lens)


def camera(source: Any, size: tuple[int, int] | None = None) -> Camera:
    """The camera of an object of another package, by what it has rather than by its type.

    source: a trimesh scene; a PyVista plotter or camera; a Camera, which is returned as it is.
    size: width and height of the picture in pixels. Without it that of the scene or plotter, or 1024 x 1024.
    """
    if isinstance(source, Camera):
        return source
    if hasattr(source, "camera_transform") and hasattr(source, "camera"):
        return _of_trimesh(source, size)
    if hasattr(source, "camera") and hasattr(source.camera, "GetViewAngle"):
        window = getattr(source, "window_size", None)
        return _of_pyvista(source.camera, size or (tuple(window) if window is not None else None))
    if hasattr(source, "GetViewAngle"):
        return _of_pyvista(source, size)
    kind = type(source).__name__
    raise Error(f"camera: no camera can be made of {kind}; give a Camera, a trimesh scene, or a PyVista plotter or camera")


def _of_trimesh(scene: Any, size: tuple[int, int] | None) -> Camera:
    """A scene's transform takes the camera's coordinates to the world's; its camera looks along -z."""
    pose = _matrix("camera_transform", scene.camera_transform)
    width, height = size or tuple(int(side) for side in scene.camera.resolution)
    fov = float(scene.camera.fov[1])
    return _along(pose[:3, 3], -pose[:3, 2], pose[:3, 1], (width, height), fov=fov)


def _of_pyvista(source: Any, size: tuple[int, int] | None) -> Camera:
    """A VTK camera has a focal point, and a scale, half a height, where it is orthographic."""
    if source.GetParallelProjection():
        lens: dict[str, Any] = {"ortho": 2.0 * float(source.GetParallelScale())}
    else:
        if source.GetUseHorizontalViewAngle():
            raise Error("camera: its view angle is horizontal; switch UseHorizontalViewAngle off")
        lens = {"fov": float(source.GetViewAngle())}
    width, height = size or (1024, 1024)
    return Camera(
        eye=_point("position", source.GetPosition()),
        target=_point("focal point", source.GetFocalPoint()),
        up=_point("up", source.GetViewUp()),
        size=(int(width), int(height)),
        **lens,
    )


def _along(eye: Any, forward: Any, up: Any, size: tuple[int, int], **lens: Any) -> Camera:
    """A camera that looks along a direction: the target lies about as far from the eye as the eye from zero."""
    reach = max(float(np.linalg.norm(eye)), 1.0)
    target = np.asarray(eye) + np.asarray(forward) * reach
    return Camera(eye=_point("eye", eye), target=_point("target", target), up=_point("up", up), size=size, **lens)


def _point(name: str, given: Any) -> tuple[float, float, float]:
    try:
        x, y, z = (float(number) for number in np.asarray(given, dtype=float).ravel())
    except (TypeError, ValueError):
        raise Error(f"{name}: three numbers are wanted") from None
    return x, y, z


def _matrix(name: str, given: Any) -> npt.NDArray[np.float64]:
    try:
        matrix = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise Error(f"{name}: a 4 x 4 matrix of numbers is wanted") from None
    if matrix.shape != (4, 4) or not np.all(np.isfinite(matrix)):
        raise Error(f"{name}: a 4 x 4 matrix of finite numbers is wanted")
    return matrix
