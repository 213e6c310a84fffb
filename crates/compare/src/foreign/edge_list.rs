//! Lines as JSON: pairs of vertices, polylines in pixels, and what the commands `extract` and `lines` write.
//!
//! | key | holds |
//! |---|---|
//! | `"edges": [[a,b]...]` | pairs of vertices of the mesh, from 0, in any order: silhouette edges, seen or not |
//! | `"polylines": [[[x,y]...]...]` | lines in pixels, origin at the top left of the picture, centres of pixels at .5; one that is closed repeats its first point |
//! | `"chains": [{"pixels": [[x,y]...], "closed", "visible", "kind", "handles"}...]` | the same as `lines` writes them; what is not visible is left out, and `handles` are those of cubic Bezier curves |
//!
//! A document has one of them. What else it says about itself is checked where it is there: `"size": [w,h]` of the picture,
//! `"mesh": {"vertices", "triangles"}`, `"camera"` as `lines` and `"viewpoint"` as `extract` writes it. Everything else is ignored.

use super::Drawing;
use super::error::ForeignFault;
use super::trace::{Frame, Tracer};
use glam::{DVec2, DVec3};
use serde::Deserialize;
use std::collections::BTreeMap;

/// What a document holds.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeList {
    /// The lines.
    pub drawing: Drawing,
    /// What it says about where it comes from.
    pub claims: Claims,
    /// What its user should know.
    pub notes: Vec<String>,
}

/// What a document says about where it comes from, as far as it does.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Claims {
    /// The method that made it.
    pub method: Option<String>,
    /// The mesh that it was made of.
    pub mesh: Option<ClaimedMesh>,
    /// The camera that it was made by.
    pub camera: Option<ClaimedCamera>,
    /// What facing depended on.
    pub viewpoint: Option<ClaimedViewpoint>,
}

/// A mesh, as far as a document says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub struct ClaimedMesh {
    /// Number of vertices.
    pub vertices: Option<usize>,
    /// Number of triangles.
    pub triangles: Option<usize>,
}

/// A camera in the coordinates of the mesh's file.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct ClaimedCamera {
    /// Where it is.
    pub eye: DVec3,
    /// What it looks at.
    pub target: DVec3,
    /// How it projects.
    pub projection: ClaimedProjection,
}

/// How a camera projects.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ClaimedProjection {
    /// From an eye.
    Perspective {
        /// Vertical field of view in radians.
        fov_y_rad: f64,
    },
    /// In parallel.
    Orthographic {
        /// Units from the top to the bottom of the picture.
        height: f64,
    },
}

/// What facing depends on.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ClaimedViewpoint {
    /// An eye.
    Perspective {
        /// Where it is, in the coordinates of the mesh's file.
        eye: DVec3,
    },
    /// A direction.
    Orthographic {
        /// Towards the viewer.
        toward_viewer: DVec3,
    },
}

#[derive(Deserialize)]
#[serde(expecting = "an object with \"polylines\", \"edges\" or \"chains\"")]
struct Document {
    method: Option<String>,
    mesh: Option<ClaimedMesh>,
    camera: Option<ClaimedCamera>,
    viewpoint: Option<ClaimedViewpoint>,
    size: Option<[u32; 2]>,
    edges: Option<Vec<[u32; 2]>>,
    polylines: Option<Vec<Vec<DVec2>>>,
    chains: Option<Vec<ChainDocument>>,
}

#[derive(Deserialize)]
struct ChainDocument {
    pixels: Vec<DVec2>,
    #[serde(default)]
    closed: bool,
    #[serde(default = "yes")]
    visible: bool,
    #[serde(default)]
    kind: Option<String>,
    #[serde(default)]
    handles: Vec<[DVec2; 2]>,
}

fn yes() -> bool {
    true
}

/// Kinds of chains that the truth holds too, as `lines` names them.
const TRUE_KINDS: [&str; 3] = ["silhouette", "boundary", "curve"];

/// Reads a document. O(bytes).
///
/// # Errors
/// [`ForeignFault`] with the line and column, or the key and index, of what does not fit.
pub fn read(text: &[u8], frame: Frame) -> Result<EdgeList, ForeignFault> {
    let document: Document = serde_json::from_slice(text).map_err(|error| form(text, &error))?;
    let Document { method, mesh, camera, viewpoint, size, edges, polylines, chains } = document;
    if let Some(size) = size.filter(|size| *size != frame.size) {
        let found = format!("size: is {} x {} pixels", size[0], size[1]);
        return Err(ForeignFault::WrongSize { found, wanted: frame.size });
    }
    let mut notes = Vec::new();
    let drawing = match (edges, polylines, chains) {
        (Some(edges), None, None) => Drawing::Edges(edges),
        (None, Some(polylines), None) => Drawing::Lines(trace_polylines(&polylines, frame)?),
        (None, None, Some(chains)) => Drawing::Lines(trace_chains(&chains, frame, &mut notes)?),
        (edges, polylines, chains) => {
            let there = [("edges", edges.is_some()), ("polylines", polylines.is_some()), ("chains", chains.is_some())];
            let named: Vec<&str> = there.iter().filter(|(_, is_there)| *is_there).map(|(key, _)| *key).collect();
            let found = if named.is_empty() {
                "it has none of these".to_owned()
            } else {
                format!("has {}", named.join(" and "))
            };
            return Err(ForeignFault::UnknownKeys { found });
        }
    };
    Ok(EdgeList { drawing, claims: Claims { method, mesh, camera, viewpoint }, notes })
}

