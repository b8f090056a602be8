//! A whole picture: its panels, the legend below them, and the file.

use crate::camera::Camera;
use crate::canvas::Canvas;
use crate::legend::Rows;
use crate::overlay::{self, TEXT};
use crate::paint::{self, PAPER};
use crate::raster::to_f64;
use crate::scene::{Panel, Sheet};
use crate::text::{Font, fitting};
use crate::{LEAST_PX, MOST_PANELS, MOST_PX, RenderError, encode};

/// A finished picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The file.
    pub png: Vec<u8>,
    /// Its pixels, row by row from the top: red, green, blue.
    pub pixels: Vec<[u8; 3]>,
    /// The views, in the sheet's order.
    pub shown: Vec<Shown>,
    /// How many labels of frames found no place.
    pub labels_left_out: usize,
}

/// Where a view is in the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Its camera, whose pixels are counted from the panel's upper left corner.
    pub camera: Camera,
    /// That corner, in pixels of the picture.
    pub corner: [usize; 2],
}

impl Shown {
    /// Where a point of the world is in the picture, in pixels from the left and from the top.
    #[must_use]
    pub fn pixel(&self, point: [f64; 3]) -> [f64; 2] {
        let [x, y, _] = self.camera.project(point);
        let [left, top] = self.corner.map(to_f64);
        [left + x, top + y]
    }
}

/// Draws a sheet.
///
/// # Errors
/// When its size, its number of panels or a camera is none.
pub fn draw(sheet: &Sheet) -> Result<Picture, RenderError> {
    let allowed = LEAST_PX..=MOST_PX;
    if !allowed.contains(&sheet.width) || !allowed.contains(&sheet.height) {
        return Err(RenderError::Size);
    }
    if sheet.panels.is_empty() || sheet.panels.len() > MOST_PANELS {
        return Err(RenderError::Panels);
    }
    let side = |n: u32| usize::try_from(n).map_err(|_| RenderError::Size);
    let (width, height) = (side(sheet.width)?, side(sheet.height)?);
    let mut canvas = Canvas::new(width, height, PAPER);
    let rows = Rows::of(sheet, width, height);
    let above = height - rows.height();
    let (across, down) = grid(sheet.panels.len());
    let mut placed = Vec::new();
    for (i, panel) in sheet.panels.iter().enumerate() {
        let (column, row) = (i % across, i / across);
        // The borders are rounded as a whole, so that no row of pixels stays empty.
        let (left, right) = (width * column / across, width * (column + 1) / across);
        let (top, bottom) = (above * row / down, above * (row + 1) / down);
        let size = [right - left, bottom - top];
        let camera = Camera::over(&panel.eye, &panel.bodies, size.map(to_f64))?;
        placed.push((panel, camera, [left, top], size));
    }
    // Views of the whole have one scale on one sheet, as on a drawing.
    let whole = |panel: &Panel| panel.eye.aim.is_none();
    let least = placed
        .iter()
        .filter(|(panel, ..)| whole(panel))
        .map(|(_, camera, ..)| camera.px_per_mm)
        .fold(f64::INFINITY, f64::min);
    let mut shown = Vec::new();
    let mut labels_left_out = 0;
    for (panel, mut camera, [left, top], size) in placed {
        if whole(panel) {
            camera.px_per_mm = least;
        }
        let (drawn, left_out) = one(panel, &camera, size);
        canvas.put(&drawn, left, top);
        labels_left_out += left_out;
        if left > 0 {
            canvas.fill([left, top, 1, size[1]], TEXT, 0.3);
        }
        if top > 0 {
            canvas.fill([left, top, size[0], 1], TEXT, 0.3);
        }
        shown.push(Shown {
            camera,
            corner: [left, top],
        });
    }
    if rows.height() > 0 {
        canvas.fill([0, above, width, 1], TEXT, 0.3);
    }
    rows.draw(&mut canvas, above);
    Ok(Picture {
        png: encode::png(&canvas)?,
        pixels: canvas.pixels,
        shown,
        labels_left_out,
    })
}

/// Columns and rows for so many panels.
fn grid(panels: usize) -> (usize, usize) {
    let across = match panels {
        1 => 1,
        2..=4 => 2,
        _ => 3,
    };
    (across, panels.div_ceil(across))
}

/// One panel at its size, and how many labels have no place.
fn one(panel: &Panel, camera: &Camera, [width, height]: [usize; 2]) -> (Canvas, usize) {
    let mut painted = paint::bodies(panel, camera, width, height);
    let (mut labels, left_out) = overlay::marks(&mut painted, camera, &panel.marks);
    labels.extend(overlay::world(&mut painted.canvas, camera));
    labels.extend(overlay::scale(&mut painted.canvas, camera));
    let mut canvas = painted.canvas.halved();
    for label in labels {
        label.write(&mut canvas);
    }
    let title = fitting(&panel.title, Font::Bold, width.saturating_sub(20));
    canvas.text(&title, [10, 8], Font::Bold, TEXT);
    (canvas, left_out)
}
