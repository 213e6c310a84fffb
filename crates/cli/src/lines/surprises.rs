//! What will surprise about a drawing, as notes: seams that are open, parts that are wound against each other, and an empty page.

use super::arguments::LinesArguments;
use crate::failure::note;
use crate::out_of_view::out_of_view;
use silhouette_core::seams::OpenSeams;
use silhouette_core::{EdgeId, Topology};
use silhouette_visibility::plot::Drawing;
use silhouette_visibility::{LineScene, Lines};

/// Notes what is odd about the meshes of a scene, named in the order of its objects. O(E).
pub fn note_meshes(scene: &LineScene, topology: &Topology, names: &[&str], arguments: &LinesArguments) {
    let mesh = scene.mesh().mesh();
    let mut edges = vec![0; names.len()];
    let mut inconsistent = vec![0; names.len()];
    let mut boundary: Vec<Vec<EdgeId>> = vec![Vec::new(); names.len()];
    for edge in topology.edges().ids() {
        let half_edges = topology.half_edges(edge);
        let object = scene.object_of(half_edges[0].face()) as usize;
        edges[object] += 1;
        match half_edges {
            [_] => boundary[object].push(edge),
            [_, _] if topology.consistent_pair(mesh, edge).is_none() => inconsistent[object] += 1,
            _ => {}
        }
    }
    for (object, name) in names.iter().enumerate() {
        if inconsistent[object] > 0 {
            note_winding(name, inconsistent[object], edges[object], arguments.orient.orient);
        }
        if arguments.weld.is_none() && arguments.heal.is_none() {
            note_seams(name, &OpenSeams::among(mesh, topology, boundary[object].iter().copied()));
        }
    }
}

fn note_winding(name: &str, inconsistent: usize, edges: usize, is_oriented: bool) {
    let mend = if is_oriented { "--orient turned what it could" } else { "--orient turns parts that are inside out" };
    note(format!(
        "{name}: at {inconsistent} of {edges} edges faces are wound against each other; hidden lines are right all the same, but \
         ridges and valleys may be taken for each other; {mend}"
    ));
}

fn note_seams(name: &str, seams: &OpenSeams) {
    let OpenSeams { edges, distance } = *seams;
    if edges > 0 {
        let weld = if distance > 0.0 { format!("--weld={distance}") } else { "--weld".to_owned() };
        note(format!(
            "{name}: {edges} boundary edges lie on each other, as at the seams of textures; {weld} closes them"
        ));
    }
}

/// Notes why nothing is drawn, where nothing is. `drawing` is there where pages are.
pub fn note_empty(scene: &LineScene, lines: &Lines, drawing: Option<&Drawing>, arguments: &LinesArguments) {
    let is_empty = match drawing {
        Some(drawing) => drawing.layers.is_empty(),
        None => lines.chains.is_empty() && lines.outline.rings.is_empty(),
    };
    if !is_empty {
        return;
    }
    if let Some(reason) = out_of_view(&lines.camera, scene.mesh().mesh()) {
        return note(format!("no line lies in the view: {reason}"));
    }
    match drawing.map(|drawing| &drawing.stats) {
        Some(stats) if stats.dropped.paths > 0 => {
            note(format!("nothing is drawn: each of {} paths is shorter than --min-length", stats.dropped.paths));
        }
        Some(stats) if stats.repeats > 0 => {
            note("nothing is drawn: within --tolerance all lines lie on each other; choose a smaller one");
        }
        // That they are cut off is a note of its own.
        Some(stats) if stats.cut_off > 0.0 => {}
        _ => {
            let options = arguments.line_options();
            let more = [
                ("--creases 30", options.ridge_deg.is_none() && options.valley_deg.is_none()),
                ("--all-edges", !options.mesh && !arguments.smooth),
                ("--hidden", options.max_invisibility == 0 && !arguments.quick),
            ];
            let more: Vec<_> = more.into_iter().filter_map(|(option, is_new)| is_new.then_some(option)).collect();
            let mend = if more.is_empty() { String::new() } else { format!("; {} may draw more", more.join(" or ")) };
            note(format!("no line lies in the view: none of the kinds that are drawn is visible in it{mend}"));
        }
    }
}
