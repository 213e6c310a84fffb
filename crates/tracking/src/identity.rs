//! Identity of loops over time: each keeps an id while it lives, and what happens to loops is reported as events.
//!
//! This is no part of Hall's paper, though it rests on what tracking learns: which old loops became which new ones, and
//! by how many shared half-edges. Nothing else is needed, so the same rules serve any method that relates two frames.
//!
//! An id passes to the child that shares the most half-edges; between equals the lowest old id and then the first child
//! chooses. A loop has at most one heir and at most one ancestor. Hence:
//!
//! - a new id is either *born* (no old loop became this one) or named among the parts of a *split*;
//! - an id that ends has either *died* (its loop became nothing) or is named among the sources of a *merge*.

/// Identity of a loop, never used twice by one tracker.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LoopId(u64);

impl LoopId {
    /// The number, counted from 0 in the order of births.
    pub fn get(self) -> u64 {
        self.0
    }
}

/// An old loop became, or is part of what became, a new one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Relation {
    /// Index of the old loop.
    pub old: u32,
    /// Index of the new loop.
    pub new: u32,
    /// How many half-edges they share; 0 where the silhouette moved on but is known to be the same.
    pub shared: u32,
}

/// What happened to loops between two frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoopEvent<'a> {
    /// A loop appeared.
    Birth {
        /// Its id.
        id: LoopId,
    },
    /// A loop vanished.
    Death {
        /// The id it had.
        id: LoopId,
    },
    /// A loop came apart. One of the parts may have its id.
    Split {
        /// The id of the loop that was.
        from: LoopId,
        /// The ids of the loops it became, two or more.
        into: &'a [LoopId],
    },
    /// Loops came together. The result may have one of their ids.
    Merge {
        /// The ids of the loops that were, two or more.
        from: &'a [LoopId],
        /// The id of the loop they became.
        into: LoopId,
    },
}

#[derive(Debug, Clone, Copy)]
enum Kind {
    Birth,
    Death,
    Split,
    Merge,
}

/// The events of one frame: deaths, splits, merges, births; each kind in the order of loops.
#[derive(Debug, Clone, Default)]
pub struct LoopEvents {
    events: Vec<(Kind, LoopId)>,
    /// Where the list of each event ends in `lists`.
    ends: Vec<usize>,
    lists: Vec<LoopId>,
}

impl LoopEvents {
    /// Number of events.
    pub fn len(&self) -> usize {
        self.events.len()
    }

    /// Whether nothing happened: every loop goes on.
    pub fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    /// The events.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = LoopEvent<'_>> {
        self.events.iter().enumerate().map(|(index, &(kind, id))| {
            let begin = if index == 0 { 0 } else { self.ends[index - 1] };
            let list = &self.lists[begin..self.ends[index]];
            match kind {
                Kind::Birth => LoopEvent::Birth { id },
                Kind::Death => LoopEvent::Death { id },
                Kind::Split => LoopEvent::Split { from: id, into: list },
                Kind::Merge => LoopEvent::Merge { from: list, into: id },
            }
        })
    }

    fn clear(&mut self) {
        self.events.clear();
        self.ends.clear();
        self.lists.clear();
    }

    fn push(&mut self, kind: Kind, id: LoopId, list: impl Iterator<Item = LoopId>) {
        self.lists.extend(list);
        self.ends.push(self.lists.len());
        self.events.push((kind, id));
    }
}

/// Ids of this frame's loops; passes them on from frame to frame.
#[derive(Debug, Clone, Default)]
pub struct LoopIdentities {
    ids: Vec<LoopId>,
    old_ids: Vec<LoopId>,
    events: LoopEvents,
    next: u64,
    /// Scratch: relations, each pair once; how many each loop has; which new loops have no id yet.
    relations: Vec<Relation>,
    children: Vec<u32>,
    parents: Vec<u32>,
    has_heir: Vec<bool>,
    is_named: Vec<bool>,
}

impl LoopIdentities {
    /// The id of each loop of the last frame that was passed in.
    pub fn ids(&self) -> &[LoopId] {
        &self.ids
    }

    /// What happened between the last two frames.
    pub fn events(&self) -> &LoopEvents {
        &self.events
    }

