//! GLSL and HLSL includes, written by naga from the WGSL text.

use naga::back::{glsl, hlsl};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::kind::Kind;
use crate::layout::push_comment;
use crate::module::Translation;

/// Name of the entry point that exists only while naga writes.
const ENTRY: &str = "iridescence_entry";

/// Parses and validates WGSL.
pub fn validate(wgsl: &str) -> Result<(naga::Module, ModuleInfo), String> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|e| e.emit_to_string(wgsl))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|e| e.emit_to_string(wgsl))?;
    Ok((module, info))
}

/// Fragment entry point that calls every public function, since naga writes GLSL only for an entry point.
fn with_entry(translation: &Translation) -> String {
    let mut text = translation.wgsl.clone();
    text.push_str(&format!(
        "\n@fragment fn {ENTRY}(@location(0) v: vec4<f32>) -> @location(0) f32 {{\n    var total = v.x;\n"
    ));
    for function in translation.symbols.functions.values().filter(|f| f.public) {
        let arguments: Option<Vec<&str>> = function
            .arguments
            .iter()
            .map(|(_, kind)| match kind {
                Kind::F32 => Some("v.y"),
                Kind::I32 => Some("1i"),
                Kind::U32 => Some("1u"),
                Kind::Bool => Some("(v.y > 0.0)"),
                _ => None,
            })
            .collect();
        let Some(arguments) = arguments else { continue };
        let call = format!("{}({})", function.name, arguments.join(", "));
        text.push_str(&match &function.result {
            Kind::F32 => format!("    total += {call};\n"),
            Kind::I32 | Kind::U32 => format!("    total += f32({call});\n"),
            Kind::Bool => format!("    total += select(0.0, 1.0, {call});\n"),
            _ => format!("    {{ let unused_value = {call}; }}\n"),
        });
    }
    text + "    return total;\n}\n"
}

/// GLSL text of the translation: constants, structs and functions.
pub fn glsl(translation: &Translation) -> Result<String, String> {
    let (module, info) = validate(&with_entry(translation))?;
    let options = glsl::Options {
        version: glsl::Version::Desktop(330),
        writer_flags: glsl::WriterFlags::INCLUDE_UNUSED_ITEMS,
        ..Default::default()
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: naga::ShaderStage::Fragment,
        entry_point: ENTRY.to_owned(),
        multiview: None,
    };
    let mut text = String::new();
    glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, Default::default())
        .and_then(|mut writer| writer.write().map(|_| ()))
        .map_err(|e| e.to_string())?;
    Ok(include_part(&text, translation))
}

/// HLSL text of the translation: constants, structs and functions.
pub fn hlsl(translation: &Translation) -> Result<String, String> {
    let (module, info) = validate(&with_entry(translation))?;
    let options = hlsl::Options {
        force_loop_bounding: false,
        ..Default::default()
    };
    let pipeline = hlsl::PipelineOptions::default();
    let mut text = String::new();
    hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(&module, &info, None)
        .map_err(|e| e.to_string())?;
    Ok(include_part(&text, translation))
}

/// What an include may hold: the top-level items without the version line, the interface and the entry point.
fn include_part(text: &str, translation: &Translation) -> String {
    let mut out = String::new();
    for item in top_level_items(text) {
        let first = item.lines().next().unwrap_or_default();
        let interface = [
            "#",
            "precision ",
            "layout(",
            "in ",
            "out ",
            "void main(",
            "uniform ",
            "smooth ",
            "flat ",
        ];
        let entry = first.contains(ENTRY) || item.lines().take(2).any(|line| line.contains(ENTRY));
        if entry || first.contains("FragmentInput") || interface.iter().any(|word| first.starts_with(word)) {
            continue;
        }
        if !is_constant(first) {
            out.push('\n');
        }
        if let Some(function) = defined(first).and_then(|name| translation.symbols.functions.get(name)) {
            push_comment(&mut out, "", &function.documentation);
        }
        for line in item.lines() {
            // Helpers of naga get our prefix, so that a host shader that naga wrote too may include this text.
            out.push_str(line.replace("naga_", "iridescence_").trim_end());
            out.push('\n');
        }
    }
    out
}

fn is_constant(line: &str) -> bool {
    line.starts_with("const ") || line.starts_with("static const ")
}

/// Name of the function whose definition starts with this line.
fn defined(line: &str) -> Option<&str> {
    let head = line.split_once('(')?.0;
    let mut words = head.split_whitespace();
    match (words.next(), words.next(), words.next()) {
        (Some(_), Some(name), None) => Some(name),
        _ => None,
    }
}

/// Splits text into its top-level items: directives, declarations and blocks.
fn top_level_items(text: &str) -> Vec<String> {
    let mut items = Vec::new();
    let mut current = String::new();
    let mut depth = 0usize;
    for line in text.lines() {
        if current.is_empty() && line.trim().is_empty() {
            continue;
        }
        current.push_str(line);
        current.push('\n');
        depth += line.matches('{').count();
        depth = depth.saturating_sub(line.matches('}').count());
        let trimmed = line.trim_end();
        if depth == 0 && (trimmed.starts_with('#') || trimmed.ends_with(['}', ';'])) {
            items.push(std::mem::take(&mut current));
        }
    }
    if !current.is_empty() {
        items.push(current);
    }
    items
}
