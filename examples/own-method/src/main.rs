//! The whole command line of `silhouettes` with a method of one's own: it is listed by `doctor`, extracts, draws, and stands
//! beside the others in the report of `compare`.

mod single_precision;

use silhouettes::{Entry, Registry};
use single_precision::SinglePrecision;

fn main() -> std::process::ExitCode {
    silhouettes::run(&Registry::builtin().with(Entry::of::<SinglePrecision>().edges()))
}
