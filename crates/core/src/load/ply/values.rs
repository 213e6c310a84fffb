//! The numbers of a PLY body, stored as text or in binary.

use super::header::{Element, Number};
use crate::load::error::{Located, Place, Problem, quote};
use crate::load::placing::Placing;
use crate::load::rows::Rows;

/// A body read number by number, in the order of the header's properties.
pub(super) trait Values {
    /// Least bytes of a face row that is taken.
    const LEAST_TRIANGLE: usize;

    /// Least bytes of a row; 0 for an element without properties.
    fn least_row(element: &Element) -> u64;
    /// Goes to the next row of `what`, of which `done` out of `promised` have been read.
    fn begin_row(&mut self, what: &str, promised: u64, done: u64) -> Result<(), Located>;
    /// The next number as the coordinate of `vertex` along an axis.
    fn coordinate(&mut self, number: Number, axis: usize, vertex: usize, placing: &mut Placing)
    -> Result<f32, Located>;
    /// The next number as a whole number.
    fn integer(&mut self, number: Number) -> Result<i64, Located>;
    /// The next number as the length of a list of `item`s, which the remaining bytes can hold.
    fn list_length(&mut self, number: Number, item: Number) -> Result<u64, Located>;
    /// Passes over `count` numbers.
    fn skip(&mut self, number: Number, count: u64) -> Result<(), Located>;
    /// Bytes not read yet.
    fn remaining(&self) -> usize;
    /// Bytes read, the header included.
    fn offset(&self) -> usize;
    /// Where reading has come to.
    fn place(&self) -> Place;
    /// Refuses what is left behind the last row, if nothing may be.
    fn finish(self) -> Result<(), Located>;

    /// Puts a problem where reading has come to.
    fn locate(&self, problem: Problem) -> Located {
        Located { place: Some(self.place()), problem }
    }
}

const LENGTH: &str = "the length of a list";

/// Numbers as text.
pub(super) struct TextValues<'a> {
    rows: Rows<'a>,
}

impl<'a> TextValues<'a> {
    pub(super) fn new(rows: Rows<'a>) -> Self {
        Self { rows }
    }
}

impl Values for TextValues<'_> {
    /// `3 0 0 0` and the line end.
    const LEAST_TRIANGLE: usize = 8;

    fn least_row(element: &Element) -> u64 {
        // A digit and what separates it from the next.
        2 * element.properties.len() as u64
    }

    fn begin_row(&mut self, what: &str, promised: u64, done: u64) -> Result<(), Located> {
        if self.rows.next_row() {
            return Ok(());
        }
        Err(self.locate(Problem::Promise { what: what.to_owned(), promised, possible: done }))
    }

    fn coordinate(
        &mut self,
        _number: Number,
        axis: usize,
        vertex: usize,
        placing: &mut Placing,
    ) -> Result<f32, Located> {
        self.rows.words().coordinate(axis, vertex, placing)
    }

    fn integer(&mut self, _number: Number) -> Result<i64, Located> {
        self.rows.words().integer("a vertex number")
    }

    fn list_length(&mut self, _number: Number, _item: Number) -> Result<u64, Located> {
        self.rows.words().count(LENGTH)
    }

    fn skip(&mut self, _number: Number, count: u64) -> Result<(), Located> {
        for _ in 0..count {
            if self.rows.words().word().is_empty() {
                return Err(self.locate(Problem::expected("a number for each property", b"")));
            }
        }
        Ok(())
    }

    fn remaining(&self) -> usize {
        self.rows.remaining()
    }

    fn offset(&self) -> usize {
        self.rows.offset()
    }

    fn place(&self) -> Place {
        self.rows.place()
    }

    fn finish(self) -> Result<(), Located> {
        self.rows.finish()
    }
}

/// Numbers in binary, without any gap.
pub(super) struct BinaryValues<'a, const BIG_ENDIAN: bool> {
    bytes: &'a [u8],
    offset: usize,
}

