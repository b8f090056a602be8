//! Spur gears, measured by the kernel, against closed forms of the involute.
//!
//! Notation: module m, teeth z, profile shift x, pressure angle alpha; pitch radius r = m z / 2, base
//! radius r_b = r cos alpha. The involute unrolled by t is at the radius r_b sqrt(1 + t^2) and the polar
//! angle t - atan t from its foot; t = tan alpha_y at the pressure angle alpha_y of that radius, so that
//! inv alpha_y = t - atan t.

use core::f64::consts::{PI, TAU};

use assemcad_factories::Registry;
use assemcad_kernel::facts::Surface;
use assemcad_kernel::query::Side;
use assemcad_kernel::{Shape, replay};
use assemcad_model::ports::Port;
use serde_json::{Value, json};

/// How far flanks may be inside of the involute, in mm, as the factory states it.
pub const FLANK: f64 = 0.5e-3;

/// A gear as its formulas describe it.
#[derive(Debug, Clone, Copy)]
pub struct Gear {
    pub module: f64,
    pub teeth: u32,
    pub width: f64,
    pub bore_d: f64,
    pub alpha_deg: f64,
    pub shift: f64,
    /// How much thinner each tooth is along the pitch circle.
    pub thinner: f64,
}

pub const PLAIN: Gear = Gear {
    module: 2.0,
    teeth: 20,
    width: 15.0,
    bore_d: 12.0,
    alpha_deg: 20.0,
    shift: 0.0,
    thinner: 0.0,
};

impl Gear {
    pub fn params(&self) -> Value {
        json!({
            "module": self.module, "teeth": self.teeth, "width": self.width, "bore_d": self.bore_d,
            "pressure_angle_deg": self.alpha_deg, "profile_shift": self.shift,
            "backlash_mm": self.thinner,
        })
    }

    pub fn built(&self) -> (Shape, Vec<Port>) {
        let params = self.params();
        let built = Registry::builtin()
            .get("gear.spur")
            .unwrap()
            .build(params.as_object().unwrap())
            .unwrap();
        let part = replay(&built.recipe, &mut |_, _| ()).unwrap();
        (part.solid, part.ports)
    }

    pub fn pitch_radius(&self) -> f64 {
        self.module * f64::from(self.teeth) / 2.0
    }

    pub fn base_radius(&self) -> f64 {
        self.pitch_radius() * libm::cos(self.alpha_deg.to_radians())
    }

    pub fn tip_radius(&self) -> f64 {
        self.pitch_radius() + self.module * (1.0 + self.shift)
    }

    pub fn root_radius(&self) -> f64 {
        self.pitch_radius() - self.module * (1.25 - self.shift)
    }

    /// The angle to which the involute is unrolled at a radius; 0 below the base circle.
    fn unrolled(&self, radius: f64) -> f64 {
        let over = radius / self.base_radius();
        libm::sqrt((over * over - 1.0).max(0.0))
    }

    /// Half the angle that a tooth takes up at a radius: s / 2r + inv alpha - inv alpha_y, where the
    /// thickness at the pitch circle is s = m (pi/2 + 2 x tan alpha) less what it is made thinner.
    pub fn half_angle(&self, radius: f64) -> f64 {
        let alpha = self.alpha_deg.to_radians();
        let s = self.module * (PI / 2.0 + 2.0 * self.shift * libm::tan(alpha)) - self.thinner;
        let t = self.unrolled(radius);
        s / (2.0 * self.pitch_radius()) + (libm::tan(alpha) - alpha) - (t - libm::atan(t))
    }

    /// The area of the cross-section with exact flanks: the sum of 1/2 r^2 d(theta) along the outline.
    ///
    /// Of a tooth, the tip gives r_a^2 times its half angle, the root r_f^2 times half the gap's angle,
    /// radial lines nothing, and each of the two flanks, with r^2 = r_b^2 (1 + t^2) and
    /// d(theta) = (1 - 1/(1 + t^2)) dt = t^2 / (1 + t^2) dt, the integral of 1/2 r_b^2 t^2 dt.
    fn area(&self) -> f64 {
        let (rb, ra, rf) = (self.base_radius(), self.tip_radius(), self.root_radius());
        let (from, to) = (self.unrolled(rf), self.unrolled(ra));
        let flanks = 2.0 * rb * rb * (to * to * to - from * from * from) / 6.0;
        let z = f64::from(self.teeth);
        let tooth =
            ra * ra * self.half_angle(ra) + flanks + rf * rf * (PI / z - self.half_angle(rf));
        z * tooth - PI / 4.0 * self.bore_d * self.bore_d
    }

    /// The length of all flanks: an involute from t_1 to t_2 is r_b (t_2^2 - t_1^2) / 2 long.
    fn flanks(&self) -> f64 {
        let (from, to) = (
            self.unrolled(self.root_radius()),
            self.unrolled(self.tip_radius()),
        );
        f64::from(self.teeth) * self.base_radius() * (to * to - from * from)
    }

    /// How far the gear reaches in a direction from +x: to the tip circle where a tip is there,
    /// otherwise to the nearest corner of a tip.
    fn reach(&self, direction: f64) -> f64 {
        let ra = self.tip_radius();
        let pitch = TAU / f64::from(self.teeth);
        let off = (direction / pitch - (direction / pitch).round()).abs() * pitch;
        ra * libm::cos((off - self.half_angle(ra)).max(0.0))
    }
}

