//! Parts of one recipe as instances of one product, with its name and colour.

use assemcad_kernel::protocol::{Instance, Product};
use assemcad_model::diagnostic::{Code, Diagnostic};

use crate::place::Placements;
use crate::resolved::Resolved;

/// Colours of products, given out in the order in which products first appear: muted tones that
/// are told apart next to each other.
const PALETTE: [[f64; 3]; 8] = [
    [0.62, 0.65, 0.69],
    [0.33, 0.51, 0.70],
    [0.80, 0.62, 0.33],
    [0.45, 0.62, 0.45],
    [0.72, 0.45, 0.42],
    [0.55, 0.49, 0.69],
    [0.41, 0.64, 0.66],
    [0.74, 0.70, 0.52],
];

/// The distinct solids, in the order in which they first appear, and the parts as their instances. Parts without a place
/// are at the origin.
///
/// # Errors
/// When a recipe has no hash: a fault of the server.
pub fn products(
    resolved: &Resolved,
    placements: &Placements,
) -> Result<(Vec<Product>, Vec<Instance>), Diagnostic> {
    let mut hashes: Vec<String> = Vec::new();
    let mut products: Vec<Product> = Vec::new();
    let mut instances = Vec::new();
    for (i, part) in resolved.parts.iter().enumerate() {
        let recipe = &part.made.recipe;
        let hash = recipe
            .hash()
            .map_err(|e| Diagnostic::error(Code::Internal, &part.id, e.to_string()))?;
        let solid = match hashes.iter().position(|h| *h == hash) {
            Some(there) => there,
            None => {
                let same = |p: &&Product| {
                    p.name == part.factory || p.name.starts_with(&format!("{}-", part.factory))
                };
                let name = match products.iter().filter(same).count() {
                    0 => part.factory.clone(),
                    n => format!("{}-{}", part.factory, n + 1),
                };
                let color = PALETTE.get(products.len() % PALETTE.len()).copied();
                products.push(Product {
                    name,
                    recipe: recipe.clone(),
                    color: color.unwrap_or_default(),
                });
                hashes.push(hash);
                products.len() - 1
            }
        };
        let placement = placements.of(i).unwrap_or_default();
        instances.push(Instance {
            name: part.id.clone(),
            solid,
            placement: placement.into(),
        });
    }
    Ok((products, instances))
}
