//! [`PreparedMesh`]: derived artefacts, each built the first time something asks for it, once, and accounted for.
//!
//! "Model only what a scene requires": a method on a polygon soup asks for nothing, and [`PreparedMesh::report`] proves
//! it. An artefact is any type that implements [`Artefact`], in any crate.

use crate::id::VertexId;
use crate::mesh::TriangleMesh;
use crate::progress::{Cancelled, Progress};
use std::any::{Any, TypeId};
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Something derived from a mesh that several methods may share.
pub trait Artefact: Any + Send + Sync + Sized {
    /// Name in reports and in [`MethodInfo::needs`](crate::method::MethodInfo::needs).
    const NAME: &'static str;

    /// Derives it. May ask `mesh` for other artefacts, with [`NAME`](Self::NAME) as the asker; two artefacts must not
    /// ask for each other.
    ///
    /// # Errors
    /// [`Cancelled`]; the artefact is then built anew when somebody asks again.
    fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled>;

    /// Bytes it holds.
    fn bytes(&self) -> usize;
}

/// What one artefact cost and who wanted it.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct ArtefactReport {
    /// [`Artefact::NAME`].
    pub name: &'static str,
    /// Bytes it holds.
    pub bytes: usize,
    /// Wall time of the build, artefacts that it asked for included where they were not there yet.
    pub build_time: Duration,
    /// Everyone who asked, sorted.
    pub asked_by: BTreeSet<&'static str>,
}

/// A mesh and what has been derived from it so far. Share it behind an `Arc`.
pub struct PreparedMesh {
    mesh: Arc<TriangleMesh>,
    feature_edges: Arc<[[VertexId; 2]]>,
    given: Vec<(TypeId, Shared)>,
    slots: Mutex<HashMap<TypeId, Arc<Slot>>>,
    reports: Mutex<Vec<ArtefactReport>>,
}

type Shared = Arc<dyn Any + Send + Sync>;

type Slot = Mutex<Option<Shared>>;

impl PreparedMesh {
    /// Takes the mesh; derives nothing.
    pub fn new(mesh: impl Into<Arc<TriangleMesh>>) -> Self {
        Self {
            mesh: mesh.into(),
            feature_edges: Arc::default(),
            given: Vec::new(),
            slots: Mutex::default(),
            reports: Mutex::default(),
        }
    }

    /// The same mesh with other [`feature_edges`](Self::feature_edges), to be called before artefacts are asked for.
    #[must_use]
    pub fn with_feature_edges(self, edges: Vec<[VertexId; 2]>) -> Self {
        Self { feature_edges: edges.into(), ..self }
    }

    /// The same mesh with an artefact that the caller has, read from a file for example: it is not built, and not reported. To
    /// be called before artefacts are asked for.
    #[must_use]
    pub fn with_artefact<A: Artefact>(mut self, artefact: A) -> Self {
        self.given.push((TypeId::of::<A>(), Arc::new(artefact)));
        self.fresh()
    }

    /// The same mesh with the same feature edges and the artefacts that [were given](Self::with_artefact), of which nothing has
    /// been derived yet: for measuring what preparation costs.
    #[must_use]
    pub fn fresh(&self) -> Self {
        let slot = |(id, shared): &(TypeId, Shared)| (*id, Arc::new(Mutex::new(Some(Arc::clone(shared)))));
        Self {
            feature_edges: Arc::clone(&self.feature_edges),
            slots: Mutex::new(self.given.iter().map(slot).collect()),
            given: self.given.clone(),
            ..Self::new(Arc::clone(&self.mesh))
        }
    }

    /// The mesh itself.
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// Edges at which whoever made the mesh says that the surface is sharp, as pairs of vertices in any order; none unless
    /// [`with_feature_edges`](Self::with_feature_edges) gave some. A pair that
    /// [`Topology::find_edge`](crate::topology::Topology::find_edge) does not find is no edge of the mesh and means
    /// nothing.
    pub fn feature_edges(&self) -> &[[VertexId; 2]] {
        &self.feature_edges
    }

