//! The header of a PLY file: its encoding, its elements and their properties.

use crate::load::error::{Located, Problem, quote};
use crate::load::lines::{Lines, Words};

/// How numbers are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// Type of a stored number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Number {
    fn named(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"int64" => Self::I64,
            b"uint64" => Self::U64,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a binary number.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// What an element is to a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Vertices,
    Faces,
    Strips,
    Other,
}

/// An element: so many rows of the same properties.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) role: Role,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
    line: u64,
}

/// A property: one number per row, or a list of them.
#[derive(Debug)]
pub(super) struct Property {
    /// Type of the number, or of a list's numbers.
    pub(super) item: Number,
    /// Type of a list's length; `None` for a single number.
    pub(super) length: Option<Number>,
    /// Which coordinate of a vertex the number is.
    pub(super) axis: Option<usize>,
    /// Whether the list holds the corners of a face or strip.
    corners: bool,
}

impl Property {
    /// Type of the list's length, if the list holds corners.
    pub(super) fn corner_list(&self) -> Option<Number> {
        self.length.filter(|_| self.corners)
    }
}

/// A header that describes a mesh: vertices with three coordinates, faces with corners.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// How many vertices are promised.
    pub(super) vertices: u64,
}

impl Header {
    /// Reads up to `end_header`; the body begins with the next line.
    pub(super) fn read(lines: &mut Lines<'_>) -> Result<Self, Located> {
        if lines.next_line().map(<[u8]>::trim_ascii) != Some(b"ply") {
            return Err(Problem::expected("the word ply", b"").at_line(1));
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let line = lines.next_line().ok_or_else(|| Problem::expected("end_header", b"").at_line(lines.number()))?;
            let mut words = Words::new(line, lines.number());
            match words.word() {
                b"" | b"comment" | b"obj_info" => {}
                b"format" => encoding = Some(read_encoding(&mut words)?),
                b"element" => elements.push(read_element(&mut words)?),
                b"property" => {
                    let element = elements.last_mut();
                    let element = element.ok_or_else(|| {
                        Problem::expected("an element before its properties", line).at_line(lines.number())
                    })?;
                    element.properties.push(read_property(element.role, &mut words)?);
                }
                b"end_header" => break,
                _ => return Err(Problem::expected("a header row of PLY", line).at_line(lines.number())),
            }
        }
        let encoding = encoding.ok_or_else(|| Problem::expected("a format row in the header", b""))?;
        let vertices = check(&elements)?;
        Ok(Self { encoding, elements, vertices })
    }
}

fn read_encoding(words: &mut Words<'_>) -> Result<Encoding, Located> {
    match words.word() {
        b"ascii" => Ok(Encoding::Text),
        b"binary_little_endian" => Ok(Encoding::LittleEndian),
        b"binary_big_endian" => Ok(Encoding::BigEndian),
        other => {
            let expected = "the format ascii, binary_little_endian or binary_big_endian";
            Err(Problem::expected(expected, other).at_line(words.line()))
        }
    }
}

fn read_element(words: &mut Words<'_>) -> Result<Element, Located> {
    const EXPECTED: &str = "the number of rows of an element";
    let name = words.word();
    let role = match name {
        b"vertex" => Role::Vertices,
        b"face" => Role::Faces,
        b"tristrips" => Role::Strips,
        _ => Role::Other,
    };
    let count = words.count(EXPECTED)?;
    Ok(Element { name: quote(name), role, count, properties: Vec::new(), line: words.line() })
}

fn read_property(role: Role, words: &mut Words<'_>) -> Result<Property, Located> {
    let number = |words: &mut Words<'_>| {
        let name = words.word();
        Number::named(name).ok_or_else(|| Problem::expected("a number type of PLY", name).at_line(words.line()))
    };
    let mut length = None;
    if words.peek() == b"list" {
        words.word();
        length = Some(number(words)?);
    }
    let item = number(words)?;
    let name = words.word();
    let axis = [b"x", b"y", b"z"].iter().position(|&axis| axis == name);
    let axis = axis.filter(|_| role == Role::Vertices && length.is_none());
    let corners = matches!(role, Role::Faces | Role::Strips) && matches!(name, b"vertex_indices" | b"vertex_index");
    if length.is_some_and(|length| !length.is_integer()) || (corners && !item.is_integer()) {
        let what = "a list with a floating-point length or vertex number".to_owned();
        return Err(Problem::Unsupported { what, mend: "export the list with integers" }.at_line(words.line()));
    }
    Ok(Property { item, length, axis, corners })
}

/// Checks that the elements describe a mesh; returns how many vertices they promise.
fn check(elements: &[Element]) -> Result<u64, Located> {
    let mut vertices = None;
    for element in elements {
        match element.role {
            Role::Vertices => {
                let axes = |axis| element.properties.iter().filter(|p| p.axis == Some(axis)).count();
                if [0, 1, 2].map(axes) != [1, 1, 1] {
                    let expected = "one property each of x, y and z in element vertex";
                    return Err(Problem::expected(expected, b"").at_line(element.line));
                }
                if vertices.replace(element.count).is_some() {
                    return Err(Problem::expected("one element vertex", b"a second one").at_line(element.line));
                }
            }
            Role::Faces | Role::Strips => {
                if element.count > 0 && !element.properties.iter().any(|p| p.corner_list().is_some()) {
                    let expected = "a property list vertex_indices in element face or tristrips";
                    return Err(Problem::expected(expected, b"").at_line(element.line));
                }
            }
            Role::Other => {}
        }
    }
    vertices.ok_or_else(|| Problem::expected("an element vertex in the header", b"").into())
}
