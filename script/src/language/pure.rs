//! Vectors, planes and locations as CadQuery's constructors make them.

use starlark::values::Value;

use super::bind::Given;
use super::{items, kind_of, number, vector};
use crate::fault::Fault;
use crate::values::{Location, Plane, Vector, handle};

/// The named planes of CadQuery's `Plane.named`.
pub(super) fn named(name: &str, origin: [f64; 3]) -> Plane {
    let (x, z) = match name {
        "YZ" => ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        "ZX" => ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        "XZ" | "bottom" => ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]),
        "YX" => ([0.0, 1.0, 0.0], [0.0, 0.0, -1.0]),
        "ZY" | "left" => ([0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
        "back" => ([-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        "right" => ([0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
        "top" => ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        _ => ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
    };
    let frame = assemcad_model::frame::Frame { origin, x, z };
    Plane { frame }
}

/// `Vector(x, y, z)`, `Vector((x, y, z))`, `Vector(other)`.
pub(super) fn point(given: &Given<'_>) -> Result<Vector, Fault> {
    let named = |word: &str| given.named.iter().find(|(name, _)| *name == word);
    let numbers: Vec<Value<'_>> = if given.named.is_empty() {
        given.positions.clone()
    } else {
        ["x", "y", "z"]
            .iter()
            .filter_map(|word| named(word).map(|(_, value)| *value))
            .collect()
    };
    let at = match *numbers.as_slice() {
        [] => [0.0; 3],
        [one] => vector(one, "the point")?,
        [x, y] => [number(x, "x")?, number(y, "y")?, 0.0],
        [x, y, z] => [number(x, "x")?, number(y, "y")?, number(z, "z")?],
        _ => {
            return Err(Fault::new("Vector takes at most three numbers")
                .hint("Vector(x, y, z) or Vector((x, y, z))"));
        }
    };
    Vector::new(at)
}

/// The forms of CadQuery's `Location`.
pub(super) fn location(given: &Given<'_>) -> Result<Location, Fault> {
    const FORMS: &str = "Location(x=0, y=0, z=0, rx=0, ry=0, rz=0), Location((x, y, z)), \
        Location((x, y, z), (rx, ry, rz)), Location((x, y, z), axis, angle), Location(plane) or \
        Location(plane, (x, y, z)); angles in degrees";
    let wrong = |why: String| Fault::new(why).hint(FORMS);
    const WORDS: [&str; 6] = ["x", "y", "z", "rx", "ry", "rz"];
    let number_at = |value: Value<'_>, word: &str| number(value, word).map_err(|f| f.hint(FORMS));
    let is_number = |v: &Value<'_>| matches!(v.get_type(), "int" | "float");
    if given.positions.iter().all(is_number) {
        let mut all = [0.0; 6];
        if given.positions.len() > all.len() {
            return Err(wrong("Location takes at most six numbers".to_owned()));
        }
        for ((slot, value), word) in all.iter_mut().zip(&given.positions).zip(WORDS) {
            *slot = number_at(*value, word)?;
        }
        for (word, value) in &given.named {
            let place = WORDS.iter().position(|w| w == word);
            let Some(slot) = place.and_then(|i| all.get_mut(i)) else {
                return Err(wrong(format!("Location has no parameter '{word}'")));
            };
            *slot = number_at(*value, word)?;
        }
        let [x, y, z, rx, ry, rz] = all;
        return Location::turned([x, y, z], [rx, ry, rz]);
    }
    let values: Vec<Value<'_>> = given
        .positions
        .iter()
        .copied()
        .chain(given.named.iter().map(|(_, v)| *v))
        .collect();
    let plane = values.first().and_then(|v| Plane::from_value(*v));
    match (plane, values.as_slice()) {
        (Some(plane), [_]) => Location::of(&plane.frame),
        (Some(plane), [_, at]) => Location::of(&assemcad_model::frame::Frame {
            origin: vector(*at, "the place")?,
            ..plane.frame
        }),
        (None, [at]) if handle(*at).is_none() => {
            Location::turned(vector(*at, "the place")?, [0.0; 3])
        }
        (None, [at, turns]) if items(*turns).is_some_and(|t| t.len() == 3) => {
            Location::turned(vector(*at, "the place")?, vector(*turns, "the angles")?)
        }
        (None, [at, axis, angle]) => Location::about(
            vector(*at, "the place")?,
            vector(*axis, "the axis")?,
            number(*angle, "the angle")?,
        ),
        _ => {
            let kinds: Vec<String> = values.iter().map(|v| kind_of(*v)).collect();
            Err(wrong(format!(
                "Location does not take {}",
                kinds.join(", ")
            )))
        }
    }
}
