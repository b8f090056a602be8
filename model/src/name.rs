//! Names that clients choose, and suggestions for misspelt ones.

/// The longest name in characters.
pub const MAX_LENGTH: usize = 64;

/// The rule for names in plain words, for messages.
pub const RULE: &str =
    "1 to 64 characters from A-Z, a-z, 0-9, '_', '-'; the first a letter or a digit";

/// Whether a text may name an assembly, a part or a mate.
///
/// Names become file names and STEP names, so they hold nothing that a path, a shell or a STEP string
/// could take for something else.
#[must_use]
pub fn is_valid(name: &str) -> bool {
    name.len() <= MAX_LENGTH
        && name.starts_with(|c: char| c.is_ascii_alphanumeric())
        && name
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-')
}

/// The candidates most like `wanted`, best first, at most `most`.
///
/// Likeness is the Jaro-Winkler measure; equal likeness keeps the given order.
#[must_use]
pub fn nearest<'a>(
    wanted: &str,
    candidates: impl IntoIterator<Item = &'a str>,
    most: usize,
) -> Vec<&'a str> {
    // The measure takes as long as both lengths multiplied, and nobody misspells a name that long.
    if wanted.len() > 4 * MAX_LENGTH {
        return Vec::new();
    }
    let wanted = wanted.to_ascii_lowercase();
    let mut scored: Vec<(f64, &str)> = candidates
        .into_iter()
        .map(|c| (strsim::jaro_winkler(&wanted, &c.to_ascii_lowercase()), c))
        .filter(|(score, _)| *score > 0.6)
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    scored.into_iter().take(most).map(|(_, c)| c).collect()
}

/// So many names are offered in place of one that is unknown.
const MOST_OFFERED: usize = 60;

/// So many names are held against one that is unknown.
const MOST_COMPARED: usize = 2000;

/// Names in place of one that is unknown: the first of them, with how many more there are, and the one most like it.
#[must_use]
pub fn instead<'a>(wanted: &str, names: &[&'a str]) -> (serde_json::Value, Option<&'a str>) {
    let mut offered: Vec<String> = names
        .iter()
        .take(MOST_OFFERED)
        .map(|n| (*n).to_owned())
        .collect();
    if let Some(more) = names.len().checked_sub(MOST_OFFERED).filter(|n| *n > 0) {
        offered.push(format!("... and {more} more"));
    }
    let compared = names.iter().take(MOST_COMPARED).copied();
    (
        offered.into(),
        nearest(wanted, compared, 1).first().copied(),
    )
}

/// The first names in quotation marks, and how many more there are.
#[must_use]
pub fn listed(names: &[String], most: usize) -> String {
    let quoted: Vec<String> = names.iter().take(most).map(|n| format!("'{n}'")).collect();
    match names.len().saturating_sub(most) {
        0 => quoted.join(", "),
        more => format!("{} and {more} more", quoted.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::{is_valid, nearest};

    #[test]
    fn names_with_path_parts_are_refused() {
        for good in ["a", "shaft_1", "M6-nut", "9lives"] {
            assert!(is_valid(good), "{good}");
        }
        let long = "x".repeat(65);
        for bad in [
            "", ".", "..", "a/b", "a\\b", "a b", "-a", "_a", "a\0", "ä", "a.b", &long,
        ] {
            assert!(!is_valid(bad), "{bad}");
        }
    }

    #[test]
    fn what_is_offered_instead_has_an_end() {
        let names: Vec<String> = (0..5000).map(|i| format!("part_{i}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let (offered, near) = super::instead("prat_17", &names);
        assert_eq!(offered.as_array().map(Vec::len), Some(61));
        assert_eq!(offered.get(60).unwrap(), "... and 4940 more");
        assert_eq!(near, Some("part_17"));
        // The measure takes time by both lengths.
        assert!(nearest(&"p".repeat(700_000), names, 1).is_empty());
    }

    #[test]
    fn the_nearest_name_comes_first() {
        let all = [
            "base_frame.rect_plate",
            "bearing.ball",
            "base_frame.stepped_shaft",
        ];
        assert_eq!(
            nearest("base_frame.plate", all, 1),
            ["base_frame.rect_plate"]
        );
        assert_eq!(nearest("bearing.bal", all, 1), ["bearing.ball"]);
        assert!(nearest("qqq", all, 3).is_empty());
    }
}
