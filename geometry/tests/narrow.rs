//! What is decided from skins alone, held against the kernel's booleans on two thousand placed pairs: touching,
//! one micrometre apart, one micrometre overlapping, inside each other, and anywhere.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::print_stdout
)]

use assemcad_geometry::narrow::{Boundary, Common, common, enter};
use assemcad_kernel::Shape;
use assemcad_kernel::brep::Topology;
use assemcad_kernel::pair;
use assemcad_model::frame::{Frame, Placement};

/// Numbers that are the same in every run (xorshift64*, Vigna 2016).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() >> 33) as usize % n
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn at(x: f64, y: f64, z: f64) -> Frame {
    Frame {
        origin: [x, y, z],
        ..Frame::WORLD
    }
}

fn rod(z: f64, radius: f64, height: f64) -> Shape {
    Shape::cylinder(&at(0.0, 0.0, z), radius, height).unwrap()
}

fn one(group: &Shape) -> Shape {
    let clean = group.cleaned().unwrap();
    clean.parts(Topology::Solid).unwrap().remove(0)
}

fn cut(of: &Shape, tool: &Shape) -> Shape {
    one(&of.without(&[tool], None).unwrap())
}

struct Solid {
    name: &'static str,
    shape: Shape,
    boundary: Boundary,
}

fn solid(name: &'static str, shape: Shape) -> Solid {
    // As a worker hands it out: read from its own bytes.
    let shape = Shape::from_bytes(&shape.to_bytes().unwrap()).unwrap();
    let boundary = Boundary::new(shape.skin(0.01, 10.0).unwrap()).unwrap();
    Solid {
        name,
        shape,
        boundary,
    }
}

/// All stand on z = 0, round about the z axis where they are round, 10 high unless they are balls.
fn solids() -> Vec<Solid> {
    let block = |x: f64, y: f64| Shape::cuboid(&at(-x / 2.0, -y / 2.0, 0.0), [x, y, 10.0]).unwrap();
    let hole = |radius: f64| rod(-1.0, radius, 12.0);
    let cone = |base: f64, top: f64| Shape::cone(&Frame::WORLD, base, top, 10.0).unwrap();
    let ball = |radius: f64| Shape::sphere(&at(0.0, 0.0, 5.0), radius).unwrap();
    let ring = |radius: f64, tube: f64| {
        Shape::torus(&Placement::translation(0.0, 0.0, 5.0), radius, tube).unwrap()
    };
    let drilled = || cut(&block(30.0, 20.0), &hole(5.0));
    let quarter = Shape::cuboid(&at(0.0, 0.0, -1.0), [20.0, 20.0, 12.0]).unwrap();
    let headed = rod(0.0, 5.0, 10.0).fused(&[&rod(7.0, 8.0, 3.0)], false, None);
    vec![
        solid("block", block(30.0, 20.0)),
        solid("small block", block(6.0, 8.0)),
        solid("drilled block", drilled()),
        solid("pin", rod(0.0, 5.0, 10.0)),
        solid("thin pin", rod(0.0, 4.9, 10.0)),
        solid("bush", cut(&rod(0.0, 8.0, 10.0), &hole(5.0))),
        solid("wide bush", cut(&rod(0.0, 12.0, 10.0), &hole(8.0))),
        solid("headed pin", one(&headed.unwrap())),
        solid("stepped hole", cut(&drilled(), &rod(7.0, 8.0, 4.0))),
        solid("plug", cone(5.0, 3.0)),
        solid("seat", cut(&rod(0.0, 8.0, 10.0), &cone(5.0, 3.0))),
        solid("ball", ball(5.0)),
        solid(
            "socket",
            cut(&cut(&block(30.0, 20.0), &ball(5.0)), &hole(2.0)),
        ),
        solid("ring", ring(6.0, 2.0)),
        solid("grooved pin", cut(&rod(0.0, 6.0, 10.0), &ring(6.0, 2.0))),
        solid("corner", cut(&block(20.0, 20.0), &quarter)),
    ]
}

/// Moves along which solids come to touch: multiples of their heights, radii and widths.
const SHIFTS: [f64; 14] = [
    0.0, 0.0, 0.0, 10.0, -10.0, 7.0, 3.0, 15.0, 5.0, 10.0, 13.0, 18.0, -16.0, 20.0,
];

fn place(n: &mut Numbers) -> Placement {
    let kind = n.below(10);
    if kind == 0 {
        let turned = Placement::rotation_about([0.0; 3], [0.36, 0.48, 0.8], n.between(0.0, 360.0));
        let [x, y, z] = [0; 3].map(|_| n.between(-20.0, 20.0));
        return Placement::translation(x, y, z) * turned.unwrap();
    }
    let mut shift = || SHIFTS[n.below(SHIFTS.len())];
    let mut by = match kind {
        1..=4 => [0.0, 0.0, shift()],
        5 | 6 => [shift(), 0.0, 0.0],
        7 => [0.0, shift(), shift()],
        _ => [shift(), shift(), shift()],
    };
    // One micrometre nearer or farther, along one axis.
    let micrometre = [0.0, 0.0, 1e-3, -1e-3][n.below(4)];
    by[n.below(3)] += micrometre;
    let turn = match n.below(5) {
        0 => Placement::rotation_x(180.0),
        1 => Placement::rotation_x(90.0),
        2 => Placement::rotation_z(n.between(0.0, 360.0)),
        _ => Placement::IDENTITY,
    };
    Placement::translation(by[0], by[1], by[2]) * turn
}