fn trace_polylines(polylines: &[Vec<DVec2>], frame: Frame) -> Result<Vec<super::Polyline>, ForeignFault> {
    let mut tracer = Tracer::new(frame);
    for (at, points) in polylines.iter().enumerate() {
        let place = || format!("polylines[{at}]");
        let Some((first, rest)) = points.split_first() else { continue };
        tracer.move_to(*first);
        let is_closed = rest.len() > 2 && rest.last() == Some(first);
        let open = if is_closed { &rest[..rest.len() - 1] } else { rest };
        open.iter().try_for_each(|&point| tracer.line_to(point)).map_err(|many| many.at(place()))?;
        if is_closed {
            tracer.close().map_err(|many| many.at(place()))?;
        }
    }
    tracer.finished()
}

fn trace_chains(
    chains: &[ChainDocument],
    frame: Frame,
    notes: &mut Vec<String>,
) -> Result<Vec<super::Polyline>, ForeignFault> {
    let mut tracer = Tracer::new(frame);
    let mut others: BTreeMap<&str, usize> = BTreeMap::new();
    for (at, chain) in chains.iter().enumerate().filter(|(_, chain)| chain.visible) {
        let Some((first, rest)) = chain.pixels.split_first() else { continue };
        let place = || format!("chains[{at}]");
        let segments = rest.len() + usize::from(chain.closed && !rest.is_empty());
        if !chain.handles.is_empty() && chain.handles.len() != segments {
            let message = format!("{} for {segments} segments; give two handles per segment", chain.handles.len());
            return Err(ForeignFault::Form { place: format!("{}.handles", place()), message });
        }
        tracer.move_to(*first);
        let closing = if chain.closed { Some(first) } else { None };
        for (segment, &to) in rest.iter().chain(closing.filter(|_| !chain.handles.is_empty())).enumerate() {
            let drawn = match chain.handles.get(segment) {
                Some(&handles) => tracer.curve_to(handles, to),
                None => tracer.line_to(to),
            };
            drawn.map_err(|many| many.at(place()))?;
        }
        if chain.closed {
            tracer.close().map_err(|many| many.at(place()))?;
        }
        if let Some(kind) = chain.kind.as_deref().filter(|kind| !TRUE_KINDS.contains(kind)) {
            *others.entry(kind).or_default() += 1;
        }
    }
    if !others.is_empty() {
        let kinds: Vec<String> = others.iter().map(|(kind, count)| format!("{kind} ({count})")).collect();
        let kinds = kinds.join(", ");
        notes.push(format!("holds chains of kinds that the truth does not hold, and that count as spurious: {kinds}"));
    }
    let lines = tracer.finished()?;
    let hidden = chains.iter().filter(|chain| !chain.visible).count();
    if lines.is_empty() && hidden > 0 {
        let mend = "write those that are visible";
        return Err(ForeignFault::NoLines { why: format!(": all of its {hidden} chains are hidden"), mend });
    }
    Ok(lines)
}

/// Words that Python and others write for numbers that JSON has not.
const NO_NUMBERS: [&str; 4] = ["NaN", "nan", "Infinity", "inf"];

