//! File names that every program can open.

/// The most characters of a name that is left as it is: endings that are put behind the name must fit as well.
const MAX_NAME_CHARS: usize = 100;

/// A name of letters, digits and `-_.` alone, for a name that other programs may not be able to open: POV-Ray opens no
/// file whose name is not ASCII, and spaces end names in Wavefront files. A name that is not plain, or too long, is cut
/// and ends with a number that is computed from all of it, so that different names stay different.
pub fn plain(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    if name.len() <= MAX_NAME_CHARS && name.chars().all(is_plain) {
        return name.to_owned();
    }
    // FNV-1a, of characters (http://www.isthe.com/chongo/tech/comp/fnv).
    let number = (name.chars()).fold(0x811c_9dc5_u32, |hash, c| {
        (hash ^ u32::from(c)).wrapping_mul(0x0100_0193)
    });
    let start = name.chars().take(MAX_NAME_CHARS - 9);
    let start: String = start.map(|c| if is_plain(c) { c } else { '_' }).collect();
    format!("{start}_{number:08x}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn plain_names_stay_and_others_stay_apart() {
        for name in ["scene", "a-b_c.v2", "-", &"x".repeat(100)] {
            assert_eq!(plain(name), name);
        }
        let long = "x".repeat(101);
        let names = [
            "škola",
            "čkola",
            "_kola",
            "two words",
            "two\twords",
            "two_words",
            "a%b",
            "a\"b",
            "a\\b",
            "a'b",
            "a$b",
            "a#b",
            "a\nb",
            "a/b",
            "🎲",
            &long,
            &(long.clone() + "x"),
        ];
        let plains: HashSet<String> = names.iter().map(|n| plain(n)).collect();
        assert_eq!(plains.len(), names.len(), "{plains:?}");
        for name in plains {
            assert!(name.len() <= MAX_NAME_CHARS && name.bytes().all(|b| b.is_ascii_graphic()));
            assert!(
                !name.contains(['%', '"', '\\', '\'', '$', '#', '/']),
                "{name}"
            );
            assert_eq!(plain(&name), name);
        }
    }
}
