//! Every construct of the subset means the same as Rust, as text and on a device: the fixture of the translator is
//! compiled here and translated.

use gpu_parity::adapter::Adapter;
use gpu_parity::catalogue::{Entry, plain};
use gpu_parity::comparison::compare;
use gpu_parity::inputs;
use gpu_parity::trace::Program;

/// The built-ins that the fixture uses, as `src/shader/gpu.rs` has them.
mod gpu {
    pub fn select(no: f32, yes: f32, condition: bool) -> f32 {
        if condition { yes } else { no }
    }

    pub fn round(x: f32) -> f32 {
        x.round_ties_even()
    }

    pub fn bits_of(x: f32) -> u32 {
        x.to_bits()
    }

    pub fn from_bits(bits: u32) -> f32 {
        f32::from_bits(bits)
    }
}

#[allow(dead_code)]
#[path = "../../../benches/shadergen/tests/fixtures/phase.rs"]
mod phase;

const FIXTURE: &str = include_str!("../../../benches/shadergen/tests/fixtures/phase.rs");

const FUNCTIONS: [Entry; 3] = [
    Entry {
        name: "sine_cosine_turns",
        arguments: 1,
        fields: &["sine", "cosine"],
        call: |x, y| {
            let both = phase::sine_cosine_turns(x[0]);
            y.copy_from_slice(&[both.sine, both.cosine]);
        },
    },
    plain("with_sign", 2, |x, y| y[0] = phase::with_sign(x[0], x[1])),
    plain("series", 2, |x, y| y[0] = phase::series(x[0], x[1])),
];

fn text() -> String {
    shadergen::translate(&[("phase.rs", FIXTURE)])
        .unwrap_or_else(|e| panic!("{e}"))
        .wgsl
}

fn rows(entry: &Entry) -> Vec<f32> {
    inputs::rows(entry.arguments)
        .chunks_exact(entry.arguments)
        .step_by(7)
        .flatten()
        .copied()
        .collect()
}

#[test]
fn the_translation_evaluated_operation_by_operation_gives_the_bits_of_rust() {
    let program = Program::parse(&text()).unwrap_or_else(|e| panic!("{e}"));
    for entry in &FUNCTIONS {
        let rows = rows(entry);
        let width = entry.fields.len().max(1);
        for (row, ours) in rows
            .chunks_exact(entry.arguments)
            .zip(entry.run(&rows).chunks_exact(width))
        {
            let trace = program
                .evaluate(entry.name, row)
                .unwrap_or_else(|e| panic!("{}: {e}", entry.name));
            assert_eq!(trace.results.len(), width);
            for (a, b) in ours.iter().zip(&trace.results) {
                assert!(
                    a.to_bits() == b.value.to_bits() || (a.is_nan() && b.value.is_nan()),
                    "{} of {row:?}: {a:e}, {:e}",
                    entry.name,
                    b.value
                );
            }
        }
    }
}

#[test]
fn the_translation_agrees_with_rust_on_a_device() {
    let Some(adapter) = Adapter::open_or_skip("the constructs of the subset") else {
        return;
    };
    let program = Program::parse(&text()).unwrap_or_else(|e| panic!("{e}"));
    for entry in &FUNCTIONS {
        let rows = rows(entry);
        let device = adapter.run(&text(), &entry.kernel(), &rows);
        let found = compare(&program, entry.name, entry.arguments, &rows, &entry.run(&rows), &device)
            .unwrap_or_else(|e| panic!("{e}"));
        println!("{}", found.line());
        assert!(found.failures.is_empty(), "{}: {:?}", found.name, found.failures[0]);
        assert!(
            found.share() > 0.9,
            "{}: only {} of the rows are bit-equal",
            found.name,
            found.share()
        );
    }
}
