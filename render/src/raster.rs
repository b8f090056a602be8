//! Triangles and lines into a depth buffer.

/// What a pixel of a layer shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Texel {
    /// The body, counted from 1; 0 for nothing.
    pub(crate) body: u16,
    /// What of it.
    pub(crate) kind: Kind,
    /// How bright it is, from 0 to 255.
    pub(crate) shade: u8,
}

/// What of a body a pixel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Kind {
    /// Its surface.
    #[default]
    Face,
    /// Material that was cut.
    Cut,
    /// Material of two bodies in one place that was cut.
    Both,
    /// An edge or an outline.
    Line,
}

/// A picture of bodies with its depths, row by row from the top.
#[derive(Debug)]
pub(crate) struct Layer {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// How near to the viewer, in pixels; minus infinity where nothing is.
    pub(crate) depth: Vec<f32>,
    pub(crate) texels: Vec<Texel>,
}

impl Texel {
    fn is_cut_of_another(self, body: u16) -> bool {
        self.body != body && matches!(self.kind, Kind::Cut | Kind::Both)
    }
}

/// Cut faces whose depths differ by less, in pixels, are in one plane.
const LEVEL: f32 = 0.05;

/// A corner of a triangle: pixels from the left, from the top, towards the viewer; brightness 0 to 255.
pub(crate) type Corner = [f64; 4];

