//! Work beside the window: a [`Job`] is one piece of it, a [`Worker`] does the latest that was asked of it.
//!
//! A job of the command line's code has notes as well, which it would print. Both report their progress, can be cancelled, and wake the window when there is something to see. What is dropped is cancelled, and
//! its result with it: nothing that is stale arrives.

use silhouette_core::Progress;
use silhouettes::application::{Observer, observed};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Asks the window to look again.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// A thread of the background panicked, which is a defect of this program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Died;

impl std::fmt::Display for Died {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("the work broke off, which is a defect of this program; please report it")
    }
}

/// How far a piece of work is.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Stage {
    /// What is done at the moment; empty where nobody has said.
    pub name: String,
    /// Steps that are done.
    pub done: u64,
    /// Steps in all; 0 where nobody knows.
    pub total: u64,
}

impl Stage {
    /// The share that is done, where the number of steps is known.
    pub fn share(&self) -> Option<f32> {
        (self.total > 0).then(|| (self.done as f64 / self.total as f64).min(1.0) as f32)
    }
}

/// The progress of a piece of work as both sides see it.
pub struct Signal {
    is_cancelled: AtomicBool,
    name: Mutex<String>,
    done: AtomicU64,
    total: AtomicU64,
    notes: Mutex<Vec<String>>,
    wake: Wake,
}

impl Signal {
    fn new(wake: &Wake) -> Arc<Self> {
        Arc::new(Self {
            is_cancelled: AtomicBool::new(false),
            name: Mutex::default(),
            done: AtomicU64::new(0),
            total: AtomicU64::new(0),
            notes: Mutex::default(),
            wake: Arc::clone(wake),
        })
    }

    fn stage(&self) -> Stage {
        let (done, total) = (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed));
        Stage { name: lock(&self.name).clone(), done, total }
    }

    fn cancel(&self) {
        self.is_cancelled.store(true, Ordering::Relaxed);
    }
}

impl Progress for Signal {
    fn stage(&self, name: &str, total: u64) {
        name.clone_into(&mut lock(&self.name));
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
        (self.wake)();
    }

    fn advance(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }
}

impl Observer for Signal {
    fn note(&self, text: &str) {
        lock(&self.notes).push(text.to_owned());
    }
}

/// One piece of work on a thread of its own; cancelled when dropped.
pub struct Job<T> {
    signal: Arc<Signal>,
    result: Receiver<T>,
}

impl<T: Send + 'static> Job<T> {
    /// Begins it.
    pub fn start(wake: &Wake, work: impl FnOnce(&dyn Progress) -> T + Send + 'static) -> Self {
        let signal = Signal::new(wake);
        let (sender, result) = channel();
        let own = Arc::clone(&signal);
        std::thread::spawn(move || {
            let observer: Arc<Signal> = Arc::clone(&own);
            // Where nobody waits for the result any more it is dropped.
            let _ = sender.send(observed(observer, || work(&*own)));
            (own.wake)();
        });
        Self { signal, result }
    }
}

impl<T> Job<T> {
    /// The result, once it is there.
    pub fn poll(&self) -> Option<Result<T, Died>> {
        match self.result.try_recv() {
            Ok(result) => Some(Ok(result)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(Died)),
        }
    }

    /// How far it is.
    pub fn stage(&self) -> Stage {
        self.signal.stage()
    }

    /// Asks it to end early. Its result still comes, and says whether it did.
    pub fn cancel(&self) {
        self.signal.cancel();
    }

    /// What the command line would have printed as notes so far.
    pub fn notes(&self) -> Vec<String> {
        lock(&self.signal.notes).clone()
    }
}

impl<T> Drop for Job<T> {
    fn drop(&mut self) {
        self.signal.cancel();
    }
}

/// A thread that answers questions, the latest first and older ones not at all.
pub struct Worker<Q, A> {
    shared: Arc<Shared<Q>>,
    answers: Receiver<A>,
    wake: Wake,
}

struct Shared<Q> {
    desk: Mutex<Desk<Q>>,
    changed: Condvar,
}

struct Desk<Q> {
    waiting: Option<(Q, Arc<Signal>)>,
    running: Option<Arc<Signal>>,
    is_closed: bool,
}

impl<Q: Send + 'static, A: Send + 'static> Worker<Q, A> {
    /// Starts the thread.
    pub fn start(wake: &Wake, mut answer: impl FnMut(Q, &dyn Progress) -> A + Send + 'static) -> Self {
        let desk = Desk { waiting: None, running: None, is_closed: false };
        let shared = Arc::new(Shared { desk: Mutex::new(desk), changed: Condvar::new() });
        let (sender, answers) = channel();
        let own = Arc::clone(&shared);
        std::thread::spawn(move || {
            while let Some((question, signal)) = own.next() {
                let is_taken = sender.send(answer(question, &*signal)).is_ok();
                // After the answer is there: whoever sees that nothing is running has it.
                lock(&own.desk).running = None;
                if !is_taken {
                    break;
                }
                (signal.wake)();
            }
        });
        Self { shared, answers, wake: Arc::clone(wake) }
    }
}

