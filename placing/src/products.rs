//! Parts of one recipe as instances of one product, with its name and colour.

use assemcad_kernel::protocol::{Instance, Product};

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
pub fn products(resolved: &Resolved, placements: &Placements) -> (Vec<Product>, Vec<Instance>) {
    let mut products: Vec<Product> = Vec::new();
    let mut instances = Vec::new();
    for (i, part) in resolved.parts.iter().enumerate() {
        let recipe = &part.made.solid;
        let solid = match products.iter().position(|p| p.recipe == *recipe) {
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
    (products, instances)
}
