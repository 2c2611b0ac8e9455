//! The committed shader text is what the sources give, under the names that the sources use.

use std::fs::{create_dir_all, read_to_string, write};
use std::path::Path;
use std::process::Command;

use naga::{ScalarKind, TypeInner};
use shadergen::{Kind, SOURCES, library, outputs, root, validate};

const TEXTS: [&str; 4] = [
    "wgsl/iridescence.wgsl",
    "wgsl/iridescence_bevy.wgsl",
    "glsl/iridescence.glsl",
    "hlsl/iridescence.hlsl",
];

#[test]
fn the_committed_text_is_current() {
    let translation = library(&root()).unwrap_or_else(|e| panic!("{e}"));
    let stale: Vec<&str> = outputs(&translation)
        .unwrap_or_else(|e| panic!("{e}"))
        .iter()
        .filter(|file| file.is_stale(&root()))
        .map(|file| file.path)
        .collect();
    assert!(stale.is_empty(), "run `cargo run -p shadergen`: stale {stale:?}");
}

/// Runs `shadergen --check` on a copy of the shader folder with one source changed.
fn check_with(folder: &str, file: &str, change: impl Fn(&str) -> String) -> (Option<i32>, String) {
    let copy = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    for path in SOURCES.into_iter().chain(TEXTS) {
        let text = read_to_string(root().join("src/shader").join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
        let target = copy.join("src/shader").join(path);
        create_dir_all(target.parent().expect("a folder")).expect("a folder");
        write(&target, if path == file { change(&text) } else { text }).expect("a file");
    }
    let run = Command::new(env!("CARGO_BIN_EXE_shadergen"))
        .args(["--check", "--root"])
        .arg(&copy)
        .output()
        .expect("the program runs");
    (run.status.code(), String::from_utf8_lossy(&run.stderr).into_owned())
}

/// The text with the second digit of the value of its first f32 constant changed: far more than one ulp.
fn one_digit_changed(text: &str) -> String {
    let value = text.find(": f32 = ").expect("an f32 constant") + ": f32 = ".len();
    let digits = |c: char| c.is_ascii_digit();
    let first = value
        + text[value..]
            .find(|c| digits(c) && c != '0')
            .expect("a digit that counts");
    let place = first + 1 + text[first + 1..].find(digits).expect("a second digit");
    let other = if &text[place..=place] == "5" { "4" } else { "5" };
    format!("{}{other}{}", &text[..place], &text[place + 1..])
}

#[test]
fn check_accepts_what_is_current() {
    let (code, notice) = check_with("current", "", str::to_owned);
    assert_eq!((code, notice.as_str()), (Some(0), ""));
}

#[test]
fn check_names_every_file_when_a_coefficient_of_the_source_is_changed() {
    let (code, notice) = check_with("changed_source", "coefficients.rs", one_digit_changed);
    assert_eq!(code, Some(1), "{notice}");
    for path in TEXTS {
        assert!(notice.contains(&format!("src/shader/{path} is stale")), "{notice}");
    }
}

#[test]
fn check_names_the_file_whose_text_was_edited() {
    for path in TEXTS {
        let (code, notice) = check_with("edited_text", path, |text| text.replacen(" = ", " =  ", 1));
        assert_eq!(code, Some(1), "{notice}");
        let stale: Vec<_> = notice.lines().collect();
        assert_eq!(stale.len(), 1, "{notice}");
        assert!(stale[0].contains(path), "{notice}");
    }
}

#[test]
fn check_refuses_a_source_outside_the_subset_with_its_place() {
    let (code, notice) = check_with("refused", "sine_integral.rs", |text| {
        format!("{text}\nfn wrong(x: f32) -> f32 {{ x.abs() }}\n")
    });
    assert_eq!(code, Some(2), "{notice}");
    assert!(notice.contains("src/shader/sine_integral.rs:"), "{notice}");
}

#[test]
fn every_public_function_keeps_its_name_and_its_arguments() {
    let translation = library(&root()).unwrap_or_else(|e| panic!("{e}"));
    let public: Vec<_> = translation.symbols.functions.values().filter(|f| f.public).collect();
    assert!(public.len() >= 8, "only {} public functions", public.len());
    let files = outputs(&translation).unwrap_or_else(|e| panic!("{e}"));
    let (module, _) = validate(&files[0].text).unwrap_or_else(|e| panic!("{e}"));
    for function in public {
        let (_, found) = module
            .functions
            .iter()
            .find(|(_, f)| f.name.as_deref() == Some(&function.name))
            .unwrap_or_else(|| panic!("{} is not in the WGSL", function.name));
        assert_eq!(found.arguments.len(), function.arguments.len(), "{}", function.name);
        for (argument, (_, kind)) in found.arguments.iter().zip(&function.arguments) {
            if let TypeInner::Scalar(scalar) = &module.types[argument.ty].inner {
                assert_eq!(
                    scalar.kind == ScalarKind::Float,
                    *kind == Kind::F32,
                    "{}",
                    function.name
                );
            }
        }
        let call = format!(" {}(", function.name);
        for file in &files {
            assert!(
                file.text.contains(&call),
                "{} is renamed in {}",
                function.name,
                file.path
            );
        }
    }
}

/// A compiler of GLSL or HLSL may read a decimal as f64 and then round it to f32.
#[test]
fn every_literal_reads_alike_directly_and_through_f64() {
    let translation = library(&root()).unwrap_or_else(|e| panic!("{e}"));
    let mut seen = 0;
    for file in outputs(&translation).unwrap_or_else(|e| panic!("{e}")) {
        let code: String = file
            .text
            .lines()
            .filter(|l| !l.trim_start().starts_with("//"))
            .collect::<Vec<_>>()
            .join("\n");
        for word in code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '.' || c == '-')) {
            let word = word.trim_start_matches('-').trim_end_matches('f');
            if word.starts_with(|c: char| c.is_ascii_digit())
                && word.contains('.')
                && let (Ok(direct), Ok(wide)) = (word.parse::<f32>(), word.parse::<f64>())
            {
                assert_eq!(direct.to_bits(), (wide as f32).to_bits(), "{word} in {}", file.path);
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "only {seen} literals seen");
}
