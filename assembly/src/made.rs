//! Parts as their factories make them: recipe and ports.
//!
//! The script only says what is to be done; where a selected face lies, and so where a port sits, the
//! kernel finds out.

use std::sync::Arc;

use assemcad_factories::Registry;
use assemcad_factories::failure::failed_in;
use assemcad_kernel::protocol::Named;
use assemcad_placing::Made;
use serde_json::{Map, Value};

use crate::{Faults, Workshop};

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
        let solid = Named::new(evaluated.recipe.clone());
        let designation = evaluated
            .designation
            .clone()
            .filter(|_| Registry::is_builtin(named.name()));
        if let Some(known) = self.remembered.get(solid.hash()) {
            // Two sources, or two sets of parameters, may have one recipe: what goes beside it is that of
            // those that were asked for.
            if known.lines == evaluated.lines
                && known.params == evaluated.params
                && known.designation == designation
            {
                return Ok(known);
            }
        }
        let failed = |failure| {
            let d = failed_in(&failure, part, named.name(), &evaluated.lines);
            vec![d]
        };
        let built = self.door.asker().build(&solid).await.map_err(failed)?;
        let made = Arc::new(Made {
            solid: solid.clone(),
            lines: evaluated.lines.clone(),
            ports: built.ports,
            params: evaluated.params.clone(),
            designation,
        });
        self.remembered
            .put(solid.hash().to_owned(), Arc::clone(&made));
        Ok(made)
    }
}