impl Layer {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            depth: vec![f32::NEG_INFINITY; width * height],
            texels: vec![Texel::default(); width * height],
        }
    }

    /// Draws a triangle where it is nearer than what is there. A pixel belongs to it when its middle
    /// does; triangles with a common edge share no pixel and leave none out.
    pub(crate) fn triangle(&mut self, corners: [Corner; 3], body: u16, kind: Kind) {
        let [a, b, c] = corners;
        let (u, v) = (minus(b, a), minus(c, a));
        // Seen from outside, which is counter-clockwise in space, y being counted downwards here.
        let turn = u[0] * v[1] - u[1] * v[0];
        if turn.is_nan() || turn >= 0.0 {
            return;
        }
        let slope = |k: usize| {
            let (p, q) = (component(&u, k), component(&v, k));
            [(p * v[1] - q * u[1]) / turn, (q * u[0] - p * v[0]) / turn]
        };
        let (z, shade) = (slope(2), slope(3));
        let range = |k: usize| {
            let all = [component(&a, k), component(&b, k), component(&c, k)];
            all.iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
                    (l.min(*x), h.max(*x))
                })
        };
        let ((top, bottom), (z_low, z_high)) = (range(1), range(2));
        for y in pixels(top, bottom, self.height) {
            let middle = to_f64(y) + 0.5;
            let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
            for (p, q) in [(a, b), (b, c), (c, a)] {
                if let Some(x) = crossing(p, q, middle) {
                    from = from.min(x);
                    to = to.max(x);
                }
            }
            let columns = pixels(from, to, self.width);
            let Some(first) = columns.clone().next() else {
                continue;
            };
            let row = y * self.width + first..y * self.width + columns.end;
            let (Some(depths), Some(texels)) =
                (self.depth.get_mut(row.clone()), self.texels.get_mut(row))
            else {
                continue;
            };
            let (dx, dy) = (to_f64(first) + 0.5 - a[0], middle - a[1]);
            let (mut depth, mut light) = (
                a[2] + z[0] * dx + z[1] * dy,
                a[3] + shade[0] * dx + shade[1] * dy,
            );
            for (at, texel) in depths.iter_mut().zip(texels) {
                // A triangle seen almost edge-on has slopes that lead out of it.
                let near = narrow(depth.clamp(z_low, z_high));
                if kind == Kind::Cut && texel.is_cut_of_another(body) && (near - *at).abs() < LEVEL
                {
                    texel.kind = Kind::Both;
                } else if near > *at {
                    *at = near;
                    *texel = Texel {
                        body,
                        kind,
                        shade: byte(light),
                    };
                }
                depth += z[0];
                light += shade[0];
            }
        }
    }

    /// Draws an edge of a body as thick as `width` pixels, where it is seen, on the pixels of that body
    /// alone: the body's silhouette stays what it is.
    pub(crate) fn edge(&mut self, a: [f64; 3], b: [f64; 3], body: u16, width: usize) {
        let Some((a, b)) = clip(a, b, self.width, self.height) else {
            return;
        };
        let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let steps = (d[0].abs().max(d[1].abs()) * 1.5).ceil().max(1.0);
        let mut i = 0.0;
        while i <= steps {
            let t = i / steps;
            i += 1.0;
            let p = [a[0] + d[0] * t, a[1] + d[1] * t, a[2] + d[2] * t];
            let (x, y) = (p[0].floor(), p[1].floor());
            if self.is_seen(x, y, p[2]) {
                self.dot(x, y, body, width);
            }
        }
    }

    /// Whether a point is not behind everything around it: the surface right at an edge may be a pixel
    /// beside it.
    fn is_seen(&self, x: f64, y: f64, depth: f64) -> bool {
        let mut farthest = f64::INFINITY;
        for dy in [-1.0, 0.0, 1.0] {
            for dx in [-1.0, 0.0, 1.0] {
                let at = self.index(x + dx, y + dy);
                if let Some(there) = at.and_then(|i| self.depth.get(i)) {
                    farthest = farthest.min(f64::from(*there));
                }
            }
        }
        farthest.is_finite() && depth >= farthest - 0.5 || farthest == f64::NEG_INFINITY
    }

    fn dot(&mut self, x: f64, y: f64, body: u16, width: usize) {
        let back = to_f64(width / 2);
        for dy in 0..width {
            for dx in 0..width {
                let at = self.index(x + to_f64(dx) - back, y + to_f64(dy) - back);
                if let Some(texel) = at.and_then(|i| self.texels.get_mut(i))
                    && texel.body == body
                {
                    texel.kind = Kind::Line;
                }
            }
        }
    }

    /// Takes back what is cut twice but nowhere wider than four pixels: where round parts fit, the
    /// corners of their triangles reach into each other by less than that. All of it where `meant` says
    /// that it is none.
    pub(crate) fn settle_overlaps(&mut self, meant: bool) {
        let both = |texels: &[Texel], x: usize, y: usize| {
            let at = (x < self.width).then(|| texels.get(y * self.width + x));
            at.flatten().is_some_and(|t| t.kind == Kind::Both)
        };
        let mut kept = vec![false; self.texels.len()];
        let mut found = Vec::new();
        for y in 0..self.height {
            for x in 0..self.width {
                if !both(&self.texels, x, y) {
                    continue;
                }
                found.push(y * self.width + x);
                let square = || (0..5).flat_map(|dy| (0..5).map(move |dx| (dx, dy)));
                // The square of five by five pixels with this one at its corner.
                if meant && square().all(|(dx, dy)| both(&self.texels, x + dx, y + dy)) {
                    for (dx, dy) in square() {
                        if let Some(kept) = kept.get_mut((y + dy) * self.width + x + dx) {
                            *kept = true;
                        }
                    }
                }
            }
        }
        for i in found {
            if !kept.get(i).copied().unwrap_or_default()
                && let Some(texel) = self.texels.get_mut(i)
            {
                texel.kind = Kind::Cut;
            }
        }
    }

    /// How near the body is that is seen at a place; none where nothing is.
    pub(crate) fn depth_at(&self, x: f64, y: f64) -> Option<f64> {
        let depth = self.depth.get(self.index(x.floor(), y.floor())?)?;
        depth.is_finite().then_some(f64::from(*depth))
    }

    fn index(&self, x: f64, y: f64) -> Option<usize> {
        let inside = x >= 0.0 && y >= 0.0 && x < to_f64(self.width) && y < to_f64(self.height);
        inside.then(|| whole(y) * self.width + whole(x))
    }
}

fn minus(a: Corner, b: Corner) -> Corner {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]]
}

fn component(c: &Corner, k: usize) -> f64 {
    c.get(k).copied().unwrap_or_default()
}

/// Where a side crosses the row's middle. Always reckoned from its upper end, so that two triangles find
/// the same place for their common side.
fn crossing(p: Corner, q: Corner, y: f64) -> Option<f64> {
    let (p, q) = if p[1] <= q[1] { (p, q) } else { (q, p) };
    let inside = p[1] <= y && y < q[1];
    inside.then(|| p[0] + (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1])))
}

/// The pixels whose middles lie from `low` up to, but not at, `high`.
fn pixels(low: f64, high: f64, most: usize) -> core::ops::Range<usize> {
    let bound = |x: f64| whole((x - 0.5).ceil().clamp(0.0, to_f64(most)));
    if low < high {
        bound(low)..bound(high)
    } else {
        0..0
    }
}

