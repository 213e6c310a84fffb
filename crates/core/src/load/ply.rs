//! PLY, the Stanford polygon format: text, binary little-endian and binary big-endian.
//!
//! Read are the properties `x`, `y`, `z` of `vertex`, of any number type, and the list `vertex_indices` (or
//! `vertex_index`), of any integer types, of `face` and of `tristrips`, where -1 ends a strip and begins the next.
//! Every other property and element is skipped. Rows of text may be broken or share lines, unless they hold more numbers
//! than their element has properties.

mod header;
mod values;

use self::header::{Element, Encoding, Header, Property, Role};
use self::values::{BinaryValues, TextValues, Values};
use super::assembly::{Assembly, LabelledMesh, check_promise, vertex_id};
use super::error::Located;
use super::lines::Lines;
use super::placing::Placing;
use super::polygon::strip;
use super::rows::read_rows;
use super::steps::Steps;
use glam::Vec3;

/// Reads a PLY file. O(bytes).
pub(super) fn read(bytes: &[u8], placing: Placing, steps: &mut Steps<'_>) -> Result<LabelledMesh, Located> {
    let mut lines = Lines::new(bytes)?;
    let header = Header::read(&mut lines)?;
    match header.encoding {
        Encoding::Text => read_rows(&lines, false, |rows, promised| {
            *promised = header.elements.iter().fold(0, |sum, element| element.count.saturating_add(sum));
            read_elements(&header, TextValues::new(rows), placing, steps)
        }),
        Encoding::LittleEndian => {
            read_elements(&header, BinaryValues::<false>::new(bytes, lines.offset()), placing, steps)
        }
        Encoding::BigEndian => read_elements(&header, BinaryValues::<true>::new(bytes, lines.offset()), placing, steps),
    }
}

fn read_elements<V: Values>(
    header: &Header,
    mut values: V,
    placing: Placing,
    steps: &mut Steps<'_>,
) -> Result<LabelledMesh, Located> {
    let mut body = Body { assembly: Assembly::new(placing), corners: Vec::new(), vertices: header.vertices };
    for element in &header.elements {
        let least = V::least_row(element);
        if least == 0 {
            // Rows without properties take no bytes, however many are promised.
            continue;
        }
        let what = format!("rows of {}", element.name);
        let rows = check_promise(&what, element.count, least, values.remaining());
        let rows = rows.map_err(|problem| values.locate(problem))?;
        match element.role {
            Role::Vertices => body.assembly.positions.reserve_exact(rows),
            // A triangle takes no fewer bytes than its row: rows of fewer than three corners become none.
            Role::Faces => body.assembly.triangles.reserve(rows.min(values.remaining() / V::LEAST_TRIANGLE)),
            Role::Strips | Role::Other => {}
        }
        for row in 0..rows {
            values.begin_row(&what, element.count, row as u64)?;
            match element.role {
                Role::Vertices => body.vertex(element, &mut values)?,
                Role::Faces => body.face(element, row as u64, &mut values)?,
                Role::Strips => body.strips(element, row as u64, &mut values)?,
                Role::Other => skip_row(element, &mut values)?,
            }
            steps.reach(values.offset())?;
        }
    }
    values.finish()?;
    body.assembly.finish()
}

/// The mesh under construction, and what its rows need.
struct Body {
    assembly: Assembly,
    /// Corners of the face or strip being read.
    corners: Vec<u32>,
    /// Promised by the header, so that faces may stand before vertices.
    vertices: u64,
}

impl Body {
    fn vertex<V: Values>(&mut self, element: &Element, values: &mut V) -> Result<(), Located> {
        let (vertex, mut position) = (self.assembly.positions.len(), Vec3::ZERO);
        for property in &element.properties {
            match property.axis {
                Some(axis) => {
                    position[axis] = values.coordinate(property.item, axis, vertex, &mut self.assembly.placing)?;
                }
                None => skip(property, values)?,
            }
        }
        self.assembly.positions.push(position);
        Ok(())
    }

    fn face<V: Values>(&mut self, element: &Element, face: u64, values: &mut V) -> Result<(), Located> {
        for property in &element.properties {
            let Some(length) = property.corner_list() else {
                skip(property, values)?;
                continue;
            };
            self.corners.clear();
            for _ in 0..values.list_length(length, property.item)? {
                let index = values.integer(property.item)?;
                self.corners.push(vertex_id(index, face, self.vertices).map_err(|problem| values.locate(problem))?);
            }
            self.assembly.polygon(&self.corners, || values.place());
        }
        Ok(())
    }

    fn strips<V: Values>(&mut self, element: &Element, row: u64, values: &mut V) -> Result<(), Located> {
        for property in &element.properties {
            let Some(length) = property.corner_list() else {
                skip(property, values)?;
                continue;
            };
            self.corners.clear();
            for _ in 0..values.list_length(length, property.item)? {
                match values.integer(property.item)? {
                    -1 => {
                        strip(&self.corners, &mut self.assembly.triangles);
                        self.corners.clear();
                    }
                    index => {
                        let id = vertex_id(index, row, self.vertices).map_err(|problem| values.locate(problem))?;
                        self.corners.push(id);
                    }
                }
            }
            strip(&self.corners, &mut self.assembly.triangles);
        }
        Ok(())
    }
}

fn skip_row<V: Values>(element: &Element, values: &mut V) -> Result<(), Located> {
    element.properties.iter().try_for_each(|property| skip(property, values))
}

fn skip<V: Values>(property: &Property, values: &mut V) -> Result<(), Located> {
    let count = match property.length {
        Some(length) => values.list_length(length, property.item)?,
        None => 1,
    };
    values.skip(property.item, count)
}
