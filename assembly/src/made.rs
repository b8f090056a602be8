//! Parts as their factories make them: recipe and ports.
//!
//! The script only says what is to be done; where a selected face lies, and so where a port sits, the
//! kernel finds out.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use assemcad_factories::Registry;
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
    /// The parameters as they were used: checked, with defaults filled in.
    pub params: Map<String, Value>,
    /// What a standard calls the part, where a built-in factory says so. Solids do not show whether such
    /// a claim is true, so that it is not taken from factories that were admitted on evidence of solids.
    pub designation: Option<String>,
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
        let designation = evaluated
            .designation
            .clone()
            .filter(|_| Registry::is_builtin(named.name()));
        if let Some(known) = hash.as_deref().and_then(|hash| self.kept.get(hash)) {
            // Two sources, or two sets of parameters, may have one recipe: what goes beside it is that of
            // those that were asked for.
            if known.lines == evaluated.lines
                && known.params == evaluated.params
                && known.designation == designation
            {
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
            params: evaluated.params.clone(),
            designation,
        });
        if let Some(hash) = hash {
            self.kept.put(hash, Arc::clone(&made));
        }
        Ok(made)
    }
}
