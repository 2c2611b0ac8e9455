//! The committed WGSL gives the numbers of the Rust f32 functions, on a GPU API and operation by operation.

use std::collections::BTreeSet;

use gpu_parity::adapter::Adapter;
use gpu_parity::catalogue::{CATALOGUE, Entry};
use gpu_parity::comparison::{Comparison, compare_continuous};
use gpu_parity::inputs;
use gpu_parity::trace::Program;
use iridescence::shader::WGSL;
use shadergen::Kind;

/// Every `step`-th row.
fn thinned(rows: &[f32], arguments: usize, step: usize) -> Vec<f32> {
    rows.chunks_exact(arguments).step_by(step).flatten().copied().collect()
}

/// Compares each function on the adapter, with the WGSL text given.
fn measure(adapter: &Adapter, wgsl: &str, step: usize) -> Vec<Comparison> {
    let program = Program::parse(wgsl).unwrap_or_else(|e| panic!("{e}"));
    let one = |entry: &Entry| {
        let rows = thinned(&inputs::rows_for(entry.name, entry.arguments), entry.arguments, step);
        let device = adapter.run(wgsl, &entry.kernel(), &rows);
        compare_continuous(
            &program,
            entry.name,
            entry.arguments,
            &rows,
            &entry.run(&rows),
            &device,
            entry.continuous(),
        )
        .unwrap_or_else(|e| panic!("{e}"))
    };
    CATALOGUE.iter().map(one).collect()
}

/// What is wrong with a comparison: a row beyond the bound of WGSL, or, on a software adapter, any difference of a
/// function that neither divides nor takes roots.
fn faults(found: &[Comparison], software: bool) -> Vec<String> {
    let mut faults = Vec::new();
    for one in found {
        if let Some((row, ours, theirs, bound)) = one.failures.first() {
            faults.push(format!(
                "{}: {} rows beyond WGSL's table, first {row:?}: Rust {ours:e}, device {theirs:e}, allowed {bound:e}",
                one.name,
                one.failures.len()
            ));
        }
        if software && !one.divides && one.bit_equal + one.outside < one.rows {
            faults.push(format!(
                "{}: {} of {} rows bit-equal without a division",
                one.name, one.bit_equal, one.rows
            ));
        }
        if one.outside + one.undecided > one.rows / 20 {
            faults.push(format!(
                "{}: {} rows differ outside the guarantee: too many to say anything",
                one.name,
                one.outside + one.undecided
            ));
        }
    }
    faults
}

#[test]
fn the_catalogue_is_the_list_of_public_functions() {
    let translation = shadergen::library(&shadergen::root()).unwrap_or_else(|e| panic!("{e}"));
    let public: BTreeSet<(&str, usize)> = translation
        .symbols
        .functions
        .values()
        .filter(|f| f.public && f.arguments.iter().all(|(_, kind)| *kind == Kind::F32))
        .map(|f| (f.name.as_str(), f.arguments.len()))
        .collect();
    let listed: BTreeSet<(&str, usize)> = CATALOGUE.iter().map(|entry| (entry.name, entry.arguments)).collect();
    assert_eq!(listed, public);
}

/// No adapter is needed for this: the text itself, evaluated with correctly rounded operations.
#[test]
fn the_text_evaluated_operation_by_operation_gives_the_bits_of_rust() {
    let program = Program::parse(WGSL).unwrap_or_else(|e| panic!("{e}"));
    for entry in CATALOGUE {
        let rows = thinned(&inputs::rows_for(entry.name, entry.arguments), entry.arguments, 37);
        for (row, ours) in rows
            .chunks_exact(entry.arguments)
            .zip(entry.run(&rows).chunks_exact(entry.fields.len().max(1)))
        {
            let trace = program
                .evaluate(entry.name, row)
                .unwrap_or_else(|e| panic!("{}: {e}", entry.name));
            for (expected, found) in ours.iter().zip(&trace.results) {
                assert!(
                    expected.to_bits() == found.value.to_bits() || (expected.is_nan() && found.value.is_nan()),
                    "{} of {row:?}: Rust {expected:e}, text {:e}",
                    entry.name,
                    found.value
                );
            }
        }
    }
}

