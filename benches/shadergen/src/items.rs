//! Items of a file: what may stand there, under which names, with which attributes.

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{Attribute, FnArg, Item, Pat, ReturnType, Visibility};

use crate::builtins;
use crate::layout::documentation;
use crate::names;
use crate::refusal::Refusal;
use crate::symbols::{Signature, Symbols};

/// Records the items of a file and refuses what cannot be an item of the subset.
pub(crate) fn collect(file: &str, parsed: &syn::File, symbols: &mut Symbols) -> Result<(), Refusal> {
    attributes(file, &parsed.attrs)?;
    for item in &parsed.items {
        let refuse = |reason: &str| Err(Refusal::at(file, item.span(), reason));
        match item {
            Item::Use(import) => check_use(file, import)?,
            Item::Mod(module) if is_test(&module.attrs) => {}
            Item::Const(constant) => {
                attributes(file, &constant.attrs)?;
                let name = fresh(file, &constant.ident, symbols)?;
                let kind = symbols.kind(file, &constant.ty)?;
                symbols.constants.insert(name, kind);
            }
            Item::Struct(record) => {
                attributes(file, &record.attrs)?;
                let name = fresh(file, &record.ident, symbols)?;
                if !record.generics.params.is_empty() {
                    return refuse("a generic struct");
                }
                let syn::Fields::Named(fields) = &record.fields else {
                    return refuse("a struct with unnamed fields: name them");
                };
                let mut list = Vec::new();
                for field in &fields.named {
                    attributes(file, &field.attrs)?;
                    if let Some(ident) = &field.ident {
                        check_name(file, ident)?;
                        list.push((ident.to_string(), symbols.kind(file, &field.ty)?));
                    }
                }
                symbols.structs.insert(name, list);
            }
            Item::Fn(function) => {
                let signature = signature(file, function, symbols)?;
                symbols.functions.insert(signature.name.clone(), signature);
            }
            Item::Mod(_) => {
                return refuse("a module: only `#[cfg(test)] mod tests` may stand in a kernel file");
            }
            Item::Impl(_) => return refuse("an impl block: write free functions"),
            Item::Enum(_) => return refuse("an enum"),
            Item::Trait(_) => return refuse("a trait"),
            Item::Static(_) => return refuse("a static: use const"),
            Item::Macro(_) => return refuse("a macro"),
            Item::Type(_) => return refuse("a type alias: write the type"),
            _ => return refuse("this item is not in the subset"),
        }
    }
    Ok(())
}

fn signature(file: &str, function: &syn::ItemFn, symbols: &Symbols) -> Result<Signature, Refusal> {
    attributes(file, &function.attrs)?;
    let sig = &function.sig;
    let name = fresh(file, &sig.ident, symbols)?;
    let refuse = |span: Span, reason: &str| Err(Refusal::at(file, span, reason));
    if sig.asyncness.is_some() || sig.unsafety.is_some() || sig.abi.is_some() || sig.variadic.is_some() {
        return refuse(sig.span(), "only plain functions: no async, unsafe or extern");
    }
    if !sig.generics.params.is_empty() {
        return refuse(sig.generics.span(), "a generic function");
    }
    let ReturnType::Type(_, result) = &sig.output else {
        return refuse(sig.span(), "a function without a result");
    };
    let mut arguments = Vec::new();
    for input in &sig.inputs {
        let FnArg::Typed(input) = input else {
            return refuse(input.span(), "a method: write a free function");
        };
        match &*input.pat {
            Pat::Ident(ident) if ident.by_ref.is_none() && ident.subpat.is_none() => {
                if ident.mutability.is_some() {
                    return refuse(
                        input.span(),
                        "a `mut` argument: WGSL arguments are constant, copy it with let mut",
                    );
                }
                arguments.push((ident.ident.to_string(), symbols.kind(file, &input.ty)?));
            }
            other => return refuse(other.span(), "a pattern as argument: use one name"),
        }
    }
    Ok(Signature {
        name,
        public: matches!(function.vis, Visibility::Public(_)),
        arguments,
        result: symbols.kind(file, result)?,
        documentation: documentation(&function.attrs),
    })
}

fn check_name(file: &str, ident: &syn::Ident) -> Result<String, Refusal> {
    let name = ident.to_string();
    match names::objection(&name) {
        Some(reason) => Err(Refusal::at(file, ident.span(), reason)),
        None => Ok(name),
    }
}

fn fresh(file: &str, ident: &syn::Ident, symbols: &Symbols) -> Result<String, Refusal> {
    let name = check_name(file, ident)?;
    if builtins::is_builtin(&name) {
        return Err(Refusal::at(
            file,
            ident.span(),
            format!("`{name}` is a built-in of gpu.rs"),
        ));
    }
    if symbols.defines(&name) {
        return Err(Refusal::at(
            file,
            ident.span(),
            format!("`{name}` is defined twice: WGSL has one scope for all files"),
        ));
    }
    Ok(name)
}

fn check_use(file: &str, import: &syn::ItemUse) -> Result<(), Refusal> {
    let refuse = |reason: &str| Err(Refusal::at(file, import.span(), reason));
    let syn::UseTree::Path(first) = &import.tree else {
        return refuse("only `use super::...` and `use crate::shader::...`");
    };
    let inner = match (first.ident.to_string().as_str(), &*first.tree) {
        ("super", tree) => tree,
        ("crate", syn::UseTree::Path(second)) if second.ident == "shader" => &second.tree,
        _ => return refuse("only `use super::...` and `use crate::shader::...`"),
    };
    if renames_or_leaves(inner) {
        return refuse("`use .. as ..` or a second `super`: names stay as they are, inside the shader module");
    }
    Ok(())
}

fn renames_or_leaves(tree: &syn::UseTree) -> bool {
    match tree {
        syn::UseTree::Path(path) => path.ident == "super" || renames_or_leaves(&path.tree),
        syn::UseTree::Group(group) => group.items.iter().any(renames_or_leaves),
        syn::UseTree::Rename(_) => true,
        syn::UseTree::Name(_) | syn::UseTree::Glob(_) => false,
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .parse_args::<syn::Ident>()
                .is_ok_and(|condition| condition == "test")
    })
}

/// Accepts attributes without meaning for a shader and refuses the others.
fn attributes(file: &str, list: &[Attribute]) -> Result<(), Refusal> {
    for attribute in list {
        let path = attribute.path();
        let known = ["doc", "inline", "must_use", "allow", "expect", "derive"]
            .iter()
            .any(|name| path.is_ident(name))
            || path.segments.first().is_some_and(|first| first.ident == "rustfmt");
        if !known {
            return Err(Refusal::at(
                file,
                attribute.span(),
                "this attribute could change the item: only doc, inline, must_use, allow, expect, derive and rustfmt are ignored",
            ));
        }
    }
    if let (Some(line), Some(attribute)) = (documentation(list).iter().find(|line| !line.is_ascii()), list.first()) {
        return Err(Refusal::at(
            file,
            attribute.span(),
            format!("shader comments are ASCII: {line}"),
        ));
    }
    Ok(())
}
