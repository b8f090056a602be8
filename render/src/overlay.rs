//! What is drawn over the bodies: frames with their names, the world's axes, the scale.

use crate::camera::Camera;
use crate::canvas::{Canvas, Rgb};
use crate::paint::{FINE, Painted};
use crate::raster::{to_f64, whole};
use crate::scene::Mark;
use crate::text::{Font, width};

/// The colours of x, y and z.
const AXES: [Rgb; 3] = [[200, 32, 38], [22, 136, 44], [28, 72, 208]];

/// Text and the scale's bar.
pub(crate) const TEXT: Rgb = [36, 38, 44];

/// The names of frames behind a body.
const HIDDEN: Rgb = [112, 116, 124];

/// How much of a frame behind a body is seen.
const FAINT: f64 = 0.4;

/// The length of a frame's axes in pixels: of ports, and of parts.
const AXIS: [f64; 2] = [22.0, 40.0];

/// The length of the world's axes in the corner, in pixels.
const CORNER: f64 = 20.0;

/// Where an axis has its name, as a multiple of its length.
const NAME: f64 = 1.35;

/// How far axes and names stay from the corner, in pixels.
const FREE: f64 = 16.0;

/// A text and the upper left corner of its place, in pixels of the picture.
pub(crate) struct Label {
    text: String,
    at: [usize; 2],
    font: Font,
    color: Rgb,
    boxed: bool,
}

impl Label {
    pub(crate) fn write(&self, canvas: &mut Canvas) {
        let [x, y] = self.at;
        if self.boxed {
            let wide = width(&self.text, self.font) + 2;
            let place = [x.saturating_sub(1), y, wide, self.font.height()];
            canvas.fill(place, [255, 255, 255], 0.72);
        }
        canvas.text(&self.text, self.at, self.font, self.color);
    }
}

/// An axis from a point of the panel, as it is seen: a line with a short head.
fn axis(canvas: &mut Canvas, from: [f64; 2], d: [f64; 2], color: Rgb, (thick, share): (f64, f64)) {
    let fine = to_f64(FINE);
    let to = [from[0] + d[0], from[1] + d[1]];
    let scaled = |p: [f64; 2]| p.map(|x| x * fine);
    canvas.line(scaled(from), scaled(to), thick * fine, color, share);
    let long = (d[0] * d[0] + d[1] * d[1]).sqrt();
    if long > 6.0 {
        let [x, y] = d.map(|c| c / long);
        for side in [1.0, -1.0] {
            let head = [
                to[0] - 5.0 * x + 2.5 * side * y,
                to[1] - 5.0 * y - 2.5 * side * x,
            ];
            canvas.line(scaled(to), scaled(head), thick * fine, color, share);
        }
    }
}

/// Draws frames, those behind a body faintly. Gives the labels that found a place, and how many did not.
pub(crate) fn marks(painted: &mut Painted, camera: &Camera, marks: &[Mark]) -> (Vec<Label>, usize) {
    let [wide, high] = camera.size;
    let mut taken: Vec<[f64; 4]> = Vec::new();
    let mut labels = Vec::new();
    let mut without = 0;
    let seen = |p: [f64; 3]| (0.0..wide).contains(&p[0]) && (0.0..high).contains(&p[1]);
    let shown = || {
        marks
            .iter()
            .map(|m| (m, camera.project(m.frame.origin)))
            .filter(|(_, p)| seen(*p))
    };
    for (mark, [x, y, z]) in shown() {
        let share = if painted.is_hidden([x, y, z]) {
            FAINT
        } else {
            1.0
        };
        let canvas = &mut painted.canvas;
        taken.push([x - 4.0, y - 4.0, 8.0, 8.0]);
        let long = if mark.large { AXIS[1] } else { AXIS[0] };
        let ([a, b, c], [d, e, f]) = (mark.frame.z, mark.frame.x);
        let across = [b * f - c * e, c * d - a * f, a * e - b * d];
        for (color, direction) in AXES.iter().zip([mark.frame.x, across, mark.frame.z]) {
            let [right, up, _] = camera.turn(direction);
            let d = [long * right, -long * up];
            axis(canvas, [x, y], d, *color, (1.5, share));
        }
        let fine = to_f64(FINE);
        let dot = [x * fine, y * fine];
        canvas.line(dot, dot, 5.0 * fine, TEXT, share);
    }
    for (mark, [x, y, z]) in shown() {
        let hidden = painted.is_hidden([x, y, z]);
        let font = Font::Small;
        let size = [
            to_f64(width(&mark.label, font)) + 2.0,
            to_f64(font.height()),
        ];
        let free = |place: &[f64; 4]| {
            let [px, py, w, h] = *place;
            px >= 1.0
                && py >= 1.0
                && px + w < wide
                && py + h < high
                && !taken.iter().any(|[qx, qy, v, u]| {
                    px < qx + v && *qx < px + w && py < qy + u && *qy < py + h
                })
        };
        // Beside the origin, then farther and farther above and below.
        let right = x + 6.0;
        let left = x - 6.0 - size[0];
        let place = (0..12)
            .flat_map(|step| {
                let off = f64::from(step) * 6.0;
                [(right, off), (left, off), (right, -off), (left, -off)]
            })
            .map(|(px, off)| [px, y - 5.0 + off, size[0], size[1]])
            .find(free);
        match place {
            Some(place) => {
                taken.push(place);
                labels.push(Label {
                    text: mark.label.clone(),
                    at: [whole(place[0] + 1.0), whole(place[1])],
                    font,
                    color: if hidden { HIDDEN } else { TEXT },
                    boxed: true,
                });
            }
            None => without += 1,
        }
    }
    (labels, without)
}

