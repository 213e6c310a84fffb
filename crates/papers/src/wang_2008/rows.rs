//! The tables that the paper lacks: figures for its pictures, outlines of spheres, and its equations as printed and corrected.

use super::cells;
use super::drawn::{Drawn, PaperFigure};
use super::growth::VIEWS;
use super::lowered::Lowered;
use super::outlines::{self, OUTLINES};
use super::residuals;
use super::sampled::{ARCS_DEG, CHORDS_PX, Sampled};
use super::tangents::{HALF_ANGLE_DEG, RATIOS};
use crate::table::{Cell, Column, Row, Table};

/// Distance of the outline from the fine mesh's; charts read it.
pub const OUTLINE: Column = Column::new(
    "outline",
    "outline off the fine mesh",
    "px",
    "mean distance between the outline and that of the fine mesh",
);

/// How polygonal an outline is; charts read it.
pub const POLYGONAL: Column = Column::new(
    "polygonal",
    "outline off its own limit",
    "px",
    "95 % Hausdorff distance between the outline and that of the same method with far more triangles: PN triangles of level \
     15, smoothing at 0.01 px",
);

/// A figure of the paper, with what it leaves to the eye as numbers.
pub fn figure(name: &'static str, subject: String, about: String, figure: &PaperFigure) -> Table {
    let columns = vec![
        Column { digits: 0, ..Column::new("drawn", "triangles drawn", "", "triangles drawn") },
        OUTLINE,
        Column::new(
            "outline, 95 %",
            "outline off the fine mesh, 95 % Hausdorff",
            "px",
            "95 % Hausdorff distance between both outlines",
        ),
        Column::new(
            "area",
            "wrong area",
            "%",
            "area covered by one of both but not by the other, of that of the fine mesh",
        ),
        POLYGONAL,
    ];
    let row = |Drawn { label, triangles, against_fine, against_limit }: &Drawn| {
        let cells = vec![
            Cell::one(*triangles as f64),
            Cell::one(against_fine.boundary_chamfer_px),
            Cell::one(against_fine.boundary_hausdorff_95_px),
            Cell::one(100.0 * against_fine.xor_share),
            Cell::one(against_limit.map_or(f64::NAN, |limit| limit.boundary_hausdorff_95_px)),
        ];
        Row::new(label.clone(), cells)
    };
    Table { name, subject, about, columns, rows: figure.drawn.iter().map(row).collect(), ..Table::default() }
}

/// Outlines of spheres, by level, then in the order of [`OUTLINES`]; errors by distance.
pub fn outlines(levels: &[Vec<[f64; 3]>]) -> Table {
    let column = |title, metric| Column { digits: 5, ..Column::new(title, metric, "R", OUTLINE_MEANING) };
    let rows = levels.iter().zip(outlines::LEVELS).flat_map(|(errors, level)| {
        let faces = 20 * 4_u32.pow(level);
        errors.iter().zip(OUTLINES).map(move |(errors, (label, _))| {
            Row::new(format!("{faces} faces, {label}"), errors.map(Cell::one).to_vec())
        })
    });
    Table {
        name: "outlines of spheres",
        about: format!(
            "largest error over {} views; as printed: newton=0 segments=as-printed normals=angle",
            outlines::VIEWS
        ),
        columns: vec![
            column("parallel", "radius error, parallel"),
            column("2 R", "radius error from 2 R"),
            column("1.2 R", "radius error from 1.2 R"),
        ],
        rows: rows.collect(),
        ..Table::default()
    }
}

const OUTLINE_MEANING: &str = "largest error of the radius in the image, as a share of the sphere's radius there";

/// Eq. 1.
pub fn tangents(errors_deg: &[[f64; 2]]) -> Table {
    let degrees = |title, metric, meaning| Column { digits: 3, ..Column::new(title, metric, "°", meaning) };
    let meaning = "angle between the tangent at the middle of three points on a circle and that of the circle";
    let row = |([corrected, printed], ratio): (&[f64; 2], f64)| {
        Row::new(format!("edges 1 : {ratio}"), vec![Cell::one(*printed), Cell::one(*corrected)])
    };
    Table {
        name: "Eq. 1, tangents of feature polylines",
        about: format!("the shorter edge spans {} degrees of the circle", 2.0 * HALF_ANGLE_DEG),
        columns: vec![
            degrees("as printed", "angle error, as printed", meaning),
            degrees("corrected", "angle error, corrected", meaning),
        ],
        rows: errors_deg.iter().zip(RATIOS).map(row).collect(),
        ..Table::default()
    }
}

