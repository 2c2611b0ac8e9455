//! The order of the house, read from its sources: arrows point down, no std, no platform maths, f32 kernels stay f32.

use std::path::{Path, PathBuf};

/// The storeys from the ground up; modules of one storey do not know each other. The shader kernels import nothing
/// but themselves; `simd` stands above the scalar sources.
const STOREYS: [&[&str]; 6] = [
    &["numeric"],
    &["special", "color"],
    &["geometry", "optics"],
    &["diffraction", "film", "groove"],
    &["light", "sampling"],
    &["model", "shader"],
];
/// Above all storeys.
const ROOF: [&str; 1] = ["simd"];

/// Methods that call the platform's mathematics, or would without std.
const PLATFORM_MATHS: [&str; 28] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "exp2", "exp_m1",
    "ln", "ln_1p", "log", "log2", "log10", "powi", "powf", "sqrt", "cbrt", "hypot", "mul_add", "floor", "round",
    "ceil",
];

/// Every source of the library below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The code of a file: no comments, no text in quotes, no test modules.
fn code(text: &str) -> String {
    let mut lines = Vec::new();
    for line in text.lines() {
        if line.trim() == "#[cfg(test)]" {
            break;
        }
        let bare = line.split("//").next().unwrap_or_default();
        lines.push(bare.split('"').step_by(2).collect::<Vec<_>>().join("\"\""));
    }
    lines.join("\n")
}

/// Each source with its path below src and its code.
fn house() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let all = sources(&root).into_iter().map(|path| {
        let name = path
            .strip_prefix(&root)
            .expect("below src")
            .to_string_lossy()
            .replace('\\', "/");
        (name, code(&std::fs::read_to_string(&path).expect("a source")))
    });
    all.collect()
}

/// The first word of a path, or the words of a group: `numeric` of `numeric::phase`, `a` and `b` of `{a, b::c}`.
fn heads(path: &str) -> Vec<String> {
    let word = |text: &str| {
        text.chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect::<String>()
    };
    let Some(group) = path.strip_prefix('{') else {
        return vec![word(path)];
    };
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (i, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => {
                parts.push(&group[start..i]);
                break;
            }
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&group[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    parts
        .iter()
        .map(|part| word(part.trim()))
        .filter(|head| !head.is_empty())
        .collect()
}

/// The modules that code of the module `own` names: through `crate::`, and through as many `super::` as leave it.
fn imports(code: &str, own: &str, depth: usize) -> Vec<String> {
    let up = "super::".repeat(depth);
    let mut found = Vec::new();
    for prefix in ["crate::", up.as_str()] {
        if prefix.is_empty() {
            continue;
        }
        for (i, _) in code.match_indices(prefix) {
            if !code[..i].ends_with("$") && !code[..i].ends_with("super::") {
                found.extend(heads(&code[i + prefix.len()..]));
            }
        }
    }
    found.retain(|head| head != own && head != "super");
    found
}

fn storey(module: &str) -> Option<usize> {
    STOREYS.iter().position(|modules| modules.contains(&module))
}

/// What is wrong with an import, if anything.
fn fault(own: &str, imported: &str) -> Option<String> {
    if ROOF.contains(&own) {
        return None;
    }
    match (storey(own), storey(imported)) {
        (None, _) => Some(format!("{own} stands on no storey")),
        (Some(_), None) => Some(format!("{own} imports {imported}, which stands on no storey")),
        (Some(above), Some(below)) if below < above => None,
        _ => Some(format!("{own} imports {imported}, which is not below it")),
    }
}

#[test]
fn arrows_point_down_only() {
    let mut faults = Vec::new();
    let mut arrows = 0;
    for (name, code) in house() {
        let own = name.split(['/', '.']).next().expect("a name").to_owned();
        if own == "lib" {
            continue;
        }
        // From src/a/b.rs, `super::super::` leaves the module; from src/a/mod.rs and src/a.rs, `super::` does.
        let file = name.rsplit('/').next().unwrap_or_default();
        let depth = name.matches('/').count() + usize::from(file != "mod.rs");
        for imported in imports(&code, &own, depth) {
            arrows += 1;
            faults.extend(fault(&own, &imported).map(|f| format!("src/{name}: {f}")));
        }
        if own == "shader" {
            assert!(
                imports(&code, &own, depth).is_empty(),
                "src/{name} imports from outside the kernels"
            );
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(arrows > 5, "{arrows} imports found");
}

#[test]
fn the_reader_of_imports_sees_every_form() {
    let seen = |code: &str| imports(code, "special", 2);
    assert_eq!(seen("use crate::numeric::phase::{a, b};"), ["numeric"]);
    assert_eq!(
        seen("use crate::{numeric::{x, y}, special::z, light};"),
        ["numeric", "light"]
    );
    assert_eq!(seen("let y = crate::model::f(x);"), ["model"]);
    assert_eq!(seen("use super::super::film::airy;"), ["film"]);
    assert!(seen("use super::tables::TAIL;").is_empty());
    assert!(fault("special", "color").is_some() && fault("special", "film").is_some());
    assert!(fault("film", "special").is_none() && fault("film", "groove").is_some());
    assert!(code("/// use crate::light;\nlet s = \"crate::film::\"; // crate::model").contains("let s"));
    assert!(!code("/// use crate::light;\nlet s = \"crate::film::\"; // crate::model").contains("crate"));
}

#[test]
fn the_library_is_no_std_and_has_no_unsafe_code() {
    let text = include_str!("../src/lib.rs");
    assert!(text.contains("\n#![no_std]\n") && text.contains("\n#![forbid(unsafe_code)]\n"));
    for (name, code) in house() {
        for word in ["std::", "extern crate", "unsafe ", "alloc::"] {
            assert!(!code.contains(word), "src/{name} has `{word}`");
        }
    }
}

/// Names of called methods among the forbidden ones.
fn platform_maths(code: &str) -> Vec<&'static str> {
    let called = |name: &&&str| {
        code.contains(&format!(".{name}("))
            || code.contains(&format!("f64::{name}("))
            || code.contains(&format!("f32::{name}("))
    };
    PLATFORM_MATHS.iter().filter(called).copied().collect()
}

#[test]
fn no_source_calls_the_mathematics_of_the_platform() {
    for (name, code) in house() {
        let found = platform_maths(&code);
        assert!(found.is_empty(), "src/{name} calls {found:?}");
    }
    assert_eq!(platform_maths("x.sin() + f64::sqrt(y)"), ["sin", "sqrt"]);
    assert!(platform_maths("libm::sin(x) + x.abs().copysign(y)").is_empty());
}

#[test]
fn the_kernels_use_no_f64() {
    let mut kernels = 0;
    for (name, code) in house().iter().filter(|(name, _)| name.starts_with("shader/")) {
        let mut words = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
        assert!(!words.any(|word| word == "f64"), "src/{name} uses f64");
        kernels += 1;
    }
    assert!(kernels >= 5, "{kernels} kernel files found");
}
