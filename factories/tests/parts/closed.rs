//! Volume, centre and box of every factory's part as formulas of its parameters: nothing here comes
//! from a script or from the kernel.

use core::f64::consts::PI;

use serde_json::Value;

use super::tables::{hex_sizes, keyway, medium, minor, socket_sizes, washer_sizes};

/// Pieces of a part: signed volume and centre each; and the box around it all.
#[derive(Debug, Default)]
pub struct Closed {
    pieces: Vec<(f64, [f64; 3])>,
    pub min: [f64; 3],
    pub max: [f64; 3],
    /// By how much the part may have less, where its outline is known to lie inside of the ideal one.
    pub less: f64,
    /// How far off the kernel's own integral may be: a cross hole's rims are curves that it approximates.
    pub slack: f64,
}

impl Closed {
    fn add(&mut self, volume: f64, centre: [f64; 3]) {
        self.pieces.push((volume, centre));
    }

    fn spans(mut self, min: [f64; 3], max: [f64; 3]) -> Self {
        (self.min, self.max) = (min, max);
        self
    }

    pub fn volume(&self) -> f64 {
        self.pieces.iter().map(|(v, _)| v).sum()
    }

    pub fn centre(&self) -> [f64; 3] {
        [0, 1, 2].map(|i| {
            let moment: f64 = self.pieces.iter().map(|(v, c)| v * c[i]).sum();
            moment / self.volume()
        })
    }
}

/// The formulas of a factory at checked parameters.
pub fn closed(name: &str, p: &Value) -> Closed {
    match name {
        "base_frame.bolt_circle_flange" => flange(p),
        "base_frame.boss" => boss(p),
        "base_frame.coupling_hub" => hub(p),
        "base_frame.housing_block" => housing(p),
        "base_frame.l_bracket" => bracket(p),
        "base_frame.rect_plate" => plate(p),
        "base_frame.stepped_shaft" => shaft(p),
        "base_frame.u_channel" => channel(p),
        "bearing.ball" => bearing(p),
        "fastener.bolt" => bolt(p),
        "fastener.nut" => nut(p),
        "fastener.washer" => washer(p),
        "gear.spur" => gear(p),
        _ => panic!("no formulas for {name}"),
    }
}

fn n(p: &Value, name: &str) -> f64 {
    p[name].as_f64().unwrap_or_else(|| panic!("{name} in {p}"))
}

/// A parameter, or what stands for 0.
fn or(p: &Value, name: &str, other: f64) -> f64 {
    match n(p, name) {
        0.0 => other,
        value => value,
    }
}

fn disc(d: f64) -> f64 {
    PI / 4.0 * d * d
}

/// A regular hexagon by its width across flats: `sqrt(3)/2 s^2`.
fn hexagon(s: f64) -> f64 {
    3.0_f64.sqrt() / 2.0 * s * s
}

/// Simpson's rule.
fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let steps = 2000;
    let h = (to - from) / f64::from(steps);
    let weight = |i: i32| match i {
        0 => 1.0,
        i if i == steps => 1.0,
        i if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let sum: f64 = (0..=steps)
        .map(|i| weight(i) * f(from + h * f64::from(i)))
        .sum();
    sum * h / 3.0
}

fn plate(p: &Value) -> Closed {
    let (l, w, t) = (n(p, "length"), n(p, "width"), n(p, "thickness"));
    let mut c = Closed::default();
    c.add(l * w * t, [0.0, 0.0, t / 2.0]);
    if n(p, "bolt_d") > 0.0 {
        let d = or(p, "hole_d", medium(n(p, "bolt_d")));
        c.add(-4.0 * disc(d) * t, [0.0, 0.0, t / 2.0]);
    }
    c.spans([-l / 2.0, -w / 2.0, 0.0], [l / 2.0, w / 2.0, t])
}

fn housing(p: &Value) -> Closed {
    let (l, w, h) = (n(p, "length"), n(p, "width"), n(p, "height"));
    let mut c = Closed::default();
    c.add(l * w * h, [0.0, 0.0, h / 2.0]);
    let axis = or(p, "bore_height", h / 2.0);
    c.add(-disc(n(p, "bore_d")) * w, [0.0, 0.0, axis]);
    c.spans([-l / 2.0, -w / 2.0, 0.0], [l / 2.0, w / 2.0, h])
}

fn shaft(p: &Value) -> Closed {
    let mut c = Closed::default();
    let (mut z, mut widest) = (0.0, 0.0_f64);
    for s in p["segments"].as_array().unwrap() {
        let (d, l) = (n(s, "d"), n(s, "length"));
        c.add(disc(d) * l, [0.0, 0.0, z + l / 2.0]);
        z += l;
        widest = widest.max(d);
    }
    round(c, widest, z)
}

/// The box of a body of revolution from z = 0.
fn round(c: Closed, d: f64, h: f64) -> Closed {
    let r = d / 2.0;
    c.spans([-r, -r, 0.0], [r, r, h])
}

