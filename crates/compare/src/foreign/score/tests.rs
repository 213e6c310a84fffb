//! What is known of drawings is what they score: the truth itself, and the truth made worse.

use super::*;
use crate::metrics::{LineMetrics, table::PictureMetrics};
use crate::runner::NamedMesh;
use crate::scene::Profile;
use silhouette_core::{NoProgress, PreparedMesh, VertexId, shapes};

fn subject(shape: &str) -> Subject {
    let mesh = Arc::new(PreparedMesh::new(shapes::by_name(shape).unwrap()));
    NamedMesh { name: shape.to_owned(), mesh }.into()
}

/// A scorer of two views in small pictures.
fn scorer(subject: &Subject) -> Scorer<'_> {
    let mut scene = Profile::Quick.scene();
    (scene.picture.width, scene.picture.height) = (200, 160);
    scene.path.scored = 2;
    let bounds = subject.mesh.mesh.mesh().bounds().unwrap();
    let views = ScoredView::of_scene(&scene, &bounds).unwrap();
    Scorer::new(subject, views, 2.0, &NoProgress).unwrap()
}

fn file(drawing: Drawing) -> ForeignFile {
    ForeignFile { drawing, claims: Claims::default(), notes: Vec::new() }
}

fn metrics(score: &ForeignScore) -> LineMetrics {
    match score.view.metrics {
        PictureMetrics::Lines(metrics) => metrics,
        PictureMetrics::Fill(_) => panic!("lines"),
    }
}

fn score(scorer: &mut Scorer<'_>, view: usize, drawing: Drawing) -> ForeignScore {
    scorer.score(view, file(drawing), &NoProgress).unwrap()
}

/// The true edges of a view as pairs of vertices, and its true lines.
fn truth(scorer: &mut Scorer<'_>, view: usize) -> (Vec<[u32; 2]>, Vec<Polyline>) {
    let topology = Arc::clone(&scorer.topology);
    let (truth, _) = scorer.truths.view_and_finder(view);
    let pairs = truth.edges.iter().map(|edge| topology.end_points(edge).map(VertexId::get)).collect();
    let line =
        |line: &crate::truth::visible::VisibleLine| Polyline { points: line.points.clone(), closed: line.closed };
    (pairs, truth.visible.iter().map(line).collect())
}

fn assert_perfect(score: &ForeignScore) {
    let LineMetrics { missed_0_5px, spurious_0_5px, chamfer_px, hausdorff_95_px, gaps_per_1000px, .. } = metrics(score);
    let all = [missed_0_5px, spurious_0_5px, chamfer_px, hausdorff_95_px, gaps_per_1000px];
    assert!(all.iter().all(|value| value.abs() < 1e-12), "{all:?}");
    let errors = score.view.errors.unwrap();
    assert!(errors.missed_px().abs() < 1e-12 && errors.spurious_px().abs() < 1e-12 && errors.true_px() > 100.0);
}

#[test]
fn the_truth_scores_perfectly_in_every_form() {
    for shape in ["torus", "blob:2000", "grid"] {
        let subject = subject(shape);
        let mut scorer = scorer(&subject);
        for view in 0..2 {
            let (pairs, lines) = truth(&mut scorer, view);
            let of_edges = score(&mut scorer, view, Drawing::Edges(pairs.clone()));
            assert_perfect(&of_edges);
            let edges = of_edges.view.edges.unwrap();
            assert_eq!((edges.found, edges.precision, edges.recall), (pairs.len(), 1.0, 1.0));
            let of_lines = score(&mut scorer, view, Drawing::Lines(lines));
            assert_perfect(&of_lines);
            assert_eq!(of_lines.view.edges, None);
            assert_perfect(&score(&mut scorer, view, Drawing::Picture(of_lines.pictures[1].clone())));
        }
    }
}

#[test]
fn what_is_left_out_of_the_edges_is_missed() {
    let subject = subject("torus");
    let mut scorer = scorer(&subject);
    let (pairs, _) = truth(&mut scorer, 0);
    let half = score(&mut scorer, 0, Drawing::Edges(pairs[..pairs.len() / 2].to_vec()));
    let edges = half.view.edges.unwrap();
    assert!((edges.precision - 1.0).abs() < 1e-12 && (edges.recall - 0.5).abs() < 0.02, "{edges:?}");
    let metrics = metrics(&half);
    assert!(metrics.missed_1px > 0.1 && metrics.spurious_2px.abs() < 1e-12, "{metrics:?}");
}

