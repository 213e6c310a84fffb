//! Bad input: one line on stderr that names the place, exit code 2, nothing written.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        fs::write(self.path(name), bytes).unwrap();
        self.path(name).to_str().unwrap().to_owned()
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<_> =
            self.0.path().read_dir().unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

fn silhouettes(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_silhouettes")).args(arguments).output().unwrap()
}

/// Runs a command that must be refused; yields its one line.
fn refused(arguments: &[&str]) -> String {
    let output = silhouettes(arguments);
    let line = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {line}");
    assert_eq!(line.lines().count(), 1, "{arguments:?}: {line}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    line
}

/// Extracting from a bad mesh is refused with a line that names the file and holds `expected`, and writes nothing.
fn bad_mesh(folder: &Folder, mesh: &str, expected: &str) {
    let before = folder.names();
    let result = folder.path("result.json");
    let line = refused(&["extract", mesh, "-o", result.to_str().unwrap()]);
    let name = Path::new(mesh).file_name().unwrap().to_str().unwrap();
    assert!(line.contains(name) && line.contains(expected), "wanted '{expected}' in: {line}");
    assert_eq!(folder.names(), before, "nothing is written");
}

/// A mesh that a method is not defined for is refused by commands of one method, with the elements at fault.
#[test]
fn a_mesh_that_a_method_refuses() {
    let folder = Folder::new();
    for command in ["extract", "render"] {
        for method in ["tracking", "tracking-exact"] {
            let result = folder.path("result.svg").with_extension(if command == "extract" { "svg" } else { "png" });
            let line = refused(&[command, "builtin:moebius", "--method", method, "-o", result.to_str().unwrap()]);
            assert!(line.contains(&format!("builtin:moebius: not defined for {method}: ")), "{line}");
            assert!(line.contains("edge ") && folder.names().is_empty(), "{line}");
        }
    }
    let cut = silhouettes(&["extract", "builtin:moebius", "--method", "tracking", "--set", "mesh=cut"]);
    assert!(cut.status.success(), "{}", String::from_utf8_lossy(&cut.stderr));
}

fn binary_stl(promised: u32, present: usize) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(promised.to_le_bytes());
    for face in 0..present {
        bytes.extend([0; 12]);
        for corner in [[0.0, 0.0, face as f32], [1.0, 0.0, face as f32], [0.0, 1.0, face as f32]] {
            corner.iter().for_each(|c: &f32| bytes.extend(c.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn binary_ply(vertices: &str, faces: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
         property float z\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    for coordinate in [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0] {
        bytes.extend(coordinate.to_le_bytes());
    }
    bytes.push(3);
    [0_i32, 1, 2].iter().for_each(|index| bytes.extend(index.to_le_bytes()));
    bytes
}

#[test]
fn files_that_are_none() {
    let folder = Folder::new();
    bad_mesh(&folder, folder.path("missing.obj").to_str().unwrap(), "");
    fs::create_dir(folder.path("folder.obj")).unwrap();
    bad_mesh(&folder, folder.path("folder.obj").to_str().unwrap(), "directory");
    for name in ["empty.obj", "empty.ply", "empty.off", "empty.stl", "empty.glb", "empty.gltf"] {
        bad_mesh(&folder, &folder.file(name, ""), "empty");
    }
    bad_mesh(&folder, &folder.file("mesh.xyz", OBJ), ".obj");
    bad_mesh(&folder, &folder.file("mesh", OBJ), ".obj");
}

/// A pipe that nobody writes to, and a device without end: to open or to read either would be to wait for ever.
#[cfg(unix)]
#[test]
fn pipes_and_devices() {
    let folder = Folder::new();
    assert!(Command::new("mkfifo").arg(folder.path("pipe.obj")).status().unwrap().success());
    std::os::unix::fs::symlink("/dev/zero", folder.path("endless.stl")).unwrap();
    for name in ["pipe.obj", "endless.stl"] {
        bad_mesh(&folder, folder.path(name).to_str().unwrap(), "no regular file");
    }
}

#[test]
fn truncated_binary_files() {
    let folder = Folder::new();
    bad_mesh(&folder, &folder.file("short.stl", &binary_stl(2, 2)[..160]), "");
    let ply = binary_ply("3", "1");
    assert!(silhouettes(&["extract", &folder.file("whole.ply", &ply)]).status.success());
    bad_mesh(&folder, &folder.file("short.ply", &ply[..ply.len() - 3]), "");
    bad_mesh(&folder, &folder.file("header.ply", &ply[..60]), "");
    let mut glb = b"glTF".to_vec();
    glb.extend(2_u32.to_le_bytes());
    glb.extend(4000_u32.to_le_bytes());
    bad_mesh(&folder, &folder.file("short.glb", glb), "");
}

#[test]
fn indices_and_coordinates() {
    let folder = Folder::new();
    bad_mesh(&folder, &folder.file("zero.obj", OBJ.replace("f 1 2 3", "f 0 1 2")), "line 4");
    bad_mesh(&folder, &folder.file("far.obj", OBJ.replace("f 1 2 3", "f 1 2 4")), "line 4");
    bad_mesh(&folder, &folder.file("negative.obj", OBJ.replace("f 1 2 3", "f -1 -2 -4")), "line 4");
    bad_mesh(&folder, &folder.file("nan.obj", OBJ.replace("v 1 0 0", "v nan 0 0")), "line 2");
    bad_mesh(&folder, &folder.file("infinite.obj", OBJ.replace("v 1 0 0", "v inf 0 0")), "line 2");
    bad_mesh(&folder, &folder.file("overflow.obj", OBJ.replace("v 1 0 0", "v 1e39 0 0")), "line 2");
    bad_mesh(&folder, &folder.file("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "line 4");
    bad_mesh(&folder, &folder.file("far.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6");
    bad_mesh(&folder, &folder.file("none.obj", "v 0 0 0\n"), "face");
    bad_mesh(&folder, &folder.file("none.off", "OFF\n1 0 0\n0 0 0\n"), "face");
    let mut nan = binary_stl(1, 1);
    nan[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
    bad_mesh(&folder, &folder.file("nan.stl", nan), "");
}

/// A limit on the address space turns a large allocation into a failure.
#[test]
fn headers_that_promise_billions_allocate_little() {
    let folder = Folder::new();
    let files = [
        folder.file("many.stl", binary_stl(u32::MAX, 1)),
        folder.file("vertices.ply", binary_ply("4000000000", "1")),
        folder.file("faces.ply", binary_ply("3", "4000000000")),
        folder.file("ascii.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"),
        folder.file("many.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    ];
    for file in &files {
        bad_mesh(&folder, file, "");
        let binary = env!("CARGO_BIN_EXE_silhouettes");
        let limited = Command::new("sh")
            .args(["-c", "ulimit -v 4000000; exec \"$0\" extract \"$1\"", binary, file])
            .output()
            .unwrap();
        assert_eq!(limited.status.code(), Some(2), "{file}: {}", String::from_utf8_lossy(&limited.stderr));
    }
}

#[test]
fn outputs_that_cannot_be_written() {
    let folder = Folder::new();
    let mesh = folder.file("mesh.obj", OBJ);
    let into_missing = folder.path("missing/x.json");
    assert!(refused(&["extract", &mesh, "-o", into_missing.to_str().unwrap()]).contains("missing"));
    fs::create_dir(folder.path("x.json")).unwrap();
    assert!(refused(&["extract", &mesh, "-o", folder.path("x.json").to_str().unwrap()]).contains("directory"));
    assert!(refused(&["extract", &mesh, "-o", folder.path("x.dwg").to_str().unwrap()]).contains(".svg"));
    assert!(refused(&["render", &mesh, "-o", folder.path("x.jpg").to_str().unwrap()]).contains(".png"));
    assert!(refused(&["smooth", &mesh, "-o", folder.path("x.stl").to_str().unwrap()]).contains(".obj or .png"));
    assert!(refused(&["smooth", &mesh, "-o", &mesh]).contains("input"));
    assert!(refused(&["extract", &mesh, "-o", &mesh]).contains("input"));
    let scene = folder.file("scene.gltf", "{}");
    assert!(refused(&["lines", &mesh, &scene, "-o", &scene]).contains("input"));
    assert_eq!(fs::read_to_string(&mesh).unwrap(), OBJ, "the input is left alone");
    assert!(refused(&["extract", &mesh, "-o", "/dev/null/x.json"]).contains("x.json"));
    assert!(refused(&["compare", &mesh, "-o", "/dev/null/report"]).contains("/dev/null/report"));
    assert!(refused(&["compare", &mesh, "-o", &folder.file("taken", "mine")]).contains("taken"));
    assert_eq!(fs::read(folder.path("taken")).unwrap(), b"mine", "nothing a user made is lost");
    assert_eq!(folder.names(), ["mesh.obj", "scene.gltf", "taken", "x.json"]);
}

/// 6000 long, thin triangles, nearly all of which cross each other, exceed the work limit of a view.
#[test]
fn arguments_that_do_not_go_with_a_glb() {
    let folder = Folder::new();
    let mesh = folder.file("mesh.obj", OBJ);
    let glb = folder.path("x.glb");
    for options in
        [["--method", "tracking"], ["--set", "speed=9"], ["--eye", "1,2,3"], ["--view", "iso"], ["--fov", "30"]]
    {
        let line = refused(&[&["extract", &mesh, "-o", glb.to_str().unwrap()], &options[..]].concat());
        assert!(line.contains("edges of every view"), "{line}");
    }
    assert!(refused(&["extract", &mesh, "--creases", "30"]).contains(".glb"));
    assert!(refused(&["extract", &mesh, "--creases", "181", "-o", glb.to_str().unwrap()]).contains("0 to 180"));
    assert!(refused(&["extract", &mesh, "--weld=-1", "-o", glb.to_str().unwrap()]).contains("--weld"));
    assert!(!glb.exists());
}

/// A file of edges whose document says something else about them than its bytes do.
#[test]
fn edges_that_do_not_fit_their_mesh() {
    let folder = Folder::new();
    let good = folder.path("good.glb");
    assert!(silhouettes(&["extract", "builtin:cylinder", "-o", good.to_str().unwrap()]).status.success());
    let bytes = fs::read(good).unwrap();
    let of_text = |from: &str, to: &str| {
        assert_eq!(from.len(), to.len());
        let at = bytes.windows(from.len()).position(|window| window == from.as_bytes()).unwrap();
        let mut bytes = bytes.clone();
        bytes[at..at + to.len()].copy_from_slice(to.as_bytes());
        folder.file("bad.glb", bytes)
    };
    let place = "meshes[0].primitives[0]";
    bad_mesh(&folder, &of_text("\"count\":192,", "\"count\":191,"), place);
    bad_mesh(&folder, &of_text("\"count\":192,", "\"count\":191,"), "191 bytes for 256 triangles");
    bad_mesh(&folder, &of_text("\"count\":128,", "\"count\":129,"), "an accessor");
    bad_mesh(&folder, &of_text("\"count\":128,", "\"count\":127,"), "127 for 64 silhouettes");
    bad_mesh(&folder, &of_text("5121", "5123"), "unsigned bytes");
    bad_mesh(&folder, &of_text("\"visibility\":2", "\"visibility\":7"), "beyond the 4 accessors");
}

#[test]
fn tangles_are_refused() {
    let folder = Folder::new();
    let share = |at: usize, step: usize| (at * step % 6007) as f64 / 6007.0;
    let mut mesh = String::new();
    for at in 0..6000 {
        for (corner, x) in [-1, 1, 0].into_iter().enumerate() {
            let [y, z] = [37, 101].map(|step| share(at, step * (corner + 1)));
            mesh += &format!("v {x} {y} {z}\n");
        }
        mesh += "f -3 -2 -1\n";
    }
    let mesh = folder.file("needles.obj", mesh);
    let result = folder.path("result.svg");
    let line = refused(&["lines", &mesh, "-o", result.to_str().unwrap()]);
    assert!(line.contains("needles.obj") && line.contains("over each other"), "{line}");
    let line = refused(&["lines", &mesh, "--intersections", "-o", result.to_str().unwrap()]);
    assert!(line.contains("needles.obj") && line.contains("intersection"), "{line}");
    assert_eq!(folder.names(), ["needles.obj"], "nothing is written");
}

/// Each is refused with a line that names the option.
fn arguments_of_lines(mesh: &str) {
    for (words, expected) in [
        (&["--page", "a9"][..], "letter"),
        (&["--page", "0x100"], "--page"),
        (&["--page", "99999x99999"], "10 m"),
        (&["--margin", "200mm"], "200mm"),
        (&["--margin", "-1"], "margins"),
        (&["--margin", "wide"], "--margin wide"),
        (&["--units", "px", "--margin", "3"], "--page"),
        (&["--scale", "1"], "--ortho"),
        (&["--scale", "0", "--ortho", "fit"], "scale"),
        (&["--scale", "nan", "--ortho", "fit"], "scale"),
        (&["--width", "thick"], "--width thick"),
        (&["--width", "edge=1mm"], "silhouette"),
        (&["--width", "0"], "0.001mm"),
        (&["--width", "0.0001mm"], "0.001mm"),
        (&["--page", "0.5x0.5", "--margin", "0"], "1 mm"),
        (&["--ortho", "fit", "--scale", "1e300"], "1e9"),
        (&["--threads", "9999"], "256"),
        (&["--dash", "hidden=2mm,1mm"], "--hidden"),
        (&["--colour", "reddish"], "#1a2b3c"),
        (&["--colour", "#ff000080"], "opaque"),
        (&["--scale", "2", "--mesh-unit", "m", "--ortho", "fit"], "1:100"),
        (&["--scale", "1:0", "--ortho", "fit"], "1:100"),
        (&["--dash", "2mm,1mm"], "hidden="),
        (&["--dash", "hidden=2mm"], "two lengths"),
        (&["--hidden", "--dash", "hidden=0.001mm,1mm"], "0.1mm"),
        (&["--hidden=maybe"], "dashed"),
        (&["--creases", "181"], "180"),
        (&["--creases", "30", "--ridge", "20"], "--ridge"),
        (&["--min-length", "-1mm"], "-1mm"),
        (&["--threads", "0"], "--threads"),
        (&["--heal=far"], "--heal"),
        (&["--heal=-1"], "--heal"),
        (&["--heal=nan"], "--heal"),
    ] {
        let line = refused(&[&["lines", mesh], words].concat());
        assert!(line.contains(expected), "{words:?}: wanted '{expected}' in: {line}");
    }
    assert!(refused(&["lines"]).contains("<MESH>"));
    assert!(refused(&["lines", mesh, "missing.obj"]).contains("missing.obj"));
    assert!(refused(&["lines", mesh, "-o", "x.dwg"]).contains(".svg"));
}

#[test]
fn arguments() {
    let folder = Folder::new();
    let mesh = folder.file("mesh.obj", OBJ);
    assert!(refused(&["extract", &mesh, "--eye", "1,2"]).contains("three numbers"));
    assert!(refused(&["extract", &mesh, "--eye", "1,2,nan"]).contains("--eye"));
    assert!(refused(&["extract", &mesh, "--method", "brute-farce"]).contains("brute-force"));
    assert!(refused(&["extract", &mesh, "--method", "image-precision"]).contains("no edges and no curves"));
    assert!(refused(&["extract", &mesh, "--set", "speed=9"]).contains("speed"));
    assert!(refused(&["extract", "builtin:teacup"]).contains("torus"));
    assert!(refused(&["extract", "builtin:torus:1"]).contains("torus"));
    assert!(refused(&["extract", &mesh, "--fov", "180", "--view", "iso"]).contains("field of view"));
    assert!(refused(&["extract", &mesh, "--fov", "0", "--view", "iso"]).contains("field of view"));
    assert!(refused(&["render", &mesh, "--size", "0x9", "-o", "x.png"]).contains("viewport"));
    assert!(
        refused(&["render", &mesh, "--method", "image-precision", "--set", "scale=0", "-o", "x.png"]).contains("scale")
    );
    assert!(refused(&["compare", "--methods", "none", "-o", "x"]).contains("none"));
    arguments_of_lines(&mesh);
    let rows = folder.file("rows.jsonl", "\n{}\n");
    let line = refused(&["compare", &mesh, "--peers", &rows, "-o", folder.path("report").to_str().unwrap()]);
    assert!(line.contains("rows.jsonl: line 2: missing field"), "{line}");
    assert!(refused(&["compare", &mesh, "--peers", "missing.jsonl", "-o", "x"]).contains("missing.jsonl"));
    for (name, lacks) in [("x.obj", "makes no triangles"), ("x.png", "fills no image")] {
        let result = folder.path(name);
        let line = refused(&["smooth", &mesh, "--method", "tracking", "-o", result.to_str().unwrap()]);
        assert!(line.contains(lacks) && line.contains("smoothing") && !result.exists(), "{line}");
        let points = folder.file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
        assert!(refused(&["smooth", &points, "-o", result.to_str().unwrap()]).contains("points.obj"));
        assert!(!result.exists());
    }
    assert!(refused(&["smooth", &mesh, "--set", "tolerance=0", "-o", "x.obj"]).contains("tolerance"));
    assert!(refused(&["bake", &mesh]).contains("--output"));
    assert!(refused(&["conjure", &mesh]).contains("conjure"));
}

/// What a reader leaves out of a file is said once: on stderr, or in what `inspect` prints.
#[test]
fn notes_about_a_file_are_printed_once() {
    let folder = Folder::new();
    let mesh = folder.file("few.obj", format!("{OBJ}f 1\nf 3 2\n"));
    let output = silhouettes(&["extract", &mesh, "-o", folder.path("few.json").to_str().unwrap()]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{stderr}");
    let note = "2 faces of fewer than three corners were left out (the first: line 5)";
    assert_eq!(stderr, format!("silhouettes: note: {mesh}: {note}\n"));

    let inspected = silhouettes(&["inspect", &mesh]);
    let text = String::from_utf8(inspected.stdout).unwrap();
    assert!(text.contains(note) && inspected.stderr.is_empty(), "{text}");
    let json: serde_json::Value = serde_json::from_slice(&silhouettes(&["inspect", &mesh, "--json"]).stdout).unwrap();
    assert_eq!(json["notes"], serde_json::json!([note]));
    let clean = folder.file("clean.obj", OBJ);
    let json: serde_json::Value = serde_json::from_slice(&silhouettes(&["inspect", &clean, "--json"]).stdout).unwrap();
    assert_eq!(json["notes"], serde_json::json!([]));
}

/// A cube of this size about zero.
fn cube(half: f64) -> String {
    let corner = |at: u32| [at & 1, at >> 1 & 1, at >> 2].map(|side| half * (2.0 * f64::from(side) - 1.0));
    let vertices = (0..8).map(corner).map(|[x, y, z]| format!("v {x:e} {y:e} {z:e}\n"));
    vertices.collect::<String>() + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

/// Sizes at both ends of what 32 bits hold, and no size at all: drawn, or refused with the true cause.
#[test]
fn sizes_at_the_ends_of_32_bits() {
    let folder = Folder::new();
    let out = folder.path("lines.json").to_str().unwrap().to_owned();
    for half in [1e-24, 1e-38, 1e-42] {
        let mesh = folder.file("tiny.obj", cube(half));
        let output = silhouettes(&["lines", &mesh, "--creases", "30", "-o", &out]);
        assert!(
            output.status.success() && output.stderr.is_empty(),
            "{half}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        let found = fs::read_to_string(&out).unwrap();
        assert_eq!(found.matches("\"kind\":\"silhouette\"").count(), 1, "{half}: the outline is one loop");
        let text = String::from_utf8(silhouettes(&["inspect", &mesh]).stdout).unwrap();
        assert!(text.contains("no defects") && text.contains("e-"), "{text}");
    }
    let huge = folder.file("huge.obj", cube(3.4e38));
    for command in [&["extract"][..], &["lines"], &["lines", "--ortho", "fit"], &["lines", "--outline"]] {
        let line = refused(&[command, &[&huge]].concat());
        assert!(line.contains("too large") && line.contains("scale it down"), "{line}");
    }
    let point = folder.file("point.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n");
    for command in ["extract", "lines", "inspect"] {
        assert!(silhouettes(&[command, &point]).status.success(), "{command}");
    }
}

#[test]
fn distances_that_leave_nothing_of_a_mesh() {
    for command in
        [&["extract", "--weld=1e30"][..], &["extract", "--weld=1e30", "-o", "x.glb"], &["lines", "--weld=1e30"]]
    {
        let line = refused(&[command, &["builtin:torus"]].concat());
        assert!(line.contains("--weld: within 1000000000000000000000000000000 of each other"), "{line}");
    }
    assert!(refused(&["lines", "--heal=1e30", "builtin:torus"]).contains("--heal: no face of builtin:torus is higher"));
    for distance in ["--weld=nan", "--weld=inf", "--weld=-1", "--heal=nan", "--heal=1e39"] {
        assert!(refused(&["lines", distance, "builtin:torus"]).contains("is no distance"), "{distance}");
    }
}
