"""What the scripts for Blender share: camera, scene, timing, drawing, rows.

The camera is that of `silhouettes`: by default the three-quarter view of `Camera::framing`, or the numbers given, which
both programs then take alike. With --cameras nothing is timed: each view of a document by `silhouettes score --cameras` is
drawn, and its lines are written for `silhouettes score --lines`. The mesh keeps the coordinates of its file. Needs the `bpy`
package, Blender as a module.
"""

import argparse
import json
import math
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from extraction_rows import describe_machine, load, np

import bpy
from mathutils import Matrix

# Constants of `crates/core/src/view/camera.rs`, `crates/core/src/view/preset.rs` and `crates/cli/src/camera.rs`.
FRAMING_MARGIN = 0.05
THREE_QUARTER = (0.55, 0.35, 1.0)
MIN_NEAR_TO_FAR = 1e-5
DEFAULT_FOV_DEG = 40.0
DEFAULT_SIZE = (1024, 1024)


@dataclass
class Camera:
    """A camera: `eye`, `target` and `up` in the mesh's coordinates, rounded to float32, held in float64. A perspective, or
    where a `height` in units is given, a parallel projection."""

    eye: np.ndarray
    target: np.ndarray
    up: np.ndarray
    fov_deg: float
    size: tuple
    height: float = None

    @classmethod
    def of_view(cls, view):
        """The camera of a view of `silhouettes score --cameras`."""
        eye, target, up = (as_float32(view[name]) for name in ("eye", "target", "up"))
        return cls(eye, target, up, view.get("fov_y_deg"), tuple(view["size"]), view.get("ortho_height"))

    @classmethod
    def of(cls, arguments, center, radius):
        """The camera of the command line; where it names no eye, one that shows the whole bounding sphere."""
        aspect = arguments.size[0] / arguments.size[1]
        half_y = math.radians(arguments.fov) * 0.5
        half_x = math.atan(math.tan(half_y) * aspect)
        toward = np.array(THREE_QUARTER) / np.linalg.norm(THREE_QUARTER)
        distance = radius * (1.0 + FRAMING_MARGIN) / math.sin(min(half_x, half_y))
        target = as_float32(center if arguments.target is None else arguments.target)
        framed = as_float32(center + toward * distance) + (target - as_float32(center))
        eye = as_float32(framed if arguments.eye is None else arguments.eye)
        return cls(eye, target, as_float32(arguments.up), arguments.fov, arguments.size)

    def axes(self):
        """Right, up and back in the mesh's coordinates, as rows."""
        back = self.eye - self.target
        back /= np.linalg.norm(back)
        right = np.cross(self.up, back)
        right /= np.linalg.norm(right)
        return np.stack([right, np.cross(back, right), back])

    def project(self, points):
        """Pixels of points in front of the eye; y points down."""
        view = (points - self.eye) @ self.axes().T
        if self.height is not None:
            scale = self.size[1] / self.height
            return np.array(self.size) * 0.5 + view[:, :2] * [scale, -scale]
        scale = self.size[1] * 0.5 / math.tan(math.radians(self.fov_deg) * 0.5)
        return np.array(self.size) * 0.5 + view[:, :2] * [scale, -scale] / -view[:, 2:]


def as_float32(vector):
    return np.asarray(vector, dtype=np.float32).astype(np.float64)


