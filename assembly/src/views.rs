//! Pictures of an assembly on disk and measurements on it.

use assemcad_model::diagnostic::Diagnostic;
use assemcad_views::measure::{Measurement, Question, measure};
use assemcad_views::picture::{Drawn, Wanted, draw};

use crate::partial;
use crate::{Faults, Workshop};
use assemcad_store::file_of;

impl Workshop {
    /// Draws an assembly.
    ///
    /// # Errors
    /// When there is nothing to draw, or what is asked for has no meaning.
    pub async fn draw(&self, id: &str, wanted: &Wanted) -> Result<Drawn, Faults> {
        wanted.check()?;
        let spec = self.store.load(id).map_err(|d| vec![d])?;
        let part = partial::of(self, &spec).await?;
        draw(self.door.asker(), &spec.id, &part, wanted).await
    }

    /// Writes a picture beside the assembly's other files and gives its path below the root.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn keep_picture(
        &self,
        id: &str,
        wanted: &Wanted,
        png: &[u8],
    ) -> Result<String, Diagnostic> {
        let name = match wanted.views.as_slice() {
            [one] => one.name(),
            _ => "views",
        };
        let file = file_of(id, &format!("{id}-{name}.png"));
        self.store.write(&file, png)?;
        Ok(file)
    }

    /// Measures.
    ///
    /// # Errors
    /// When what is asked for is not there, has no place, or has no such measure.
    pub async fn measure(&self, id: &str, question: &Question) -> Result<Measurement, Faults> {
        question.check()?;
        let spec = self.store.load(id).map_err(|d| vec![d])?;
        let part = partial::of(self, &spec).await?;
        measure(self.door.urgent(), &part, question).await
    }
}
