//! What each construct of the subset becomes, and that WGSL, GLSL and HLSL accept it.

use shadergen::{Translation, glsl, hlsl, translate, validate};

const PHASE: &str = include_str!("fixtures/phase.rs");

fn fixture() -> Translation {
    translate(&[("fixtures/phase.rs", PHASE)]).expect("the fixture is in the subset")
}

/// Reads an include back with naga's own GLSL parser and validates it.
fn reread(include: &str) {
    let text = format!("#version 450\n{include}\nvoid main() {}\n", "{}");
    let options = naga::front::glsl::Options::from(naga::ShaderStage::Fragment);
    let module = naga::front::glsl::Frontend::default()
        .parse(&options, &text)
        .unwrap_or_else(|e| panic!("{}", e.emit_to_string(&text)));
    naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|e| panic!("{}", e.emit_to_string(&text)));
}

#[test]
fn the_glsl_include_is_valid_without_an_entry_point() {
    reread(&glsl(&fixture()).expect("GLSL"));
}

/// Text of the only function in `source`, without comments.
fn wgsl(source: &str) -> String {
    let translation = translate(&[("a.rs", source)]).unwrap_or_else(|e| panic!("{e}"));
    validate(&translation.wgsl).unwrap_or_else(|e| panic!("{e}\n{}", translation.wgsl));
    let lines = translation
        .wgsl
        .lines()
        .map(str::trim)
        .filter(|l| !l.is_empty() && !l.starts_with("//"));
    lines.collect::<Vec<_>>().join(" ")
}

fn body(arguments: &str, statements: &str) -> String {
    let text = wgsl(&format!("fn f({arguments}) -> f32 {{ {statements} }}"));
    let start = text.find('{').expect("a body") + 1;
    text[start..text.len() - 1].trim().to_owned()
}

#[test]
fn the_fixture_translates_and_validates_in_all_languages() {
    let translation = fixture();
    validate(&translation.wgsl).unwrap_or_else(|e| panic!("{e}\n{}", translation.wgsl));
    for text in [glsl(&translation).expect("GLSL"), hlsl(&translation).expect("HLSL")] {
        for name in [
            "sine_cosine_turns(",
            "with_sign(",
            "series(",
            "struct SineCosine",
            " TURN",
        ] {
            assert!(text.contains(name), "{name} is missing or renamed in\n{text}");
        }
        for gone in [
            "#version",
            "main",
            "iridescence_entry",
            "layout(",
            "precision",
            "FragmentInput",
            "unused_value",
        ] {
            assert!(!text.contains(gone), "{gone} is left in\n{text}");
        }
    }
}

#[test]
fn a_shadowed_let_gets_a_letter_and_its_own_initialiser_sees_the_old_one() {
    assert_eq!(
        body("t: f32", "let t = t * t; let t = t - 1.0; t"),
        "let t_b = t * t; let t_c = t_b - 1.0f; return t_c;"
    );
}

#[test]
fn an_inner_name_ends_with_its_block() {
    assert_eq!(
        body("t: f32", "let mut u = t; if t > 1.0 { let t = t * 2.0; u = t; } u * t"),
        "var u = t; if t > 1.0f { let t_b = t * 2.0f; u = t_b; } return u * t;"
    );
}

#[test]
fn parentheses_and_the_order_of_operations_stay() {
    assert_eq!(
        body("a: f32, b: f32", "(a + b) - (a - (b - a))"),
        "return (a + b) - (a - (b - a));"
    );
    assert_eq!(body("a: f32, b: f32", "a - -b * -(-a)"), "return a - -b * -(-a);");
    assert_eq!(body("a: f32, b: f32", "a / b * a"), "return a / b * a;");
}

#[test]
fn mixtures_that_wgsl_forbids_get_parentheses() {
    assert_eq!(
        body("a: u32, b: u32", "let c = a & b + 1u32 | b << 3; c as f32"),
        "let c = (a & (b + 1u)) | (b << 3); return f32(c);"
    );
    assert_eq!(
        body("a: f32, b: f32", "if a < b && b < 1.0 || a > 2.0 { a } else { b }"),
        "if (a < b && b < 1.0f) || a > 2.0f { return a; } else { return b; }"
    );
}

