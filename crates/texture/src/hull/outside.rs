//! The nodes of a lattice that are outside: connected to its border without passing a node within the offset.
//!
//! A flood fill in sweeps over rows, to and fro until nothing changes; a row takes all its nodes from its neighbours at once,
//! 64 to a word. Cavities, which no sweep reaches, count as inside from then on.

use crate::hull::lattice::Nodes;
use silhouette_core::{Cancelled, Progress};

/// All nodes that are not outside, given those within the offset. None of the outermost may be within it. O(nodes / 64) per
/// sweep; shapes without labyrinths take a few.
pub(super) fn not_outside(within: &Nodes, progress: &dyn Progress) -> Result<Nodes, Cancelled> {
    let mut inside = all_but_the_border(within);
    let (rows, layers) = (1..within.size().y - 1, 1..within.size().z - 1);
    loop {
        let mut is_changed = false;
        for z in layers.clone() {
            progress.check()?;
            for y in rows.clone() {
                is_changed |= update(&mut inside, within, y, z);
            }
        }
        for z in layers.clone().rev() {
            progress.check()?;
            for y in rows.clone().rev() {
                is_changed |= update(&mut inside, within, y, z);
            }
        }
        if !is_changed {
            return Ok(inside);
        }
    }
}

/// The outermost nodes are outside, all others not yet.
fn all_but_the_border(within: &Nodes) -> Nodes {
    let mut inside = within.clone();
    let size = within.size();
    for (y, z) in (0..size.z).flat_map(|z| (0..size.y).map(move |y| (y, z))) {
        let is_border = y == 0 || z == 0 || y == size.y - 1 || z == size.z - 1;
        for is_middle in [false, true] {
            let row = inside.row_mut(is_middle, y, z);
            row.fill(if is_border { 0 } else { u64::MAX });
            row[0] &= !1;
            // From the last node on, those that fill up the row included.
            row[(size.x as usize - 1) / 64] &= !(u64::MAX << ((size.x - 1) % 64));
        }
    }
    inside
}

/// Takes out of a row of corners and the row of middles above it what its neighbours reach; whether anything changed.
fn update(inside: &mut Nodes, within: &Nodes, y: u32, z: u32) -> bool {
    let mut is_changed = false;
    for is_middle in [false, true] {
        // Middles lie above their corner, so that those around a corner begin one row before it.
        let (ys, zs) = if is_middle { ([y, y + 1], [z, z + 1]) } else { ([y - 1, y], [z - 1, z]) };
        let words = inside.row(is_middle, y, z).len();
        let mut kept = Vec::with_capacity(words);
        for word in 0..words {
            let across = |y: u32, z: u32| inside.row(is_middle, y, z)[word];
            let mut all = across(y - 1, z) & across(y + 1, z) & across(y, z - 1) & across(y, z + 1);
            for (y, z) in [(ys[0], zs[0]), (ys[1], zs[0]), (ys[0], zs[1]), (ys[1], zs[1])] {
                let other = inside.row(!is_middle, y, z);
                all &= other[word] & if is_middle { before(other, word) } else { after(other, word) };
            }
            kept.push(inside.row(is_middle, y, z)[word] & (all | within.row(is_middle, y, z)[word]));
        }
        along(&mut kept, within.row(is_middle, y, z));
        let row = inside.row_mut(is_middle, y, z);
        is_changed |= row != kept;
        row.copy_from_slice(&kept);
    }
    is_changed
}

/// A word whose bits are those of the next node of a row.
fn before(row: &[u64], word: usize) -> u64 {
    row[word] >> 1 | row.get(word + 1).map_or(0, |next| next << 63)
}

/// A word whose bits are those of the previous node of a row.
fn after(row: &[u64], word: usize) -> u64 {
    row[word] << 1 | if word == 0 { 0 } else { row[word - 1] >> 63 }
}

/// Takes out of a row what its own nodes reach along it.
fn along(inside: &mut [u64], within: &[u64]) {
    let words = inside.len();
    let mut carry = 0;
    for word in 0..words {
        let outside = spread(!inside[word] | carry & !within[word], !within[word], |bits, by| bits << by);
        inside[word] &= !outside;
        carry = outside >> 63;
    }
    carry = 0;
    for word in (0..words).rev() {
        let outside = spread(!inside[word] | carry & !within[word], !within[word], |bits, by| bits >> by);
        inside[word] &= !outside;
        carry = outside << 63;
    }
}

/// Spreads bits one way over free ones, in six doublings.
fn spread(mut bits: u64, mut free: u64, shift: impl Fn(u64, u32) -> u64) -> u64 {
    for by in [1, 2, 4, 8, 16, 32] {
        bits |= free & shift(bits, by);
        free &= shift(free, by);
    }
    bits
}
