//! From bodies to colours: shading, outlines, hatching, glass.

use crate::camera::Camera;
use crate::canvas::{Canvas, Rgb, mix, rgb};
use crate::raster::{Corner, Kind, Layer, Texel, byte, to_f64};
use crate::scene::{Body, Look, Panel};

/// How many times finer than the picture its bodies are drawn, each way.
pub(crate) const FINE: usize = 2;

/// The paper.
pub(crate) const PAPER: Rgb = [255, 255, 255];

/// Edges and outlines.
const INK: Rgb = [28, 30, 34];

/// What is wrong stands out by this colour, which no part should have: red, green, blue from 0 to 1.
pub const ALARM: [f64; 3] = [0.90, 0.08, 0.10];

/// Surroundings that are only shown for orientation.
const GHOST: Rgb = [168, 172, 178];

/// How thick edges are, in fine pixels.
const EDGE: usize = 2;

/// The step in depth, in fine pixels beyond what a plane has, that shows as an outline within a body.
const STEP: f32 = 8.0;

/// A point in a face is not behind it: so many pixels are rounding.
const BEHIND: f64 = 2.0;

/// Where the light comes from: right, up, towards the viewer.
const LIGHT: [f64; 3] = [-0.36, 0.72, 0.593];

/// Looks in the order in which they are drawn; each has a layer of its own.
const LOOKS: [Look; 3] = [Look::Solid, Look::Glass, Look::Ghost];

/// The bodies, drawn at [`FINE`] times the panel's size.
pub(crate) struct Painted {
    pub(crate) canvas: Canvas,
    /// The opaque bodies and their depths; none where there are none.
    solid: Option<Layer>,
}

impl Painted {
    /// Whether a point, as the camera projects it, lies behind an opaque body.
    pub(crate) fn is_hidden(&self, [x, y, depth]: [f64; 3]) -> bool {
        let fine = to_f64(FINE);
        let there = self
            .solid
            .as_ref()
            .and_then(|l| l.depth_at(x * fine, y * fine));
        there.is_some_and(|there| there > (depth + BEHIND) * fine)
    }
}

/// Draws the bodies as the camera sees them.
pub(crate) fn bodies(panel: &Panel, camera: &Camera, width: usize, height: usize) -> Painted {
    let bodies = panel.bodies.as_slice();
    let mut layers = Vec::new();
    for look in LOOKS {
        if bodies.iter().any(|b| b.look == look) {
            let mut layer = Layer::new(width * FINE, height * FINE);
            for (number, body) in (1..).zip(bodies).filter(|(_, b)| b.look == look) {
                faces(&mut layer, body, number, camera);
            }
            layer.settle_overlaps(panel.in_place);
            for (number, body) in (1..).zip(bodies).filter(|(_, b)| b.look == look) {
                edges(&mut layer, body, number, camera);
            }
            outlines(&mut layer);
            layers.push((look, layer));
        }
    }
    let canvas = composed(&layers, bodies, width * FINE, height * FINE);
    let solid = layers.into_iter().find(|(look, _)| *look == Look::Solid);
    Painted {
        canvas,
        solid: solid.map(|(_, layer)| layer),
    }
}

fn fine(camera: &Camera, p: [f64; 3]) -> [f64; 3] {
    camera.project(p).map(|x| x * to_f64(FINE))
}

fn faces(layer: &mut Layer, body: &Body, number: u16, camera: &Camera) {
    let surface = &body.surface;
    let corners: Vec<Corner> = surface
        .positions
        .iter()
        .zip(&surface.normals)
        .map(|(p, n)| {
            let [x, y, z] = fine(camera, body.placement.point(*p));
            let [a, b, c] = camera.turn(body.placement.direction(*n));
            let lit = a * LIGHT[0] + b * LIGHT[1] + c * LIGHT[2];
            // Half of the light comes from everywhere, so that no face is black.
            [x, y, z, 255.0 * (0.5 + 0.5 * lit)]
        })
        .collect();
    let corner = |i: u32| corners.get(usize::try_from(i).ok()?).copied();
    for (i, [a, b, c]) in surface.triangles.iter().enumerate() {
        if let (Some(a), Some(b), Some(c)) = (corner(*a), corner(*b), corner(*c)) {
            let cut = surface.cut.get(i).copied().unwrap_or_default();
            let kind = if cut { Kind::Cut } else { Kind::Face };
            layer.triangle([a, b, c], number, kind);
        }
    }
}

