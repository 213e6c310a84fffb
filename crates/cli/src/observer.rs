//! [`Observer`]: who sees progress and notes of a command in place of the terminal, and cancels it.

use silhouette_core::Progress;
use std::cell::RefCell;
use std::sync::Arc;

/// Sees how far a command is and what its user should know, and may cancel it.
pub trait Observer: Progress + Send {
    /// Something that does not stop the command, but that its user has to know; on one line.
    fn note(&self, text: &str);
}

thread_local! {
    static OBSERVER: RefCell<Option<Arc<dyn Observer>>> = const { RefCell::new(None) };
}

/// Does `work` on this thread. What it would print on stderr, progress and notes, goes to `observer`, and it ends early where that
/// cancels.
pub fn observed<T>(observer: Arc<dyn Observer>, work: impl FnOnce() -> T) -> T {
    struct Restores(Option<Arc<dyn Observer>>);
    impl Drop for Restores {
        fn drop(&mut self) {
            OBSERVER.replace(self.0.take());
        }
    }
    let _restores = Restores(OBSERVER.replace(Some(observer)));
    work()
}

/// Who observes this thread.
pub(crate) fn current() -> Option<Arc<dyn Observer>> {
    OBSERVER.with_borrow(Clone::clone)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Registry, execute};
    use std::sync::Mutex;

    #[derive(Default)]
    struct Seen {
        notes: Mutex<Vec<String>>,
        stages: Mutex<Vec<String>>,
        cancels: bool,
    }

    impl Progress for Seen {
        fn stage(&self, name: &str, _total: u64) {
            self.stages.lock().unwrap().push(name.to_owned());
        }

        fn advance(&self, _steps: u64) {}

        fn is_cancelled(&self) -> bool {
            self.cancels
        }
    }

    impl Observer for Seen {
        fn note(&self, text: &str) {
            self.notes.lock().unwrap().push(text.to_owned());
        }
    }

    /// A drawing of a mesh that lies behind the eye, of which the command says why it is empty.
    #[test]
    fn notes_and_progress_go_to_the_observer_and_it_cancels() {
        let folder = tempfile::tempdir().unwrap();
        let run = |cancels: bool, name: &str, threads: &[&str]| {
            let seen = Arc::new(Seen { cancels, ..Seen::default() });
            let file = folder.path().join(name);
            let view = ["--eye", "0,0,9", "--target", "0,0,20"];
            let words = ["lines", "builtin:torus", "-o", file.to_str().unwrap()].into_iter();
            let words = words.chain(view).chain(threads.iter().copied());
            let result = observed(Arc::<Seen>::clone(&seen), || execute(words, &Registry::builtin()));
            (result, seen, file)
        };
        for (count, threads) in [(1, &[][..]), (2, &["--threads", "1"])] {
            let (result, seen, file) = run(false, &format!("empty-{count}.svg"), threads);
            result.unwrap();
            let notes = seen.notes.lock().unwrap();
            assert!(file.exists() && notes.len() == 1 && notes[0].contains("behind the eye"), "{notes:?}");
            assert!(!seen.stages.lock().unwrap().is_empty(), "{threads:?}");
            let (result, _, file) = run(true, "cancelled.svg", threads);
            assert!(result.is_err() && !file.exists(), "{threads:?}");
            assert_eq!(folder.path().read_dir().unwrap().count(), count, "nothing half-written stays");
        }
        assert!(current().is_none());
    }
}