fn cases() -> Vec<Gear> {
    vec![
        PLAIN,
        Gear { teeth: 17, ..PLAIN },
        Gear {
            teeth: 41,
            bore_d: 30.0,
            ..PLAIN
        },
        // The root circle is above the base circle: no radial line.
        Gear {
            teeth: 60,
            width: 3.5,
            ..PLAIN
        },
        Gear {
            teeth: 21,
            thinner: 0.2,
            ..PLAIN
        },
        Gear {
            teeth: 12,
            shift: 0.4,
            bore_d: 8.0,
            ..PLAIN
        },
        Gear {
            module: 0.5,
            teeth: 23,
            bore_d: 3.0,
            alpha_deg: 25.0,
            ..PLAIN
        },
    ]
}

#[test]
fn volume_centre_and_box() {
    for gear in cases() {
        let (solid, _) = gear.built();
        let mass = solid.mass().unwrap();
        // Never more than with exact flanks, and less by at most their tolerance.
        let missing = gear.area() - mass.volume / gear.width;
        let slack = 1e-9 * gear.area();
        assert!(
            missing >= -slack && missing <= FLANK * gear.flanks() + slack,
            "{gear:?}: {missing}"
        );
        for (found, wanted) in mass.center.iter().zip([0.0, 0.0, gear.width / 2.0]) {
            assert!((found - wanted).abs() < 1e-9, "{gear:?}: {:?}", mass.center);
        }
        let bounds = solid.bounds().unwrap();
        let near = |found: f64, wanted: f64| {
            // The corners of the tips are on the flanks, which may be inside.
            assert!(
                (found - wanted).abs() < FLANK + 1e-6,
                "{gear:?}: {bounds:?}"
            );
        };
        near(bounds.max[0], gear.reach(0.0));
        near(-bounds.min[0], gear.reach(PI));
        near(bounds.max[1], gear.reach(PI / 2.0));
        near(-bounds.min[1], gear.reach(PI / 2.0));
        assert!(bounds.min[2].abs() < 1e-6 && (bounds.max[2] - gear.width).abs() < 1e-6);
        assert!((bounds.max[0] - gear.tip_radius()).abs() < 1e-6);
        assert!((bounds.max[1] + bounds.min[1]).abs() < 1e-6);
    }
}

#[test]
fn tip_root_and_bore_circles() {
    for gear in cases() {
        let (solid, _) = gear.built();
        // Cylinders about the axis: radius and whether they are hollow.
        let found: Vec<(f64, bool)> = solid
            .faces()
            .unwrap()
            .into_iter()
            .filter_map(|face| match face.surface {
                Surface::Cylinder { radius, inward, .. } => {
                    let [x, y, _] = face.origin;
                    (libm::hypot(x, y) < 1e-6).then_some((radius, inward))
                }
                Surface::Plane { .. } => None,
                other => panic!("{other:?}"),
            })
            .collect();
        let count = |wanted: f64, hollow: bool| {
            let same = |(r, h): &&(f64, bool)| (r - wanted).abs() < 1e-7 && *h == hollow;
            found.iter().filter(same).count()
        };
        let z = gear.teeth as usize;
        assert_eq!(count(gear.tip_radius(), false), z, "{gear:?}");
        assert_eq!(count(gear.root_radius(), false), z, "{gear:?}");
        assert_eq!(count(gear.bore_d / 2.0, true), 1, "{gear:?}");
        assert_eq!(found.len(), 2 * z + 1, "{gear:?}");
    }
}

/// At the tip, the pitch circle, the base circle and in the middle of the dedendum, on all flanks: inside
/// by the flanks' tolerance is material, outside of the exact flank is none. At the pitch circle that is
/// the thickness m pi / 2 of a plain gear, and the teeth are where the formula has them, one on +x.
#[test]
fn the_thickness_of_every_tooth() {
    for gear in cases() {
        let (solid, _) = gear.built();
        let (ra, rf) = (gear.tip_radius(), gear.root_radius());
        if gear.shift == 0.0 && gear.thinner == 0.0 {
            let s = 2.0 * gear.pitch_radius() * gear.half_angle(gear.pitch_radius());
            assert!((s - gear.module * PI / 2.0).abs() < 1e-12);
        }
        let mut points = Vec::new();
        let mut wanted = Vec::new();
        for radius in [
            ra - 1e-3,
            gear.pitch_radius(),
            gear.base_radius().max(rf + 1e-3),
            (gear.pitch_radius() + rf) / 2.0,
        ] {
            // Across the radius the flank is at most as far as this off, for t is small there.
            let depth = 2.0 * FLANK / radius;
            for tooth in 0..gear.teeth {
                for side in [1.0, -1.0] {
                    let middle = TAU * f64::from(tooth) / f64::from(gear.teeth);
                    for (off, expected) in [(-depth, Side::Inside), (1e-6 / radius, Side::Outside)]
                    {
                        let angle = middle + side * (gear.half_angle(radius) + off);
                        let (s, c) = libm::sincos(angle);
                        points.push([radius * c, radius * s, gear.width / 2.0]);
                        wanted.push(expected);
                    }
                }
            }
        }
        assert_eq!(solid.classify(&points, 1e-8).unwrap(), wanted, "{gear:?}");
    }
}

#[test]
fn faces_and_bore_are_where_their_ports_say() {
    for gear in cases() {
        let (solid, ports) = gear.built();
        for port in ports.iter().filter(|p| p.name.starts_with("face_")) {
            let e = port.params["extent_x"] / 2.0 - 1e-6;
            let corners: Vec<[f64; 3]> = [(-e, -e), (-e, e), (e, -e), (e, e), (0.0, 0.0)]
                .into_iter()
                .flat_map(|(u, v)| [[u, v, -1e-3], [u, v, 1e-3]])
                .map(|p| port.frame.placement().unwrap().point(p))
                .collect();
            let wanted = [Side::Inside, Side::Outside].repeat(5);
            assert_eq!(solid.classify(&corners, 1e-8).unwrap(), wanted, "{gear:?}");
        }
    }
}
