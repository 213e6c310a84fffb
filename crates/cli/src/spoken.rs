//! The words of the command line as people write them: an option whose value may be left out takes the next word for its value
//! if it is one.

use std::ffi::OsString;

type IsValue = fn(&str) -> bool;

/// Options of which a value may be left out, and what is one.
const OPTIONAL: [(&str, IsValue); 5] = [
    ("--hidden", |word| ["drop", "dashed", "solid"].contains(&word)),
    ("--outline", |word| ["with", "only"].contains(&word)),
    ("--fill", |word| csscolorparser::parse(word).is_ok()),
    ("--weld", is_number),
    ("--heal", |word| word == "auto" || is_number(word)),
];

fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok()
}

/// Joins `--hidden dashed` to `--hidden=dashed`, so that both are understood; a file of that name is `./dashed`. Nothing is joined
/// after `--`.
pub fn joined(words: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let mut joined: Vec<OsString> = Vec::new();
    let mut only_names = false;
    for word in words {
        let before = joined.last().and_then(|word| word.to_str());
        let option = before.and_then(|before| OPTIONAL.iter().find(|(name, _)| *name == before && !only_names));
        only_names |= word == "--";
        match (option, word.to_str(), joined.last_mut()) {
            (Some((_, is_value)), Some(value), Some(last)) if is_value(value) => {
                last.push("=");
                last.push(value);
            }
            _ => joined.push(word),
        }
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(line: &str) -> String {
        let joined = joined(line.split(' ').map(OsString::from));
        joined.iter().map(|word| word.to_str().unwrap()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn values_are_joined_to_options_that_may_lack_them() {
        assert_eq!(of("lines --hidden dashed a.obj"), "lines --hidden=dashed a.obj");
        assert_eq!(of("lines --hidden a.obj --weld 0.01"), "lines --hidden a.obj --weld=0.01");
        assert_eq!(of("lines --outline only --heal auto b.obj"), "lines --outline=only --heal=auto b.obj");
        assert_eq!(of("lines --hidden=solid dashed"), "lines --hidden=solid dashed");
        assert_eq!(of("lines --fill #eee a.obj --fill b.obj"), "lines --fill=#eee a.obj --fill b.obj");
        assert_eq!(of("lines -- --hidden dashed"), "lines -- --hidden dashed");
    }
}