/// The parser's message with its place.
fn form(text: &[u8], error: &serde_json::Error) -> ForeignFault {
    let place = format!("line {}, column {}", error.line(), error.column());
    // The parser has read one letter of a word that it does not know, or a minus before it.
    let line = text.split(|&byte| byte == b'\n').nth(error.line().saturating_sub(1)).unwrap_or_default();
    let rest = line.get(error.column().saturating_sub(1)..).unwrap_or_default();
    let rest = rest.strip_prefix(b"-").unwrap_or(rest);
    let message = error.to_string();
    let number = NO_NUMBERS.into_iter().find(|word| rest.starts_with(word.as_bytes()));
    match number {
        Some(number) => ForeignFault::NotFinite { place, number: number.to_owned() },
        None if message.starts_with("number out of range") => {
            ForeignFault::NotFinite { place, number: "a number beyond 64 bits".to_owned() }
        }
        None => {
            let message = message.split(" at line ").next().unwrap_or_default().to_owned();
            ForeignFault::Form { place, message: format!("{message}; silhouettes score --help describes the forms") }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { size: [100, 50], pen_width_px: 2.0 };

    fn lines(text: &str) -> Vec<super::super::Polyline> {
        match read(text.as_bytes(), FRAME).unwrap().drawing {
            Drawing::Lines(lines) => lines,
            other => panic!("{other:?}"),
        }
    }

    fn refused(text: &str) -> String {
        read(text.as_bytes(), FRAME).unwrap_err().to_string()
    }

    #[test]
    fn pairs_of_vertices_come_with_what_they_say_of_themselves() {
        let text = r#"{"method":"mine","mesh":{"vertices":8,"triangles":12},"viewpoint":{"perspective":{"eye":[1,2,3]}},
            "edges":[[0,1],[7,2]],"boundary":[],"loops":[[0,1]],"stats":{"faces_tested":3}}"#;
        let EdgeList { drawing, claims, notes } = read(text.as_bytes(), FRAME).unwrap();
        assert_eq!((drawing, notes.len()), (Drawing::Edges(vec![[0, 1], [7, 2]]), 0));
        assert_eq!(claims.method.as_deref(), Some("mine"));
        assert_eq!(claims.mesh, Some(ClaimedMesh { vertices: Some(8), triangles: Some(12) }));
        let eye = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(claims.viewpoint, Some(ClaimedViewpoint::Perspective { eye }));
        let flat = read(br#"{"edges":[],"viewpoint":{"orthographic":{"toward_viewer":[0,0,1]}}}"#, FRAME).unwrap();
        assert_eq!(flat.claims.viewpoint, Some(ClaimedViewpoint::Orthographic { toward_viewer: DVec3::Z }));
    }

    #[test]
    fn polylines_that_repeat_their_first_point_are_closed() {
        let found = lines(r#"{"size":[100,50],"polylines":[[[1,2],[3,4]],[[1,1],[9,1],[9,9],[1,1]],[],[[5,5]]]}"#);
        assert_eq!(
            found.iter().map(|line| (line.points.len(), line.closed)).collect::<Vec<_>>(),
            [(2, false), (3, true)]
        );
    }

    #[test]
    fn hidden_chains_are_left_out_and_kinds_that_the_truth_lacks_are_noted() {
        let chain = |kind: &str, visible: bool| {
            format!(
                r#"{{"kind":"{kind}","visible":{visible},"closed":false,"pixels":[[1,2],[30,40]],"points":[[0,0,0]]}}"#
            )
        };
        let text = |chains: &[String]| format!(r#"{{"page":{{}},"chains":[{}]}}"#, chains.join(","));
        let mixed = text(&[chain("silhouette", true), chain("silhouette", false), chain("ridge", true)]);
        let EdgeList { drawing, notes, .. } = read(mixed.as_bytes(), FRAME).unwrap();
        assert!(matches!(drawing, Drawing::Lines(lines) if lines.len() == 2));
        assert!(notes.len() == 1 && notes[0].ends_with("ridge (1)"), "{notes:?}");
        assert!(refused(&text(&[chain("boundary", false)])).contains("all of its 1 chains are hidden"));
        let curve = lines(r#"{"chains":[{"pixels":[[5,5],[45,5]],"handles":[[[5,45],[45,45]]]}]}"#);
        assert!(curve[0].points.len() > 10);
        assert!(
            refused(r#"{"chains":[{"pixels":[[5,5],[45,5]],"closed":true,"handles":[[[5,45],[45,45]]]}]}"#)
                .starts_with("chains[0].handles: 1 for 2 segments")
        );
    }

    #[test]
    fn what_does_not_fit_is_named_with_its_place() {
        assert!(refused("{}").starts_with("unknown form: it has none of these; give one of \"polylines\""));
        assert!(refused(r#"{"edges":[],"chains":[]}"#).contains("has edges and chains"));
        assert!(
            refused(r#"{"polylines":[],"size":[50,100]}"#)
                .contains("size: is 50 x 100 pixels, but the view is 100 x 50")
        );
        for (word, number) in [("NaN", "NaN"), ("-Infinity", "Infinity"), ("1e999", "a number beyond 64 bits")] {
            let message = refused(&format!("{{\n\"polylines\": [[[1,2],\n[{word},3]]]}}"));
            assert!(message.starts_with("line 3, column ") && message.contains(number), "{message}");
            assert!(message.ends_with("is no finite number; leave such points out"), "{message}");
        }
        for text in [r#"{"edges":[[1,-2]]}"#, r#"{"edges":[[1]]}"#, r#"{"edges":[[1,2.5]]}"#, "[[1,2]]", "", "edges"] {
            let message = refused(text);
            assert!(message.starts_with("line ") && message.contains("score --help describes the forms"), "{message}");
        }
        let deep = "[".repeat(1_000_000);
        assert!(refused(&format!("{{\"polylines\":{deep}")).starts_with("line 1, column "));
    }
}