    /// The artefact `A`, built now if nobody asked before. Threads that ask meanwhile wait and get the same one.
    ///
    /// Do not call it from inside a rayon task: the build itself runs on rayon's pool, which could hand this thread
    /// another task that waits for the same artefact.
    ///
    /// # Errors
    /// [`Cancelled`] by `progress` during the build.
    pub fn artefact<A: Artefact>(&self, asker: &'static str, progress: &dyn Progress) -> Result<Arc<A>, Cancelled> {
        let slot = Arc::clone(lock(&self.slots).entry(TypeId::of::<A>()).or_default());
        let mut value = lock(&slot);
        let shared = if let Some(shared) = &*value {
            Arc::clone(shared)
        } else {
            let start = Instant::now();
            let built = A::build(self, progress)?;
            let (bytes, build_time) = (built.bytes(), start.elapsed());
            lock(&self.reports).push(ArtefactReport { name: A::NAME, bytes, build_time, asked_by: BTreeSet::new() });
            let shared: Shared = Arc::new(built);
            *value = Some(Arc::clone(&shared));
            shared
        };
        if let Some(report) = lock(&self.reports).iter_mut().find(|report| report.name == A::NAME) {
            report.asked_by.insert(asker);
        }
        let Ok(artefact) = shared.downcast() else { unreachable!("slots are keyed by the artefact's type") };
        Ok(artefact)
    }

    /// What was built so far, in the order of completion.
    pub fn report(&self) -> Vec<ArtefactReport> {
        lock(&self.reports).clone()
    }
}

impl fmt::Debug for PreparedMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let faces = self.mesh.face_count();
        f.debug_struct("PreparedMesh").field("faces", &faces).field("report", &self.report()).finish()
    }
}

/// A build that panicked leaves its slot empty, never half-filled, so poison carries no information here.
fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::NoProgress;
    use std::sync::atomic::{AtomicUsize, Ordering};

    static BUILDS: AtomicUsize = AtomicUsize::new(0);

    struct FaceTotal(usize);

    impl Artefact for FaceTotal {
        const NAME: &'static str = "face-total";
        fn build(mesh: &PreparedMesh, progress: &dyn Progress) -> Result<Self, Cancelled> {
            progress.check()?;
            BUILDS.fetch_add(1, Ordering::SeqCst);
            Ok(Self(mesh.mesh().face_count()))
        }
        fn bytes(&self) -> usize {
            8
        }
    }

    struct Nothing;

    impl Artefact for Nothing {
        const NAME: &'static str = "nothing";
        fn build(_mesh: &PreparedMesh, _progress: &dyn Progress) -> Result<Self, Cancelled> {
            Ok(Self)
        }
        fn bytes(&self) -> usize {
            0
        }
    }

    struct CancelAlways;

    impl Progress for CancelAlways {
        fn stage(&self, _name: &str, _total: u64) {}
        fn advance(&self, _steps: u64) {}
        fn is_cancelled(&self) -> bool {
            true
        }
    }

    #[test]
    fn artefacts_are_built_once_by_whoever_asks_first() {
        let prepared = PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap());
        assert!(prepared.report().is_empty());
        assert!(prepared.artefact::<FaceTotal>("early", &CancelAlways).is_err());
        assert!(prepared.report().is_empty(), "a cancelled build leaves nothing");

        std::thread::scope(|scope| {
            for asker in ["one", "two", "three", "one"] {
                let prepared = &prepared;
                scope.spawn(move || assert_eq!(prepared.artefact::<FaceTotal>(asker, &NoProgress).unwrap().0, 0));
            }
        });
        assert_eq!(BUILDS.load(Ordering::SeqCst), 1);
        let report = &prepared.report()[..];
        assert_eq!(report.len(), 1);
        assert_eq!((report[0].name, report[0].bytes), ("face-total", 8));
        assert_eq!(report[0].asked_by, BTreeSet::from(["one", "two", "three"]));
    }

    #[test]
    fn an_artefact_that_was_given_is_not_built() {
        let mesh = TriangleMesh::new(vec![], vec![]).unwrap();
        let prepared = PreparedMesh::new(mesh).with_artefact(FaceTotal(7));
        assert_eq!(prepared.artefact::<FaceTotal>("test", &CancelAlways).unwrap().0, 7);
        assert!(prepared.report().is_empty());
        assert_eq!(prepared.fresh().artefact::<FaceTotal>("test", &CancelAlways).unwrap().0, 7);
    }

    #[test]
    fn a_fresh_mesh_keeps_its_feature_edges_and_nothing_derived() {
        let edges = [[VertexId::new(0), VertexId::new(1)]];
        let mesh = Arc::new(TriangleMesh::new(vec![], vec![]).unwrap());
        let prepared = PreparedMesh::new(Arc::clone(&mesh));
        assert!(prepared.feature_edges().is_empty());
        let prepared = prepared.with_feature_edges(edges.to_vec());
        prepared.artefact::<Nothing>("test", &NoProgress).unwrap();
        let fresh = prepared.fresh();
        assert_eq!((fresh.feature_edges(), prepared.feature_edges()), (&edges[..], &edges[..]));
        assert!(Arc::ptr_eq(fresh.mesh(), &mesh));
        assert_eq!((fresh.report().len(), prepared.report().len()), (0, 1));
    }
}
