//! Which identifiers survive in WGSL, GLSL and HLSL without being renamed.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use naga::keywords::wgsl::{BUILTIN_IDENTIFIERS, RESERVED};

/// Words that GLSL or HLSL keeps for itself and that WGSL does not.
const OTHER_LANGUAGES: &str = "
    asm bool break buffer case cbuffer centroid char class common const continue cross decl default discard
    do double dword else enum export extern external false filter fixed flat float for fract goto groupshared
    half hvec if implements in inline inout input int interface invariant layout lerp line lineadj linear long
    lowp mad main matrix mediump mix mod namespace noinline noperspective nointerpolation notEqual or out output
    packoffset partition pass patch pixelfragment point precise precision public rcp readonly register resource
    restrict return rsqrt sample sampler saturate shared short sizeof smooth snorm static string struct
    subroutine superp switch tbuffer technique template texture this triangle triangleadj true typedef uint
    uniform union unorm unsigned using varying vector vertexfragment void volatile while writeonly
    frac fmod ddx ddy dFdx dFdy fwidth clip noise mul dst lit equal any all not isnan isinf isfinite log
    inversesqrt outerProduct texelFetch imageLoad imageStore asfloat asint asuint abort errorf printf";

static TAKEN: LazyLock<BTreeSet<&'static str>> = LazyLock::new(|| {
    RESERVED
        .iter()
        .chain(BUILTIN_IDENTIFIERS)
        .copied()
        .chain(OTHER_LANGUAGES.split_whitespace())
        .collect()
});

/// Words that HLSL compilers take in any case.
const ANY_CASE: [&str; 8] = [
    "asm",
    "decl",
    "pass",
    "technique",
    "texture1d",
    "texture2d",
    "texture3d",
    "texturecube",
];

/// Why `name` may not stand in the generated text, if it may not.
pub(crate) fn objection(name: &str) -> Option<String> {
    if name.ends_with(|c: char| c.is_ascii_digit()) {
        return Some(format!(
            "`{name}` ends in a digit: naga renames it and naga_oil rejects it; end it in a letter"
        ));
    }
    if !name.is_ascii() {
        return Some(format!("`{name}` is not ASCII"));
    }
    if name.starts_with('_') || name.ends_with('_') || name.contains("__") {
        return Some(format!(
            "`{name}`: leading, trailing and double underscores are renamed"
        ));
    }
    if name.starts_with("gl_") || name.starts_with("naga_") || name.starts_with("r#") {
        return Some(format!("`{name}` starts with a reserved prefix"));
    }
    if TAKEN.contains(name) || ANY_CASE.contains(&name.to_ascii_lowercase().as_str()) {
        return Some(format!("`{name}` is a reserved or built-in word of WGSL, GLSL or HLSL"));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::objection;

    #[test]
    fn words_of_all_three_languages_are_refused() {
        for name in [
            "sin", "half", "float", "lerp", "var", "Pass", "vec2", "ptr", "mix", "x1", "_x", "x_", "a__b", "gl_x",
        ] {
            assert!(objection(name).is_some(), "{name} must be refused");
        }
    }

    #[test]
    fn plain_names_are_accepted() {
        for name in ["x", "sine_integral", "HALF_PI", "Sincos", "c_a", "q"] {
            assert_eq!(objection(name), None, "{name} must be accepted");
        }
    }
}
