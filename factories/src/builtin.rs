//! The sources that are part of the program.

/// Every built-in factory: name and source, sorted by name.
pub(crate) const ALL: [(&str, &str); 5] = [
    (
        "base_frame.housing_block",
        include_str!("../builtin/base_frame.housing_block.star"),
    ),
    (
        "base_frame.rect_plate",
        include_str!("../builtin/base_frame.rect_plate.star"),
    ),
    (
        "base_frame.stepped_shaft",
        include_str!("../builtin/base_frame.stepped_shaft.star"),
    ),
    ("bearing.ball", include_str!("../builtin/bearing.ball.star")),
    ("gear.spur", include_str!("../builtin/gear.spur.star")),
];

#[cfg(test)]
mod tests {
    use super::ALL;

    #[test]
    fn every_file_is_listed_once_and_in_order() {
        let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/builtin")).unwrap();
        let mut files: Vec<String> = files
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .map(|f| {
                f.strip_suffix(".star")
                    .expect("only .star files here")
                    .to_owned()
            })
            .collect();
        files.sort();
        assert_eq!(files, ALL.map(|(name, _)| name));
    }
}
