//! Texts, in the bitmap fonts of `embedded-graphics`.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::mono_font::ascii::{FONT_6X12, FONT_7X13, FONT_8X13_BOLD};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::{DrawTarget, Drawable, OriginDimensions, Point, Size};
use embedded_graphics::text::{Baseline, Text};

use crate::canvas::{Canvas, Rgb};

/// The sizes of text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Font {
    /// Labels in the picture.
    Small,
    /// The legend.
    Normal,
    /// Titles.
    Bold,
}

impl Font {
    fn mono(self) -> &'static MonoFont<'static> {
        match self {
            Self::Small => &FONT_6X12,
            Self::Normal => &FONT_7X13,
            Self::Bold => &FONT_8X13_BOLD,
        }
    }

    /// Width of a character in pixels.
    pub(crate) fn advance(self) -> usize {
        size(self.mono().character_size.width)
    }

    /// Height of a line in pixels.
    pub(crate) fn height(self) -> usize {
        size(self.mono().character_size.height)
    }
}

fn size(n: u32) -> usize {
    usize::try_from(n).unwrap_or_default()
}

/// How wide a text is, in pixels.
pub(crate) fn width(text: &str, font: Font) -> usize {
    text.chars().count() * font.advance()
}

/// The text, cut to so many pixels with three dots where it is longer.
pub(crate) fn fitting(text: &str, font: Font, most: usize) -> String {
    let room = most / font.advance();
    if text.chars().count() <= room {
        return text.to_owned();
    }
    let kept: String = text.chars().take(room.saturating_sub(3)).collect();
    format!("{kept}...")
}

impl Canvas {
    /// Writes a text, its upper left corner at (x, y).
    pub(crate) fn text(&mut self, text: &str, [x, y]: [usize; 2], font: Font, color: Rgb) {
        let [r, g, b] = color;
        let style = MonoTextStyle::new(font.mono(), Rgb888::new(r, g, b));
        let place = |n: usize| i32::try_from(n).unwrap_or(i32::MAX);
        let at = Point::new(place(x), place(y));
        // Drawing on this canvas cannot fail.
        let Ok(_) = Text::with_baseline(text, at, style, Baseline::Top).draw(self);
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        let side = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Size::new(side(self.width), side(self.height))
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            if let (Ok(x), Ok(y)) = (usize::try_from(at.x), usize::try_from(at.y))
                && let Some(pixel) = self.get_mut(x, y)
            {
                *pixel = [color.r(), color.g(), color.b()];
            }
        }
        Ok(())
    }
}
