//! Typed element ids and arrays indexed by them, so that an array of edges cannot be indexed by a face.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

/// Marks ids of vertices.
#[derive(Debug)]
pub enum Vertex {}
/// Marks ids of edges.
#[derive(Debug)]
pub enum Edge {}
/// Marks ids of faces.
#[derive(Debug)]
pub enum Face {}
/// Marks ids of half-edges.
#[derive(Debug)]
pub enum HalfEdge {}

/// Index of an element of kind `K`, 32 bits wide.
pub struct Id<K>(u32, PhantomData<fn() -> K>);

/// Id of a vertex: its row in the file that the mesh came from.
pub type VertexId = Id<Vertex>;
/// Id of an edge: its rank among the edges sorted by `(lower vertex, higher vertex)`.
pub type EdgeId = Id<Edge>;
/// Id of a face: its row among the triangles.
pub type FaceId = Id<Face>;
/// Id of a half-edge: `3 * face + slot`, running from `triangle[slot]` to `triangle[(slot + 1) % 3]`.
pub type HalfEdgeId = Id<HalfEdge>;

impl<K> Id<K> {
    /// The id with this index.
    pub const fn new(index: u32) -> Self {
        Self(index, PhantomData)
    }

    /// The id with this index.
    ///
    /// # Panics
    /// If the index does not fit 32 bits; a validated mesh has no such element.
    pub fn from_usize(index: usize) -> Self {
        Self::new(u32::try_from(index).expect("a mesh holds fewer than 2^32 elements of each kind"))
    }

    /// The index as stored.
    pub const fn get(self) -> u32 {
        self.0
    }

    /// The index, for slices.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl HalfEdgeId {
    /// The half-edge that leaves corner `slot` (0, 1 or 2) of `face`.
    pub const fn of(face: FaceId, slot: u32) -> Self {
        Self::new(face.0 * 3 + slot)
    }

    /// The face on the left of the half-edge.
    pub const fn face(self) -> FaceId {
        FaceId::new(self.0 / 3)
    }

    /// The corner of [`face`](Self::face) that the half-edge leaves.
    pub const fn slot(self) -> u32 {
        self.0 % 3
    }

    /// The half-edge that follows around the same face.
    pub const fn next_in_face(self) -> Self {
        Self::new(if self.slot() == 2 { self.0 - 2 } else { self.0 + 1 })
    }
}

impl<K> Clone for Id<K> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<K> Copy for Id<K> {}
impl<K> PartialEq for Id<K> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}
impl<K> Eq for Id<K> {}
impl<K> PartialOrd for Id<K> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl<K> Ord for Id<K> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.cmp(&other.0)
    }
}
impl<K> Hash for Id<K> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.hash(state);
    }
}
impl<K> fmt::Debug for Id<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}
impl<K> fmt::Display for Id<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
impl<K> serde::Serialize for Id<K> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u32(self.0)
    }
}

/// One value for each element of kind `K`, indexed by [`Id<K>`].
pub struct PerElement<K, T>(Vec<T>, PhantomData<fn() -> K>);

/// One value a vertex.
pub type PerVertex<T> = PerElement<Vertex, T>;
/// One value an edge.
pub type PerEdge<T> = PerElement<Edge, T>;
/// One value a face.
pub type PerFace<T> = PerElement<Face, T>;
/// One value a half-edge.
pub type PerHalfEdge<T> = PerElement<HalfEdge, T>;

impl<K, T> PerElement<K, T> {
    /// The values in the order of their ids.
    pub fn as_slice(&self) -> &[T] {
        &self.0
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no element.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The ids, ascending.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = Id<K>> + use<K, T> {
        (0..self.0.len() as u32).map(Id::new)
    }

    /// Ids with their values, ascending.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (Id<K>, &T)> {
        self.0.iter().enumerate().map(|(index, value)| (Id::new(index as u32), value))
    }
}

impl<K, T> From<Vec<T>> for PerElement<K, T> {
    fn from(values: Vec<T>) -> Self {
        Self(values, PhantomData)
    }
}
impl<K, T> Index<Id<K>> for PerElement<K, T> {
    type Output = T;
    fn index(&self, id: Id<K>) -> &T {
        &self.0[id.index()]
    }
}
impl<K, T> IndexMut<Id<K>> for PerElement<K, T> {
    fn index_mut(&mut self, id: Id<K>) -> &mut T {
        &mut self.0[id.index()]
    }
}
impl<K, T: Clone> Clone for PerElement<K, T> {
    fn clone(&self) -> Self {
        Self(self.0.clone(), PhantomData)
    }
}
impl<K, T: fmt::Debug> fmt::Debug for PerElement<K, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
