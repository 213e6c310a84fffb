//! Every variant over the path around every mesh.

use super::counted::{Counted, count_flight, flight_frames};
use super::paper::model_of;
use super::path::{CIRCLE, Circle, Frame, Path, circles};
use super::recall::Missed;
use super::timed::time_frames;
use super::variants::{Flier, Variant};
use super::visible::{VisibleError, VisibleFrames, pictured_frames};
use crate::cost::Spread;
use crate::machine::{describe_machine, describe_program};
use crate::record::Profile;
use crate::runner::NamedMesh;
use silhouette_core::loops::start_vertex;
use silhouette_core::mesh::Bounds;
use silhouette_core::method::PrepareError;
use silhouette_core::{Cancelled, HalfEdgeId, PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops, Topology};
use silhouette_tracking::{ConnectivityTable, NotTrackable, TrackedEdges};
use std::sync::Arc;

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReproduceError {
    /// No mesh was given.
    #[error("there is no mesh to fly around")]
    NoMesh,
    /// A mesh has no triangle.
    #[error("{mesh}: the mesh has no triangle, so it has no silhouette")]
    EmptyMesh {
        /// Its name.
        mesh: String,
    },
    /// A method could not be prepared.
    #[error("{mesh}: {source}")]
    Prepare {
        /// The mesh.
        mesh: String,
        /// What went wrong.
        source: PrepareError,
    },
    /// It is not known what of a mesh can be seen.
    #[error("{mesh}: {source}")]
    Visible {
        /// The mesh.
        mesh: String,
        /// Why.
        source: VisibleError,
    },
    /// No thread of its own could be had.
    #[error(transparent)]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// Stopped by the progress.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// What was measured, and where.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// How much was measured.
    pub profile: Profile,
    /// Frames of the path that were measured.
    pub frames: u32,
    /// The machine in one line.
    pub machine: String,
    /// The program in one line.
    pub program: String,
    /// One a mesh, in their order.
    pub meshes: Vec<MeshResult>,
}

/// What was measured on one mesh.
#[derive(Debug, Clone)]
pub struct MeshResult {
    /// Its name.
    pub name: String,
    /// Its faces.
    pub faces: usize,
    /// Its concave edges.
    pub concave_edges: usize,
    /// Its boundary edges.
    pub boundary_edges: usize,
    /// Silhouette half-edges on the mean of the frames.
    pub half_edges: f64,
    /// Loops on the mean of the frames.
    pub loops: f64,
    /// One a variant, in the order of [`Variant::all`].
    pub variants: Vec<VariantResult>,
}

/// What was measured of one variant on one mesh.
#[derive(Debug, Clone)]
pub struct VariantResult {
    /// The variant.
    pub variant: Variant,
    /// Faces evaluated.
    pub counted: Counted,
    /// Least and greatest speed-up counted over twenty circles: of the paper's levels on its model, with
    /// [`Profile::Full`].
    pub counted_range: Option<[f64; 2]>,
    /// Median time of a frame in microseconds.
    pub median_us: f64,
    /// Brute force's median time over this one's.
    pub speed_up: f64,
    /// What was missed.
    pub missed: Missed,
    /// Visible length missed in per cent.
    pub missed_visible: f64,
}

/// Measured frames of a profile.
pub fn frames(profile: Profile) -> u32 {
    match profile {
        Profile::Quick => 120,
        Profile::Full => 504,
    }
}

/// Flies every variant around every mesh. Seconds a mesh of a hundred thousand faces with [`Profile::Quick`].
///
/// # Errors
/// [`ReproduceError`].
pub fn run(profile: Profile, meshes: &[NamedMesh], progress: &dyn Progress) -> Result<Reproduction, ReproduceError> {
    if meshes.is_empty() {
        return Err(ReproduceError::NoMesh);
    }
    for NamedMesh { name, mesh } in meshes {
        let defects = mesh.artefact::<ConnectivityTable>("reproduce tracking", progress)?.defects().to_vec();
        if !defects.is_empty() {
            let source = PrepareError::Mesh(Box::new(NotTrackable { defects }));
            return Err(ReproduceError::Prepare { mesh: name.clone(), source });
        }
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut results = Vec::with_capacity(meshes.len());
    for mesh in meshes {
        results.push(pool.install(|| measure_mesh(profile, mesh, progress))?);
    }
    let (machine, program) = (describe_machine(), describe_program());
    Ok(Reproduction { profile, frames: frames(profile), machine, program, meshes: results })
}

/// The true loops of each measured frame, and how to judge what is found of them.
struct Truth<'a> {
    mesh: &'a NamedMesh,
    topology: &'a Topology,
    frames: Vec<SilhouetteLoops>,
}

