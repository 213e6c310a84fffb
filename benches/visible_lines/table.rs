//! Tables for people, on standard output.

use crate::row::{LinesRow, PeerRow};
use std::io::{self, Write};

/// The rows of one mesh, with ratios to those of `first`, the first mesh of this run, and to those of other tools on a mesh
/// of this name.
pub fn write_mesh(rows: &[LinesRow], first: &[LinesRow], peers: &[PeerRow], out: &mut impl Write) -> io::Result<()> {
    let Some(any) = rows.first() else { return Ok(()) };
    writeln!(out, "\n{}: {} faces", any.mesh, any.faces)?;
    for row in rows.iter().filter(|row| row.views == any.views && row.metric == any.metric) {
        writeln!(
            out,
            "{}, threads {}: prepared in {:.1} ms (topology {:.1}, face tree {:.1}), {:.1} MB, first view {:.2} ms",
            row.finder,
            row.threads,
            row.prepare_ms,
            row.topology_ms,
            row.tree_ms,
            row.prepared_bytes as f64 / 1e6,
            row.first_ms
        )?;
    }
    writeln!(
        out,
        "{:31} {:>9} {:>9} {:>7} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7} {:>7}",
        "lines, finder, views, threads",
        "median ms",
        "p95 ms",
        "ratio",
        "extract",
        "project",
        "decide",
        "chain",
        "edges",
        "contours",
        "pairs",
        "events",
        "sights",
        "pieces",
        "chains"
    )?;
    for row in rows {
        let same = first.iter().find(|other| {
            (other.metric, other.finder, other.views, other.threads) == (row.metric, row.finder, row.views, row.threads)
        });
        let ratio = same.map_or(1.0, |same| row.median_ms / same.median_ms);
        let (stages, counts) = (&row.stages_ms, &row.counts);
        writeln!(
            out,
            "{:31} {:>9.3} {:>9.3} {:>7.2} {:>8.3} {:>8.3} {:>8.3} {:>8.3} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7} {:>7}",
            format!("{}, {}, {}, {}", row.metric, row.finder, row.views, row.threads),
            row.median_ms,
            row.p95_ms,
            ratio,
            stages.extract,
            stages.project,
            stages.decide,
            stages.chain,
            counts.edges,
            counts.contours,
            counts.pairs,
            counts.events,
            counts.sight_lines,
            counts.pieces,
            counts.chains
        )?;
    }
    if let Some(first) = first.first() {
        writeln!(out, "ratio: median time over that of {} in this run", first.mesh)?;
    }
    write_peers(rows, peers, out)
}

fn write_peers(rows: &[LinesRow], peers: &[PeerRow], out: &mut impl Write) -> io::Result<()> {
    for peer in peers {
        let metric = match peer.metric.as_str() {
            "outline" => "outline",
            metric if metric.starts_with("levels") => "all",
            _ => "visible",
        };
        let same_scene = |row: &&LinesRow| row.views == "still" && row.mesh == peer.mesh && row.faces == peer.faces;
        for row in rows.iter().filter(same_scene).filter(|row| row.metric == metric) {
            let camera = &row.camera;
            let same_view = (camera.eye, camera.target, camera.up, camera.size)
                == (peer.camera.eye, peer.camera.target, peer.camera.up, peer.camera.size)
                && is_same(camera.fov_deg, peer.camera.fov_deg)
                && is_same(camera.height, peer.camera.height);
            // What begins at the mesh is held against what does: preparation and first view.
            let from_mesh_ms = row.prepare_ms + row.first_ms;
            let area = peer.area_px.map_or(String::new(), |area| {
                format!("; areas differ by {:.1e} of it", (row.counts.area_px - area).abs() / area)
            });
            writeln!(
                out,
                "{} ({}, threads {}{}) {:.2} ms: {:.1} times ours ({}, {}, threads {}), {:.1} times ours with its preparation{area}",
                peer.tool,
                peer.metric,
                peer.threads,
                if same_view { "" } else { ", ANOTHER VIEW" },
                peer.median_ms,
                peer.median_ms / row.median_ms,
                row.metric,
                row.finder,
                row.threads,
                peer.median_ms / from_mesh_ms
            )?;
        }
    }
    Ok(())
}

/// Whether two numbers, if any, differ by no more than reading them back may have rounded.
fn is_same(one: Option<f64>, other: Option<f64>) -> bool {
    let close = |(one, other): (f64, f64)| (one - other).abs() <= 1e-9 * one.abs();
    one.zip(other).map_or(one.is_none() && other.is_none(), close)
}