    /// Forgets all loops without an event. Ids are not used again.
    pub fn forget(&mut self) {
        self.ids.clear();
        self.events.clear();
    }

    /// Names the loops of a new frame, `loops` in number. `relations` lie between the loops of the last frame and of
    /// this one, in any order; of equal pairs the shared half-edges add up.
    ///
    /// O(loops + R log R) for R relations, no allocation once memory has grown.
    ///
    /// # Panics
    /// If a relation names a loop that does not exist.
    pub fn advance(&mut self, loops: usize, relations: &[Relation]) {
        std::mem::swap(&mut self.ids, &mut self.old_ids);
        self.events.clear();
        self.collect(loops, relations);
        self.inherit(loops);
        self.name_the_rest(loops);
        self.tell();
    }

    /// Adds up the relations and counts them for each loop.
    fn collect(&mut self, loops: usize, relations: &[Relation]) {
        self.relations.clear();
        self.relations.extend_from_slice(relations);
        self.relations.sort_unstable();
        self.relations.dedup_by(|later, kept| {
            let is_same = (later.old, later.new) == (kept.old, kept.new);
            if is_same {
                kept.shared += later.shared;
            }
            is_same
        });
        refill(&mut self.children, self.old_ids.len(), 0);
        refill(&mut self.parents, loops, 0);
        for relation in &self.relations {
            self.children[relation.old as usize] += 1;
            self.parents[relation.new as usize] += 1;
        }
    }

    /// Passes ids on, those that nobody else asks for first.
    fn inherit(&mut self, loops: usize) {
        refill(&mut self.ids, loops, LoopId(u64::MAX));
        refill(&mut self.is_named, loops, false);
        refill(&mut self.has_heir, self.old_ids.len(), false);
        let Self { ids, old_ids, relations, children, parents, has_heir, is_named, .. } = self;
        let is_sole = |r: &Relation| children[r.old as usize] == 1 && parents[r.new as usize] == 1;
        for relation in relations.iter().filter(|relation| is_sole(relation)) {
            ids[relation.new as usize] = old_ids[relation.old as usize];
            is_named[relation.new as usize] = true;
        }
        // The contested ones, the strongest first.
        relations.retain(|relation| !is_sole(relation));
        relations.sort_unstable_by_key(|r| (u32::MAX - r.shared, old_ids[r.old as usize], r.new));
        for relation in relations.iter() {
            let (old, new) = (relation.old as usize, relation.new as usize);
            if !has_heir[old] && !is_named[new] {
                (has_heir[old], is_named[new]) = (true, true);
                ids[new] = old_ids[old];
            }
        }
    }

    fn name_the_rest(&mut self, loops: usize) {
        for new in (0..loops).filter(|&new| !self.is_named[new]) {
            self.ids[new] = LoopId(self.next);
            self.next += 1;
        }
    }

