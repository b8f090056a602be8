//! Sines and cosines that are the same on every platform and exact at right angles.

/// Sine and cosine of an angle in degrees.
///
/// The angle is reduced in degrees (an exact operation in floating point) to at most 45 degrees
/// before `libm` sees it, so that multiples of 90 degrees give exactly 0, 1 or -1 and angles that are
/// mirror images of each other give the same digits.
#[must_use]
pub fn sin_cos_deg(angle_deg: f64) -> (f64, f64) {
    let turn = libm::fmod(angle_deg, 360.0);
    let quadrant = libm::round(turn / 90.0);
    let rest = turn - quadrant * 90.0;
    let (sin, cos) = if rest == 0.0 {
        (0.0, 1.0)
    } else {
        libm::sincos(rest * core::f64::consts::PI / 180.0)
    };
    // `quadrant` is -4 ..= 4.
    match (quadrant as i32).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The angle between two unit vectors in degrees, accurate for small angles too
/// (the arc sine of half the chord instead of the arc cosine of the dot product).
#[must_use]
pub fn between_deg(a: &nalgebra::Vector3<f64>, b: &nalgebra::Vector3<f64>) -> f64 {
    let cross = a.cross(b).norm();
    let dot = a.dot(b);
    libm::atan2(cross, dot) * 180.0 / core::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use super::sin_cos_deg;

    #[test]
    fn right_angles_are_exact() {
        for (deg, sin, cos) in [
            (0.0, 0.0, 1.0),
            (90.0, 1.0, 0.0),
            (180.0, 0.0, -1.0),
            (270.0, -1.0, 0.0),
        ] {
            for turns in [-720.0, -360.0, 0.0, 360.0, 36000.0] {
                let (s, c) = sin_cos_deg(deg + turns);
                assert!(s == sin && c == cos, "{deg}+{turns}: {s} {c}");
            }
        }
    }

    #[test]
    fn agrees_with_closed_forms() {
        // sin 30 = 1/2, cos 60 = 1/2, sin 45 = cos 45 = sqrt(1/2), sin 15 = (sqrt 6 - sqrt 2) / 4.
        let near = |a: f64, b: f64| assert!((a - b).abs() < 2e-16, "{a} {b}");
        near(sin_cos_deg(30.0).0, 0.5);
        near(sin_cos_deg(-60.0).1, 0.5);
        near(sin_cos_deg(45.0).0, 0.5_f64.sqrt());
        near(sin_cos_deg(135.0).1, -(0.5_f64.sqrt()));
        near(sin_cos_deg(15.0).0, (6.0_f64.sqrt() - 2.0_f64.sqrt()) / 4.0);
        near(sin_cos_deg(210.0).0, -0.5);
    }
}
