//! Every variant over the path around every mesh.

use super::circles::{Frame, Path};
use super::counted::{Counted, count, flight_frames};
use super::missed::Missed;
use super::timed::{ROUNDS, time_frames};
use super::variants::{Flier, Variant};
use super::visible::{VisibleFrames, pictured_frames};
use crate::error::{Cause, PaperError};
use crate::paper::Run;
use crate::table::Range;
use silhouette_compare::{NamedMesh, Profile};
use silhouette_core::loops::start_vertex;
use silhouette_core::method::PrepareError;
use silhouette_core::{
    Cancelled, HalfEdgeId, Method, PreparedMesh, Progress, SilhouetteEdges, SilhouetteLoops, Topology,
};
use silhouette_tracking::{ConnectivityTable, NotTrackable, TrackedEdges, Tracking};

/// What was measured on one mesh.
#[derive(Debug, Clone)]
pub struct MeshResult {
    /// Its name.
    pub name: String,
    /// Number of its faces.
    pub faces: usize,
    /// Number of its concave edges.
    pub concave_edges: usize,
    /// Number of its boundary edges.
    pub boundary_edges: usize,
    /// Silhouette half-edges, averaged over the measured frames.
    pub half_edges: f64,
    /// Loops, averaged over the measured frames.
    pub loops: f64,
    /// One per variant, in the order of [`Variant::all`].
    pub variants: Vec<VariantResult>,
}

/// What was measured of one variant on one mesh.
#[derive(Debug, Clone)]
pub struct VariantResult {
    /// The variant.
    pub variant: Variant,
    /// Faces evaluated, on every circle.
    pub counted: Vec<Counted>,
    /// Median time of a frame in microseconds.
    pub median_us: f64,
    /// What was missed.
    pub missed: Missed,
    /// Visible length missed, in per cent.
    pub missed_visible: f64,
}

/// Number of measured frames.
pub fn frames(profile: Profile) -> u32 {
    match profile {
        Profile::Quick => 120,
        Profile::Full => 504,
    }
}

/// Flies every variant around every mesh, on one thread. With [`Profile::Quick`] some ten seconds for a mesh of a hundred
/// thousand faces.
///
/// # Errors
/// [`PaperError`]; a mesh that cannot be tracked is reported before anything is measured.
pub fn meshes(run: &Run<'_>) -> Result<Vec<MeshResult>, PaperError> {
    for NamedMesh { name, mesh } in run.meshes {
        let table = mesh.artefact::<ConnectivityTable>(Tracking::INFO.name, run.progress)?;
        if !table.defects().is_empty() {
            let refusal = NotTrackable { defects: table.defects().to_vec() };
            return Err(PaperError::of(name)(PrepareError::Mesh(Box::new(refusal))));
        }
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let each = run.meshes.iter().map(|named| {
        pool.install(|| measure_mesh(run.profile, named, run.progress)).map_err(PaperError::of::<Cause>(&named.name))
    });
    each.collect()
}

/// The frames, and what is true of the measured ones.
struct Flight<'a> {
    mesh: &'a PreparedMesh,
    topology: &'a Topology,
    frames: Vec<Frame>,
    /// Which of the measured frames are pictured.
    pictured: Vec<usize>,
    /// The true loops of each measured frame.
    truth: Vec<SilhouetteLoops>,
}

/// What one variant found in the measured frames.
struct Observed {
    missed: Missed,
    /// The edges of the pictured frames.
    pictured: Vec<SilhouetteEdges>,
}

fn measure_mesh(profile: Profile, named: &NamedMesh, progress: &dyn Progress) -> Result<MeshResult, Cause> {
    let NamedMesh { name, mesh } = named;
    let bounds = mesh.mesh().bounds().ok_or(Cause::EmptyMesh)?;
    let table = mesh.artefact::<ConnectivityTable>(Tracking::INFO.name, progress)?;
    let tracked = mesh.artefact::<TrackedEdges>(Tracking::INFO.name, progress)?;
    let variants = Variant::all();

    progress.stage(&format!("{name}: count"), variants.len() as u64);
    let mut counts = Vec::with_capacity(variants.len());
    for &variant in &variants {
        counts.push(count(variant, mesh, bounds, flight_frames(profile), progress)?);
        progress.advance(1);
    }

    progress.stage(&format!("{name}: flight"), variants.len() as u64);
    let path = Path::new(bounds, frames(profile));
    let mut flight = Flight::new(mesh, table.topology(), &path, profile);
    flight.find_truth(Flier::new(Variant::BruteForce, mesh, progress)?, progress)?;
    let (mut fliers, mut observed) = (Vec::new(), Vec::new());
    for &variant in &variants {
        let mut flier = Flier::new(variant, mesh, progress)?;
        if flier.has_a_past() {
            path.lead_in().for_each(|view| flier.frame(&view));
        }
        flier.keep();
        observed.push(flight.observe(&mut flier, progress)?);
        fliers.push(flier);
        progress.advance(1);
    }

    progress.stage(&format!("{name}: time"), u64::from(ROUNDS) * variants.len() as u64);
    let times_us = time_frames(&mut fliers, &flight.frames, progress)?;
    let visible = VisibleFrames::find(mesh, &path, &flight.pictured_frames(), profile.size(), progress)?;

    let results = variants.into_iter().zip(counts).zip(observed).zip(times_us);
    let results = results.map(|(((variant, counted), Observed { missed, pictured }), times_us)| VariantResult {
        variant,
        counted,
        median_us: Range::of(times_us, "frames").map_or(f64::NAN, |range| range.median),
        missed,
        missed_visible: visible.missed(&pictured).percent(),
    });
    Ok(MeshResult {
        name: name.clone(),
        faces: mesh.mesh().face_count(),
        concave_edges: tracked.concave().len(),
        boundary_edges: tracked.boundary().len(),
        half_edges: flight.average(|loops| loops.half_edges().len()),
        loops: flight.average(SilhouetteLoops::len),
        variants: results.collect(),
    })
}

