//! [`Tracks`]: the loops of the view by their identity, and what happens to them, beside the window.

use crate::background::{Died, Stage, Wake, Worker};
use silhouette_compare::runner::NamedMesh;
use silhouette_core::glam::Vec3;
use silhouette_core::loops::start_vertex;
use silhouette_core::method::NoOptions;
use silhouette_core::{Camera, ExtractsLoops, Method, Progress, SilhouetteLoops};
use silhouette_tracking::{ExactTracking, LoopEvent, LoopId};
use silhouettes::application::Failure;
use std::collections::VecDeque;

/// A loop of the view.
#[derive(Debug, Clone)]
pub struct TrackedLoop {
    /// Its identity.
    pub id: LoopId,
    /// Its vertices in order, in the mesh's own space.
    pub points: Vec<Vec3>,
}

/// The loops of one view.
#[derive(Debug, Clone)]
pub struct Loops {
    /// The view.
    pub camera: Camera,
    /// Its loops.
    pub loops: Vec<TrackedLoop>,
    /// What happened since the last view, one line each.
    pub events: Vec<String>,
}

/// Tracks the loops of one mesh from view to view, by the method `tracking-exact`, which misses none.
pub struct Tracks(Worker<Camera, Result<Loops, Failure>>);

impl Tracks {
    /// Starts the thread. It prepares the method when it is first asked.
    pub fn start(wake: &Wake, mesh: &NamedMesh) -> Self {
        let mesh = mesh.clone();
        let mut tracking: Option<ExactTracking> = None;
        Self(Worker::start(wake, move |camera: Camera, progress| {
            let tracking = match &mut tracking {
                Some(tracking) => tracking,
                none => none.insert(prepare(&mesh, progress)?),
            };
            Ok(follow(tracking, &mesh, camera))
        }))
    }

    /// Asks for the loops of a view.
    pub fn ask(&self, camera: Camera) {
        self.0.ask(camera);
    }

    /// Loops, if some are there.
    pub fn poll(&self) -> Option<Result<Result<Loops, Failure>, Died>> {
        self.0.poll()
    }

    /// How far it is, while there is something to do.
    pub fn stage(&self) -> Option<Stage> {
        self.0.stage()
    }
}

/// The loops on screen, while they are wanted.
#[derive(Default)]
pub struct Tracked {
    /// Whether they are wanted.
    pub is_on: bool,
    /// What happened to them.
    pub events: Events,
    tracks: Option<Tracks>,
    asked: Option<Camera>,
    loops: Option<Loops>,
    failure: Option<String>,
}

impl Tracked {
    /// Forgets all that is of the last mesh.
    pub fn clear(&mut self) {
        *self = Self { is_on: self.is_on, ..Self::default() };
    }

    /// Asks for the loops of the view on screen, and takes what has come.
    pub fn update(&mut self, wake: &Wake, mesh: &NamedMesh, camera: Camera) {
        if !self.is_on {
            if self.tracks.is_some() {
                self.clear();
            }
            return;
        }
        let tracks = self.tracks.get_or_insert_with(|| Tracks::start(wake, mesh));
        if self.asked != Some(camera) && self.failure.is_none() {
            tracks.ask(camera);
            self.asked = Some(camera);
        }
        while let Some(result) = tracks.poll() {
            match result {
                Ok(Ok(loops)) => {
                    self.events.extend(&loops.events);
                    self.loops = Some(loops);
                }
                Ok(Err(failure)) => self.failure = Some(failure.to_string()),
                Err(died) => return self.failure = Some(died.to_string()),
            }
        }
    }

    /// The loops seen last.
    pub fn loops(&self) -> Option<&Loops> {
        self.loops.as_ref()
    }

    /// Why there are none.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// How far it is, while there is something to do.
    pub fn stage(&self) -> Option<Stage> {
        self.tracks.as_ref().and_then(Tracks::stage)
    }
}

/// How many events are remembered.
const REMEMBERED: usize = 200;

/// What happened to loops, the latest last.
#[derive(Debug, Default)]
pub struct Events(VecDeque<String>);