/// The piece of a line that lies in the picture, give or take a pixel.
fn clip(a: [f64; 3], b: [f64; 3], width: usize, height: usize) -> Option<([f64; 3], [f64; 3])> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (p, q, most) in [(a[0], b[0], to_f64(width)), (a[1], b[1], to_f64(height))] {
        let d = q - p;
        let (low, high) = (-1.0 - p, most + 1.0 - p);
        if d == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
            continue;
        }
        let (s, t) = (low / d, high / d);
        from = from.max(s.min(t));
        to = to.min(s.max(t));
    }
    let at = |t: f64| {
        [
            a[0] + (b[0] - a[0]) * t,
            a[1] + (b[1] - a[1]) * t,
            a[2] + (b[2] - a[2]) * t,
        ]
    };
    (from <= to).then(|| (at(from), at(to)))
}

/// Sizes of pictures are small.
pub(crate) fn to_f64(n: usize) -> f64 {
    n as f64
}

/// A number that was held between 0 and the size of a picture.
pub(crate) fn whole(x: f64) -> usize {
    x as usize
}

/// The nearest byte.
pub(crate) fn byte(x: f64) -> u8 {
    (x + 0.5).clamp(0.0, 255.0) as u8
}

fn narrow(x: f64) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::{Kind, Layer};

    fn count(layer: &Layer, body: u16) -> usize {
        layer.texels.iter().filter(|t| t.body == body).count()
    }

    #[test]
    fn pixels_belong_to_one_of_two_triangles_with_a_common_side() {
        // A square of 40.3 x 30.7 pixels in two triangles, turned by the slope 3 to 4.
        let (u, v) = ([0.8 * 40.3, 0.6 * 40.3], [-0.6 * 30.7, 0.8 * 30.7]);
        let p = |s: f64, t: f64| {
            [
                30.0 + u[0] * s + v[0] * t,
                10.0 + u[1] * s + v[1] * t,
                0.0,
                0.0,
            ]
        };
        let (a, b, c, d) = (p(0.0, 0.0), p(1.0, 0.0), p(1.0, 1.0), p(0.0, 1.0));
        let mut both = Layer::new(100, 100);
        both.triangle([a, c, b], 1, Kind::Face);
        both.triangle([a, d, c], 2, Kind::Face);
        let whole = count(&both, 1) + count(&both, 2);
        let mut alone = Layer::new(100, 100);
        alone.triangle([a, d, c], 2, Kind::Face);
        assert_eq!(count(&alone, 2), count(&both, 2), "none is in both");
        // Its middle decides: the count is the area up to the border's share.
        assert!((whole as f64 - 40.3 * 30.7).abs() < 12.0, "{whole}");
        // Seen from behind there is nothing.
        let mut behind = Layer::new(100, 100);
        behind.triangle([a, b, c], 1, Kind::Face);
        assert_eq!(count(&behind, 1), 0);
    }

    #[test]
    fn the_nearer_one_is_seen_in_either_order() {
        let square = |z: f64| {
            [
                [0.0, 0.0, z, 0.0],
                [0.0, 20.0, z, 0.0],
                [20.0, 20.0, z, 0.0],
            ]
        };
        let slanted = [
            [0.0, 0.0, -10.0, 0.0],
            [0.0, 20.0, -10.0, 0.0],
            [20.0, 20.0, 10.0, 0.0],
        ];
        for order in [[1, 2], [2, 1]] {
            let mut layer = Layer::new(20, 20);
            for body in order {
                let corners = if body == 1 { square(0.0) } else { slanted };
                layer.triangle(corners, body, Kind::Face);
            }
            // The slanted one is nearer where x > 10.
            for (i, texel) in layer.texels.iter().enumerate().filter(|(_, t)| t.body != 0) {
                assert_eq!(texel.body, if i % 20 < 10 { 1 } else { 2 }, "{i}");
            }
        }
    }

    #[test]
    fn hidden_edges_are_not_drawn() {
        let mut layer = Layer::new(40, 40);
        layer.triangle(
            [
                [0.0, 0.0, 0.0, 0.0],
                [0.0, 40.0, 0.0, 0.0],
                [40.0, 40.0, 0.0, 0.0],
            ],
            1,
            Kind::Face,
        );
        let lines = |layer: &Layer| layer.texels.iter().filter(|t| t.kind == Kind::Line).count();
        layer.edge([5.0, 30.0, -2.0], [25.0, 30.0, -2.0], 1, 1);
        assert_eq!(lines(&layer), 0, "it lies behind");
        layer.edge([5.0, 30.0, 0.0], [25.0, 30.0, 0.0], 2, 1);
        assert_eq!(lines(&layer), 0, "the pixels are another body's");
        // Far longer than the picture is wide: clipped, and as good as a short one.
        layer.edge([-1e9, 30.5, 0.0], [1e9, 30.5, 0.0], 1, 1);
        assert_eq!(lines(&layer), 30);
    }
}
