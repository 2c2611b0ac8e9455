//! The files that the library carries: which sources, which texts, where they stand.

use std::path::{Path, PathBuf};

use crate::languages;
use crate::module::{Translation, translate};

/// Kernel files below `src/shader`, each after those it calls. `gpu.rs` is the Rust side of WGSL's built-ins and
/// is not translated.
pub const SOURCES: [&str; 20] = [
    "coefficients.rs",
    "elementary.rs",
    "sine_integral.rs",
    "sinc_squared_integral.rs",
    "bessel_coefficients.rs",
    "bessel.rs",
    "faddeeva_coefficients.rs",
    "faddeeva.rs",
    "erf_difference.rs",
    "turns.rs",
    "profile.rs",
    "spatial_phase.rs",
    "reflectance.rs",
    "interference.rs",
    "footprint_coefficients.rs",
    "footprint.rs",
    "inverse.rs",
    "sampling.rs",
    "light.rs",
    "area_light.rs",
];

/// A generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// Path below `src/shader`.
    pub path: &'static str,
    /// Its text.
    pub text: String,
}

impl Output {
    /// Whether the file under `root` holds other text.
    pub fn is_stale(&self, root: &Path) -> bool {
        !std::fs::read_to_string(root.join("src/shader").join(self.path)).is_ok_and(|text| text == self.text)
    }
}

/// Root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Translation of the library's own kernel files under `root`.
pub fn library(root: &Path) -> Result<Translation, String> {
    let mut texts = Vec::new();
    for name in SOURCES {
        let path = root.join("src/shader").join(name);
        let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        texts.push((format!("src/shader/{name}"), text));
    }
    let sources: Vec<(&str, &str)> = texts
        .iter()
        .map(|(name, text)| (name.as_str(), text.as_str()))
        .collect();
    translate(&sources).map_err(|refusal| refusal.to_string())
}

/// The four files of a translation.
pub fn outputs(translation: &Translation) -> Result<Vec<Output>, String> {
    let plain = banner("WGSL") + &translation.wgsl;
    languages::validate(&plain)?;
    let bevy = format!("#define_import_path iridescence\n{plain}");
    Ok(vec![
        Output {
            path: "wgsl/iridescence.wgsl",
            text: plain,
        },
        Output {
            path: "wgsl/iridescence_bevy.wgsl",
            text: bevy,
        },
        Output {
            path: "glsl/iridescence.glsl",
            text: banner("GLSL 3.30 and later; in GLSL ES 3.00 and later after `precision highp float;`")
                + &languages::glsl(translation)?,
        },
        Output {
            path: "hlsl/iridescence.hlsl",
            text: banner("HLSL, shader model 5.1 and later") + &languages::hlsl(translation)?,
        },
    ])
}

fn banner(language: &str) -> String {
    format!(
        "// iridescence: closed-form wave optics for renderers, f32.\n\
         // {language}.\n\
         // Generated from src/shader/*.rs by `cargo run -p shadergen`: do not edit.\n\
         // Licence: MIT OR Apache-2.0.\n"
    )
}
