//! What a caller of a verification may choose.

/// Common volume above which two parts clash where the caller states none, in mm3.
pub const DEFAULT_TAU_MM3: f64 = 0.001;

/// What a caller of a verification may choose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terms {
    /// Common volume above which two parts clash, in mm3.
    pub tau_mm3: f64,
    /// Distance below which parts that do not touch are told of, in mm; 0 asks for none.
    pub clearance_mm: f64,
    /// Density of all parts in kg/m3; [`assemcad_model::report::STEEL_KG_M3`] where it is not stated.
    pub density_kg_m3: Option<f64>,
}

impl Default for Terms {
    fn default() -> Self {
        Self {
            tau_mm3: DEFAULT_TAU_MM3,
            clearance_mm: 0.0,
            density_kg_m3: None,
        }
    }
}
