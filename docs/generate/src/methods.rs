//! Tables of methods, and the text of the gallery, from what methods say of themselves and what they can do.

use crate::pictures;
use silhouette_compare::registry::Entry;
use silhouette_core::MethodInfo;

/// Pages of `docs` that say more of a method.
const PAGES: [(&str, &[&str]); 5] = [
    ("methods/edge-mesh.md", &["edge-mesh", "inverted-hull", "gbuffer-filter", "jump-flood"]),
    ("methods/image-precision.md", &["image-precision"]),
    ("methods/tracking.md", &["tracking", "tracking-exact"]),
    (
        "methods/smoothing.md",
        &[
            "smoothing",
            "interpolated-contours",
            "boundary-curve",
            "pn-triangles",
            "phong-tessellation",
            "adaptive-refinement",
        ],
    ),
    ("methods/silhouette-texture.md", &["texture", "texture-lines", "normal-map-hull", "lod-mesh"]),
];

/// The page of a method below `docs`, if it has one.
fn page(name: &str) -> Option<&'static str> {
    PAGES.into_iter().find(|(_, names)| names.contains(&name)).map(|(page, _)| page)
}

/// What preparation asks for, in words.
fn needs(info: &MethodInfo) -> String {
    if info.needs.is_empty() { "triangles".to_owned() } else { info.needs.join(", ").replace('-', " ") }
}

/// A row per method, for choosing one. `docs` leads from the file to the folder `docs`.
pub fn overview(entries: &[Entry], docs: &str) -> String {
    let mut table = "| name | goes back to | yields | needs | choose it when |\n|---|---|---|---|---|\n".to_owned();
    for info in entries.iter().map(Entry::info) {
        let guide = &info.guide;
        let name = match page(info.name) {
            Some(page) => format!("[`{}`]({docs}{page})", info.name),
            None => format!("`{}`", info.name),
        };
        table +=
            &format!("| {name} | {} | {} | {} | {} |\n", guide.origin, guide.yields, needs(info), guide.choose_when);
    }
    table
}

/// A row per method: what it needs, how close it comes, what it costs.
pub fn costs(entries: &[Entry]) -> String {
    let mut table = "| method | needs | accuracy | cost per view | memory |\n|---|---|---|---|---|\n".to_owned();
    for info in entries.iter().map(Entry::info) {
        let guide = &info.guide;
        let cells = [needs(info), guide.accuracy.to_owned(), guide.cost.to_owned(), guide.memory.to_owned()];
        table += &format!("| [`{0}`](#{0}) | {1} |\n", info.name, cells.join(" | "));
    }
    table
}

/// A section per method with its picture.
pub fn gallery(entries: &[Entry]) -> String {
    let mut sections = Vec::new();
    for entry in entries {
        let info = entry.info();
        let source = &info.source;
        let mut section =
            format!("### {}\n\n![{}](images/methods/{})\n\n", info.name, info.summary, pictures::file(entry));
        section += &format!("{}\n\n", info.summary);
        section += &format!("- **goes back to** {}", info.guide.origin);
        section += &format!(": {}, \"{}\", {} {}\n", source.authors, source.title, source.venue, source.year);
        section += &format!("- **needs** {}\n", needs(info));
        for (heading, text) in info.guide.texts().into_iter().skip(1).filter(|(_, text)| !text.is_empty()) {
            section += &format!("- **{heading}** {text}\n");
        }
        if let Some(page) = page(info.name) {
            section += &format!("- [figures and details]({page})\n");
        }
        sections.push(section);
    }
    sections.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_compare::registry::Registry;
    use std::path::Path;

    #[test]
    fn every_method_says_all_that_its_reader_needs() {
        for entry in Registry::builtin().entries() {
            for (heading, text) in entry.info().guide.texts() {
                assert!(!text.is_empty(), "{}: {heading}", entry.info().name);
                assert!(!text.ends_with('.') && !text.contains(['|', '\n']), "{}: {text}", entry.info().name);
            }
            let says_all = entry.info().guide.accuracy.starts_with("all ");
            assert_eq!(says_all, entry.info().exact, "{}", entry.info().name);
        }
    }

    #[test]
    fn pages_are_there_and_of_methods_that_are() {
        let registry = Registry::builtin();
        let docs = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        for (page, names) in PAGES {
            assert!(docs.join(page).exists(), "{page}");
            assert!(names.iter().all(|name| registry.find(name).is_ok()), "{names:?}");
        }
    }

    #[test]
    fn what_a_method_says_is_what_the_tables_say() {
        let registry = Registry::builtin();
        let entries = registry.entries();
        let tables = [overview(entries, ""), costs(entries), gallery(entries)];
        let rows = entries.len();
        assert_eq!([&tables[0], &tables[1]].map(|table| table.lines().count()), [rows + 2; 2]);
        assert_eq!(tables[2].matches("\n- **where it fails** ").count(), rows);
        assert!(entries.iter().all(|entry| tables[0].contains(entry.info().guide.choose_when)));
        assert!(!overview(&entries[1..], "").contains("`brute-force` |"), "one method less, one row less");
    }
}
