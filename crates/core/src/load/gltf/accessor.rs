//! Accessors: typed numbers in buffers, dense or sparse, with each offset checked before it is followed.

use super::buffers::Buffers;
use super::dangling::dangling;
use crate::load::assembly::check_promise;
use crate::load::error::Problem;
use ::gltf::json::accessor::{Accessor, ComponentType, Type};
use ::gltf::json::buffer::View;
use ::gltf::json::validation::Checked;
use ::gltf::json::{Index, Root};

/// The elements of a `VEC3` accessor of 32-bit floats, or of the integers that `KHR_mesh_quantization` allows.
pub(super) fn positions(
    root: &Root,
    buffers: &mut Buffers<'_>,
    index: Index<Accessor>,
) -> Result<Vec<[f32; 3]>, Problem> {
    floats(root, buffers, index, "positions of type VEC3")
}

/// The elements of a `VEC3`, `VEC4` or `MAT4` accessor, by their number of components; normalised integers as fractions. `expected`
/// names them in messages.
pub(super) fn floats<const N: usize>(
    root: &Root,
    buffers: &mut Buffers<'_>,
    index: Index<Accessor>,
    expected: &'static str,
) -> Result<Vec<[f32; N]>, Problem> {
    let accessor = find(root, index)?;
    let shape = match N {
        3 => Type::Vec3,
        4 => Type::Vec4,
        _ => Type::Mat4,
    };
    let component = component_of(accessor, shape, expected)?;
    let size = component.size();
    let scale = if accessor.normalized { component } else { ComponentType::F32 };
    let decode = |bytes: &[u8]| std::array::from_fn(|axis| normalize(number(&bytes[axis * size..], component), scale));
    elements(root, buffers, accessor, N * size, [0.0; N], decode)
}

/// Checks that a `VEC3` accessor of 32-bit floats or signed integers has the bytes of its elements; yields their number.
pub(super) fn check_normals(root: &Root, buffers: &mut Buffers<'_>, index: Index<Accessor>) -> Result<u64, Problem> {
    let accessor = find(root, index)?;
    let component = component_of(accessor, Type::Vec3, "silhouetteNormals of type VEC3")?;
    if !matches!(component, ComponentType::I8 | ComponentType::I16 | ComponentType::F32) {
        return Err(Problem::expected("silhouetteNormals of signed integers or floats", b"another type"));
    }
    Ok(elements(root, buffers, accessor, 3 * component.size(), (), |_| ())?.len() as u64)
}

/// The elements of a `SCALAR` accessor of bytes.
pub(super) fn bytes(root: &Root, buffers: &mut Buffers<'_>, index: Index<Accessor>) -> Result<Vec<u8>, Problem> {
    let accessor = find(root, index)?;
    if component_of(accessor, Type::Scalar, "visibility of type SCALAR")? != ComponentType::U8 {
        return Err(Problem::expected("visibility of unsigned bytes", b"another type"));
    }
    elements(root, buffers, accessor, 1, 0, |bytes| bytes[0])
}

/// The index that ends a line string in an accessor: the largest of its type.
pub(super) fn restart(root: &Root, index: Index<Accessor>) -> Result<u32, Problem> {
    let component = component_of(find(root, index)?, Type::Scalar, "indices of type SCALAR")?;
    Ok(u32::MAX >> (32 - 8 * component.size()))
}

/// The elements of a `SCALAR` accessor of unsigned integers.
pub(super) fn indices(root: &Root, buffers: &mut Buffers<'_>, index: Index<Accessor>) -> Result<Vec<u32>, Problem> {
    let accessor = find(root, index)?;
    let component = component_of(accessor, Type::Scalar, "indices of type SCALAR")?;
    if !is_unsigned(component) {
        return Err(Problem::expected("indices of an unsigned integer type", b"another type"));
    }
    elements(root, buffers, accessor, component.size(), 0, |bytes| unsigned(bytes, component))
}

/// How many elements the accessor promises.
pub(super) fn count(root: &Root, index: Index<Accessor>) -> Result<u64, Problem> {
    Ok(find(root, index)?.count.0)
}

/// How many elements the accessor has, or, where it promises more than its bytes can hold, how many they can. Those without bytes count
/// as they are promised, sparse ones on top.
pub(super) fn most_elements(root: &Root, buffers: &mut Buffers<'_>, index: Index<Accessor>) -> Result<u64, Problem> {
    let accessor = find(root, index)?;
    let dense = match accessor.buffer_view {
        Some(view) => accessor.count.0.min(buffers.get(root, find_view(root, view)?.buffer)?.len() as u64),
        None => accessor.count.0,
    };
    Ok(dense.saturating_add(accessor.sparse.as_ref().map_or(0, |sparse| sparse.count.0)))
}

fn find(root: &Root, index: Index<Accessor>) -> Result<&Accessor, Problem> {
    root.get(index).ok_or_else(|| dangling("accessors", root.accessors.len()))
}

fn find_view(root: &Root, index: Index<View>) -> Result<&View, Problem> {
    root.get(index).ok_or_else(|| dangling("bufferViews", root.buffer_views.len()))
}

fn component_of(accessor: &Accessor, shape: Type, expected: &'static str) -> Result<ComponentType, Problem> {
    match (accessor.component_type, accessor.type_) {
        (Checked::Valid(component), Checked::Valid(found)) if found == shape => Ok(component.0),
        _ => Err(Problem::expected(expected, b"another type")),
    }
}

fn is_unsigned(component: ComponentType) -> bool {
    matches!(component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32)
}