#[test]
fn nothing_in_common_is_never_said_of_solids_that_have() {
    let all = solids();
    let mut n = Numbers(0x5EED);
    let (mut free, mut decided, mut entered) = (0, 0, 0);
    let mut open = std::collections::BTreeMap::new();
    for _ in 0..2000 {
        let (a, b) = (&all[n.below(all.len())], &all[n.below(all.len())]);
        // Somewhere in the world, so that the numbers are not round.
        let world = Placement::translation(13.7, -4.1, 8.9)
            * Placement::rotation_about([0.0; 3], [0.6, 0.0, 0.8], 33.0).unwrap();
        let at = place(&mut n);
        let found = common(&a.boundary, &b.boundary, &(world.inverse() * (world * at)));
        // Of some pairs that touch the kernel's boolean makes nothing usable: then the points decide alone.
        let exact = pair::common(&a.shape, &world, &b.shape, &(world * at));
        let sampled = pair::sampled_common(&a.shape, &world, &b.shape, &(world * at), 200).unwrap();
        let empty = exact.as_ref().is_ok_and(|e| e.volume <= 1e-6) && sampled.inside == 0;
        free += usize::from(empty);
        if enter(&a.boundary, &b.boundary, &at) {
            entered += 1;
            assert!(
                // Of a ring in a headed pin, crosswise, the boolean finds nothing, and the points do.
                found == Common::Open
                    && (sampled.inside > 0 || exact.as_ref().is_ok_and(|e| e.volume > 1e-6)),
                "{} and {} at {at:?}: {exact:?}, {sampled:?}",
                a.name,
                b.name
            );
        }
        if found == Common::Nothing {
            decided += 1;
            assert!(
                sampled.inside == 0 && exact.as_ref().map_or(true, |e| e.volume <= 1e-6),
                "{} and {} at {at:?}: {exact:?}, {sampled:?}",
                a.name,
                b.name
            );
        } else if empty {
            *open.entry((a.name, b.name)).or_insert(0) += 1;
        }
    }
    println!("{decided} of {free} decided, {entered} seen to enter; open: {open:?}");
    // Of those that are in each other by more than a micrometre nearly all show it by a point.
    assert!(
        entered * 100 >= (2000 - free) * 70,
        "{entered} of {}",
        2000 - free
    );
    assert!(decided * 100 >= free * 95, "{decided} of {free}: {open:?}");
}

/// How long skins and what is decided from them take: `cargo test -p assemcad-geometry --release --test narrow
/// timings -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn timings() {
    let wall = std::time::Instant::now;
    let holes: Vec<Shape> = (0..250)
        .map(|n| {
            let (sin, cos) = libm::sincos(f64::from(n) * core::f64::consts::TAU / 250.0);
            let place = at(1000.0 * cos, 1000.0 * sin, -1.0);
            Shape::cylinder(&place, 4.5, 14.0).unwrap()
        })
        .collect();
    let ring = cut(
        &Shape::cylinder(&at(0.0, 0.0, 0.0), 1025.0, 12.0).unwrap(),
        &Shape::cylinder(&at(0.0, 0.0, -1.0), 975.0, 14.0).unwrap(),
    );
    let flange = one(&ring
        .without(&holes.iter().collect::<Vec<_>>(), None)
        .unwrap());
    let begun = wall();
    let skin = flange.skin(0.02, 10.0).unwrap();
    println!(
        "skin of a flange: {:?}, {} triangles",
        begun.elapsed(),
        skin.triangles.len()
    );
    let begun = wall();
    let flange = Boundary::new(skin).unwrap();
    println!("made ready: {:?}", begun.elapsed());
    let washer = cut(&rod(0.0, 8.0, 1.6), &rod(-1.0, 4.2, 4.0));
    let bolt = one(&rod(0.0, 4.0, 45.0)
        .fused(&[&rod(-5.3, 6.5, 5.3)], false, None)
        .unwrap());
    for (name, shape, z) in [("washer", washer, 12.0), ("bolt", bolt, -0.0)] {
        let boundary = Boundary::new(shape.skin(0.002, 10.0).unwrap()).unwrap();
        let begun = wall();
        for n in 0..250 {
            let deg = f64::from(n) * 360.0 / 250.0;
            let place = Placement::rotation_z(deg) * Placement::translation(1000.0, 0.0, z);
            assert_eq!(
                common(&flange, &boundary, &place),
                Common::Nothing,
                "{name}"
            );
        }
        println!("250 times flange and {name}: {:?}", begun.elapsed());
    }
    let begun = wall();
    let up = Placement::translation(0.0, 0.0, 12.0);
    println!(
        "flange on flange: {:?} {:?}",
        common(&flange, &flange, &up),
        begun.elapsed()
    );
}
