//! The sources that are part of the program.

/// Every built-in factory: name and source, sorted by name.
pub(crate) const ALL: [(&str, &str); 13] = [
    (
        "base_frame.bolt_circle_flange",
        include_str!("../builtin/base_frame.bolt_circle_flange.star"),
    ),
    (
        "base_frame.boss",
        include_str!("../builtin/base_frame.boss.star"),
    ),
    (
        "base_frame.coupling_hub",
        include_str!("../builtin/base_frame.coupling_hub.star"),
    ),
    (
        "base_frame.housing_block",
        include_str!("../builtin/base_frame.housing_block.star"),
    ),
    (
        "base_frame.l_bracket",
        include_str!("../builtin/base_frame.l_bracket.star"),
    ),
    (
        "base_frame.rect_plate",
        include_str!("../builtin/base_frame.rect_plate.star"),
    ),
    (
        "base_frame.stepped_shaft",
        include_str!("../builtin/base_frame.stepped_shaft.star"),
    ),
    (
        "base_frame.u_channel",
        include_str!("../builtin/base_frame.u_channel.star"),
    ),
    ("bearing.ball", include_str!("../builtin/bearing.ball.star")),
    (
        "fastener.bolt",
        include_str!("../builtin/fastener.bolt.star"),
    ),
    ("fastener.nut", include_str!("../builtin/fastener.nut.star")),
    (
        "fastener.washer",
        include_str!("../builtin/fastener.washer.star"),
    ),
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