    /// Tells the events; `relations` holds the contested ones by now.
    fn tell(&mut self) {
        let Self { ids, old_ids, events, relations, children, parents, .. } = self;
        for (&id, _) in old_ids.iter().zip(children.iter()).filter(|&(_, &count)| count == 0) {
            events.push(Kind::Death, id, std::iter::empty());
        }
        relations.sort_unstable_by_key(|relation| (relation.old, relation.new));
        for family in relations.chunk_by(|a, b| a.old == b.old).filter(|family| family.len() > 1) {
            let parts = family.iter().map(|relation| ids[relation.new as usize]);
            events.push(Kind::Split, old_ids[family[0].old as usize], parts);
        }
        relations.sort_unstable_by_key(|relation| (relation.new, relation.old));
        for family in relations.chunk_by(|a, b| a.new == b.new).filter(|family| family.len() > 1) {
            let sources = family.iter().map(|relation| old_ids[relation.old as usize]);
            events.push(Kind::Merge, ids[family[0].new as usize], sources);
        }
        for (&id, _) in ids.iter().zip(parents.iter()).filter(|&(_, &count)| count == 0) {
            events.push(Kind::Birth, id, std::iter::empty());
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let ids = size_of_val(self.ids.as_slice()) + size_of_val(self.old_ids.as_slice());
        let lists = size_of_val(self.events.lists.as_slice()) + size_of_val(self.events.events.as_slice());
        let counts = size_of_val(self.children.as_slice()) + size_of_val(self.parents.as_slice());
        ids + lists + counts + size_of_val(self.relations.as_slice()) + self.has_heir.len() + self.is_named.len()
    }
}

fn refill<T: Clone>(values: &mut Vec<T>, count: usize, value: T) {
    values.clear();
    values.resize(count, value);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn related(relations: &[[u32; 3]]) -> Vec<Relation> {
        relations.iter().map(|&[old, new, shared]| Relation { old, new, shared }).collect()
    }

    fn reported(identities: &LoopIdentities) -> String {
        identities
            .events()
            .iter()
            .map(|event| format!("{event:?}"))
            .collect::<Vec<_>>()
            .join("; ")
            .replace("LoopId", "")
    }

    fn ids(identities: &LoopIdentities) -> Vec<u64> {
        identities.ids().iter().map(|id| id.get()).collect()
    }

    #[test]
    fn ids_pass_to_the_child_that_shares_most() {
        let mut identities = LoopIdentities::default();
        identities.advance(2, &[]);
        assert_eq!(reported(&identities), "Birth { id: (0) }; Birth { id: (1) }");
        identities.advance(2, &related(&[[0, 1, 5], [1, 0, 7], [0, 1, 1]]));
        assert_eq!((ids(&identities), reported(&identities)), (vec![1, 0], String::new()));
        // Loop 0 (id 1) comes apart, the larger part second; loop 1 (id 0) dies.
        identities.advance(2, &related(&[[0, 0, 3], [0, 1, 4]]));
        assert_eq!(ids(&identities), [2, 1]);
        assert_eq!(reported(&identities), "Death { id: (0) }; Split { from: (1), into: [(2), (1)] }");
        // They come together again, sharing the same number: the lower id stays.
        identities.advance(1, &related(&[[0, 0, 6], [1, 0, 6]]));
        assert_eq!(ids(&identities), [1]);
        assert_eq!(reported(&identities), "Merge { from: [(2), (1)], into: (1) }");
        identities.forget();
        identities.advance(1, &[]);
        assert_eq!((ids(&identities), reported(&identities)), (vec![3], "Birth { id: (3) }".to_owned()));
    }

    proptest! {
        /// Ids are unique, and every id that begins or ends is accounted for exactly once.
        #[test]
        fn every_id_is_accounted_for(frames in prop::collection::vec(
            (0_usize..7, prop::collection::vec((any::<u32>(), any::<u32>(), 0_u32..4), 0..12)), 1..12,
        )) {
            let mut identities = LoopIdentities::default();
            let mut before: BTreeSet<LoopId> = BTreeSet::new();
            for (loops, pairs) in frames {
                let old = before.len() as u32;
                let pairs = pairs.into_iter().filter(|_| old > 0 && loops > 0);
                let relation = |(a, b, shared)| Relation { old: a % old, new: b % loops as u32, shared };
                identities.advance(loops, &pairs.map(relation).collect::<Vec<_>>());
                let now: BTreeSet<LoopId> = identities.ids().iter().copied().collect();
                prop_assert_eq!(now.len(), loops);
                let (mut begun, mut ended) = (Vec::new(), Vec::new());
                for event in identities.events().iter() {
                    match event {
                        LoopEvent::Birth { id } => begun.push(id),
                        LoopEvent::Death { id } => ended.push(id),
                        LoopEvent::Split { from, into } => {
                            prop_assert!(into.len() > 1 && before.contains(&from));
                            begun.extend(into.iter().filter(|id| !before.contains(id)));
                        }
                        LoopEvent::Merge { from, into } => {
                            prop_assert!(from.len() > 1 && now.contains(&into));
                            ended.extend(from.iter().filter(|id| !now.contains(id)));
                        }
                    }
                }
                let as_set = |ids: Vec<LoopId>| ids.into_iter().collect::<BTreeSet<_>>();
                prop_assert_eq!(as_set(begun), &now - &before);
                prop_assert_eq!(as_set(ended), &before - &now);
                before = now;
            }
        }
    }
}
