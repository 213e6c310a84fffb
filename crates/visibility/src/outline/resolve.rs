//! Step 2: cell by cell, only what may bound the covered area is kept.
//!
//! In a cell through which no contour passes, the number of layers is the same everywhere. It is known at the corners of all
//! cells by counting along the lines of the grid which contours they cross, and in the same way all along the sides of a
//! cell. In a cell that is resolved, the chain is replaced by one with no more than one layer: of its edges only those
//! stretches are left that have nothing on their right. Sides between such a cell and one that is not become edges of as
//! many layers as there are more in the other. What is covered stays the same.
//!
//! A cell is resolved
//!
//! - if it is covered all along its sides and passed by two edges at most, or from any point a straight line to the sides, in
//!   one of two directions, crosses at most half of the edges, and even they leave a layer: then it is covered all over;
//! - or if the stretches are found by looking at its edges one by one, of which there must be few, and no ties among them.

use super::arrangement::Arrangement;
use super::chain_map::{ChainMap, Part};
use super::lattice::DirectedEdge;
use crate::line_error::LineError;
use rayon::prelude::*;

/// Edges in a cell up to which it is looked at them one by one.
const MOST_COMPARED: usize = 128;

/// Cells that a task takes: some 0.1 ms of work.
const CELLS_PER_TASK: usize = 1024;

/// Most pairs of edges in cells that are not resolved, most of which may cross: `i_overlay` takes some 200 bytes for each.
const MOST_PAIRS: u64 = 3_000_000;

/// What has become of a range of cells.
struct Resolved {
    /// For each, whether it is resolved.
    is_resolved: Vec<bool>,
    /// What is left in them, each edge with its part.
    left: Vec<(u32, DirectedEdge)>,
    /// Pairs of edges in those that are not.
    pairs: u64,
}

/// A chain that bounds the same, with fewer edges. O(edges + cells that they pass), parallel.
///
/// # Errors
/// [`LineError::TooCrowded`] where more edges pass the same cells than may cross.
pub fn resolve(chain: &[DirectedEdge]) -> Result<Vec<DirectedEdge>, LineError> {
    let map = ChainMap::new(chain);
    let (first, order) = map.parts_by_cell();
    let tasks = (0..map.cells.len().div_ceil(CELLS_PER_TASK)).into_par_iter();
    let done: Vec<Resolved> = tasks
        .map(|task| {
            let begin = task * CELLS_PER_TASK;
            let cells = begin..map.cells.len().min(begin + CELLS_PER_TASK);
            let mut resolved = Resolved { is_resolved: Vec::with_capacity(cells.len()), left: Vec::new(), pairs: 0 };
            let (mut arrangement, mut parts, mut bare) = (Arrangement::default(), Vec::new(), Vec::new());
            for cell in cells {
                let of_cell = &order[first[cell] as usize..first[cell + 1] as usize];
                parts.clear();
                parts.extend(of_cell.iter().map(|&part| map.parts[part as usize]));
                bare.clear();
                let is_resolved = push_left_in_cell(&map, cell, &parts, &mut arrangement, &mut bare).is_some();
                resolved.is_resolved.push(is_resolved);
                if is_resolved {
                    resolved.left.extend(bare.iter().map(|&(index, edge)| (of_cell[index], edge)));
                } else {
                    resolved.pairs += (parts.len() as u64).pow(2) / 2;
                    let whole = |(&part, at): (&u32, &Part)| {
                        let [from, to] = at.ends;
                        (part, DirectedEdge { from, to, layers: at.layers.unsigned_abs() })
                    };
                    resolved.left.extend(of_cell.iter().zip(&parts).map(whole));
                }
            }
            resolved
        })
        .collect();
    if done.iter().map(|resolved| resolved.pairs).sum::<u64>() > MOST_PAIRS {
        return Err(LineError::TooCrowded);
    }
    let is_resolved: Vec<bool> = done.iter().flat_map(|resolved| &resolved.is_resolved).copied().collect();
    let mut left: Vec<(u32, DirectedEdge)> = done.into_iter().flat_map(|resolved| resolved.left).collect();
    // Stable: what is left of one part is in order.
    left.sort_by_key(|(part, _)| *part);
    let mut kept = joined(&map, &left);
    map.push_borders(&is_resolved, &mut kept);
    Ok(kept)
}

/// Appends what is left in a cell if it is resolved: stretches, each with its part's index in the cell. `None` if it is not.
fn push_left_in_cell(
    map: &ChainMap,
    cell: usize,
    parts: &[Part],
    arrangement: &mut Arrangement,
    out: &mut Vec<(usize, DirectedEdge)>,
) -> Option<()> {
    if parts.is_empty() {
        return Some(());
    }
    let place = [cell % map.cells.count[0], cell / map.cells.count[0]];
    let least = map.least_on_sides(place);
    let layers: i32 = parts.iter().map(|part| part.layers).sum();
    if least > 0 && parts.len() <= 2 || least > layers / 2 {
        return Some(());
    }
    if parts.len() > MOST_COMPARED { None } else { arrangement.push_bare_stretches(map, place, parts, out) }
}

/// Edges without the points at which they pass from cell to cell. `left` is ordered by part, and along it.
fn joined(map: &ChainMap, left: &[(u32, DirectedEdge)]) -> Vec<DirectedEdge> {
    let mut joined: Vec<DirectedEdge> = Vec::with_capacity(left.len());
    let mut before: Option<u32> = None;
    let begins_edge = |part: u32| map.first_part.binary_search(&part).is_ok();
    for &(part, edge) in left {
        let continues = before.is_some_and(|before| before + 1 == part) && !begins_edge(part);
        match joined.last_mut() {
            Some(last) if continues && last.to == edge.from && last.layers == edge.layers => last.to = edge.to,
            _ => joined.push(edge),
        }
        before = Some(part);
    }
    joined
}