fn bearing(p: &Value) -> Closed {
    let (a, b, w) = (n(p, "d_i") / 2.0, n(p, "d_o") / 2.0, n(p, "width"));
    let h = b - a;
    let mut c = Closed::default();
    c.add(PI * (b * b - a * a) * w, [0.0, 0.0, w / 2.0]);
    let (i, o, g) = (a + 0.3 * h, b - 0.3 * h, 0.1 * h);
    // Two grooves, one on each side: their centres are symmetric.
    c.add(-2.0 * PI * (o * o - i * i) * g, [0.0, 0.0, w / 2.0]);
    round(c, 2.0 * b, w)
}

fn bracket(p: &Value) -> Closed {
    let (l, h, w, t) = (
        n(p, "length"),
        n(p, "height"),
        n(p, "width"),
        n(p, "thickness"),
    );
    let r = n(p, "fillet");
    let mut c = Closed::default();
    c.add(l * w * t, [l / 2.0, 0.0, t / 2.0]);
    c.add(t * w * (h - t), [t / 2.0, 0.0, (h + t) / 2.0]);
    // The fillet: a square of side r less a quarter of a disc, whose centroid is 4r/(3 pi) off its centre.
    let quarter = t + r - 4.0 * r / (3.0 * PI);
    c.add(r * r * w, [t + r / 2.0, 0.0, t + r / 2.0]);
    c.add(-PI / 4.0 * r * r * w, [quarter, 0.0, quarter]);
    if n(p, "bolt_d") > 0.0 {
        let hole = disc(or(p, "hole_d", medium(n(p, "bolt_d")))) * t * n(p, "holes");
        c.add(-hole, [(t + r + l) / 2.0, 0.0, t / 2.0]);
        c.add(-hole, [t / 2.0, 0.0, (t + r + h) / 2.0]);
    }
    c.spans([0.0, -w / 2.0, 0.0], [l, w / 2.0, h])
}

fn channel(p: &Value) -> Closed {
    let (l, w, h, t) = (
        n(p, "length"),
        n(p, "width"),
        n(p, "height"),
        n(p, "thickness"),
    );
    let mut c = Closed::default();
    c.add(l * w * h, [0.0, 0.0, h / 2.0]);
    c.add(-l * (w - 2.0 * t) * (h - t), [0.0, 0.0, (h + t) / 2.0]);
    c.spans([-l / 2.0, -w / 2.0, 0.0], [l / 2.0, w / 2.0, h])
}

fn boss(p: &Value) -> Closed {
    let (d, h) = (n(p, "diameter"), n(p, "height"));
    let depth = or(p, "bore_depth", h);
    let mut c = Closed::default();
    c.add(disc(d) * h, [0.0, 0.0, h / 2.0]);
    c.add(-disc(n(p, "bore_d")) * depth, [0.0, 0.0, h - depth / 2.0]);
    round(c, d, h)
}

fn flange(p: &Value) -> Closed {
    let (d, h) = (n(p, "diameter"), n(p, "height"));
    let hole = or(p, "hole_d", medium(n(p, "bolt_d")));
    let mut c = Closed::default();
    let area = disc(d) - disc(n(p, "bore_d")) - n(p, "bolt_count") * disc(hole);
    c.add(area * h, [0.0, 0.0, h / 2.0]);
    round(c, d, h)
}

fn hub(p: &Value) -> Closed {
    let (big, l, r) = (n(p, "diameter") / 2.0, n(p, "length"), n(p, "bore_d") / 2.0);
    let mut c = Closed::default();
    c.add(PI * (big * big - r * r) * l, [0.0, 0.0, l / 2.0]);
    if p["keyway"] == true {
        let (b, t2) = keyway(2.0 * r);
        let (a, top) = (b / 2.0, r + t2);
        // What the slot takes beyond the bore: a strip less the circle's part in it.
        let area = b * top - (a * (r * r - a * a).sqrt() + r * r * libm::asin(a / r));
        let moment = a * (top * top - r * r) + a * a * a / 3.0;
        c.add(-area * l, [0.0, moment / area, l / 2.0]);
    }
    let screw = n(p, "set_screw_d");
    if screw > 0.0 {
        let q = minor(screw) / 2.0;
        // Over the hole's disc, from the bore to the rim; y = q sin(u) takes the roots off the ends.
        let chord = |u: f64| 2.0 * q * q * libm::cos(u) * libm::cos(u);
        let y2 = |u: f64| q * q * libm::sin(u) * libm::sin(u);
        let volume = integral(-PI / 2.0, PI / 2.0, |u| {
            chord(u) * ((big * big - y2(u)).sqrt() - (r * r - y2(u)).sqrt())
        });
        let moment = (big * big - r * r) / 2.0 * PI * q * q;
        c.add(-volume, [moment / volume, 0.0, l / 2.0]);
        c.slack = 1e-6 * volume;
    }
    round(c, 2.0 * big, l)
}

