//! Solids by name.

use std::sync::Arc;

use assemcad_model::recipe::Recipe;
use serde::{Deserialize, Serialize};

/// A solid by the hash of its recipe, which may come with it or not.
///
/// Hashing a long recipe takes longer than many a question, and so does sending it: it is hashed once, and sent to
/// workers that do not know the solid.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Named {
    hash: Arc<str>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    recipe: Option<Arc<Recipe>>,
}

impl Named {
    /// The solid of a recipe. One that holds a number that is not finite has no name, and is no solid.
    #[must_use]
    pub fn new(recipe: impl Into<Arc<Recipe>>) -> Self {
        let recipe = recipe.into();
        let hash = recipe.hash().unwrap_or_default().into();
        Self {
            hash,
            recipe: Some(recipe),
        }
    }

    /// SHA-256 of the recipe; empty where it has none.
    #[must_use]
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// How to make it, where that is known.
    #[must_use]
    pub fn recipe(&self) -> Option<&Recipe> {
        self.recipe.as_deref()
    }

    /// Only its name.
    #[must_use]
    pub fn alone(&self) -> Self {
        Self {
            hash: Arc::clone(&self.hash),
            recipe: None,
        }
    }
}

impl From<Recipe> for Named {
    fn from(recipe: Recipe) -> Self {
        Self::new(recipe)
    }
}

impl From<&Recipe> for Named {
    fn from(recipe: &Recipe) -> Self {
        Self::new(recipe.clone())
    }
}

impl PartialEq for Named {
    fn eq(&self, other: &Self) -> bool {
        self.hash == other.hash
    }
}

impl Eq for Named {}
