//! [`Painter`]: draws a prepared method beside the window, in a texture that the window shows.
//!
//! The texture is on the window's own device, whose queue orders what is submitted: the window shows the last frame that is whole.

use crate::background::{Died, Wake, Worker, lock};
use eframe::wgpu::TextureView;
use silhouette_compare::cost::FrameSample;
use silhouette_compare::drawing::{DrawError, Drawing};
use silhouette_core::{Camera, SilhouetteEdges};
use silhouette_gpu::Pen;
use silhouette_render::{Gpu, Image};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// From where, how large.
    pub camera: Camera,
    /// Whether the picture is read back, for what is measured on it.
    pub reads_back: bool,
}

/// A frame.
pub struct Frame {
    /// The view.
    pub camera: Camera,
    /// How long it took.
    pub sample: FrameSample,
    /// The pen of its lines.
    pub pen: Pen,
    /// What the user should know of it.
    pub warning: Option<String>,
    /// Its silhouette edges, where the method extracts edges.
    pub edges: Option<SilhouetteEdges>,
    /// The picture, where it was asked for.
    pub picture: Option<Arc<Image>>,
    /// Where it can be seen.
    pub texture: Texture,
}

/// A texture, with a number that identifies it.
#[derive(Debug, Clone)]
pub struct Texture {
    /// The texture, one sample per pixel, premultiplied by alpha.
    pub view: TextureView,
    /// No other texture of the process has it.
    pub number: u64,
}

impl Texture {
    fn of(drawing: &Drawing) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self { view: drawing.target().color_view().clone(), number: NEXT.fetch_add(1, Ordering::Relaxed) }
    }
}

/// Draws on a thread of its own, always the latest view that was asked for.
pub struct Painter {
    worker: Worker<Question, Result<Frame, DrawError>>,
    next: Arc<Mutex<Option<Drawing>>>,
}

impl Painter {
    /// Starts the thread, which draws by `drawing` once it is asked to.
    pub fn start(gpu: &Arc<Gpu>, wake: &Wake, drawing: Drawing) -> Self {
        let next = Arc::new(Mutex::new(None));
        let (gpu, given) = (Arc::clone(gpu), Arc::clone(&next));
        let mut texture = Texture::of(&drawing);
        let mut drawing = drawing;
        let worker = Worker::start(wake, move |question: Question, _| {
            if let Some(next) = lock(&given).take() {
                drawing = next;
                texture = Texture::of(&drawing);
            }
            draw(&gpu, &mut drawing, &mut texture, question)
        });
        Self { worker, next }
    }

    /// Draws with another method from the next question on.
    pub fn change(&self, drawing: Drawing) {
        *lock(&self.next) = Some(drawing);
    }

    /// Asks for a frame, in place of one that is not begun.
    pub fn ask(&self, question: Question) {
        self.worker.ask(question);
    }

    /// A frame, if one is there.
    pub fn poll(&self) -> Option<Result<Result<Frame, DrawError>, Died>> {
        self.worker.poll()
    }

    /// The next frame, if one is drawn within this time.
    pub fn wait(&self, time: Duration) -> Option<Result<Result<Frame, DrawError>, Died>> {
        self.worker.wait(time)
    }

    /// Whether a frame is to come.
    pub fn is_busy(&self) -> bool {
        self.worker.stage().is_some()
    }
}

fn draw(gpu: &Gpu, drawing: &mut Drawing, texture: &mut Texture, question: Question) -> Result<Frame, DrawError> {
    if drawing.target().size() != question.camera.size() {
        drawing.resize(gpu, question.camera.size())?;
        *texture = Texture::of(drawing);
    }
    let sample = drawing.draw(gpu, &question.camera)?;
    Ok(Frame {
        camera: question.camera,
        sample,
        pen: drawing.pen(),
        warning: drawing.warning(),
        edges: drawing.edges().cloned(),
        picture: question.reads_back.then(|| drawing.picture(gpu)).transpose()?.map(Arc::new),
        texture: texture.clone(),
    })
}
