//! Marked regions of a Markdown file: `<!-- made: NAME -->` and `<!-- end: NAME -->`, each on a line of its own.

/// What is wrong with the marks of a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RegionError {
    /// A mark is missing, or is there more than once.
    #[error("{count} lines are '{mark}'; there must be one")]
    Count {
        /// The mark.
        mark: String,
        /// How often it is there.
        count: usize,
    },
    /// The region ends before it begins.
    #[error("'{mark}' stands before the region's begin")]
    Order {
        /// The mark of the end.
        mark: String,
    },
}

/// The text with what stands between the marks of `name` replaced, an empty line on either side. The rest stays as it is.
///
/// # Errors
/// [`RegionError`] where not exactly one such region is there.
pub fn replaced(text: &str, name: &str, contents: &str) -> Result<String, RegionError> {
    let (begin, end) = (format!("<!-- made: {name} -->"), format!("<!-- end: {name} -->"));
    let lines: Vec<&str> = text.lines().collect();
    let place = |mark: &str| {
        let mut places = (0..lines.len()).filter(|&line| lines[line] == mark);
        match (places.next(), places.count()) {
            (Some(place), 0) => Ok(place),
            (first, more) => {
                Err(RegionError::Count { mark: mark.to_owned(), count: more + usize::from(first.is_some()) })
            }
        }
    };
    let (from, to) = (place(&begin)?, place(&end)?);
    if to < from {
        return Err(RegionError::Order { mark: end });
    }
    let mut replaced: Vec<&str> = lines[..=from].to_vec();
    replaced.extend(["", contents.trim_end(), ""]);
    replaced.extend(&lines[to..]);
    Ok(replaced.join("\n") + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str =
        "by hand\n<!-- made: a -->\nold\nolder\n<!-- end: a -->\nafter\n<!-- made: b -->\n<!-- end: b -->\n";

    #[test]
    fn only_what_stands_between_the_marks_changes() {
        let page = replaced(PAGE, "a", "new\n").unwrap();
        assert_eq!(page, PAGE.replace("old\nolder\n", "\nnew\n\n"));
        assert_eq!(replaced(&page, "a", "new").unwrap(), page, "once more changes nothing");
        assert_ne!(replaced(&page, "b", "new").unwrap(), page);
    }

    #[test]
    fn a_file_without_its_marks_is_refused() {
        for (name, page) in [
            ("c", PAGE.to_owned()),
            ("a", PAGE.replace("<!-- end: a -->\n", "")),
            ("a", PAGE.repeat(2)),
            ("a", PAGE.replace("made: a", "x").replace("end: a", "made: a").replace("x -->", "end: a -->")),
        ] {
            assert!(replaced(&page, name, "new").is_err(), "{name} of {page}");
        }
    }
}
