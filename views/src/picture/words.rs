//! What a picture says in words: titles, notes, and the caption beside it.

use assemcad_render::{Picture, Sheet};

use super::wanted::{Camera, Wanted};

/// The title of a view.
pub(super) fn title(id: &str, wanted: &Wanted, camera: &Camera) -> String {
    let mut title = format!("{id}: {}", camera.name());
    if wanted.explode > 0.0 {
        title.push_str(", exploded");
    }
    if let Some(section) = wanted.section {
        let axis = ["x", "y", "z"]
            .get(section.axis)
            .copied()
            .unwrap_or_default();
        title.push_str(&format!(", cut at {axis} = {} mm", section.offset_mm));
    }
    title
}

/// So many things that are missing are named.
const MOST_MISSING: usize = 20;

/// The notes of a picture with something missing.
pub(super) fn notes(missing: &[String]) -> Vec<String> {
    let named = missing.iter().take(MOST_MISSING);
    let mut notes: Vec<String> = named.map(|m| format!("not shown: {m}")).collect();
    match missing.len().saturating_sub(MOST_MISSING) {
        0 => {}
        more => notes.push(format!("not shown: {more} more")),
    }
    notes
}

/// At most so many names, and how many more there are.
pub(super) fn list(names: &[String], most: usize) -> String {
    let shown: Vec<&str> = names.iter().take(most).map(String::as_str).collect();
    match names.len().saturating_sub(most) {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}

/// The text beside the picture: where each view looks, what its pixels mean, and what is missing.
pub(super) fn caption(
    id: &str,
    wanted: &Wanted,
    sheet: &Sheet,
    picture: &Picture,
    missing: &[String],
) -> String {
    let mut lines = vec![format!(
        "Assembly '{id}', {} x {} pixels, parallel projection, millimetres.",
        wanted.width, wanted.height
    )];
    for (panel, shown) in sheet.panels.iter().zip(&picture.shown) {
        let camera = shown.camera;
        let [x, y] = shown.pixel(camera.middle);
        lines.push(format!(
            "{}: {} mm per pixel; pixel ({}, {}) shows {}; right is {}, up is {}, the viewer is towards {}.",
            panel.title,
            short(1.0 / camera.px_per_mm),
            short(x),
            short(y),
            triple(camera.middle),
            triple(camera.right),
            triple(camera.up),
            triple(camera.toward),
        ));
    }
    let entries: Vec<String> = sheet.legend.iter().map(|e| e.label.clone()).collect();
    lines.push(format!("Legend: {}.", entries.join("; ")));
    if wanted.section.is_some() {
        lines.push("The viewer's side is cut away; cut material is hatched.".to_owned());
    }
    if wanted.section.is_some() && wanted.explode == 0.0 {
        lines.push(
            "Red is material of two parts in one place, where it is wider than about two pixels."
                .to_owned(),
        );
    }
    for note in &sheet.notes {
        lines.push(format!("{note}."));
    }
    if picture.labels_left_out > 0 {
        lines.push(format!(
            "{} labels found no place; aim the camera at a smaller region to see them.",
            picture.labels_left_out
        ));
    }
    if missing.is_empty() {
        lines.push("All parts are shown.".to_owned());
    }
    lines.join("\n")
}

/// Four digits after the point are enough to look.
fn short(x: f64) -> f64 {
    libm::round(x * 1e4) / 1e4 + 0.0
}

fn triple(v: [f64; 3]) -> String {
    let [x, y, z] = v.map(short);
    format!("({x}, {y}, {z})")
}