fn bolt(p: &Value) -> Closed {
    let (d, l) = (n(p, "d"), n(p, "length"));
    let mut c = Closed::default();
    c.add(disc(d) * l, [0.0, 0.0, -l / 2.0]);
    if p["head"] == "hex" {
        let (s, k, _) = hex_sizes(d);
        c.add(hexagon(s) * k, [0.0, 0.0, k / 2.0]);
        let e = s / 3.0_f64.sqrt();
        return c.spans([-s / 2.0, -e, -l], [s / 2.0, e, k]);
    }
    let (dk, s, t) = socket_sizes(d);
    c.add(disc(dk) * d, [0.0, 0.0, d / 2.0]);
    c.add(-hexagon(s) * t, [0.0, 0.0, d - t / 2.0]);
    // The mouth, outside of the hexagon: a disc of the radius 0.6 s - depth down to the flats at 0.5 s.
    // Beyond the corners the whole hexagon is inside of the disc, below only six segments are not.
    let outside = |depth: f64| {
        let (r, a) = (0.6 * s - depth, s / 2.0);
        if r > s / 3.0_f64.sqrt() {
            PI * r * r - hexagon(s)
        } else {
            6.0 * (r * r * libm::acos((a / r).min(1.0)) - a * (r * r - a * a).max(0.0).sqrt())
        }
    };
    let corner = 0.6 * s - s / 3.0_f64.sqrt();
    let whole = |f: &dyn Fn(f64) -> f64| integral(0.0, corner, f) + integral(corner, 0.1 * s, f);
    let volume = whole(&outside);
    let depth = whole(&|x| x * outside(x)) / volume;
    c.add(-volume, [0.0, 0.0, d - depth]);
    let r = dk / 2.0;
    c.spans([-r, -r, -l], [r, r, d])
}

fn nut(p: &Value) -> Closed {
    let d = n(p, "d");
    let (s, _, m) = hex_sizes(d);
    let (s, m) = (or(p, "width", s), or(p, "height", m));
    let mut c = Closed::default();
    c.add((hexagon(s) - disc(minor(d))) * m, [0.0, 0.0, m / 2.0]);
    let e = s / 3.0_f64.sqrt();
    c.spans([-s / 2.0, -e, 0.0], [s / 2.0, e, m])
}

fn washer(p: &Value) -> Closed {
    let (d_i, d_o, h) = washer_sizes(n(p, "d"));
    let (d_i, d_o, h) = (or(p, "d_i", d_i), or(p, "d_o", d_o), or(p, "thickness", h));
    let mut c = Closed::default();
    c.add((disc(d_o) - disc(d_i)) * h, [0.0, 0.0, h / 2.0]);
    round(c, d_o, h)
}

fn gear(p: &Value) -> Closed {
    let (m, z, w) = (n(p, "module"), n(p, "teeth"), n(p, "width"));
    let (alpha, x) = (
        n(p, "pressure_angle_deg").to_radians(),
        n(p, "profile_shift"),
    );
    let pitch_r = m * z / 2.0;
    let (base, tip) = (pitch_r * libm::cos(alpha), pitch_r + m * (1.0 + x));
    let root = pitch_r - m * (1.25 - x);
    let inv = |r: f64| {
        let a = libm::acos((base / r).min(1.0));
        libm::tan(a) - a
    };
    // Half a tooth's angle at a radius; below the base circle the flank is radial.
    let thick = m * (PI / 2.0 + 2.0 * x * libm::tan(alpha)) - n(p, "backlash_mm");
    let foot = thick / (m * z) + libm::tan(alpha) - alpha;
    let ring = |from: f64, to: f64| integral(from, to, |r| 2.0 * z * r * (foot - inv(r.max(base))));
    // Near the base circle the angle grows with a root: r = base + u^2 takes it off.
    let above = |from: f64, to: f64| {
        let u = |r: f64| (r - base).max(0.0).sqrt();
        integral(u(from), u(to), |u| {
            let r = base + u * u;
            2.0 * z * r * (foot - inv(r)) * 2.0 * u
        })
    };
    let teeth = if root < base {
        ring(root, base) + above(base, tip)
    } else {
        above(root, tip)
    };
    let area = PI * root * root + teeth - disc(n(p, "bore_d"));
    let mut c = Closed::default();
    c.add(area * w, [0.0, 0.0, w / 2.0]);
    // Flanks are arcs up to half a micrometre inside of the involute: two for each tooth, 2.25 m high and
    // a little longer.
    c.less = 2.0 * z * 3.0 * m * 0.0005 * w;
    // The middle of a tooth is on +X; of the other sides only that they are within the tip circle.
    let mut c = round(c, 2.0 * tip, w);
    c.min[0] = f64::NAN;
    (c.min[1], c.max[1]) = (f64::NAN, f64::NAN);
    c
}