/// Edges that are no silhouette edges are drawn where they are seen, and are spurious.
#[test]
fn edges_besides_are_spurious_where_they_are_seen() {
    let subject = subject("torus");
    let mut scorer = scorer(&subject);
    let (pairs, _) = truth(&mut scorer, 0);
    let topology = Arc::clone(&scorer.topology);
    let every: Vec<[u32; 2]> = topology.edges().as_slice().to_vec();
    let all = score(&mut scorer, 0, Drawing::Edges(every.clone()));
    let edges = all.view.edges.unwrap();
    assert!(
        (edges.recall - 1.0).abs() < 1e-12 && (edges.precision - pairs.len() as f64 / every.len() as f64).abs() < 1e-12
    );
    let metrics = metrics(&all);
    assert!(metrics.missed_0_5px.abs() < 1e-12 && metrics.spurious_2px > 0.3, "{metrics:?}");
}

#[test]
fn drawings_made_worse_score_worse() {
    let subject = subject("knot");
    let mut scorer = scorer(&subject);
    let (_, lines) = truth(&mut scorer, 1);
    let moved = |by: DVec3| {
        let moved = |line: &Polyline| Polyline {
            points: line.points.iter().map(|&point| point + by.truncate()).collect(),
            closed: line.closed,
        };
        lines.iter().map(moved).collect::<Vec<_>>()
    };
    // The longest line less: what is missed is its share, but for where others run beside it.
    let length = |line: &Polyline| {
        let open = line.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>();
        open + if line.closed { line.points[0].distance(line.points[line.points.len() - 1]) } else { 0.0 }
    };
    let longest = lines.iter().map(length).enumerate().max_by(|one, other| one.1.total_cmp(&other.1)).unwrap();
    let share = longest.1 / lines.iter().map(length).sum::<f64>();
    let mut fewer = lines.clone();
    fewer.remove(longest.0);
    let removed = metrics(&score(&mut scorer, 1, Drawing::Lines(fewer)));
    assert!((0.7 * share..=share).contains(&removed.missed_2px), "{share} {removed:?}");
    assert!(removed.spurious_0_5px.abs() < 1e-12, "{removed:?}");
    // All by 3 px.
    let shifted = metrics(&score(&mut scorer, 1, Drawing::Lines(moved(DVec3::new(3.0, 0.0, 0.0)))));
    assert!(shifted.missed_0_5px > 0.3 && shifted.spurious_0_5px > 0.25 && shifted.chamfer_px > 0.5, "{shifted:?}");
    let slight = metrics(&score(&mut scorer, 1, Drawing::Lines(moved(DVec3::new(0.4, 0.0, 0.0)))));
    assert!(slight.missed_0_5px.abs() < 1e-12 && slight.chamfer_px < 0.5 * shifted.chamfer_px, "{slight:?}");
    // Mirrored.
    let picture = score(&mut scorer, 1, Drawing::Lines(lines.clone())).pictures[0].clone();
    let mut mirrored = picture.clone();
    for row in mirrored.rgba.chunks_exact_mut(4 * 200) {
        let pixels: Vec<[u8; 4]> = row.chunks_exact(4).rev().map(|pixel| pixel.try_into().unwrap()).collect();
        row.copy_from_slice(pixels.as_flattened());
    }
    let mirrored = metrics(&score(&mut scorer, 1, Drawing::Picture(mirrored)));
    assert!(mirrored.missed_2px > 0.2 && mirrored.spurious_2px > 0.2, "{mirrored:?}");
    // Nothing at all.
    let blank = Image { rgba: vec![255; picture.rgba.len()], ..picture };
    let blank = score(&mut scorer, 1, Drawing::Picture(blank));
    let nothing = metrics(&blank);
    assert!((nothing.missed_2px - 1.0).abs() < 1e-12 && nothing.spurious_0_5px.abs() < 1e-12, "{nothing:?}");
    let errors = blank.view.errors.unwrap();
    assert!((errors.missed_px() - errors.true_px()).abs() < 1e-9);
}

