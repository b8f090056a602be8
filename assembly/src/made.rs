//! Parts as their factories make them: recipe and ports.
//!
//! The script only says what is to be done; where a selected face lies, and so where a port sits, the
//! kernel finds out.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use assemcad_model::ports::Port;
use assemcad_model::recipe::Recipe;
use serde_json::{Map, Value};

use crate::build::failed_in;
use crate::{Faults, Workshop};

/// So many made parts are remembered.
const MOST_KEPT: usize = 1024;

/// A part as its factory makes it of its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// What the kernel needs to make the solid.
    pub recipe: Recipe,
    /// The line (1-based) of each call of the recipe in the factory's source.
    pub lines: Vec<u32>,
    /// The ports, in the part's frame.
    pub ports: Vec<Port>,
}

/// Made parts by the hash of their recipe.
#[derive(Debug, Default)]
pub(crate) struct Kept {
    parts: Mutex<BTreeMap<String, Arc<Made>>>,
}

impl Kept {
    fn get(&self, hash: &str) -> Option<Arc<Made>> {
        let parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        parts.get(hash).cloned()
    }

    fn put(&self, hash: String, made: Arc<Made>) {
        let mut parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        // The workers keep the solids: starting anew is cheaper than knowing which were used last.
        if parts.len() >= MOST_KEPT {
            parts.clear();
        }
        parts.insert(hash, made);
    }
}

impl Workshop {
    /// Evaluates a factory and has the kernel make the part, for its ports.
    ///
    /// `part` names the part in diagnostics of the kernel; none where there is no part yet.
    ///
    /// # Errors
    /// An unknown factory, parameters at fault, a fault of the script, or why the kernel makes no solid
    /// of the recipe.
    pub async fn make(
        &self,
        factory: &str,
        params: &Map<String, Value>,
        part: Option<&str>,
    ) -> Result<Arc<Made>, Faults> {
        self.recheck(factory).await?;
        let evaluated = self
            .registry
            .build(&self.evaluator, factory, params)
            .await?;
        let named = self.registry.get(factory).map_err(|d| vec![*d])?;
        let hash = evaluated.recipe.hash().ok();
        if let Some(known) = hash.as_deref().and_then(|hash| self.kept.get(hash)) {
            // Two sources may have one recipe: the lines are those of the source that was asked for.
            if known.lines == evaluated.lines {
                return Ok(known);
            }
        }
        let built = self
            .solid(&evaluated.recipe, |failure| {
                failed_in(failure, part, named.name(), &evaluated.lines)
            })
            .await
            .map_err(|d| vec![d])?;
        let made = Arc::new(Made {
            recipe: evaluated.recipe.clone(),
            lines: evaluated.lines.clone(),
            ports: built.ports,
        });
        if let Some(hash) = hash {
            self.kept.put(hash, Arc::clone(&made));
        }
        Ok(made)
    }
}
