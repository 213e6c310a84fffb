//! Groups: a number that says what follows, and what follows, a line each.

use super::super::decimal::number;
use silhouette_core::glam::DVec2;
use std::fmt::Display;
use std::io::{self, Write};

/// Writes groups, and gives out handles.
pub struct Groups<'a> {
    mm: f64,
    height: f64,
    next_handle: u32,
    out: &'a mut dyn Write,
}

/// The first handle that is given out; those below are the frame's.
pub const FIRST_HANDLE: u32 = 0x100;

impl<'a> Groups<'a> {
    /// For a page of this height in its own unit, `mm` millimetres each.
    pub fn new(mm: f64, height: f64, out: &'a mut dyn Write) -> Self {
        Self { mm, height, next_handle: FIRST_HANDLE, out }
    }

    /// A group.
    pub fn put(&mut self, code: u16, value: impl Display) -> io::Result<()> {
        write!(self.out, "{code}\n{value}\n")
    }

    /// Several groups.
    pub fn put_all(&mut self, groups: &[(u16, &str)]) -> io::Result<()> {
        groups.iter().try_for_each(|(code, value)| self.put(*code, value))
    }

    /// A place on the page, in millimetres, y up: two groups, of which `code` is the first one's.
    pub fn put_place(&mut self, code: u16, place: DVec2) -> io::Result<()> {
        self.put(code, number(place.x * self.mm))?;
        self.put(code + 10, number((self.height - place.y) * self.mm))
    }

    /// A length on the page in millimetres.
    pub fn put_length(&mut self, code: u16, length: f64) -> io::Result<()> {
        self.put(code, number(length * self.mm))
    }

    /// The handle of a new object.
    pub fn put_handle(&mut self) -> io::Result<()> {
        let handle = self.next_handle;
        self.next_handle += 1;
        self.put(5, format_args!("{handle:X}"))
    }

    /// Begins a section.
    pub fn section(&mut self, name: &str) -> io::Result<()> {
        self.put_all(&[(0, "SECTION"), (2, name)])
    }

    /// Ends it.
    pub fn end_section(&mut self) -> io::Result<()> {
        self.put(0, "ENDSEC")
    }
}
