#!/usr/bin/env python3
"""Compares `silhouettes extract` with silhouettes in exact rational arithmetic, edge for edge.

Shares no code with the workspace: reads OBJ and OFF itself, rounds coordinates to 32-bit floats as every loader must,
decides facing with Python's fractions, and random eyes come from a seeded generator. Exit code 1 on any difference.

    compare_edges.py SILHOUETTES MESH... [--views N] [--seed N] [--method NAME]
"""

import argparse
import json
import random
import struct
import subprocess
import sys
from fractions import Fraction


def to_f32(text):
    return struct.unpack("f", struct.pack("f", float(text)))[0]


def read_obj(lines):
    points, faces = [], []
    for line in lines:
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            points.append(tuple(to_f32(word) for word in words[1:4]))
        elif words[:1] == ["f"]:
            corners = [int(word.split("/")[0]) for word in words[1:]]
            corners = [c - 1 if c > 0 else len(points) + c for c in corners]
            faces += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
    return points, faces


def read_off(lines):
    words = iter(" ".join(line.split("#")[0] for line in lines).split())
    assert next(words) == "OFF"
    vertex_count, face_count, _ = (int(next(words)) for _ in range(3))
    points = [tuple(to_f32(next(words)) for _ in range(3)) for _ in range(vertex_count)]
    faces = []
    for _ in range(face_count):
        corners = [int(next(words)) for _ in range(int(next(words)))]
        faces += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
    return points, faces


def is_front(p, q, r, eye):
    """Exact sign of ((q - p) x (r - p)) . (eye - p) > 0; floats are tried first, with a bound far above their error."""
    a, b, c = ([x - y for x, y in zip(v, p)] for v in (q, r, eye))
    products = [
        c[0] * a[1] * b[2], -c[0] * a[2] * b[1],
        c[1] * a[2] * b[0], -c[1] * a[0] * b[2],
        c[2] * a[0] * b[1], -c[2] * a[1] * b[0],
    ]
    value, size = sum(products), sum(abs(x) for x in products)
    if abs(value) > 1e-12 * size and size > 1e-200:
        return value > 0, False
    p, q, r, eye = ([Fraction(x) for x in v] for v in (p, q, r, eye))
    a, b, c = ([x - y for x, y in zip(v, p)] for v in (q, r, eye))
    exact = (
        c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) + c[2] * (a[0] * b[1] - a[1] * b[0])
    )
    return exact > 0, True


def silhouette(points, faces, eye):
    sides, exact_count = {}, 0
    for face in faces:
        front, exact = is_front(*(points[v] for v in face), eye)
        exact_count += exact
        for a, b in zip(face, face[1:] + face[:1]):
            sides.setdefault((min(a, b), max(a, b)), []).append(front)
    edges = sorted(e for e, s in sides.items() if (s[0] if len(s) == 1 else any(s) and not all(s)))
    boundary = sorted(e for e, s in sides.items() if s == [True])
    return edges, boundary, exact_count


def eyes(points, faces, count, generator):
    """Random eyes around the mesh, inside its box, and in the plane of one of its faces."""
    low = [min(p[i] for p in points) for i in range(3)]
    high = [max(p[i] for p in points) for i in range(3)]
    for index in range(count):
        if index % 4 == 3:
            p, q, r = (points[v] for v in generator.choice(faces))
            s, t = generator.choice([(0, 0), (1, 0), (2, 0), (2, 2), (-1, 1)])
            yield tuple(to_f32(a + s * (b - a) + t * (c - a)) for a, b, c in zip(p, q, r))
        else:
            reach = [0.5, 2.0, 8.0][index % 3]
            middle = [(a + b) / 2 for a, b in zip(low, high)]
            size = max(b - a for a, b in zip(low, high))
            yield tuple(to_f32(m + size * generator.uniform(-reach, reach)) for m in middle)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("silhouettes")
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--views", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--method", default="brute-force")
    arguments = parser.parse_args()
    generator, different = random.Random(arguments.seed), 0
    for mesh in arguments.meshes:
        with open(mesh, encoding="ascii", errors="replace") as file:
            points, faces = (read_off if mesh.endswith(".off") else read_obj)(file.readlines())
        total = boundary_total = exact_total = wrong = 0
        for eye in eyes(points, faces, arguments.views, generator):
            text = ",".join(repr(x) for x in eye)
            command = [arguments.silhouettes, "extract", mesh, "--method", arguments.method, f"--eye={text}"]
            found = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
            edges, boundary, exact_count = silhouette(points, faces, eye)
            difference = set(edges) ^ {tuple(e) for e in found["edges"]}
            difference |= set(boundary) ^ {tuple(e) for e in found["boundary"]}
            ordered = [list(e) for e in edges] == found["edges"]
            in_loops = sum(len(loop) for loop in found["loops"])
            wrong += len(difference) + (not ordered) + (in_loops < len(edges))
            total, boundary_total, exact_total = total + len(edges), boundary_total + len(boundary), exact_total + exact_count
        different += wrong
        name = mesh.rsplit("/", 1)[-1]
        print(f"{name}: {arguments.views} views, {total} edges ({boundary_total} boundary), "
              f"{exact_total} faces needed rational arithmetic, {wrong} differences", flush=True)
    sys.exit(different > 0)


if __name__ == "__main__":
    main()