/// What one variant did on the measured frames.
struct Observed {
    missed: Missed,
    /// The edges found in the frames that are pictured.
    pictured: Vec<SilhouetteEdges>,
}

fn measure_mesh(profile: Profile, named: &NamedMesh, progress: &dyn Progress) -> Result<MeshResult, ReproduceError> {
    let NamedMesh { name, mesh } = named;
    let bounds = mesh.mesh().bounds().ok_or_else(|| ReproduceError::EmptyMesh { mesh: name.clone() })?;
    let failed = |source| match source {
        PrepareError::Cancelled(cancelled) => ReproduceError::Cancelled(cancelled),
        source => ReproduceError::Prepare { mesh: name.clone(), source },
    };
    let table = mesh.artefact::<ConnectivityTable>("reproduce tracking", progress)?;
    let tracked = mesh.artefact::<TrackedEdges>("reproduce tracking", progress)?;
    let path = Path::new(bounds, frames(profile));
    let frames = path.frames();
    let measured: Vec<Frame> = frames.iter().copied().filter(|frame| frame.is_measured).collect();
    let pictured = pictured_frames(profile, measured.len());

    let variants = Variant::all();
    progress.stage(&format!("{name}: flight"), variants.len() as u64);
    let mut truth = Truth { mesh: named, topology: table.topology(), frames: Vec::new() };
    let (mut fliers, mut states, mut observed, mut counts) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for &variant in &variants {
        counts.push(count(profile, variant, mesh, bounds, progress).map_err(failed)?);
        let mut flier = variant.prepare(mesh, progress).map_err(failed)?;
        if let Flier::Tracker(_) = flier {
            path.lead_in().for_each(|view| flier.frame(&view));
        }
        states.push(flier.state());
        observed.push(observe(&mut flier, &frames, &pictured, &mut truth, progress)?);
        fliers.push(flier);
        progress.advance(1);
    }
    progress.stage(&format!("{name}: time"), u64::from(super::timed::ROUNDS) * variants.len() as u64);
    let times_us = time_frames(&mut fliers, &states, &frames, progress)?;

    let drawn: Vec<Frame> = pictured.iter().map(|&frame| measured[frame]).collect();
    let visible = VisibleFrames::find(mesh, &path, &drawn, profile.size(), progress)
        .map_err(|source| ReproduceError::Visible { mesh: name.clone(), source })?;
    let medians: Vec<f64> = times_us.iter().map(|us| Spread::of(us).map_or(f64::NAN, |spread| spread.median)).collect();
    let results =
        variants.iter().zip(&observed).zip(&medians).zip(counts).map(|(((&variant, observed), &median_us), counts)| {
            let missed_visible = visible.missed(&observed.pictured).percent();
            let ((counted, counted_range), missed) = (counts, observed.missed);
            VariantResult {
                variant,
                counted,
                counted_range,
                median_us,
                speed_up: medians[0] / median_us,
                missed,
                missed_visible,
            }
        });
    let mean = |count: fn(&SilhouetteLoops) -> usize| {
        truth.frames.iter().map(|loops| count(loops) as f64).sum::<f64>() / truth.frames.len().max(1) as f64
    };
    Ok(MeshResult {
        name: name.clone(),
        faces: mesh.mesh().face_count(),
        concave_edges: tracked.concave().len(),
        boundary_edges: tracked.boundary().len(),
        half_edges: mean(|loops| loops.half_edges().len()),
        loops: mean(SilhouetteLoops::len),
        variants: results.collect(),
    })
}

/// Counts a variant on the circle, and the range of a level of the paper's model over all circles.
fn count(
    profile: Profile,
    variant: Variant,
    mesh: &Arc<PreparedMesh>,
    bounds: Bounds,
    progress: &dyn Progress,
) -> Result<(Counted, Option<[f64; 2]>), PrepareError> {
    let faces = mesh.mesh().face_count();
    let count = |circle: Circle| {
        let flight = circle.flight(bounds, flight_frames(profile));
        Ok::<_, PrepareError>(count_flight(&mut variant.prepare(mesh, progress)?, flight, faces, progress)?)
    };
    let is_printed = model_of(faces).is_some() && variant.paper_column().is_some();
    if profile != Profile::Full || !is_printed {
        return Ok((count(CIRCLE)?, None));
    }
    let mut range = [f64::INFINITY, 0.0];
    for circle in circles() {
        if let Some(speed_up) = count(circle)?.speed_up() {
            range = [range[0].min(speed_up), range[1].max(speed_up)];
        }
    }
    Ok((count(CIRCLE)?, Some(range)))
}

