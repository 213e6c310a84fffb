//! [`Layered`]: what lies in the layers of a lattice, each sorted by itself, so that work on it can stop between them.

use crate::hull::lattice::Lattice;
use rayon::prelude::*;
use silhouette_core::{Cancelled, Progress};

/// Distinct values in ascending order, in the layers in which their nodes lie, numbered from the first layer on.
pub(super) struct Layered<T> {
    pub(super) layers: Vec<Vec<T>>,
    /// How many values lie in the layers before each.
    before: Vec<u32>,
    /// The node of a value, by which it is ordered first.
    node: fn(T) -> u32,
    /// Nodes in a layer.
    in_layer: u32,
}

impl<T: Copy + Ord + Send + Sync> Layered<T> {
    /// All values that `all_of` finds in items. An item lies in a layer of a lattice, the nodes of its values there or in a layer next to it.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub(super) fn of<Item: Sync, const N: usize>(
        lattice: &Lattice,
        items: &[Vec<Item>],
        node: fn(T) -> u32,
        all_of: impl Fn(&Item) -> [T; N] + Sync,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        let in_layer = 2 * lattice.size().x * lattice.size().y;
        let of_layer = |z: usize| {
            progress.check()?;
            let near = &items[z.saturating_sub(1)..(z + 2).min(items.len())];
            let mut values: Vec<T> = near.iter().flatten().flat_map(&all_of).collect();
            values.retain(|&value| (node(value) / in_layer) as usize == z);
            progress.check()?;
            values.sort_unstable();
            values.dedup();
            Ok(values)
        };
        let layers: Vec<Vec<T>> = (0..items.len()).into_par_iter().map(of_layer).collect::<Result<_, Cancelled>>()?;
        let before = layers.iter().scan(0, |sum, layer| Some(std::mem::replace(sum, *sum + layer.len() as u32)));
        Ok(Self { before: before.collect(), layers, node, in_layer })
    }

    /// The number of one of the values.
    pub(super) fn number(&self, value: T) -> u32 {
        let layer = ((self.node)(value) / self.in_layer) as usize;
        self.before[layer] + self.layers[layer].binary_search(&value).map_or(0, |index| index as u32)
    }
}
