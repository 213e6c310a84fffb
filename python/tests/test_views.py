"""Visible lines, outlines and smoothed views, against shapes of which they are known."""

import numpy as np
import silhouettes


def test_a_cube_from_the_front_is_a_square() -> None:
    mesh = silhouettes.load("builtin:cube")
    camera = silhouettes.Camera(view="front", ortho="fit", size=(400, 400))
    ((ring,),) = silhouettes.outline(mesh, camera)
    x, y = ring.T
    area = 0.5 * np.sum(np.roll(x, -1) * y - x * np.roll(y, -1))
    side = np.ptp(x)
    np.testing.assert_allclose([np.ptp(y), area], [side, side * side], rtol=1e-6)
    assert side > 200


def test_lines_lie_on_the_edges_that_they_name() -> None:
    mesh = silhouettes.load("builtin:knot")
    camera = silhouettes.look_at((4, 3, 5), size=(500, 500))
    chains = silhouettes.visible_lines(mesh, camera, hidden="solid")
    assert {chain["invisibility"] > 0 for chain in chains} == {False, True}
    silhouette = {tuple(edge) for edge in silhouettes.edges(mesh, camera).tolist()}
    drawn = set()
    for chain in chains:
        following = np.roll(chain["points"], -1, axis=0)[: len(chain["edges"])]
        starts = chain["points"][: len(chain["edges"])]
        drawn |= {tuple(edge) for edge in chain["edges"].tolist()}
        ends = mesh.vertices[chain["edges"]].astype(float)
        for point in (starts, following):
            along = ends[:, 1] - ends[:, 0]
            off = np.linalg.norm(np.cross(along, point - ends[:, 0]), axis=1) / np.linalg.norm(along, axis=1)
            assert off.max() < 1e-6
    # A silhouette edge that is seen end on has no line.
    assert len(silhouette - drawn) <= 0.01 * len(silhouette)
    visible = silhouettes.visible_lines(mesh, camera)
    assert {chain["invisibility"] for chain in visible} == {0}


def test_a_finder_of_many_views_finds_what_one_view_has() -> None:
    mesh = silhouettes.load("builtin:knot")
    finder = silhouettes.LineFinder(mesh, creases=10)
    for eye in ((4.0, 3, 5), (-5.0, 1, 2)):
        camera = silhouettes.look_at(eye)
        expected = silhouettes.visible_lines(mesh, camera, creases=10)
        found = finder.find(camera)
        assert len(found) == len(expected) > 5
        for one, other in zip(found, expected, strict=True):
            assert one["kind"] == other["kind"]
            np.testing.assert_array_equal(one["points"], other["points"])
            np.testing.assert_array_equal(one["edges"], other["edges"])


def test_creases_are_wanted_or_not() -> None:
    mesh = silhouettes.load("builtin:cube")
    kinds = {chain["kind"] for chain in silhouettes.visible_lines(mesh, creases=30)}
    assert kinds == {"silhouette", "ridge"}
    assert {chain["kind"] for chain in silhouettes.visible_lines(mesh)} == {"silhouette"}


def test_a_smoothed_sphere_is_rounder() -> None:
    mesh = silhouettes.load("builtin:icosphere:1")
    smoothed = silhouettes.smooth(mesh, silhouettes.look_at((0, 0, 5)))
    vertices, normals, faces = smoothed["vertices"], smoothed["normals"], smoothed["faces"]
    assert len(vertices) == len(normals) and len(faces) > len(mesh.faces)
    assert faces.max() < len(vertices)
    middles = vertices[faces].mean(axis=1)
    rough = mesh.vertices[mesh.faces].mean(axis=1)
    assert np.linalg.norm(middles, axis=1).mean() > np.linalg.norm(rough, axis=1).mean()
    lengths = np.linalg.norm(normals, axis=1)
    np.testing.assert_allclose(lengths[lengths > 0], 1, atol=1e-5)
