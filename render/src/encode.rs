//! PNG.

use png::{BitDepth, ColorType, DeflateCompression, Encoder, Filter};

use crate::RenderError;
use crate::canvas::Canvas;

/// The picture as PNG, eight bits a colour, no time and no text in it.
///
/// Compression and filter are stated, so that they do not change with the library's defaults.
///
/// # Errors
/// When the library refuses.
pub(crate) fn png(canvas: &Canvas) -> Result<Vec<u8>, RenderError> {
    let failed = |e: png::EncodingError| RenderError::Encoding(e.to_string());
    let side = |n: usize| u32::try_from(n).map_err(|_| RenderError::Size);
    let mut out = Vec::new();
    let mut encoder = Encoder::new(&mut out, side(canvas.width)?, side(canvas.height)?);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_deflate_compression(DeflateCompression::Level(6));
    encoder.set_filter(Filter::Up);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer
        .write_image_data(canvas.pixels.as_flattened())
        .map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(out)
}
