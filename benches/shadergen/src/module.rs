//! Whole files: items, their order, and the WGSL text.

use syn::spanned::Spanned;
use syn::{Expr, Item, Lit};

use crate::body::Body;
use crate::items::collect;
use crate::layout::{citations, documentation, push_comment, push_wrapped};
use crate::refusal::Refusal;
use crate::symbols::Symbols;

/// WGSL text and what it defines.
#[derive(Clone, Debug)]
pub struct Translation {
    /// Constants, structs and functions, without a file banner.
    pub wgsl: String,
    /// The items by name.
    pub symbols: Symbols,
}

/// A source file: the name used in refusals and banners, and its text.
pub type Source<'a> = (&'a str, &'a str);

/// Translates the files, in the order given, to one WGSL text.
///
/// The first construct outside the subset is refused with its place.
pub fn translate(sources: &[Source]) -> Result<Translation, Refusal> {
    let mut symbols = Symbols::default();
    let mut files = Vec::new();
    for (file, text) in sources {
        let parsed = syn::parse_file(text).map_err(|e| Refusal::at(file, e.span(), e.to_string()))?;
        collect(file, &parsed, &mut symbols)?;
        files.push((*file, parsed));
    }
    let mut wgsl = String::new();
    for ((file, parsed), (_, text)) in files.iter().zip(sources) {
        let stem = file.rsplit('/').next().unwrap_or(file).trim_end_matches(".rs");
        let summary = documentation(&parsed.attrs);
        let paragraph: Vec<String> = summary.into_iter().take_while(|line| !line.is_empty()).collect();
        wgsl.push_str(&format!("\n// ---- {stem} ----\n"));
        push_comment(&mut wgsl, "", &paragraph);
        let named = citations(text);
        if !named.is_empty() {
            push_comment(&mut wgsl, "", &[format!("Sources named: {}.", named.join(", "))]);
        }
        wgsl.push('\n');
        let mut said = Vec::new();
        for item in &parsed.items {
            emit(file, item, &symbols, &mut said, &mut wgsl)?;
        }
    }
    Ok(Translation { wgsl, symbols })
}

/// Appends the text of an item; `said` is the comment of the constant before, which is not repeated.
fn emit(file: &str, item: &Item, symbols: &Symbols, said: &mut Vec<String>, out: &mut String) -> Result<(), Refusal> {
    match item {
        Item::Const(constant) => {
            let name = constant.ident.to_string();
            let kind = &symbols.constants[&name];
            let body = Body::new(file, symbols, kind.clone());
            if !is_constant(&constant.expr) {
                return Err(Refusal::at(
                    file,
                    constant.expr.span(),
                    "a constant is a literal, a negated literal or an array of them",
                ));
            }
            let value = body.typed(&constant.expr, kind)?;
            let comment = documentation(&constant.attrs);
            if *said != comment {
                push_comment(out, "", &comment);
            }
            *said = comment;
            push_wrapped(out, &format!("const {name}: {kind} = {value};"));
        }
        Item::Struct(record) => {
            let name = record.ident.to_string();
            out.push('\n');
            push_comment(out, "", &documentation(&record.attrs));
            out.push_str(&format!("struct {name} {{\n"));
            for (field, (member, kind)) in record.fields.iter().zip(&symbols.structs[&name]) {
                push_comment(out, "    ", &documentation(&field.attrs));
                out.push_str(&format!("    {member}: {kind},\n"));
            }
            out.push_str("}\n");
        }
        Item::Fn(function) => {
            let signature = &symbols.functions[&function.sig.ident.to_string()];
            let mut body = Body::new(file, symbols, signature.result.clone());
            for (input, (name, kind)) in function.sig.inputs.iter().zip(&signature.arguments) {
                body.argument(input.span(), name, kind.clone())?;
            }
            let lines = body.translate(&function.block)?;
            let arguments: Vec<String> = signature.arguments.iter().map(|(n, k)| format!("{n}: {k}")).collect();
            out.push('\n');
            push_comment(out, "", &signature.documentation);
            push_wrapped(
                out,
                &format!(
                    "fn {}({}) -> {} {{",
                    signature.name,
                    arguments.join(", "),
                    signature.result
                ),
            );
            for line in lines {
                push_wrapped(out, &line);
            }
            out.push_str("}\n");
        }
        _ => {}
    }
    Ok(())
}

fn is_constant(value: &Expr) -> bool {
    match value {
        Expr::Lit(lit) => matches!(lit.lit, Lit::Float(_) | Lit::Int(_) | Lit::Bool(_)),
        Expr::Unary(unary) => matches!(unary.op, syn::UnOp::Neg(_)) && matches!(*unary.expr, Expr::Lit(_)),
        Expr::Array(array) => array.elems.iter().all(is_constant),
        _ => false,
    }
}