/// Eq. 7.
pub fn residuals(worst_deg: &[[f64; 5]]) -> Table {
    let column = |title, metric| Column {
        digits: 4,
        ..Column::new(
            title,
            metric,
            "°",
            "largest angle between a silhouette point's normal and the perpendicular to the view",
        )
    };
    let row =
        |(errors, distance): (&[f64; 5], f64)| Row::new(format!("from {distance} R"), errors.map(Cell::one).to_vec());
    Table {
        name: "Eq. 7, silhouette points in perspective",
        about: format!("a sphere of 80 faces, {} views", outlines::VIEWS),
        columns: vec![
            column("as printed", "residual, as printed"),
            column("1 step", "residual after 1 step of Newton's method"),
            column("2 steps", "residual after 2 steps of Newton's method"),
            column("3 steps", "residual after 3 steps of Newton's method"),
            column("4 steps", "residual after 4 steps of Newton's method"),
        ],
        rows: worst_deg.iter().zip(residuals::DISTANCES).map(row).collect(),
        ..Table::default()
    }
}

/// Eq. 8: as printed, and the bound.
pub fn sampled(arcs: &[[Sampled; 2]]) -> Table {
    let worst = "largest distance between an arc and its polyline over the tolerance";
    let spare = "most segments more than the least number that keeps the tolerance";
    let count = |title, metric| Column { digits: 0, ..Column::new(title, metric, "", spare) };
    let row = |([printed, guaranteed], arc_deg): (&[Sampled; 2], f64)| {
        let spare = |sampled: &Sampled| Cell::one(f64::from(sampled.most_spare));
        let cells = vec![Cell::one(printed.worst), Cell::one(guaranteed.worst), spare(printed), spare(guaranteed)];
        Row::new(format!("arc of {arc_deg}°"), cells)
    };
    Table {
        name: "Eq. 8, number of samples",
        about: format!("chords of {} to {} px, tolerance 1 px", CHORDS_PX[0], CHORDS_PX[1]),
        columns: vec![
            Column::new("as printed", "error over tolerance, as printed", "×", worst),
            Column::new("bound", "error over tolerance, bound", "×", worst),
            count("spare, as printed", "spare segments, as printed"),
            count("spare, bound", "spare segments, bound"),
        ],
        rows: arcs.iter().zip(ARCS_DEG).map(row).collect(),
        ..Table::default()
    }
}

/// Section III-E: by mesh and law.
pub fn lowered(rows: &[(String, Lowered)]) -> Table {
    let percent = |title, metric, meaning| Column::new(title, metric, "%", meaning);
    let row = |(label, lowered): &(String, Lowered)| {
        let Lowered { vertices, above_before, above, raised } = lowered;
        let shares = [above_before, above, raised].map(|share| Cell::one(100.0 * share));
        Row::new(label.clone(), [Cell::one(*vertices)].into_iter().chain(shares).collect())
    };
    Table {
        name: "III-E. Local perturbation",
        about: format!("{VIEWS} views in perspective; planes that no vertex of the same arc would pass are left out"),
        columns: vec![
            Column {
                digits: 1,
                ..Column::new("vertices", "vertices near concave segments", "", "averaged over the views")
            },
            percent("above, before", "above a plane before", "of these vertices, before they are moved"),
            percent("above, after", "above a plane after", "of these vertices, after they are moved"),
            percent("raised", "raised above a plane", "of these vertices, below all planes before and above one after"),
        ],
        rows: rows.iter().map(row).collect(),
        ..Table::default()
    }
}

/// Section III-B: the printed cells, and gnomonic ones.
pub fn wrong_cells([printed, gnomonic]: [f64; 2]) -> Table {
    let meaning = "vertices whose visibility a cluster decides against the definition, per million";
    Table {
        name: "III-B. Clusters of normals",
        about: format!("a sphere of 20 480 faces in parallel projection, {} views", cells::VIEWS),
        columns: vec![Column::new("wrong", "vertices decided wrongly", "per million", meaning)],
        rows: vec![
            Row::new("as printed, by longitude and latitude", vec![Cell::one(printed)]),
            Row::new("gnomonic", vec![Cell::one(gnomonic)]),
        ],
        ..Table::default()
    }
}