/// Draws the world's axes into the lower left corner of the fine canvas.
pub(crate) fn world(canvas: &mut Canvas, camera: &Camera) -> Vec<Label> {
    let mut labels = Vec::new();
    let axes = [
        ("x", [1.0, 0.0, 0.0]),
        ("y", [0.0, 1.0, 0.0]),
        ("z", [0.0, 0.0, 1.0]),
    ];
    // The one that points away from the viewer first, so that the nearer ones lie over it.
    let mut order: Vec<_> = axes
        .iter()
        .zip(AXES)
        .map(|((name, d), color)| (*name, camera.turn(*d), color))
        .collect();
    order.sort_by(|a, b| a.1[2].total_cmp(&b.1[2]));
    // As near to the corner as the axes that point there allow.
    let reach = |way: fn(&[f64; 3]) -> f64| {
        let all = order.iter().map(|(_, d, _)| CORNER * NAME * way(d));
        all.fold(0.0, f64::max)
    };
    let origin = [
        FREE + reach(|d| -d[0]),
        camera.size[1] - FREE - reach(|d| -d[1]),
    ];
    for (name, [right, up, _], color) in order {
        let d = [CORNER * right, -CORNER * up];
        // An axis that is seen end-on has no direction in the picture.
        if d[0].abs() + d[1].abs() < 1.0 {
            continue;
        }
        axis(canvas, origin, d, color, (1.8, 1.0));
        let tip = [origin[0] + d[0] * NAME, origin[1] + d[1] * NAME];
        labels.push(Label {
            text: name.to_owned(),
            at: [whole(tip[0] - 3.5), whole(tip[1] - 7.0)],
            font: Font::Bold,
            color,
            boxed: false,
        });
    }
    labels
}

/// Draws a bar of a round length into the lower right corner of the fine canvas.
pub(crate) fn scale(canvas: &mut Canvas, camera: &Camera) -> Option<Label> {
    let [wide, high] = camera.size;
    let most = wide / 5.0 / camera.px_per_mm;
    let length = round_below(most)?;
    let px = length * camera.px_per_mm;
    let (right, y) = (wide - 14.0, high - 12.0);
    let fine = to_f64(FINE);
    let mut stroke = |a: [f64; 2], b: [f64; 2]| {
        canvas.line(
            a.map(|c| c * fine),
            b.map(|c| c * fine),
            1.5 * fine,
            TEXT,
            1.0,
        );
    };
    stroke([right - px, y], [right, y]);
    for x in [right - px, right] {
        stroke([x, y - 4.0], [x, y + 4.0]);
    }
    let text = format!("{length} mm");
    let left = right - px / 2.0 - to_f64(width(&text, Font::Normal)) / 2.0;
    Some(Label {
        text,
        at: [whole(left.max(0.0)), whole((y - 18.0).max(0.0))],
        font: Font::Normal,
        color: TEXT,
        boxed: false,
    })
}

/// The largest of 1, 2 and 5 times a power of ten that is not above `most`.
fn round_below(most: f64) -> Option<f64> {
    if !(1e-6..1e9).contains(&most) {
        return None;
    }
    // Powers below one are reckoned by division, which gives the nearest number to each.
    let (mut ten, mut below) = (1.0, 1.0);
    while ten * 10.0 <= most {
        ten *= 10.0;
    }
    while ten / below > most {
        below *= 10.0;
    }
    [5.0, 2.0, 1.0]
        .into_iter()
        .map(|n| n * ten / below)
        .find(|n| *n <= most)
}

#[cfg(test)]
mod tests {
    #[test]
    fn bars_have_round_lengths() {
        for (most, length) in [
            (73.0, 50.0),
            (49.9, 20.0),
            (1.0, 1.0),
            (0.37, 0.2),
            (0.05, 0.05),
            (19.0, 10.0),
        ] {
            assert_eq!(super::round_below(most), Some(length));
        }
        assert_eq!(super::round_below(f64::NAN), None);
    }
}