def build_scene(positions, triangles, camera, center, radius):
    """Empties Blender and builds a scene of the mesh, seen by the camera; yields the scene and the mesh's object."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    mesh = bpy.data.meshes.new("mesh")
    mesh.vertices.add(len(positions))
    mesh.vertices.foreach_set("co", positions.ravel())
    mesh.loops.add(triangles.size)
    mesh.loops.foreach_set("vertex_index", triangles.astype(np.int32).ravel())
    mesh.polygons.add(len(triangles))
    mesh.polygons.foreach_set("loop_start", np.arange(0, triangles.size, 3, dtype=np.int32))
    mesh.update(calc_edges=True)
    if mesh.validate():
        # Blender holds no face that names a vertex twice, and no face twice.
        print(f"Blender keeps {len(mesh.polygons)} of {len(triangles)} faces", file=sys.stderr)
    mesh_object = bpy.data.objects.new("mesh", mesh)
    scene.collection.objects.link(mesh_object)

    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    if camera.height is not None:
        lens.type, lens.ortho_scale = "ORTHO", camera.height
    else:
        lens.angle_y = math.radians(camera.fov_deg)
    depth = float((camera.eye - center) @ camera.axes()[2])
    lens.clip_end = depth + 1.01 * radius
    lens.clip_start = max(depth - 1.01 * radius, lens.clip_end * MIN_NEAR_TO_FAR)
    placed = bpy.data.objects.new("camera", lens)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = camera.axes().T, camera.eye
    placed.matrix_world = Matrix(matrix.tolist())
    scene.collection.objects.link(placed)
    scene.camera = placed
    scene.render.resolution_x, scene.render.resolution_y = camera.size
    scene.render.resolution_percentage = 100
    return scene, mesh_object


@dataclass
class Cell:
    """One metric on one mesh: `once` does the work and yields its wall and processor time in ms; `strokes` yields the
    lines of one more run, not timed, each an array of pixels (N x 2, y down)."""

    metric: str
    once: callable
    strokes: callable


def stopwatch(work):
    """Wall and processor time of a call, in ms; the latter of all threads together."""
    wall, processor = time.perf_counter(), time.process_time()
    work()
    return (time.perf_counter() - wall) * 1e3, (time.process_time() - processor) * 1e3


def run(tool, prepare, options=None):
    """Measures one tool on the meshes that the command line names and writes the rows, and the SVG where asked.

    `prepare(scene, mesh_object, camera, arguments)` yields the cells, measured in turn after a warm-up of each;
    `options(parser)` adds the tool's own arguments.
    """
    # Blender writes its progress to standard output, where rows may go.
    rows_out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    arguments = parse(tool, options)
    if arguments.cameras:
        draw_views(tool, prepare, arguments)
        return
    rows = []
    for path in arguments.meshes:
        rows += measure(tool, prepare, path, arguments)
    text = "".join(json.dumps(row) + "\n" for row in rows)
    if arguments.output:
        arguments.output.write_text(text, encoding="utf-8")
    else:
        with rows_out:
            rows_out.write(text)


def draw_views(tool, prepare, arguments):
    """Draws each view of a document by `silhouettes score --cameras`, and writes its lines for `silhouettes score --lines`."""
    document = json.loads(arguments.cameras.read_text(encoding="utf-8"))
    name, positions, triangles = load(arguments.meshes[0])
    if (len(positions), len(triangles)) != (document["mesh"]["vertices"], document["mesh"]["triangles"]):
        raise SystemExit(f"{name}: is not the mesh of {arguments.cameras}: vertices or triangles are more or fewer")
    center, radius = sphere_of(positions, triangles)
    for view in document["views"]:
        camera = Camera.of_view(view)
        scene, mesh_object = build_scene(positions, triangles, camera, center, radius)
        visible = prepare(scene, mesh_object, camera, arguments)[0]
        polylines = [np.round(stroke, 4).tolist() for stroke in visible.strokes()]
        lines = {"method": tool, "version": bpy.app.version_string, "size": camera.size, "polylines": polylines}
        path = Path(str(arguments.lines).replace("{frame}", str(view["frame"])))
        path.write_text(json.dumps(lines) + "\n", encoding="utf-8")


def parse(tool, options):
    parser = argparse.ArgumentParser(description=f"Times of {tool} on silhouette and boundary edges.")
    parser.add_argument("meshes", nargs="+", metavar="MESH", type=Path, help=".obj, or .ply by --export of our bench")
    parser.add_argument("--eye", type=vector, metavar="X,Y,Z", help="default: a three-quarter view that shows all")
    parser.add_argument("--target", type=vector, metavar="X,Y,Z", help="default: the middle of the mesh")
    parser.add_argument("--up", type=vector, metavar="X,Y,Z", default=(0.0, 1.0, 0.0), help="default: 0,1,0")
    parser.add_argument("--fov", type=float, metavar="DEG", default=DEFAULT_FOV_DEG, help="vertical (default: 40)")
    parser.add_argument("--size", type=size, metavar="WxH", default=DEFAULT_SIZE, help="pixels (default: 1024x1024)")
    parser.add_argument("--runs", type=int, default=9, help="timed runs after a warm-up (default: 9)")
    parser.add_argument("-o", "--output", type=Path, help="JSON Lines file for the rows (default: standard output)")
    parser.add_argument("--cameras", type=Path, metavar="FILE.json", help="views by silhouettes score --cameras, of one mesh")
    parser.add_argument("--lines", type=Path, metavar="FILE.json", help="of --cameras, with {frame} in its name")
    parser.add_argument("--svg", type=Path, help="SVG file for the visible lines of the one mesh given")
    if options:
        options(parser)
    # A vector that begins with a minus is no option: argparse takes it after '=' alone.
    words = sys.argv[1:]
    for index in reversed(range(len(words) - 1)):
        if words[index] in ("--eye", "--target", "--up"):
            words[index : index + 2] = [f"{words[index]}={words[index + 1]}"]
    arguments = parser.parse_args(words)
    if arguments.runs < 1:
        parser.error("--runs must be at least 1")
    if not 0.0 < arguments.fov < 180.0:
        parser.error("--fov must be above 0 and below 180")
    if bool(arguments.cameras) != bool(arguments.lines and "{frame}" in str(arguments.lines)):
        parser.error("--cameras needs --lines with {frame} in its name, and --lines needs --cameras")
    if arguments.cameras and len(arguments.meshes) > 1:
        parser.error("--cameras is for one mesh")
    if arguments.svg and len(arguments.meshes) > 1:
        parser.error("--svg is for one mesh")
    return arguments


def vector(text):
    numbers = tuple(float(word) for word in text.split(","))
    if len(numbers) != 3 or not all(map(math.isfinite, numbers)):
        raise ValueError
    return numbers


def size(text):
    width, height = (int(word) for word in text.split("x"))
    if width < 1 or height < 1:
        raise ValueError
    return width, height


def sphere_of(positions, triangles):
    """Middle of the box around the vertices that faces have, and the radius of the sphere around it that holds them."""
    used = positions[np.unique(triangles)].astype(np.float64)
    center = (used.min(axis=0) + used.max(axis=0)) * 0.5
    return center, float(np.sqrt(((used - center) ** 2).sum(axis=1).max()))


def measure(tool, prepare, path, arguments):
    """The rows of one mesh."""
    name, positions, triangles = load(path)
    center, radius = sphere_of(positions, triangles)
    camera = Camera.of(arguments, center, radius)
    scene, mesh_object = build_scene(positions, triangles, camera, center, radius)
    cells = prepare(scene, mesh_object, camera, arguments)
    drawn = [cell.strokes() for cell in cells]  # The warm-up, too.
    for cell, strokes in zip(cells, drawn):
        if not strokes:
            raise SystemExit(f"{path}: no line for '{cell.metric}': nothing to time")
    times = [[cell.once() for cell in cells] for _ in range(arguments.runs)]
    if arguments.svg:
        arguments.svg.write_text(svg(drawn[0], camera.size), encoding="utf-8")
    return [
        {
            "tool": tool,
            "version": bpy.app.version_string,
            "mesh": name,
            "faces": len(triangles),
            "metric": cell.metric,
            "median_ms": float(np.median([wall for wall, _ in timed])),
            "min_ms": min(wall for wall, _ in timed),
            "cpu_ms": float(np.median([processor for _, processor in timed])),
            "runs": arguments.runs,
            "strokes": len(strokes),
            "points": sum(map(len, strokes)),
            "length_px": sum(map(length, strokes)),
            "size": list(camera.size),
            "eye": shortest(camera.eye),
            "target": shortest(camera.target),
            "up": shortest(camera.up),
            "fov_deg": camera.fov_deg,
            "threads": scene.render.threads,
            "machine": describe_machine(),
        }
        for cell, strokes, timed in zip(cells, drawn, zip(*times))
    ]


def length(stroke):
    return float(np.linalg.norm(np.diff(stroke, axis=0), axis=1).sum())


def shortest(vector):
    """The shortest decimals that name the same float32: `silhouettes` reads them back to the bit."""
    return [float(str(number)) for number in vector.astype(np.float32)]


def svg(strokes, size):
    """Strokes as thin polylines, a unit a pixel."""
    width, height = size
    lines = (" ".join(f"{x:.2f},{y:.2f}" for x, y in stroke) for stroke in strokes)
    body = "".join(f'<polyline points="{points}"/>\n' for points in lines)
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
    return f'{head}\n<rect width="100%" height="100%" fill="white"/>\n<g fill="none" stroke="black">\n{body}</g>\n</svg>\n'
