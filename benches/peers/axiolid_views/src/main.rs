//! Visible silhouette and boundary edges by `axiolid-hidden-lines`, as polylines in the pixels of the views that
//! `silhouettes score --cameras` prints. It is linked to nothing of this repository: it reads its mesh and its cameras from files.
//!
//! `cargo run --release --ignore-rust-version -- MESH.obj cameras.json 'axiolid-{frame}.json'`
//!
//! Parallel projections only, which are all that axiolid draws, and manifold meshes that are wound consistently.

use axiolid_contracts::ExecutionOptions;
use axiolid_core::{Frame3, Point3, Tolerance, Vec3};
use axiolid_hidden_lines::ScalarHiddenLines;
use axiolid_mesh::TriMesh;
use axiolid_mesh_hidden_lines_contract::{
    EdgeSelection, HiddenLineLimits, HiddenLineMesh, HiddenLineRequest, MeshHiddenLines, MeshId, MeshRole,
    OrthographicView,
};
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::process::ExitCode;

/// What is used of the document by `silhouettes score --cameras`.
#[derive(Deserialize)]
struct Cameras {
    views: Vec<View>,
}

#[derive(Deserialize)]
struct View {
    frame: u32,
    size: [u32; 2],
    ortho_height: Option<f64>,
    /// Rows: right, up and backwards, each with how far the mesh's origin lies from the eye along it.
    world_to_camera: [[f64; 4]; 4],
}

/// What `silhouettes score --lines` takes.
#[derive(Serialize)]
struct Lines {
    method: &'static str,
    size: [u32; 2],
    polylines: Vec<[[f64; 2]; 2]>,
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("axiolid-views: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [mesh, cameras, lines] = &words[..] else {
        return Err("give MESH.obj, cameras.json and a name with {frame} in it".into());
    };
    let mesh = read_obj(&std::fs::read_to_string(mesh)?)?;
    let cameras: Cameras = serde_json::from_str(&std::fs::read_to_string(cameras)?)?;
    for view in &cameras.views {
        let path = lines.replace("{frame}", &view.frame.to_string());
        std::fs::write(path, serde_json::to_string(&draw(&mesh, view)?)?)?;
    }
    Ok(())
}

fn draw(mesh: &TriMesh, view: &View) -> Result<Lines, Box<dyn Error>> {
    let height = view.ortho_height.ok_or("only parallel projections are drawn: projection = \"orthographic\"")?;
    let [right, up, back, _] = view.world_to_camera;
    let axis = |row: [f64; 4]| Vec3::new(row[0], row[1], row[2]);
    let frame = Frame3 { origin: Point3::ZERO, x: axis(right), y: axis(up), z: axis(back) };
    let meshes = [HiddenLineMesh::new(MeshId(0), MeshRole::Sheet, mesh)];
    let edges = EdgeSelection::new(None).with_hidden(false);
    let limits = HiddenLineLimits::new(1, usize::MAX, usize::MAX, usize::MAX, usize::MAX);
    let request = HiddenLineRequest::new(&meshes, OrthographicView::new(frame), edges, limits);
    let options = ExecutionOptions::new(Tolerance::new(1e-9, 1e-9)?);
    let outcome = ScalarHiddenLines::new().hidden_lines(&request, &options).map_err(|error| format!("{error:?}"))?;
    let [width_px, height_px] = view.size.map(f64::from);
    let scale = height_px / height;
    let pixel = |x: f64, y: f64| [width_px * 0.5 + (x + right[3]) * scale, height_px * 0.5 - (y + up[3]) * scale];
    let polyline = |ends: [f64; 4]| [pixel(ends[0], ends[1]), pixel(ends[2], ends[3])];
    let segments = outcome.segments.iter();
    let polylines = segments.map(|piece| polyline([piece.start.x, piece.start.y, piece.end.x, piece.end.y])).collect();
    Ok(Lines { method: "axiolid-hidden-lines 0.1.2", size: view.size, polylines })
}

/// Positions and faces of a Wavefront OBJ, polygons fanned about their first corner.
fn read_obj(text: &str) -> Result<TriMesh, Box<dyn Error>> {
    let (mut positions, mut corners) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                // As meshes are kept here: in 32 bits.
                let numbers: Vec<f32> = words.take(3).map(str::parse).collect::<Result<_, _>>()?;
                let &[x, y, z] = &numbers[..] else { return Err(format!("'{line}' is no vertex").into()) };
                positions.push(Point3::new(x.into(), y.into(), z.into()));
            }
            Some("f") => {
                let id = |word: &str| word.split('/').next().unwrap_or_default().parse::<u32>();
                let ids: Vec<u32> = words.map(id).collect::<Result<_, _>>()?;
                for pair in ids.get(1..).unwrap_or_default().windows(2) {
                    corners.extend([ids[0] - 1, pair[0] - 1, pair[1] - 1]);
                }
            }
            _ => {}
        }
    }
    Ok(TriMesh::new(positions, corners))
}