#[test]
fn the_device_agrees_with_rust_within_the_table_of_wgsl() {
    let Some(adapter) = Adapter::open_or_skip("the WGSL text against the Rust f32 functions") else {
        return;
    };
    println!("device: {}", adapter.description());
    println!("{}", Comparison::head());
    let found = measure(&adapter, WGSL, 1);
    for one in &found {
        println!("{}", one.line());
    }
    if let Ok(path) = std::env::var("PARITY_CSV") {
        let rows: Vec<String> = found.iter().map(|one| one.csv(&adapter.description())).collect();
        let text = format!("{}\n{}\n", Comparison::CSV_HEAD, rows.join("\n"));
        print!("{text}");
        std::fs::write(&path, text).unwrap_or_else(|e| panic!("{path}: {e}"));
    }
    let faults = faults(&found, adapter.is_software());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The text with one digit of its `n`-th long float literal changed, or None when there are fewer.
fn changed(wgsl: &str, n: usize) -> Option<String> {
    let mut seen = 0;
    let mut start = None;
    for (i, c) in wgsl.char_indices().chain([(wgsl.len(), ' ')]) {
        if c.is_ascii_digit() || c == '.' {
            start.get_or_insert(i);
            continue;
        }
        let literal = start.take().map(|s| (s, &wgsl[s..i]));
        if let Some((s, digits)) = literal
            && digits.contains('.')
            && digits.len() > 6
            && matches!(c, 'f' | 'e')
        {
            if seen == n {
                // The second digit that counts, or the only one, up or down by one.
                let first = digits.find(|c: char| ('1'..='9').contains(&c))?;
                let second = digits[first + 1..].find(|c: char| c.is_ascii_digit());
                let place = s + second.map_or(first, |second| first + 1 + second);
                let digit = wgsl.as_bytes()[place];
                let mut text = wgsl.to_owned();
                let other = if digit == b'9' { b'8' } else { digit + 1 };
                text.replace_range(place..=place, &(other as char).to_string());
                return Some(text);
            }
            seen += 1;
        }
    }
    None
}

#[test]
fn a_changed_coefficient_is_seen_on_the_device() {
    let Some(adapter) = Adapter::open_or_skip("a changed coefficient is seen") else {
        return;
    };
    let text = changed(WGSL, 0).expect("the text has a coefficient");
    // The comparison judges by the bounds of the committed text, on what the changed text gives.
    let committed = Program::parse(WGSL).unwrap_or_else(|e| panic!("{e}"));
    let mut failures = 0;
    for entry in CATALOGUE {
        let rows = thinned(&inputs::rows_for(entry.name, entry.arguments), entry.arguments, 16);
        let device = adapter.run(&text, &entry.kernel(), &rows);
        let found = compare_continuous(
            &committed,
            entry.name,
            entry.arguments,
            &rows,
            &entry.run(&rows),
            &device,
            entry.continuous(),
        )
        .unwrap_or_else(|e| panic!("{e}"));
        failures += faults(&[found], adapter.is_software()).len();
    }
    assert!(failures > 0, "a changed coefficient went unseen");
}

/// Whether the `n`-th long float literal is a limit, whose place is free by design.
fn is_limit(wgsl: &str, n: usize) -> bool {
    let changed = changed(wgsl, n).unwrap_or_default();
    wgsl.lines()
        .zip(changed.lines())
        .any(|(a, b)| a != b && a.contains("_LIMIT: f32"))
}

/// Whether a text gives other bits than Rust on every `step`-th row of some function.
fn differs(program: &Program, step: usize) -> bool {
    CATALOGUE.iter().any(|entry| {
        // Few rows of a light over the whole band, and not all of them meet it.
        let step = if entry.continuous().is_some() {
            step.div_ceil(50)
        } else {
            step
        };
        let rows = thinned(&inputs::rows_for(entry.name, entry.arguments), entry.arguments, step);
        rows.chunks_exact(entry.arguments)
            .zip(entry.run(&rows).chunks_exact(entry.fields.len().max(1)))
            .any(|(row, ours)| {
                let trace = program.evaluate(entry.name, row).unwrap_or_else(|e| panic!("{e}"));
                ours.iter()
                    .zip(&trace.results)
                    .any(|(a, b)| !a.is_nan() && a.to_bits() != b.value.to_bits())
            })
    })
}

/// So the comparison of bits above sees each of them.
#[test]
fn every_changed_coefficient_changes_the_text_evaluated() {
    let mut unseen = Vec::new();
    let mut tried = 0;
    while let Some(text) = changed(WGSL, tried) {
        let program = Program::parse(&text).unwrap_or_else(|e| panic!("{e}"));
        let seen = is_limit(WGSL, tried) || differs(&program, 701) || differs(&program, 37);
        if !seen {
            unseen.push(tried);
        }
        tried += 1;
    }
    assert!(tried > 20, "only {tried} coefficients found");
    assert!(unseen.is_empty(), "changed and unseen: literals {unseen:?} of {tried}");
}
