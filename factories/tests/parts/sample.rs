//! Pseudo-random parameters, the same in every run: mostly such that an engineer could mean them.

use serde_json::{Value, json};

/// The sizes of bolts that the tables hold.
const SIZES: [f64; 10] = [3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 24.0];

/// A linear congruential generator: Knuth's constants for MMIX, the upper 53 bits as a fraction.
pub struct Rng(u64);

impl Rng {
    /// One that begins where the name says.
    pub fn of(name: &str) -> Self {
        let seed = name
            .bytes()
            .fold(17_u64, |sum, b| sum.wrapping_mul(31).wrapping_add(b.into()));
        let mut rng = Self(seed);
        rng.unit();
        rng
    }

    /// From 0 to below 1.
    fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Small numbers as often as large ones; three decimals.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        let value = low * libm::pow(high / low, self.unit());
        ((value * 1000.0).round() / 1000.0).clamp(low, high)
    }

    fn even(&mut self, low: f64, high: f64) -> f64 {
        ((low + self.unit() * (high - low)) * 1000.0).round() / 1000.0
    }

    fn whole(&mut self, low: u32, high: u32) -> u32 {
        let span = f64::from(high - low + 1);
        low + (self.unit() * span) as u32
    }

    fn chance(&mut self, share: f64) -> bool {
        self.unit() < share
    }

    fn size(&mut self) -> f64 {
        SIZES[self.whole(0, 9) as usize]
    }
}

/// A bolt and the diameter of its hole as stated, 0 for that of the standard.
fn bolt_and_hole(rng: &mut Rng) -> (f64, f64) {
    if rng.chance(0.6) {
        return (rng.size(), 0.0);
    }
    let bolt = rng.between(1.5, 30.0);
    (bolt, bolt + rng.between(0.1, 3.0))
}

pub fn sample(name: &str, rng: &mut Rng) -> Value {
    match name {
        "base_frame.bolt_circle_flange" => flange(rng),
        "base_frame.boss" => boss(rng),
        "base_frame.coupling_hub" => hub(rng),
        "base_frame.housing_block" => housing(rng),
        "base_frame.l_bracket" => bracket(rng),
        "base_frame.rect_plate" => plate(rng),
        "base_frame.stepped_shaft" => shaft(rng),
        "base_frame.u_channel" => channel(rng),
        "bearing.ball" => bearing(rng),
        "fastener.bolt" => bolt(rng),
        "fastener.nut" => nut(rng),
        "fastener.washer" => washer(rng),
        "gear.spur" => gear(rng),
        _ => panic!("no parameters for {name}"),
    }
}

fn plate(rng: &mut Rng) -> Value {
    let (length, width) = (rng.between(5.0, 2000.0), rng.between(5.0, 2000.0));
    let thickness = rng.between(0.5, 200.0);
    if rng.chance(0.4) {
        return json!({"length": length, "width": width, "thickness": thickness});
    }
    let (bolt_d, hole_d) = bolt_and_hole(rng);
    let edge = if rng.chance(0.5) {
        0.0
    } else {
        rng.between(0.6, 3.0) * bolt_d
    };
    json!({
        "length": length + 6.0 * bolt_d, "width": width + 6.0 * bolt_d, "thickness": thickness,
        "bolt_d": bolt_d, "hole_d": hole_d, "edge": edge,
    })
}

fn housing(rng: &mut Rng) -> Value {
    let bore = rng.between(2.0, 500.0);
    let height = (bore + rng.between(1.5, 300.0)).max(5.0);
    let axis = if rng.chance(0.5) {
        0.0
    } else {
        rng.even(bore / 2.0 + 0.5, height - bore / 2.0)
    };
    json!({
        "length": (bore + rng.between(1.5, 300.0)).max(5.0), "width": rng.between(1.0, 500.0), "height": height,
        "bore_d": bore, "bore_height": axis,
    })
}

fn shaft(rng: &mut Rng) -> Value {
    let mut segments = Vec::new();
    let mut d = rng.between(1.0, 300.0);
    for _ in 0..rng.whole(1, 8) {
        segments.push(json!({"d": d, "length": rng.between(0.2, 500.0)}));
        // The same diameter now and then; and once in a while one that is too near.
        d = match rng.unit() {
            x if x < 0.15 => d,
            x if x < 0.17 => d + 0.004,
            x if x < 0.3 => d + rng.between(0.01, 1.0),
            _ => rng.between(1.0, 300.0),
        };
    }
    json!({ "segments": segments })
}

fn bearing(rng: &mut Rng) -> Value {
    let d_i = rng.between(1.0, 500.0);
    let d_o = d_i + rng.between(1.0, 300.0);
    let width = ((d_o - d_i) * rng.even(0.15, 1.5)).max(0.5);
    json!({"d_i": d_i, "d_o": d_o, "width": width})
}

