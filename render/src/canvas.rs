//! Colours, pixel by pixel.

use crate::raster::{byte, to_f64, whole};

/// Red, green, blue.
pub(crate) type Rgb = [u8; 3];

/// A picture in colours, row by row from the top.
#[derive(Debug, Clone)]
pub(crate) struct Canvas {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) pixels: Vec<Rgb>,
}

/// A colour from numbers between 0 and 1.
pub(crate) fn rgb(color: [f64; 3]) -> Rgb {
    color.map(|c| byte(c * 255.0))
}

/// `share` of the second colour over the first.
pub(crate) fn mix(under: Rgb, over: Rgb, share: f64) -> Rgb {
    let mut out = under;
    for (o, top) in out.iter_mut().zip(over) {
        *o = byte(f64::from(*o) + (f64::from(top) - f64::from(*o)) * share);
    }
    out
}

impl Canvas {
    pub(crate) fn new(width: usize, height: usize, color: Rgb) -> Self {
        Self {
            width,
            height,
            pixels: vec![color; width * height],
        }
    }

    pub(crate) fn get_mut(&mut self, x: usize, y: usize) -> Option<&mut Rgb> {
        if x < self.width {
            self.pixels.get_mut(y * self.width + x)
        } else {
            None
        }
    }

    /// Half the resolution: each pixel the mean of four.
    pub(crate) fn halved(&self) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let mut pixels = Vec::with_capacity(width * height);
        let mut rows = self.pixels.chunks_exact(self.width.max(1));
        while let (Some(upper), Some(lower)) = (rows.next(), rows.next()) {
            for (a, b) in upper
                .as_chunks::<2>()
                .0
                .iter()
                .zip(lower.as_chunks::<2>().0)
            {
                let [[p, q], [r, s]] = [a, b];
                let mut mean = [0; 3];
                for ((((m, p), q), r), s) in mean.iter_mut().zip(p).zip(q).zip(r).zip(s) {
                    *m =
                        byte((f64::from(*p) + f64::from(*q) + f64::from(*r) + f64::from(*s)) / 4.0);
                }
                pixels.push(mean);
            }
        }
        Self {
            width,
            height,
            pixels,
        }
    }

    /// Puts another picture onto this one, its upper left corner at (x, y).
    pub(crate) fn put(&mut self, other: &Self, x: usize, y: usize) {
        for (dy, row) in other.pixels.chunks_exact(other.width.max(1)).enumerate() {
            for (dx, color) in row.iter().enumerate() {
                if let Some(pixel) = self.get_mut(x + dx, y + dy) {
                    *pixel = *color;
                }
            }
        }
    }

    /// Fills a rectangle, `share` of its colour over what is there.
    pub(crate) fn fill(&mut self, [x, y, w, h]: [usize; 4], color: Rgb, share: f64) {
        for y in y..y + h {
            for x in x..x + w {
                if let Some(pixel) = self.get_mut(x, y) {
                    *pixel = mix(*pixel, color, share);
                }
            }
        }
    }

    /// A straight line of a thickness in pixels.
    pub(crate) fn line(&mut self, a: [f64; 2], b: [f64; 2], thick: f64, color: Rgb, share: f64) {
        let d = [b[0] - a[0], b[1] - a[1]];
        let square = (d[0] * d[0] + d[1] * d[1]).max(1e-12);
        let reach = thick / 2.0;
        let range = |p: f64, q: f64, most: usize| {
            let bound = |x: f64| whole(x.clamp(0.0, to_f64(most)));
            bound((p.min(q) - reach).floor())..bound((p.max(q) + reach).ceil())
        };
        for y in range(a[1], b[1], self.height) {
            for x in range(a[0], b[0], self.width) {
                let p = [to_f64(x) + 0.5 - a[0], to_f64(y) + 0.5 - a[1]];
                let t = ((p[0] * d[0] + p[1] * d[1]) / square).clamp(0.0, 1.0);
                let off = [p[0] - d[0] * t, p[1] - d[1] * t];
                if off[0] * off[0] + off[1] * off[1] <= reach * reach
                    && let Some(pixel) = self.get_mut(x, y)
                {
                    *pixel = mix(*pixel, color, share);
                }
            }
        }
    }
}
