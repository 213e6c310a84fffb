//! `silhouettes inspect`: what a mesh is and what is wrong with it.

use crate::args::InspectArguments;
use crate::failure::Failure;
use crate::input;
use crate::output::Output;
use crate::progress::TerminalProgress;
use serde::Serialize;
use silhouette_core::Topology;
use silhouette_core::heal::TJunctions;
use silhouette_core::inspect::{Defects, Inspection, inspect_with_progress};
use std::fmt::{Display, Write};

/// How many ids of a kind of defect the text shows; `--json` holds all.
const IDS_SHOWN: usize = 8;

#[derive(Serialize)]
struct Document<'a> {
    mesh: &'a str,
    #[serde(flatten)]
    inspection: &'a Inspection,
    /// What its file's reader has to say, one sentence each.
    notes: Vec<String>,
}

/// Runs the command.
pub fn run(arguments: &InspectArguments) -> Result<(), Failure> {
    let progress = TerminalProgress::new();
    let (named, notes) = input::mesh_with_notes(&arguments.mesh, &progress)?;
    let notes: Vec<String> = notes.iter().map(ToString::to_string).collect();
    let topology = named.mesh.artefact::<Topology>("inspect", &progress)?;
    let inspection = inspect_with_progress(named.mesh.mesh(), &topology, &progress)?;
    let mut text = if arguments.json {
        let document = Document { mesh: &named.name, inspection: &inspection, notes };
        serde_json::to_string_pretty(&document).map_err(Failure::run)?
    } else {
        summary(&named.name, &inspection, &notes)
    };
    text.push('\n');
    Output::Stdout.write(text.as_bytes())
}

fn summary(name: &str, found: &Inspection, notes: &[String]) -> String {
    let mut text = format!("{name}\n");
    let mut row = |label: &str, value: String| {
        let _ = writeln!(text, "  {label:<16} {value}");
    };
    row("vertices", found.vertices.to_string());
    row("edges", format!("{} ({} boundary)", found.edges, found.boundary_edges));
    row("faces", found.faces.to_string());
    let holds = |holds: bool, yes: &str, no: &str| if holds { yes.to_owned() } else { no.to_owned() };
    let kinds = [
        holds(found.is_closed, "closed", "open"),
        holds(found.is_manifold, "manifold", "non-manifold"),
        holds(found.is_consistently_wound, "consistently wound", "inconsistently wound"),
        holds(found.is_orientable, "orientable", "not orientable"),
    ];
    row("surface", kinds.join(", "));
    if found.inside_out_faces > 0 {
        row(
            "inside out",
            format!(
                "{} of {} faces; --orient, of the commands that draw, turns them",
                found.inside_out_faces, found.faces
            ),
        );
    }
    if found.cavities > 0 {
        row("cavities", format!("{}, whose walls rightly point inward", found.cavities));
    }
    if let Some(seams) = found.seams {
        let weld = if seams.distance == 0.0 { "--weld".to_owned() } else { format!("--weld={}", seams.distance) };
        row("seams", format!("{} of {} boundary edges; lines {weld} closes them", seams.edges, found.boundary_edges));
    }
    if let Some(junctions) = found.t_junctions {
        let TJunctions { edges, largest_distance } = junctions;
        let far = if largest_distance == 0.0 { String::new() } else { format!(", up to {largest_distance:.1e} off") };
        row("T-junctions", format!("{edges} edges with vertices on them{far}; lines --heal divides them"));
    }
    row("components", found.components.len().to_string());
    let inward = found.components.iter().filter_map(|part| Some((part.first_face, part.volume.filter(|v| *v < 0.0)?)));
    let inward: Vec<_> = inward.map(|(face, volume)| format!("{} (face {face})", rounded(volume))).collect();
    if !inward.is_empty() {
        row("negative volume", format!("{} of them: {}", inward.len(), shown(&inward)));
    }
    row("genus", found.genus.map_or_else(|| "undefined".to_owned(), |genus| genus.to_string()));
    row("Euler number", found.euler_characteristic.to_string());
    let lengths: Vec<_> = found.boundary_loops.iter().map(|boundary| boundary.edges).collect();
    let edges = if lengths.is_empty() { String::new() } else { format!(" (edges: {})", shown(&lengths)) };
    row("boundary loops", format!("{}{edges}", lengths.len()));
    if let Some(extent) = found.extent {
        let [a, b] = [extent.min, extent.max].map(|p| p.map(number).join(", "));
        row("extent", format!("[{a}] to [{b}], diagonal {}", rounded(extent.diagonal)));
    }
    if found.origin.iter().any(|&coordinate| coordinate != 0.0) {
        row("origin", format!("[{}], from which positions count", found.origin.map(number).join(", ")));
    }
    if let Some(lengths) = found.edge_lengths {
        row("edge length", format!("{:.3e} to {:.3e}, mean {:.3e}", lengths.min, lengths.max, lengths.mean));
    }
    if let Some(angle) = found.smallest_angle {
        row("smallest angle", format!("{:.3} degrees, face {}", angle.angle_deg, angle.face));
    }
    for note in notes {
        let _ = writeln!(text, "  {:<16} {note}", "note");
    }
    if found.defects.is_empty() {
        text.push_str(if found.inside_out_faces > 0 { "  no other defects" } else { "  no defects" });
    } else {
        text.push_str("  defects");
        list_defects(&found.defects, &mut text);
    }
    text
}

/// A number in full, with a power of ten where that is shorter.
fn number(value: f64) -> String {
    let is_handy = value == 0.0 || (1e-4..1e10).contains(&value.abs());
    if is_handy { value.to_string() } else { format!("{value:e}") }
}

/// The same of seven digits.
fn rounded(value: f64) -> String {
    number(format!("{value:.6e}").parse().unwrap_or(value))
}

fn list_defects(defects: &Defects, text: &mut String) {
    let pairs = |edges: &[silhouette_core::inspect::EdgeDefect]| {
        shown(&edges.iter().map(|edge| format!("{}-{}", edge.vertices[0], edge.vertices[1])).collect::<Vec<_>>())
    };
    let ids = [
        pairs(&defects.non_manifold_edges),
        shown(&defects.non_manifold_vertices),
        pairs(&defects.inconsistent_edges),
        pairs(&defects.folded_edges),
        shown(&defects.zero_area_faces),
        shown(&defects.repeated_vertex_faces),
        groups(&defects.duplicate_faces),
        shown(&defects.unreferenced_vertices),
        groups(&defects.duplicate_vertices),
    ];
    for ((kind, count), ids) in defects.counts().into_iter().zip(ids) {
        if count > 0 {
            let _ = write!(text, "\n    {count} {kind}: {ids}");
        }
    }
}

/// The first few, and whether there are more.
fn shown(items: &[impl Display]) -> String {
    let first: Vec<_> = items.iter().take(IDS_SHOWN).map(ToString::to_string).collect();
    let more = if items.len() > IDS_SHOWN { ", ... (all with --json)" } else { "" };
    format!("{}{more}", first.join(", "))
}

fn groups(groups: &[Vec<impl Display>]) -> String {
    let group = |ids: &Vec<_>| {
        let first: Vec<_> = ids.iter().take(IDS_SHOWN).map(ToString::to_string).collect();
        format!("{}{}", first.join("="), if ids.len() > IDS_SHOWN { "=..." } else { "" })
    };
    shown(&groups.iter().map(group).collect::<Vec<_>>())
}
