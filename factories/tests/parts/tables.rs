//! The dimensions that the standards list, written down a second time: the scripts have their own.

/// ISO 273, medium series: M3 to M6 by 10 percent or 0.4 mm and so on; here as the standard lists it.
pub fn medium(bolt: f64) -> f64 {
    let table = [
        (3.0, 3.4),
        (4.0, 4.5),
        (5.0, 5.5),
        (6.0, 6.6),
        (8.0, 9.0),
        (10.0, 11.0),
        (12.0, 13.5),
        (16.0, 17.5),
        (20.0, 22.0),
        (24.0, 26.0),
    ];
    table
        .iter()
        .find(|(d, _)| *d == bolt)
        .map_or(0.0, |(_, hole)| *hole)
}

/// The minor diameter of an internal thread by ISO 724: `D - 5/4 H`, `H = sqrt(3)/2 P`.
pub fn minor(d: f64) -> f64 {
    d - 1.25 * 3.0_f64.sqrt() / 2.0 * pitch(d)
}

/// ISO 261, coarse series.
pub fn pitch(d: f64) -> f64 {
    match d {
        3.0 => 0.5,
        4.0 => 0.7,
        5.0 => 0.8,
        6.0 => 1.0,
        8.0 => 1.25,
        10.0 => 1.5,
        12.0 => 1.75,
        16.0 => 2.0,
        20.0 => 2.5,
        24.0 => 3.0,
        _ => f64::NAN,
    }
}

/// DIN 6885-1: width and hub depth of the keyway of a bore.
pub fn keyway(d: f64) -> (f64, f64) {
    let rows = [
        (8.0, 2.0, 1.0),
        (10.0, 3.0, 1.4),
        (12.0, 4.0, 1.8),
        (17.0, 5.0, 2.3),
        (22.0, 6.0, 2.8),
        (30.0, 8.0, 3.3),
        (38.0, 10.0, 3.3),
        (44.0, 12.0, 3.3),
        (50.0, 14.0, 3.8),
        (58.0, 16.0, 4.3),
        (65.0, 18.0, 4.4),
        (75.0, 20.0, 4.9),
        (85.0, 22.0, 5.4),
        (95.0, 25.0, 5.4),
        (110.0, 28.0, 6.4),
    ];
    let row = rows.iter().find(|(most, _, _)| d <= *most).unwrap();
    (row.1, row.2)
}

/// Width across flats and height of a hexagon head (ISO 4014), and of a nut (ISO 4032): s, k, m.
pub fn hex_sizes(d: f64) -> (f64, f64, f64) {
    match d {
        3.0 => (5.5, 2.0, 2.4),
        4.0 => (7.0, 2.8, 3.2),
        5.0 => (8.0, 3.5, 4.7),
        6.0 => (10.0, 4.0, 5.2),
        8.0 => (13.0, 5.3, 6.8),
        10.0 => (16.0, 6.4, 8.4),
        12.0 => (18.0, 7.5, 10.8),
        16.0 => (24.0, 10.0, 14.8),
        20.0 => (30.0, 12.5, 18.0),
        24.0 => (36.0, 15.0, 21.5),
        _ => panic!("no size M{d}"),
    }
}

/// Socket head (ISO 4762): head's diameter, socket's width and depth.
pub fn socket_sizes(d: f64) -> (f64, f64, f64) {
    match d {
        3.0 => (5.5, 2.5, 1.3),
        4.0 => (7.0, 3.0, 2.0),
        5.0 => (8.5, 4.0, 2.5),
        6.0 => (10.0, 5.0, 3.0),
        8.0 => (13.0, 6.0, 4.0),
        10.0 => (16.0, 8.0, 5.0),
        12.0 => (18.0, 10.0, 6.0),
        16.0 => (24.0, 14.0, 8.0),
        20.0 => (30.0, 17.0, 10.0),
        24.0 => (36.0, 19.0, 12.0),
        _ => panic!("no size M{d}"),
    }
}

/// Plain washer (ISO 7089): inner and outer diameter, thickness.
pub fn washer_sizes(d: f64) -> (f64, f64, f64) {
    match d {
        3.0 => (3.2, 7.0, 0.5),
        4.0 => (4.3, 9.0, 0.8),
        5.0 => (5.3, 10.0, 1.0),
        6.0 => (6.4, 12.0, 1.6),
        8.0 => (8.4, 16.0, 1.6),
        10.0 => (10.5, 20.0, 2.0),
        12.0 => (13.0, 24.0, 2.5),
        16.0 => (17.0, 30.0, 3.0),
        20.0 => (21.0, 37.0, 3.0),
        24.0 => (25.0, 44.0, 4.0),
        _ => (f64::NAN, f64::NAN, f64::NAN),
    }
}
