#!/usr/bin/env python3
"""Silhouette edges by numpy, the straightforward vectorised way, in float32 and in float64, on one core.

Prepared once: a plane a face (computed in float64, kept in the method's type), an edge table with the two faces of each
edge. Per view: planes times eye (one matrix-vector product), sign, exclusive or over the edge table, flatnonzero. A
boundary edge is tested against a face that is never front, so the rules are those of this workspace; a non-manifold edge
is one row for each of its faces beyond the first. Not exact: faces that are nearly edge-on may get the wrong sign, in
float64 far fewer than in float32.

The two types are two methods, measured in turn within each view.

Usage:
    pip install numpy
    python3 numpy_silhouette.py MESH... [--views 200] [--output rows.jsonl]
"""

from functools import partial

from extraction_rows import edge_table, np, run


def prepare(positions, triangles, scalar):
    corners = positions.astype(np.float64)[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    offsets = -(normals * corners[:, 0]).sum(axis=1)
    planes = np.column_stack([normals, offsets]).astype(scalar)

    edges, edge_of_half_edge = edge_table(triangles)
    order = np.argsort(edge_of_half_edge, kind="stable")
    edge, face = edge_of_half_edge.ravel()[order], order // 3
    first_of_edge = np.searchsorted(edge, np.arange(len(edges)))
    degree = np.diff(np.append(first_of_edge, len(edge)))
    later = np.ones(len(edge), dtype=bool)
    later[first_of_edge] = False
    none = len(triangles)
    boundary = np.flatnonzero(degree == 1)
    pair_edge = np.concatenate([edge[later], boundary]).astype(np.int32)
    one = np.concatenate([face[first_of_edge[edge[later]]], face[first_of_edge[boundary]]]).astype(np.int32)
    other = np.concatenate([face[later], np.full(len(boundary), none)]).astype(np.int32)
    by_edge = np.argsort(pair_edge, kind="stable")
    pair_edge, one, other = pair_edge[by_edge], one[by_edge], other[by_edge]
    is_manifold = bool((degree <= 2).all())
    front = np.zeros(none + 1, dtype=bool)  # the last is the face that is never front

    def extract(eye):
        np.greater(planes @ np.append(eye, 1.0).astype(scalar), 0.0, out=front[:none])
        found = np.flatnonzero(front[one] ^ front[other])
        if not is_manifold:
            found = np.unique(pair_edge[found])
        return len(found)

    return extract, planes.nbytes + pair_edge.nbytes + one.nbytes + other.nbytes + front.nbytes


if __name__ == "__main__":
    scalars = {"planes-xor-float32": np.float32, "planes-xor-float64": np.float64}
    run("numpy", {method: partial(prepare, scalar=scalar) for method, scalar in scalars.items()})