fn bracket(rng: &mut Rng) -> Value {
    let t = rng.between(0.5, 40.0);
    let fillet = if rng.chance(0.5) {
        0.0
    } else {
        rng.between(0.1, 40.0)
    };
    let (length, height) = (rng.between(2.0, 300.0), rng.between(2.0, 300.0));
    let width = rng.between(2.0, 300.0);
    if rng.chance(0.4) {
        return json!({
            "length": length + t + fillet, "height": height + t + fillet, "width": width,
            "thickness": t, "fillet": fillet,
        });
    }
    let ((bolt_d, hole_d), holes) = (bolt_and_hole(rng), rng.whole(1, 6));
    let room = 1.5 * bolt_d;
    json!({
        "length": length + t + fillet + room, "height": height + t + fillet + room,
        "width": width + 1.2 * f64::from(holes) * bolt_d, "thickness": t, "fillet": fillet,
        "bolt_d": bolt_d, "hole_d": hole_d, "holes": holes,
    })
}

fn channel(rng: &mut Rng) -> Value {
    let t = rng.between(0.5, 50.0);
    json!({
        "length": rng.between(1.0, 2000.0), "width": (2.0 * t + rng.between(0.8, 500.0)).max(2.5),
        "height": (t + rng.between(0.8, 500.0)).max(1.5), "thickness": t,
    })
}

fn boss(rng: &mut Rng) -> Value {
    let (bore, height) = (rng.between(0.5, 300.0), rng.between(0.5, 300.0));
    let depth = if rng.chance(0.5) {
        0.0
    } else {
        rng.even(0.1, 1.1 * height)
    };
    json!({
        "diameter": (bore + rng.between(0.4, 200.0)).max(1.0), "height": height, "bore_d": bore, "bore_depth": depth,
    })
}

fn flange(rng: &mut Rng) -> Value {
    let (bolt_d, hole_d) = bolt_and_hole(rng);
    let count = rng.whole(2, 16);
    let bore = if rng.chance(0.3) {
        0.0
    } else {
        rng.between(0.5, 500.0)
    };
    let inner = (bore + 1.5 * bolt_d).max(bolt_d * f64::from(count) / 2.0);
    let circle = inner + rng.between(1.0, 100.0);
    let stated = rng.chance(0.7);
    let diameter = if stated {
        circle + 1.5 * bolt_d + rng.between(1.0, 100.0)
    } else {
        2.0 * circle - bore
    };
    json!({
        "diameter": diameter, "height": rng.between(0.5, 200.0), "bore_d": bore, "bolt_d": bolt_d,
        "bolt_count": count, "bolt_circle_d": if stated { circle } else { 0.0 }, "hole_d": hole_d,
    })
}

fn hub(rng: &mut Rng) -> Value {
    let keyway = rng.chance(0.5);
    let bore = if keyway {
        rng.between(6.0, 110.0)
    } else {
        rng.between(0.5, 500.0)
    };
    let screw = if bore > 6.0 && rng.chance(0.5) {
        rng.size()
    } else {
        0.0
    };
    json!({
        "diameter": bore * rng.even(1.3, 3.0) + 1.0 + screw / 2.0,
        "length": rng.between(0.5, 300.0) + screw, "bore_d": bore, "keyway": keyway, "set_screw_d": screw,
    })
}

fn bolt(rng: &mut Rng) -> Value {
    let length = rng.between(3.0, 400.0);
    let thread = if rng.chance(0.7) {
        0.0
    } else {
        rng.even(0.5, 1.2 * length)
    };
    let head = if rng.chance(0.5) { "hex" } else { "socket" };
    json!({"d": rng.size(), "length": length, "head": head, "thread_length": thread})
}

fn nut(rng: &mut Rng) -> Value {
    let d = rng.size();
    let width = if rng.chance(0.5) {
        0.0
    } else {
        d * rng.even(1.1, 3.0)
    };
    let height = if rng.chance(0.5) {
        0.0
    } else {
        d * rng.even(0.05, 4.0)
    };
    json!({"d": d, "width": width, "height": height})
}

fn washer(rng: &mut Rng) -> Value {
    let d = if rng.chance(0.7) {
        rng.size()
    } else {
        rng.between(1.0, 150.0)
    };
    let own = |rng: &mut Rng, value: f64| if rng.chance(0.3) { 0.0 } else { value };
    if SIZES.contains(&d) {
        let d_i = rng.even(0.95, 1.2) * d;
        let d_o = rng.even(1.3, 3.0) * d;
        let thickness = rng.between(0.1, 20.0);
        return json!({
            "d": d, "d_i": own(rng, d_i), "d_o": own(rng, d_o), "thickness": own(rng, thickness),
        });
    }
    let d_i = rng.even(1.001, 1.2) * d;
    json!({"d": d, "d_i": d_i, "d_o": d_i * rng.even(1.15, 2.0), "thickness": rng.between(0.1, 20.0)})
}

fn gear(rng: &mut Rng) -> Value {
    let (module, teeth) = (rng.between(0.3, 20.0), rng.whole(14, 80));
    let shift = if rng.chance(0.6) {
        0.0
    } else {
        rng.even(-0.2, 0.6)
    };
    let angle = if rng.chance(0.7) {
        20.0
    } else {
        rng.even(17.0, 27.0)
    };
    let thinner = if rng.chance(0.6) {
        0.0
    } else {
        rng.even(0.0, 0.2) * module
    };
    let root = module * (f64::from(teeth) - 2.5 + 2.0 * shift);
    json!({
        "module": module, "teeth": teeth, "width": rng.between(1.0, 200.0),
        "bore_d": root * rng.even(0.1, 0.95), "pressure_angle_deg": angle, "profile_shift": shift,
        "backlash_mm": thinner,
    })
}
