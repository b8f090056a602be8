//! Tables of standards that checks use.

/// Clearance holes by ISO 273: nominal diameter, then the fine, medium and coarse series, in mm. Up to M39: larger sizes are left
/// out until they are held against the standard.
static CLEARANCE: [(f64, f64, f64, f64); 21] = [
    (1.6, 1.7, 1.8, 2.0),
    (2.0, 2.2, 2.4, 2.6),
    (2.5, 2.7, 2.9, 3.1),
    (3.0, 3.2, 3.4, 3.6),
    (4.0, 4.3, 4.5, 4.8),
    (5.0, 5.3, 5.5, 5.8),
    (6.0, 6.4, 6.6, 7.0),
    (8.0, 8.4, 9.0, 10.0),
    (10.0, 10.5, 11.0, 12.0),
    (12.0, 13.0, 13.5, 14.5),
    (14.0, 15.0, 15.5, 16.5),
    (16.0, 17.0, 17.5, 18.5),
    (18.0, 19.0, 20.0, 21.0),
    (20.0, 21.0, 22.0, 24.0),
    (22.0, 23.0, 24.0, 26.0),
    (24.0, 25.0, 26.0, 28.0),
    (27.0, 28.0, 30.0, 32.0),
    (30.0, 31.0, 33.0, 35.0),
    (33.0, 34.0, 36.0, 38.0),
    (36.0, 37.0, 39.0, 42.0),
    (39.0, 40.0, 42.0, 45.0),
];

/// The clearance holes of a nominal diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Clearance {
    pub(crate) fine: f64,
    pub(crate) medium: f64,
    pub(crate) coarse: f64,
}

/// The clearance holes of ISO 273 for a nominal diameter, where the table has it.
pub(crate) fn clearance(nominal: f64) -> Option<Clearance> {
    let row = CLEARANCE.iter().find(|r| (r.0 - nominal).abs() < 1e-6)?;
    Some(Clearance {
        fine: row.1,
        medium: row.2,
        coarse: row.3,
    })
}

#[cfg(test)]
mod tests {
    use super::{CLEARANCE, clearance};

    #[test]
    fn series_grow_and_are_sorted() {
        assert!(CLEARANCE.is_sorted_by(|a, b| a.0 < b.0 && a.2 < b.2));
        assert!(
            CLEARANCE
                .iter()
                .all(|r| r.0 < r.1 && r.1 < r.2 && r.2 < r.3)
        );
        assert_eq!(clearance(8.0).unwrap().medium, 9.0);
        assert_eq!(clearance(8.1), None);
    }
}
