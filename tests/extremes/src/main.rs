//! Writes `docs/STABILITY.md`.

#![allow(clippy::print_stdout, reason = "what was found is the output")]

use silhouette_extremes::{families, matrix};
use silhouette_render::{AdapterChoice, Gpu};

fn main() {
    let gpu = Gpu::new(AdapterChoice::from_env().unwrap()).unwrap();
    let wanted = std::env::args().nth(1);
    for family in families::ALL.iter().filter(|family| wanted.as_ref().is_none_or(|word| family.title.contains(word))) {
        let rows = (family.rows)();
        let named = std::env::args().nth(2);
        for row in rows.iter().filter(|row| named.as_ref().is_none_or(|name| row.name == name)) {
            let start = std::time::Instant::now();
            let cells = matrix::run(&gpu, std::slice::from_ref(row));
            println!("== {} ({:.1} s)", row.name, start.elapsed().as_secs_f64());
            for cell in cells {
                let expected = row.expected_of(cell.method, cell.aspect).outcome;
                let mark = if expected == cell.found.outcome { ' ' } else { '!' };
                println!("{mark} {:24} {:6} {:8} {}", cell.method, cell.aspect.name(), cell.found.outcome.word(), cell.found.text);
            }
        }
    }
}
