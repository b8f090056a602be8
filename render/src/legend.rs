//! What stands below the views: notes, and which colour is which part.

use crate::canvas::{Canvas, Rgb, rgb};
use crate::overlay::TEXT;
use crate::scene::{Entry, Sheet};
use crate::text::{Font, fitting, width};

/// The height of a row in pixels.
const ROW: usize = 17;

/// The side of a colour's square in pixels.
const SQUARE: usize = 11;

/// The free border in pixels.
const BORDER: usize = 10;

/// Notes stand out.
const NOTE: Rgb = [168, 20, 20];

/// The rows of notes and legend, laid out.
pub(crate) struct Rows<'a> {
    notes: Vec<String>,
    entries: Vec<Vec<(usize, &'a Entry, String)>>,
    /// How many entries have no room.
    left_out: usize,
}

impl<'a> Rows<'a> {
    /// Lays out at most a quarter of the sheet.
    pub(crate) fn of(sheet: &'a Sheet, wide: usize, high: usize) -> Self {
        let most_rows = (high / 4 / ROW).max(1);
        let room = wide.saturating_sub(2 * BORDER);
        let mut notes: Vec<String> = Vec::new();
        for note in &sheet.notes {
            if notes.len() < most_rows / 2 {
                notes.push(fitting(note, Font::Normal, room));
            }
        }
        let mut rows: Vec<Vec<(usize, &Entry, String)>> = Vec::new();
        let mut at = room;
        let mut left_out = 0;
        for entry in &sheet.legend {
            let label = fitting(&entry.label, Font::Normal, room.saturating_sub(SQUARE + 6));
            let long = SQUARE + 6 + width(&label, Font::Normal) + 18;
            // The last 120 pixels of the last row stay free for the count of what is left out.
            let last = rows.len() + notes.len() >= most_rows;
            let end = if last { room.saturating_sub(120) } else { room };
            if at + long > end + 18 || rows.is_empty() {
                if last || left_out > 0 {
                    left_out += 1;
                    continue;
                }
                rows.push(Vec::new());
                at = 0;
            }
            if let Some(row) = rows.last_mut() {
                row.push((at, entry, label));
                at += long;
            }
        }
        Self {
            notes,
            entries: rows,
            left_out,
        }
    }

    /// How high it is in pixels.
    pub(crate) fn height(&self) -> usize {
        match self.notes.len() + self.entries.len() {
            0 => 0,
            rows => rows * ROW + BORDER,
        }
    }

    /// Draws it from a height of the canvas on.
    pub(crate) fn draw(&self, canvas: &mut Canvas, top: usize) {
        let mut y = top + BORDER / 2;
        for note in &self.notes {
            canvas.text(note, [BORDER, y + 1], Font::Normal, NOTE);
            y += ROW;
        }
        for row in &self.entries {
            for (x, entry, label) in row {
                let x = BORDER + x;
                canvas.fill([x, y + 2, SQUARE, SQUARE], TEXT, 1.0);
                canvas.fill(
                    [x + 1, y + 3, SQUARE - 2, SQUARE - 2],
                    rgb(entry.color),
                    1.0,
                );
                canvas.text(label, [x + SQUARE + 6, y + 1], Font::Normal, TEXT);
            }
            y += ROW;
        }
        if self.left_out > 0 {
            let text = format!("and {} more", self.left_out);
            let x = canvas
                .width
                .saturating_sub(BORDER + width(&text, Font::Normal));
            canvas.text(&text, [x, y.saturating_sub(ROW) + 1], Font::Normal, TEXT);
        }
    }
}