/// Flies the frames and judges them. The first flier is brute force, whose answers are the truth.
fn observe(
    flier: &mut Flier,
    frames: &[Frame],
    pictured: &[usize],
    truth: &mut Truth<'_>,
    progress: &dyn Progress,
) -> Result<Observed, Cancelled> {
    let mut observed = Observed { missed: Missed::default(), pictured: Vec::new() };
    let mut edges = SilhouetteEdges::default();
    let mut measured = 0;
    for frame in frames {
        progress.check()?;
        flier.frame(&frame.view);
        if !frame.is_measured {
            continue;
        }
        if let (Flier::BruteForce(brute_force), true) = (&*flier, truth.frames.len() == measured) {
            truth.frames.push(brute_force.loops().clone());
        }
        flier.edges(truth.topology, &mut edges);
        truth.judge(measured, &edges, &mut observed.missed);
        if pictured.contains(&measured) {
            observed.pictured.push(edges.clone());
        }
        measured += 1;
    }
    Ok(observed)
}

impl Truth<'_> {
    fn judge(&self, frame: usize, found: &SilhouetteEdges, missed: &mut Missed) {
        let mesh = self.mesh.mesh.mesh();
        let length = |half_edge: HalfEdgeId| {
            let ends = [half_edge, half_edge.next_in_face()].map(|half_edge| start_vertex(mesh, half_edge));
            let [from, to] = ends.map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
            from.distance(to)
        };
        missed.count(&self.frames[frame], |half_edge| found.contains(self.topology.edge_of(half_edge)), length);
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use silhouette_core::{NoProgress, shapes};
    use std::sync::OnceLock;

    fn named(shape: &str) -> NamedMesh {
        NamedMesh { name: shape.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
    }

    /// A small reproduction, flown once for all tests, on a mesh whose name would break out of a page.
    pub fn reproduction() -> &'static Reproduction {
        static FLOWN: OnceLock<Reproduction> = OnceLock::new();
        FLOWN.get_or_init(|| {
            let mut mesh = named("blob:2000");
            mesh.name = "<b>blob</b>".to_owned();
            run(Profile::Quick, &[mesh, named("gear")], &NoProgress).unwrap()
        })
    }

    #[test]
    fn exact_variants_miss_nothing_and_others_do() {
        let blob = &reproduction().meshes[0];
        assert_eq!((blob.faces, blob.variants.len()), (2000, Variant::all().len()));
        assert!(blob.half_edges > 50.0 && blob.loops >= 1.0);
        for result in &blob.variants {
            let missed = [result.missed.edges, result.missed.loops, result.missed.length].map(|share| share.percent());
            let may_miss = match result.variant {
                Variant::Level(level, _) => level != Some(0.0),
                Variant::Budget => true,
                Variant::BruteForce | Variant::BruteForceInFours | Variant::Exact | Variant::Today(..) => false,
            };
            assert!(may_miss || missed.iter().all(|&percent| percent <= 0.0), "{}: {missed:?}", result.variant.label());
            assert!(may_miss || result.missed_visible <= 0.0, "{}: {}", result.variant.label(), result.missed_visible);
            assert!(result.median_us > 0.0 && result.speed_up > 0.0);
        }
        let ignored = blob.variants.iter().find(|result| result.variant.label().contains("no concave")).unwrap();
        assert!(ignored.missed.edges.percent() > 0.0, "a blob has bumps that come into view");
    }

    #[test]
    fn higher_levels_evaluate_less_than_brute_force() {
        let counted = |result: &VariantResult| result.counted.speed_up().unwrap();
        let variants = &reproduction().meshes[0].variants;
        assert_eq!(variants[0].counted.speed_up(), Some(1.0));
        let levels: Vec<f64> = variants[1..8].iter().map(counted).collect();
        assert!(levels.is_sorted() && levels[6] > 1.5, "{levels:?}");
        assert!(variants.iter().all(|result| result.counted.fallbacks == 0));
    }

    #[test]
    fn what_cannot_be_flown_is_refused() {
        let run = |meshes: &[NamedMesh]| run(Profile::Quick, meshes, &NoProgress);
        assert!(matches!(run(&[]), Err(ReproduceError::NoMesh)));
        let triangles = silhouette_core::TriangleMesh::new(vec![], vec![]).unwrap();
        let empty = NamedMesh { name: "e".to_owned(), mesh: Arc::new(PreparedMesh::new(triangles)) };
        assert!(matches!(run(&[empty]), Err(ReproduceError::EmptyMesh { mesh }) if mesh == "e"));
        let refused = run(&[named("cube"), named("moebius:12,2")]).unwrap_err().to_string();
        assert!(refused.starts_with("moebius:12,2: ") && refused.contains("disagree"), "{refused}");
    }
}