impl<Q> Shared<Q> {
    /// The next question, as soon as there is one; `None` when there will be none.
    fn next(&self) -> Option<(Q, Arc<Signal>)> {
        let mut desk = lock(&self.desk);
        loop {
            if desk.is_closed {
                return None;
            }
            if let Some((question, signal)) = desk.waiting.take() {
                desk.running = Some(Arc::clone(&signal));
                return Some((question, signal));
            }
            desk = self.changed.wait(desk).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl<Q, A> Worker<Q, A> {
    /// Asks a question in place of any that waits. The one that is being answered is finished first.
    pub fn ask(&self, question: Q) {
        lock(&self.shared.desk).waiting = Some((question, Signal::new(&self.wake)));
        self.shared.changed.notify_one();
    }

    /// Cancels what is being answered and what waits.
    pub fn cancel(&self) {
        let mut desk = lock(&self.shared.desk);
        desk.waiting = None;
        if let Some(signal) = &desk.running {
            signal.cancel();
        }
    }

    /// An answer, if there is one.
    pub fn poll(&self) -> Option<Result<A, Died>> {
        match self.answers.try_recv() {
            Ok(answer) => Some(Ok(answer)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(Died)),
        }
    }

    /// The next answer, if one comes within this time.
    pub fn wait(&self, time: Duration) -> Option<Result<A, Died>> {
        match self.answers.recv_timeout(time) {
            Ok(answer) => Some(Ok(answer)),
            Err(RecvTimeoutError::Timeout) => None,
            Err(RecvTimeoutError::Disconnected) => Some(Err(Died)),
        }
    }

    /// How far the answer is, while there is a question.
    pub fn stage(&self) -> Option<Stage> {
        let desk = lock(&self.shared.desk);
        let waiting = desk.waiting.as_ref().map(|(_, signal)| signal);
        desk.running.as_ref().or(waiting).map(|signal| signal.stage())
    }
}

impl<Q, A> Drop for Worker<Q, A> {
    fn drop(&mut self) {
        self.cancel();
        lock(&self.shared.desk).is_closed = true;
        self.shared.changed.notify_one();
    }
}

/// What is locked here is replaced, never edited, so that a panic elsewhere leaves a whole value behind.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::AtomicUsize;
    use std::time::Instant;

    fn wake() -> (Wake, Arc<AtomicUsize>) {
        let count = Arc::new(AtomicUsize::new(0));
        let own = Arc::clone(&count);
        let wake = move || {
            own.fetch_add(1, Ordering::SeqCst);
        };
        (Arc::new(wake), count)
    }

    /// Waits for something that will be there soon.
    fn soon<T>(mut look: impl FnMut() -> Option<T>) -> T {
        let begin = Instant::now();
        loop {
            if let Some(found) = look() {
                return found;
            }
            assert!(begin.elapsed() < Duration::from_secs(60), "nothing came");
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    #[test]
    fn a_job_tells_its_stage_and_wakes_the_window() {
        let (wake, woken) = wake();
        let (go, wait) = channel::<()>();
        let job = Job::start(&wake, move |progress| {
            progress.stage("baking", 10);
            progress.advance(4);
            wait.recv().unwrap();
            7
        });
        let stage = soon(|| Some(job.stage()).filter(|stage| stage.done == 4));
        assert_eq!((stage.name.as_str(), stage.share()), ("baking", Some(0.4)));
        assert!(job.poll().is_none());
        go.send(()).unwrap();
        assert_eq!(soon(|| job.poll()), Ok(7));
        soon(|| (woken.load(Ordering::SeqCst) >= 2).then_some(()));
    }

    #[test]
    fn a_job_that_is_dropped_is_cancelled_and_one_that_panics_is_known_to_have() {
        let (ended, end) = channel();
        let job = Job::start(&wake().0, move |progress| {
            while progress.check().is_ok() {
                std::thread::sleep(Duration::from_millis(1));
            }
            ended.send(()).unwrap();
        });
        drop(job);
        assert!(end.recv_timeout(Duration::from_secs(60)).is_ok());
        let job: Job<()> = Job::start(&wake().0, |_| panic!("expected by this test"));
        assert_eq!(soon(|| job.poll()), Err(Died));
    }

    #[test]
    fn a_worker_answers_the_latest_question_and_skips_the_older() {
        let (began, begin) = channel();
        let (go, wait) = channel::<()>();
        let worker = Worker::start(&wake().0, move |question: u32, _| {
            began.send(question).unwrap();
            wait.recv().unwrap();
            question
        });
        worker.ask(1);
        assert_eq!(begin.recv().unwrap(), 1);
        worker.ask(2);
        worker.ask(3);
        assert!(worker.stage().is_some());
        go.send(()).unwrap();
        go.send(()).unwrap();
        assert_eq!(soon(|| worker.poll()), Ok(1));
        assert_eq!(soon(|| worker.poll()), Ok(3));
        soon(|| worker.stage().is_none().then_some(()));
    }

    #[test]
    fn what_a_worker_does_can_be_cancelled() {
        let worker = Worker::start(&wake().0, |question: u32, progress: &dyn Progress| {
            while question == 1 && progress.check().is_ok() {
                std::thread::sleep(Duration::from_millis(1));
            }
            (question, progress.is_cancelled())
        });
        worker.ask(1);
        soon(|| lock(&worker.shared.desk).running.is_some().then_some(()));
        worker.cancel();
        assert_eq!(soon(|| worker.poll()), Ok((1, true)));
        worker.ask(2);
        assert_eq!(soon(|| worker.poll()), Ok((2, false)), "later questions are not cancelled");
    }
}
