//! Ways in which files go bad.

use crate::random::Random;

/// Words that sit where readers of text make decisions: huge, negative, odd, missing.
pub const WORDS: [&str; 20] = [
    "4294967295",
    "-1",
    "0",
    "99999999999999999999",
    "nan",
    "1e39",
    " ",
    "\n",
    "\\\n",
    "#",
    "list",
    "/",
    "\0",
    "\u{ff}",
    "\r",
    " \\ \n",
    "OFF",
    "18446744073709551615",
    "end loop",
    "endsolid",
];

/// Changes bytes in one of the ways in which files go bad: cut short, holes, stretches twice or turned round, lines joined, words and
/// bytes overwritten.
pub fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    let length = bytes.len().max(1);
    let at = random.below(length).min(bytes.len());
    let end = (at + random.below(1 + length / 4)).min(bytes.len());
    match random.below(9) {
        0 => bytes.truncate(at),
        1 => drop(bytes.drain(at..end)),
        2 => {
            // A stretch of the file again, somewhere else.
            let stretch = bytes[at..end].to_vec();
            let to = random.below(bytes.len() + 1);
            bytes.splice(to..to, stretch);
        }
        3 => {
            let word = WORDS[random.below(WORDS.len())];
            let end = (at + random.below(4)).min(bytes.len());
            bytes.splice(at..end, word.bytes());
        }
        4 => bytes[at..end].reverse(),
        5 => bytes.iter_mut().filter(|byte| **byte == b'\n').for_each(|byte| *byte = b" \r"[at % 2]),
        6 => bytes[at..end].iter_mut().filter(|byte| byte.is_ascii_digit()).for_each(|byte| *byte = b'1' + (*byte % 8)),
        _ => {
            for byte in bytes.get_mut(at..(at + 1 + random.below(4)).min(end.max(at))).into_iter().flatten() {
                *byte = random.bits() as u8;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn most_mutations_change_something_and_none_grows_without_bound() {
        let good = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec();
        let mut random = Random::new(5);
        let mut changed = 0;
        for _ in 0..1000 {
            let mut bytes = good.clone();
            mutate(&mut bytes, &mut random);
            assert!(bytes.len() <= good.len() + good.len() / 4 + 20);
            changed += usize::from(bytes != good);
        }
        assert!(changed > 600, "{changed}");
    }
}