#[test]
fn what_a_file_says_of_itself_has_to_fit() {
    let subject = subject("torus");
    let mut scorer = scorer(&subject);
    let (pairs, _) = truth(&mut scorer, 0);
    let mut refused = |claims: Claims| {
        let file = ForeignFile { drawing: Drawing::Edges(pairs.clone()), claims, notes: Vec::new() };
        scorer.score(0, file, &NoProgress).map(drop).map_err(|error| error.to_string())
    };
    let camera = {
        let views = self::scorer(&subject);
        views.views()[0].camera
    };
    let mesh = subject.mesh.mesh.mesh();
    let counts = |vertices, triangles| Claims {
        mesh: Some(super::super::edge_list::ClaimedMesh { vertices, triangles }),
        ..Claims::default()
    };
    assert_eq!(refused(counts(Some(mesh.vertex_count()), Some(mesh.face_count()))), Ok(()));
    let other = refused(counts(None, Some(7))).unwrap_err();
    assert!(other.starts_with("mesh.triangles: was made of 7 triangles, but torus has "), "{other}");
    let from = |eye: DVec3| Claims { viewpoint: Some(ClaimedViewpoint::Perspective { eye }), ..Claims::default() };
    let eye = camera.eye().as_dvec3();
    assert_eq!(refused(from(eye * 1.0005)), Ok(()));
    let elsewhere = refused(from(-eye)).unwrap_err();
    assert!(elsewhere.starts_with("viewpoint: is from ") && elsewhere.contains("but frame 7 has "), "{elsewhere}");
    let along = ClaimedViewpoint::Orthographic { toward_viewer: eye };
    let flat = refused(Claims { viewpoint: Some(along), ..Claims::default() }).unwrap_err();
    assert!(flat.contains("has a field of view of 45 degrees"), "{flat}");
    let seen = |eye: DVec3, fov_y_deg: f64| {
        let projection = ClaimedProjection::Perspective { fov_y_rad: fov_y_deg.to_radians() };
        let camera = ClaimedCamera { eye, target: camera.target().as_dvec3(), projection };
        Claims { camera: Some(camera), ..Claims::default() }
    };
    assert_eq!(refused(seen(eye, 45.0)), Ok(()));
    assert!(refused(seen(eye, 46.0)).unwrap_err().contains("a field of view of 45 degrees"));
    assert!(refused(seen(eye * 2.0, 45.0)).unwrap_err().starts_with("camera: has its eye at "));
    assert!(refused(seen(-eye, 45.0)).unwrap_err().starts_with("camera: looks along "));
}

#[test]
fn nothing_is_refused_where_something_is_to_be_seen() {
    let subject = subject("torus");
    let mut scorer = scorer(&subject);
    for empty in [Drawing::Lines(Vec::new()), Drawing::Edges(Vec::new())] {
        let refused = scorer.score(0, file(empty), &NoProgress).unwrap_err().to_string();
        assert!(refused.starts_with("holds no line; for a drawing without lines give a white picture"), "{refused}");
    }
    // A sheet seen from its back has no silhouette edge by Hall's definition: nothing is then right.
    let mesh = shapes::by_name("grid").unwrap();
    let turned: Vec<[u32; 3]> = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    let back = TriangleMesh::new(mesh.positions().to_vec(), turned).unwrap();
    let (one, other) = (
        self::subject("grid"),
        Subject::from(NamedMesh { name: "back".to_owned(), mesh: Arc::new(PreparedMesh::new(back)) }),
    );
    let outcomes = [&one, &other].map(|subject| {
        let mut scorer = self::scorer(subject);
        scorer.score(0, file(Drawing::Edges(Vec::new())), &NoProgress).is_ok()
    });
    assert_eq!(outcomes.iter().filter(|&&is_right| is_right).count(), 1, "{outcomes:?}");
}

#[test]
fn results_have_the_columns_of_a_comparison_and_leave_times_empty() {
    let subject = subject("torus");
    let mut scorer = scorer(&subject);
    let scores: Vec<ForeignScore> = (0..2)
        .map(|view| {
            let (pairs, _) = truth(&mut scorer, view);
            score(&mut scorer, view, Drawing::Edges(pairs))
        })
        .collect();
    let cell = scorer.cell("mine", scores.iter().map(|score| score.view.clone()).collect());
    let bounds = subject.mesh.mesh.mesh().bounds().unwrap();
    let cameras =
        super::super::cameras::CamerasDocument::new("torus", subject.mesh.mesh.mesh(), &bounds, scorer.views(), 2.0);
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("score");
    let files = ["a.json", "b.json"].map(str::to_owned);
    for _ in 0..2 {
        super::super::results::check_target(&target).unwrap();
        super::super::results::write(&target, &cell, &scores, &files, &cameras).unwrap();
    }
    let compared = crate::record::flat::Table::of_views(std::slice::from_ref(&cell));
    let mut table = csv::Reader::from_path(target.join("results.csv")).unwrap();
    assert_eq!(table.headers().unwrap().iter().collect::<Vec<_>>(), compared.columns);
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    let value = |row: usize, name: &str| {
        rows[row].get(compared.columns.iter().position(|column| column == name).unwrap()).unwrap().to_owned()
    };
    assert_eq!((rows.len(), value(0, "method"), value(1, "edge_recall")), (2, "mine".to_owned(), "1".to_owned()));
    for name in ["prepare_ms", "renderer_ms", "bytes_prepared", "frames", "frame_median_ms", "frame_p95_ms", "frame_ms"]
    {
        assert_eq!(value(0, name), "", "{name}");
    }
    let line = std::fs::read_to_string(target.join("results.jsonl")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&line).unwrap();
    assert!(json["prepare"]["prepare_ms"].is_null() && json["views"][1]["frame_ms"].is_null());
    assert_eq!(json["views"][1]["metrics"]["lines"]["missed_1px"], 0.0);
    assert!(target.join("images/00007-difference.png").is_file());
}