#[test]
fn built_ins_keep_the_order_of_their_arguments() {
    assert_eq!(
        body("x: f32", "select(x, -x, x < 0.0)"),
        "return select(x, -x, x < 0.0f);"
    );
    assert_eq!(
        body("x: f32", "from_bits(bits_of(x) & 0x7fff_ffff)"),
        "return bitcast<f32>(bitcast<u32>(x) & 0x7fffffff);"
    );
    assert_eq!(
        body("x: f32", "clamp(floor(x), 0.0, max(x, 1.0))"),
        "return clamp(floor(x), 0.0f, max(x, 1.0f));"
    );
}

#[test]
fn casts_shifts_and_negation_of_bits_follow_the_type() {
    assert_eq!(
        body("x: f32", "let n = x as i32; let m = !(n >> n) as u32; m as f32"),
        "let n = i32(x); let m = u32(~(n >> u32(n))); return f32(m);"
    );
}

#[test]
fn structs_are_built_in_the_order_of_their_fields() {
    let source = "pub struct Pair { pub a: f32, pub b: f32 } pub fn f(x: f32) -> Pair { Pair { b: x, a: 1.0 } }";
    assert_eq!(
        wgsl(source),
        "struct Pair { a: f32, b: f32, } fn f(x: f32) -> Pair { return Pair(1.0f, x); }"
    );
}

#[test]
fn loops_returns_and_late_initialisers_are_kept() {
    assert_eq!(
        body(
            "x: f32",
            "let mut s = 0.0; for i in 0..6u32 { if i == 3u32 { continue; } s += x; } if s > 1.0 { return 1.0; } let y: f32; y = s; y"
        ),
        "var s = 0.0f; for (var i: u32 = 0; i < 6u; i++) { if i == 3u { continue; } s += x; } \
         if s > 1.0f { return 1.0f; } var y: f32; y = s; return y;"
    );
}

#[test]
fn comments_and_sources_reach_the_text() {
    let text = fixture().wgsl;
    assert!(
        text.contains(
            "// ---- phase ----\n// Sine and cosine of an angle in turns, for the tests of the translator.\n"
        )
    );
    assert!(text.contains("// Sources named: DLMF 4.19.1.\n"));
    assert!(text.contains("// Sine and cosine of `turns` full turns.\nfn sine_cosine_turns("));
    assert!(!text.contains("Second paragraph"));
    assert!(!text.contains("the_sign_is_taken_over"));
}

#[test]
fn a_comment_shared_by_constants_in_a_row_is_written_once() {
    let source = "/// Fit.\nconst A: f32 = 1.0;\n/// Fit.\nconst B: f32 = 2.0;\n/// Border.\nconst C: f32 = 3.0;\n/// Fit.\nconst D: f32 = 4.0;\n";
    let text = translate(&[("a.rs", source)]).expect("in the subset").wgsl;
    assert!(text.ends_with("// Fit.\nconst A: f32 = 1.0f;\nconst B: f32 = 2.0f;\n// Border.\nconst C: f32 = 3.0f;\n// Fit.\nconst D: f32 = 4.0f;\n"), "{text}");
}

#[test]
fn every_literal_keeps_the_bits_that_rustc_gives_it() {
    // Spread over the exponents, in the shortest form and with too many digits.
    for step in 0..400u32 {
        let bits = 0x0080_0000 + step * 5_325_117 % 0x7e00_0000;
        let value = f32::from_bits(bits);
        for digits in [
            format!("{value:e}"),
            format!("{:.25e}", f64::from(value) * (1.0 + 5e-8)),
        ] {
            let digits = if digits.contains('.') {
                digits
            } else {
                digits.replace('e', ".0e")
            };
            let expected = digits.parse::<f32>().expect("a float");
            let source = format!("pub const C: f32 = {digits};");
            let translation = translate(&[("a.rs", &source)]).unwrap_or_else(|e| panic!("{e}"));
            let (module, _) = validate(&translation.wgsl).expect("WGSL");
            let (_, constant) = module.constants.iter().next().expect("a constant");
            match module.global_expressions[constant.init] {
                naga::Expression::Literal(naga::Literal::F32(found)) => {
                    assert_eq!(found.to_bits(), expected.to_bits(), "{digits}");
                }
                ref other => panic!("{other:?}"),
            }
        }
    }
}

#[test]
fn the_text_is_the_same_every_time() {
    assert_eq!(fixture().wgsl, fixture().wgsl);
    assert_eq!(glsl(&fixture()), glsl(&fixture()));
    assert_eq!(hlsl(&fixture()), hlsl(&fixture()));
}
