//! How long looking at many parts takes (`cargo test --release -p assemcad-assembly looks_at -- --ignored
//! --nocapture`).

use std::sync::Arc;
use std::time::Instant;

use assemcad_axioms::indexed::Indexed;
use assemcad_kernel::mesh::Mesh;
use assemcad_model::angle::sin_cos_deg;
use assemcad_model::frame::Placement;
use serde_json::{Value, json};

use super::limit::Limit;
use super::rays::{Facets, PlacedFacets};
use super::ways::{MOST_WORK, look};

/// Adds a tube about z, of so many corners; the outside may be a square.
fn tube(
    mesh: &mut Mesh,
    at: [f64; 3],
    [inner, outer]: [f64; 2],
    height: f64,
    n: u32,
    square: bool,
) {
    let first = u32::try_from(mesh.positions.len()).unwrap();
    let [x, y, z] = at;
    for k in 0..n {
        let (sin, cos) = sin_cos_deg(360.0 * f64::from(k) / f64::from(n) + 0.1);
        let reach = if square {
            outer / sin.abs().max(cos.abs())
        } else {
            outer
        };
        for (r, h) in [(inner, 0.0), (inner, height), (reach, 0.0), (reach, height)] {
            mesh.positions.push([x + r * cos, y + r * sin, z + h]);
        }
    }
    for k in 0..n {
        let [a, b] = [k, (k + 1) % n].map(|k| first + 4 * k);
        // Inner and outer wall, bottom and top, seen from outside.
        for [p, q, r, s] in [
            [a, a + 1, b + 1, b],
            [a + 2, b + 2, b + 3, a + 3],
            [a, b, b + 2, a + 2],
            [a + 1, a + 3, b + 3, b + 1],
        ] {
            mesh.triangles.extend([[p, q, r], [p, r, s]]);
        }
    }
}

/// Two flanges of cells with a hole each, and bolts with washers and nuts through them.
fn flange(bolts: usize) -> (Indexed, Vec<Option<PlacedFacets>>) {
    let at = |i: usize, r: f64| {
        let (sin, cos) = sin_cos_deg(360.0 * i as f64 / bolts as f64);
        [r * cos, r * sin, 0.0]
    };
    let r = 5.0 * bolts as f64;
    let solid = |make: &dyn Fn(&mut Mesh)| {
        let mut mesh = Mesh::default();
        make(&mut mesh);
        Arc::new(Facets::new(&mesh, 0.01))
    };
    let plate = solid(&|m| (0..bolts).for_each(|i| tube(m, at(i, r), [4.5, 13.0], 12.0, 48, true)));
    let washer = solid(&|m| tube(m, [0.0; 3], [4.2, 8.0], 1.6, 48, false));
    let bolt = solid(&|m| {
        tube(m, [0.0; 3], [0.0, 4.0], 36.0, 48, false);
        tube(m, [0.0, 0.0, 36.0], [0.0, 6.5], 5.3, 6, false);
    });
    let nut = solid(&|m| tube(m, [0.0; 3], [3.3, 6.5], 6.8, 48, false));
    let mut parts: Vec<Value> = Vec::new();
    let mut bodies = Vec::new();
    let mut mates: Vec<Value> = Vec::new();
    let mut put = |id: String, solid: &Arc<Facets>, p: Placement, ports: Value| {
        parts.push(json!({"id": id, "factory": "user.part", "ports": ports, "placement": p}));
        bodies.push(Some(PlacedFacets::new(solid, &p)));
    };
    put("lower".into(), &plate, Placement::IDENTITY, json!([]));
    put(
        "upper".into(),
        &plate,
        Placement::translation(0.0, 0.0, 12.0),
        json!([]),
    );
    for i in 0..bolts {
        let [x, y, _] = at(i, r);
        let turn = Placement::rotation_z(360.0 * i as f64 / bolts as f64);
        let place = |z: f64| Placement::translation(x, y, z) * turn;
        let frame = json!({"origin": [0, 0, 0], "x": [1, 0, 0], "z": [0, 0, 1]});
        let thread = |t: &str, length: &str| {
            let params = json!({"diameter": 8, "pitch": 1.25, "hand": 1, length: 6.8, "modelled_diameter": 6.6});
            json!([{"name": "thread", "type": t, "frame": frame, "params": params}])
        };
        put(format!("washer_{i}"), &washer, place(24.0), json!([]));
        put(format!("under_{i}"), &washer, place(-1.6), json!([]));
        let own = thread("THREAD_EXTERNAL", "length");
        put(format!("bolt_{i}"), &bolt, place(-10.4), own);
        put(
            format!("nut_{i}"),
            &nut,
            place(-8.4),
            thread("THREAD_INTERNAL", "depth"),
        );
        mates.push(json!({
            "id": format!("t_{i}"), "mate_type": "thread_engage",
            "base": {"ref": format!("bolt_{i}"), "port": "thread"},
            "incoming": {"ref": format!("nut_{i}"), "port": "thread"},
        }));
    }
    let facts = serde_json::from_value(json!({"parts": parts, "mates": mates})).unwrap();
    (Indexed::new(facts), bodies)
}

#[test]
fn a_ring_of_bolts_comes_apart() {
    let (facts, bodies) = flange(5);
    let (limit, _waiting) = Limit::new(MOST_WORK);
    let (ways, _) = look(&facts, &bodies, &limit, Vec::new());
    assert_eq!((ways.axes.len(), ways.open.len()), (1, 0));
    let parts: Vec<String> = facts.parts.iter().map(|p| p.id.clone()).collect();
    let left = assemcad_axioms::apart::groups(&parts, &ways.axes);
    assert_eq!(left.len(), parts.len());
    // Of a bolt's own pairs all but two are one on the other: the bolt passes the nut, whose thread it is in.
    assert!(
        ways.axes[0]
            .stops
            .iter()
            .all(|s| !(s.part == "bolt_0" && s.by == "nut_0"))
    );
    // What would be too much work is left open, and says so.
    let (limit, _waiting) = Limit::new(100);
    let (ways, _) = look(&facts, &bodies, &limit, Vec::new());
    assert_eq!((ways.axes.len(), ways.open.len()), (0, parts.len()));
}

#[test]
#[ignore = "a measurement"]
fn looks_at_many_parts() {
    for bolts in [10, 50, 250, 1000] {
        let (facts, bodies) = flange(bolts);
        let (limit, _waiting) = Limit::new(MOST_WORK);
        let start = Instant::now();
        let (ways, _) = look(&facts, &bodies, &limit, Vec::new());
        let stops: usize = ways.axes.iter().map(|w| w.stops.len()).sum();
        let (took, axes, open) = (start.elapsed(), ways.axes.len(), ways.open.len());
        println!(
            "{} parts: {axes} axes, {stops} stops, {open} open, {took:?}",
            facts.parts.len()
        );
    }
}