impl Events {
    /// Adds what happened in a view.
    pub fn extend(&mut self, events: &[String]) {
        self.0.extend(events.iter().cloned());
        let surplus = self.0.len().saturating_sub(REMEMBERED);
        self.0.drain(..surplus);
    }

    /// Forgets all of it.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// All that is remembered, the latest last.
    pub fn all(&self) -> impl DoubleEndedIterator<Item = &str> {
        self.0.iter().map(String::as_str)
    }
}

fn prepare(mesh: &NamedMesh, progress: &dyn Progress) -> Result<ExactTracking, Failure> {
    let prepared = ExactTracking::prepare(&mesh.mesh, &NoOptions, progress);
    prepared.map_err(|error| Failure::of_preparation(&mesh.name, ExactTracking::INFO.name, error))
}

fn follow(tracking: &mut ExactTracking, mesh: &NamedMesh, camera: Camera) -> Loops {
    tracking.extract_loops(&camera.viewpoint(), &mut SilhouetteLoops::default());
    let (tracker, mesh) = (tracking.tracker(), mesh.mesh.mesh());
    let loops = tracker.loops().iter().zip(tracker.ids()).map(|(half_edges, &id)| {
        let points = half_edges.iter().map(|&edge| mesh.positions()[start_vertex(mesh, edge).index()]);
        TrackedLoop { id, points: points.collect() }
    });
    Loops { camera, loops: loops.collect(), events: tracker.events().iter().map(in_words).collect() }
}

fn in_words(event: LoopEvent<'_>) -> String {
    let list = |ids: &[LoopId]| ids.iter().map(|id| id.get().to_string()).collect::<Vec<_>>().join(", ");
    match event {
        LoopEvent::Birth { id } => format!("birth of {}", id.get()),
        LoopEvent::Death { id } => format!("death of {}", id.get()),
        LoopEvent::Split { from, into } => format!("split of {} into {}", from.get(), list(into)),
        LoopEvent::Merge { from, into } => format!("merge of {} into {}", list(from), into.get()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::DVec3;
    use silhouette_core::view::Framing;
    use silhouette_core::{NoProgress, PreparedMesh, shapes};
    use std::sync::Arc;

    #[test]
    fn the_last_events_are_remembered() {
        let mut events = Events::default();
        (0..300).for_each(|number| events.extend(&[format!("birth of {number}")]));
        assert_eq!((events.all().count(), events.all().next()), (REMEMBERED, Some("birth of 100")));
        events.clear();
        assert_eq!(events.all().count(), 0);
    }

    /// Over a torus: one loop from above becomes two, the rim and the hole, and these are one again from the side.
    #[test]
    fn loops_keep_their_identity_and_what_happens_is_told() {
        let mesh = Arc::new(PreparedMesh::new(shapes::by_name("torus").unwrap()));
        let named = NamedMesh { name: "torus".into(), mesh };
        let bounds = named.mesh.mesh().bounds().unwrap();
        let mut tracking = prepare(&named, &NoProgress).unwrap();
        let (mut events, mut seen) = (Vec::new(), Vec::new());
        for step in 0..60 {
            let direction = DVec3::new(0.01, 1.0, f64::from(step) * 0.1);
            let up = Vec3::NEG_Z;
            let camera = Camera::framing(&bounds, direction, up, Framing::Orthographic, [64, 64]).unwrap();
            let loops = follow(&mut tracking, &named, camera);
            assert!(loops.loops.iter().all(|tracked| tracked.points.len() > 2));
            seen.push(loops.loops.iter().map(|tracked| tracked.id).collect::<Vec<_>>());
            events.extend(loops.events);
        }
        assert!(seen[0].len() == 2 && seen[1].iter().all(|id| seen[0].contains(id)), "{:?}", &seen[..2]);
        assert!(events.iter().filter(|event| event.starts_with("birth")).count() >= 2, "{events:?}");
        let changes = events.iter().any(|event| event.starts_with("merge") || event.starts_with("split"));
        assert!(changes || seen.iter().all(|ids| ids.len() == 2), "{events:?}");
    }
}