/// The accessor's elements: those of its buffer view, or `zero`s, with the sparse ones put in their places.
fn elements<T: Copy>(
    root: &Root,
    buffers: &mut Buffers<'_>,
    accessor: &Accessor,
    size: usize,
    zero: T,
    decode: impl Fn(&[u8]) -> T,
) -> Result<Vec<T>, Problem> {
    let promised = accessor.count.0;
    let replaced = replaced(root, buffers, accessor, size, &decode)?;
    let mut values = match accessor.buffer_view {
        Some(view) => {
            let offset = accessor.byte_offset.unwrap_or_default().0;
            Strided::new(root, buffers, view, offset, promised, size)?.iter().map(decode).collect()
        }
        // Nothing but the promise stands for these: take it only as far as the buffers in use could have held it.
        None => vec![zero; check_promise("elements without a bufferView", promised, 1, buffers.bytes())?],
    };
    for (place, value) in replaced {
        let Some(slot) = values.get_mut(place as usize) else {
            let found = format!("index {place} of {promised} elements");
            return Err(Problem::Expected { expected: "sparse indices within the accessor", found });
        };
        *slot = value;
    }
    Ok(values)
}

/// The sparse elements of an accessor with their places; none where it is dense.
fn replaced<T>(
    root: &Root,
    buffers: &mut Buffers<'_>,
    accessor: &Accessor,
    size: usize,
    decode: impl Fn(&[u8]) -> T,
) -> Result<Vec<(u32, T)>, Problem> {
    let Some(sparse) = &accessor.sparse else { return Ok(Vec::new()) };
    let Checked::Valid(component) = sparse.indices.component_type else {
        return Err(Problem::expected("sparse indices of an unsigned integer type", b"another type"));
    };
    let (places, items, count) = (&sparse.indices, &sparse.values, sparse.count.0);
    let places = Strided::new(root, buffers, places.buffer_view, places.byte_offset.0, count, component.0.size())?;
    let places: Vec<u32> = places.iter().map(|bytes| unsigned(bytes, component.0)).collect();
    let items = Strided::new(root, buffers, items.buffer_view, items.byte_offset.0, count, size)?;
    Ok(places.into_iter().zip(items.iter().map(decode)).collect())
}

/// Elements of the same size at equal distances, all of them within their buffer.
struct Strided<'b> {
    bytes: &'b [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'b> Strided<'b> {
    fn new(
        root: &Root,
        buffers: &'b mut Buffers<'_>,
        view: Index<View>,
        offset: u64,
        count: u64,
        size: usize,
    ) -> Result<Self, Problem> {
        let view = find_view(root, view)?;
        let stride = view.byte_stride.map_or(size, |stride| stride.0);
        if stride < size {
            let found = format!("a byteStride of {stride}");
            return Err(Problem::Expected { expected: "elements that do not overlap", found });
        }
        let start = view.byte_offset.unwrap_or_default().0;
        let bytes = buffers.get(root, view.buffer)?;
        let end = start.checked_add(view.byte_length.0).filter(|&end| end <= bytes.len() as u64);
        let viewed = match end {
            Some(end) => &bytes[start as usize..end as usize],
            None => {
                let (needed, found) = (start.saturating_add(view.byte_length.0), bytes.len() as u64);
                return Err(Problem::Truncated { within: "a bufferView", needed, found });
            }
        };
        let needed = match count.checked_sub(1) {
            Some(before_last) => {
                offset.saturating_add(before_last.saturating_mul(stride as u64)).saturating_add(size as u64)
            }
            None => 0,
        };
        if needed > viewed.len() as u64 {
            return Err(Problem::Truncated { within: "an accessor", needed, found: viewed.len() as u64 });
        }
        let offset = if count == 0 { viewed.len() } else { offset as usize };
        Ok(Self { bytes: &viewed[offset..], stride, size, count: count as usize })
    }

    fn iter(&self) -> impl Iterator<Item = &'b [u8]> + use<'b> {
        let (bytes, stride, size) = (self.bytes, self.stride, self.size);
        (0..self.count).map(move |i| &bytes[i * stride..][..size])
    }
}

/// A little-endian number at the start of `bytes`, exactly where 32-bit floats can; positions have no other types.
fn number(bytes: &[u8], component: ComponentType) -> f32 {
    match component {
        ComponentType::I8 => f32::from(i8::from_le_bytes(first(bytes))),
        ComponentType::U8 => f32::from(u8::from_le_bytes(first(bytes))),
        ComponentType::I16 => f32::from(i16::from_le_bytes(first(bytes))),
        ComponentType::U16 => f32::from(u16::from_le_bytes(first(bytes))),
        ComponentType::U32 => u32::from_le_bytes(first(bytes)) as f32,
        ComponentType::F32 => f32::from_le_bytes(first(bytes)),
    }
}

/// The integer of a normalised accessor as a fraction of its type's range; other numbers as they are.
fn normalize(value: f32, scale: ComponentType) -> f32 {
    match scale {
        ComponentType::I8 => (value / f32::from(i8::MAX)).max(-1.0),
        ComponentType::U8 => value / f32::from(u8::MAX),
        ComponentType::I16 => (value / f32::from(i16::MAX)).max(-1.0),
        ComponentType::U16 => value / f32::from(u16::MAX),
        ComponentType::U32 | ComponentType::F32 => value,
    }
}

/// A little-endian unsigned integer at the start of `bytes`; indices have no other types.
fn unsigned(bytes: &[u8], component: ComponentType) -> u32 {
    match component.size() {
        1 => u32::from(u8::from_le_bytes(first(bytes))),
        2 => u32::from(u16::from_le_bytes(first(bytes))),
        _ => u32::from_le_bytes(first(bytes)),
    }
}

/// The first bytes of an element that is known to be long enough.
fn first<const N: usize>(bytes: &[u8]) -> [u8; N] {
    std::array::from_fn(|i| bytes[i])
}