impl<'a, const BIG_ENDIAN: bool> BinaryValues<'a, BIG_ENDIAN> {
    /// Reads the bytes from `offset` on.
    pub(super) fn new(bytes: &'a [u8], offset: usize) -> Self {
        Self { bytes, offset }
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], Located> {
        let Some(bytes) = self.bytes[self.offset..].first_chunk::<N>() else {
            return Err(self.truncated(N as u64));
        };
        self.offset += N;
        let mut bytes = *bytes;
        if BIG_ENDIAN {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn truncated(&self, needed: u64) -> Located {
        let found = self.remaining() as u64;
        self.locate(Problem::Truncated { within: "a row of an element", needed, found })
    }
}

impl<const BIG_ENDIAN: bool> Values for BinaryValues<'_, BIG_ENDIAN> {
    /// A length and three vertex numbers of a byte each.
    const LEAST_TRIANGLE: usize = 4;

    fn least_row(element: &Element) -> u64 {
        element.properties.iter().map(|p| p.length.unwrap_or(p.item).size() as u64).sum()
    }

    fn begin_row(&mut self, _what: &str, _promised: u64, _done: u64) -> Result<(), Located> {
        Ok(())
    }

    fn coordinate(
        &mut self,
        number: Number,
        axis: usize,
        vertex: usize,
        placing: &mut Placing,
    ) -> Result<f32, Located> {
        let start = self.offset;
        let value = match number {
            Number::F32 => f64::from(f32::from_le_bytes(self.take()?)),
            Number::F64 => f64::from_le_bytes(self.take()?),
            Number::U64 => return Ok(placing.place_integer(axis, u64::from_le_bytes(self.take()?).into())),
            _ => return Ok(placing.place_integer(axis, self.integer(number)?.into())),
        };
        // The conversion rounds to nearest; magnitudes beyond 32 bits become infinite and are refused here.
        let placed = placing.place(axis, value);
        let is_finite = placed.is_finite() && (value as f32).is_finite();
        let not_finite = || Problem::NotFinite { vertex: vertex as u64, value: quote(value.to_string().as_bytes()) };
        if is_finite { Ok(placed) } else { Err(not_finite().at_byte(start)) }
    }

    fn integer(&mut self, number: Number) -> Result<i64, Located> {
        Ok(match number {
            Number::I8 => i64::from(i8::from_le_bytes(self.take()?)),
            Number::U8 => i64::from(u8::from_le_bytes(self.take()?)),
            Number::I16 => i64::from(i16::from_le_bytes(self.take()?)),
            Number::U16 => i64::from(u16::from_le_bytes(self.take()?)),
            Number::I32 => i64::from(i32::from_le_bytes(self.take()?)),
            Number::U32 => i64::from(u32::from_le_bytes(self.take()?)),
            Number::I64 => i64::from_le_bytes(self.take()?),
            Number::U64 => {
                let value = u64::from_le_bytes(self.take()?);
                i64::try_from(value).map_err(|_| {
                    self.locate(Problem::expected("a whole number below 2^63", value.to_string().as_bytes()))
                })?
            }
            Number::F32 | Number::F64 => return Err(self.locate(Problem::expected("an integer type", b"a float type"))),
        })
    }

    fn list_length(&mut self, number: Number, item: Number) -> Result<u64, Located> {
        let start = self.offset;
        let length = self.integer(number)?;
        let Ok(length) = u64::try_from(length) else {
            return Err(
                Problem::Expected { expected: LENGTH, found: quote(length.to_string().as_bytes()) }.at_byte(start)
            );
        };
        let needed = length.saturating_mul(item.size() as u64);
        if needed > self.remaining() as u64 {
            return Err(self.truncated(needed));
        }
        Ok(length)
    }

    fn skip(&mut self, number: Number, count: u64) -> Result<(), Located> {
        let needed = count.saturating_mul(number.size() as u64);
        if needed > self.remaining() as u64 {
            return Err(self.truncated(needed));
        }
        self.offset += needed as usize;
        Ok(())
    }

    fn remaining(&self) -> usize {
        self.bytes.len() - self.offset
    }

    fn offset(&self) -> usize {
        self.offset
    }

    fn place(&self) -> Place {
        Place::Byte(self.offset as u64)
    }

    fn finish(self) -> Result<(), Located> {
        Ok(())
    }
}
