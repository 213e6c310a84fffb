//! Long work checks its [`Progress`] for cancellation, and stops. The longest time between two checks is printed, and bounded so that a
//! phase without any is found.
//!
//! `SILHOUETTES_CANCEL_FACES=1000000 cargo test --release -p silhouette-tests cancelling -- --nocapture` measures it on a large mesh.

use silhouette_compare::registry::Registry;
use silhouette_core::inside_out::inside_out_faces_with_progress;
use silhouette_core::inspect::inspect_with_progress;
use silhouette_core::load::{Format, read};
use silhouette_core::method::PrepareError;
use silhouette_core::{Progress, Topology, TriangleMesh};
use silhouette_testing::pace::Pace;
use silhouette_testing::prepare::{cheap_options, prepared};
use silhouette_testing::{Cancelling, builtin};
use std::fmt::Write as _;
use std::io::{Write as _, stderr};
use std::time::Duration;

/// Faces of the mesh; the variable `SILHOUETTES_CANCEL_FACES` overrides this.
const USUAL: u32 = 20_000;

/// No phase may be as long as this on a mesh of the usual size, however slow the machine: the usual is some milliseconds.
const MOST: Duration = Duration::from_secs(10);

type Work<'a> = Box<dyn Fn(&dyn Progress) -> Result<(), String> + 'a>;

fn obj(mesh: &TriangleMesh) -> Vec<u8> {
    let mut text = String::new();
    mesh.positions().iter().for_each(|p| writeln!(text, "v {} {} {}", p.x, p.y, p.z).unwrap());
    mesh.triangles().iter().for_each(|[a, b, c]| writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap());
    text.into_bytes()
}

/// All that is long, by its name.
fn works<'a>(mesh: &'a TriangleMesh, topology: &'a Topology, file: &'a [u8]) -> Vec<(String, Work<'a>)> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let mut works: Vec<(String, Work<'a>)> = vec![
        (
            "read OBJ".into(),
            Box::new(move |progress| {
                read(Format::Obj, "large", file, progress).map(drop).map_err(|error| text(&error))
            }),
        ),
        (
            "inspect".into(),
            Box::new(move |progress| inspect_with_progress(mesh, topology, progress).map(drop).map_err(|e| text(&e))),
        ),
        (
            "inside out".into(),
            Box::new(move |progress| {
                inside_out_faces_with_progress(mesh, topology, progress).map(drop).map_err(|error| text(&error))
            }),
        ),
    ];
    for entry in Registry::builtin().entries() {
        let (entry, info) = (entry.clone(), entry.info());
        let work = move |progress: &dyn Progress| {
            let mesh = prepared(mesh.clone());
            match entry.prepare(&mesh, &cheap_options(info.options), progress) {
                Ok(_) | Err(PrepareError::Mesh(_)) => Ok(()),
                Err(error) => Err(error.to_string()),
            }
        };
        works.push((format!("prepare {}", info.name), Box::new(work)));
    }
    works
}

#[test]
fn long_work_checks_and_stops() {
    let faces = std::env::var("SILHOUETTES_CANCEL_FACES").ok().and_then(|faces| faces.parse().ok()).unwrap_or(USUAL);
    let mesh = builtin(&format!("blob:{faces}"));
    let (topology, file) = (Topology::new(&mesh), obj(&mesh));
    for (name, work) in works(&mesh, &topology, &file) {
        let pace = Pace::begin();
        work(&pace).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (longest, stage, checks) = pace.end();
        writeln!(stderr(), "{name}: checks {checks} times, at most {longest:?} apart, in '{stage}'").unwrap();
        assert!(longest < MOST, "{name}: {longest:?} in '{stage}'");
        // Methods that prepare nothing check nothing. How often others check may depend on what threads find done.
        for check in [0, checks / 2].into_iter().filter(|_| checks > 0) {
            let stopped = work(&Cancelling::at_poll(check));
            assert!(stopped.is_err_and(|error| error.contains("cancelled")), "{name} goes on after check {check}");
        }
    }
}
