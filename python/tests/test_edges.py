"""Silhouette edges against a few lines of numpy, which know nothing of the package."""

import numpy as np
import pytest
import silhouettes


def silhouette_of(mesh, eye):
    """The edges between a face that the eye is in front of and one that it is not, as sorted pairs."""
    corners = mesh.vertices.astype(np.float64)[mesh.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    is_front = np.einsum("ij,ij->i", normals, np.asarray(eye) - corners[:, 0]) > 0
    sides = np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, of_side = np.unique(sides, axis=0, return_inverse=True)
    fronts = np.bincount(of_side.ravel(), weights=np.repeat(is_front, 3))
    return edges[fronts == 1]


EYES = [(3.1, 0.7, 1.3), (-2.0, 5.0, 0.5), (0.3, -4.0, 6.0)]


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("shape", ["knot", "gear", "icosphere:3"])
def test_edges_are_those_between_front_and_back(shape, eye):
    mesh = silhouettes.load(f"builtin:{shape}")
    found = silhouettes.edges(mesh, silhouettes.look_at(eye))
    assert found.dtype == np.uint32
    expected = silhouette_of(mesh, eye)
    np.testing.assert_array_equal(found, expected)
    assert len(expected) > 10
    # Another eye sees others: the comparison can fail.
    assert not np.array_equal(found, silhouette_of(mesh, -np.asarray(eye)))


def test_a_mesh_of_arrays_is_the_mesh():
    loaded = silhouettes.load("builtin:knot")
    made = silhouettes.Mesh(loaded.vertices, loaded.faces)
    wide = silhouettes.Mesh(loaded.vertices.astype(np.float64), loaded.faces.astype(np.int64))
    for mesh in (made, wide):
        np.testing.assert_array_equal(mesh.vertices, loaded.vertices)
        np.testing.assert_array_equal(silhouettes.edges(mesh), silhouettes.edges(loaded))