fn edges(layer: &mut Layer, body: &Body, number: u16, camera: &Camera) {
    for chain in &body.surface.edges {
        let mut points = chain.iter().map(|p| fine(camera, body.placement.point(*p)));
        let Some(mut from) = points.next() else {
            continue;
        };
        for to in points {
            layer.edge(from, to, number, EDGE);
            from = to;
        }
    }
}

/// Marks the border of each body against what is farther away, and steps within a body, on the nearer
/// side: what is covered stays the same.
fn outlines(layer: &mut Layer) {
    let (width, height) = (layer.width, layer.height);
    let mut marked = Vec::new();
    let at = |x: usize, y: usize| -> Option<(Texel, f32)> {
        let i = y * width + x;
        Some((*layer.texels.get(i)?, *layer.depth.get(i)?))
    };
    for y in 0..height {
        for x in 0..width {
            let Some((own, depth)) = at(x, y).filter(|(t, _)| t.body != 0) else {
                continue;
            };
            let border = |dx: isize, dy: isize| {
                let beside =
                    |n: usize, d: isize, most: usize| n.checked_add_signed(d).filter(|n| *n < most);
                let (Some(p), Some(q)) = (beside(x, dx, width), beside(y, dy, height)) else {
                    return false;
                };
                let Some((other, there)) = at(p, q) else {
                    return false;
                };
                if other.body != own.body {
                    return there < depth;
                }
                // On a plane the neighbour across lies as much nearer as this one lies farther.
                let across = (beside(x, -dx, width), beside(y, -dy, height));
                let (Some(p), Some(q)) = across else {
                    return false;
                };
                at(p, q).is_some_and(|(back, here)| {
                    back.body == own.body && (depth - there) - (here - depth) > STEP
                })
            };
            if [(1, 0), (-1, 0), (0, 1), (0, -1)]
                .iter()
                .any(|(dx, dy)| border(*dx, *dy))
            {
                marked.push(y * width + x);
            }
        }
    }
    for i in marked {
        if let Some(texel) = layer.texels.get_mut(i) {
            texel.kind = Kind::Line;
        }
    }
}

/// Lays the layers over each other, the farthest first in every pixel.
fn composed(layers: &[(Look, Layer)], bodies: &[Body], width: usize, height: usize) -> Canvas {
    let mut canvas = Canvas::new(width, height, PAPER);
    let colors: Vec<Rgb> = bodies.iter().map(|b| rgb(b.color)).collect();
    // One list for all pixels: a picture has millions.
    let mut seen: Vec<(f32, Look, Texel)> = Vec::with_capacity(LOOKS.len());
    for (i, pixel) in canvas.pixels.iter_mut().enumerate() {
        seen.clear();
        for (look, layer) in layers {
            if let (Some(depth), Some(texel)) = (layer.depth.get(i), layer.texels.get(i))
                && texel.body != 0
            {
                seen.push((*depth, *look, *texel));
            }
        }
        seen.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        let (x, y) = (i % width.max(1), i / width.max(1));
        for (_, look, texel) in &seen {
            let body = usize::from(texel.body) - 1;
            let own = colors.get(body).copied().unwrap_or(GHOST);
            let (color, share) = colored(*texel, *look, own, x, y);
            *pixel = mix(*pixel, color, share);
        }
    }
    canvas
}

/// The colour of a pixel, and how much it covers of what is behind.
fn colored(texel: Texel, look: Look, own: Rgb, x: usize, y: usize) -> (Rgb, f64) {
    let lit = |c: Rgb| {
        let light = 0.42 + 0.78 * f64::from(texel.shade) / 255.0;
        c.map(|c| byte(f64::from(c) * light))
    };
    match (look, texel.kind) {
        (Look::Solid, Kind::Face) => (lit(own), 1.0),
        (Look::Solid, Kind::Line) => (mix(own, INK, 0.88), 1.0),
        (Look::Ghost, Kind::Line) => (GHOST, 0.8),
        (Look::Ghost, _) => (lit(GHOST), 0.22),
        (_, Kind::Both) => (rgb(ALARM), 1.0),
        (_, Kind::Cut) => {
            // Cut material is hatched at 45 degrees, neighbours the other way.
            let place = if texel.body.is_multiple_of(2) {
                x + y
            } else {
                x + 3 * FINE * 4096 - y
            };
            let hatch = place % (8 * FINE) < FINE + 1;
            let light = mix(own, PAPER, 0.35);
            (if hatch { mix(own, INK, 0.6) } else { light }, 1.0)
        }
        (Look::Glass, Kind::Face) => (lit(own), 0.45),
        (Look::Glass, Kind::Line) => (mix(own, INK, 0.8), 0.85),
    }
}