impl<'a> Flight<'a> {
    fn new(mesh: &'a PreparedMesh, topology: &'a Topology, path: &Path, profile: Profile) -> Self {
        let frames = path.frames();
        let measured = frames.iter().filter(|frame| frame.is_measured).count();
        Self { mesh, topology, frames, pictured: pictured_frames(profile, measured), truth: Vec::new() }
    }

    fn measured(&self) -> impl Iterator<Item = &Frame> {
        self.frames.iter().filter(|frame| frame.is_measured)
    }

    fn pictured_frames(&self) -> Vec<Frame> {
        let measured: Vec<&Frame> = self.measured().collect();
        self.pictured.iter().map(|&frame| *measured[frame]).collect()
    }

    /// Finds the true loops by brute force.
    fn find_truth(&mut self, mut brute_force: Flier, progress: &dyn Progress) -> Result<(), Cancelled> {
        let mut truth = Vec::new();
        for frame in self.measured() {
            progress.check()?;
            brute_force.frame(&frame.view);
            truth.extend(brute_force.loops().cloned());
        }
        self.truth = truth;
        Ok(())
    }

    /// Flies all frames and judges the measured ones.
    fn observe(&self, flier: &mut Flier, progress: &dyn Progress) -> Result<Observed, Cancelled> {
        let mut observed = Observed { missed: Missed::default(), pictured: Vec::new() };
        let mut edges = SilhouetteEdges::default();
        let mut measured = 0;
        for frame in &self.frames {
            progress.check()?;
            flier.frame(&frame.view);
            if !frame.is_measured {
                continue;
            }
            flier.edges(self.topology, &mut edges);
            let is_found = |half_edge| edges.contains(self.topology.edge_of(half_edge));
            observed.missed.count(&self.truth[measured], is_found, |half_edge| self.length(half_edge));
            if self.pictured.contains(&measured) {
                observed.pictured.push(edges.clone());
            }
            measured += 1;
        }
        Ok(observed)
    }

    fn length(&self, half_edge: HalfEdgeId) -> f64 {
        let mesh = self.mesh.mesh();
        let ends = [half_edge, half_edge.next_in_face()].map(|half_edge| start_vertex(mesh, half_edge));
        let [from, to] = ends.map(|vertex| mesh.positions()[vertex.index()].as_dvec3());
        from.distance(to)
    }

    fn average(&self, count: fn(&SilhouetteLoops) -> usize) -> f64 {
        self.truth.iter().map(|loops| count(loops) as f64).sum::<f64>() / self.truth.len().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::{NoProgress, shapes};
    use silhouette_tracking::TestedEdges;
    use std::sync::{Arc, OnceLock};

    fn named(shape: &str) -> NamedMesh {
        NamedMesh { name: shape.to_owned(), mesh: Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap())) }
    }

    fn run(meshes: &[NamedMesh]) -> Run<'_> {
        Run { profile: Profile::Quick, meshes, gpu: None, progress: &NoProgress }
    }

    /// Two small meshes, flown once for all tests.
    fn flown() -> &'static [MeshResult] {
        static FLOWN: OnceLock<Vec<MeshResult>> = OnceLock::new();
        FLOWN.get_or_init(|| meshes(&run(&[named("blob:2000"), named("gear")])).unwrap())
    }

    #[test]
    fn exact_variants_miss_nothing_and_others_do() {
        let blob = &flown()[0];
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
            assert!(result.median_us > 0.0);
        }
        let ignored = blob.variants.iter().find(|result| result.variant == Variant::Level(None, TestedEdges::All));
        assert!(ignored.unwrap().missed.edges.percent() > 0.0, "a blob has bumps that come into view");
    }

    #[test]
    fn higher_levels_evaluate_less_than_brute_force_on_every_circle() {
        let variants = &flown()[0].variants;
        let speed_ups = |result: &VariantResult| result.counted.iter().map(Counted::speed_up).collect::<Vec<_>>();
        assert_eq!(speed_ups(&variants[0]), [1.0; 20]);
        let levels: Vec<Vec<f64>> = variants[1..8].iter().map(speed_ups).collect();
        for circle in 0..20 {
            let levels: Vec<f64> = levels.iter().map(|level| level[circle]).collect();
            assert!(levels.is_sorted() && levels[6] > levels[0], "{levels:?}");
        }
        let fallbacks =
            variants.iter().flat_map(|result| &result.counted).map(|counted| counted.fallbacks).sum::<u32>();
        assert_eq!(fallbacks, 0);
    }

    #[test]
    fn a_mesh_that_cannot_be_tracked_is_refused_by_name() {
        let refused = meshes(&run(&[named("cube"), named("moebius:12,2")])).unwrap_err();
        assert!(refused.is_of_input(), "{refused}");
        let refused = refused.to_string();
        assert!(refused.starts_with("moebius:12,2: ") && refused.contains("disagree"), "{refused}");
    }
}
