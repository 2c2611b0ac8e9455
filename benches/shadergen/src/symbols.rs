//! What the sources define: functions, structs and constants, by name.

use std::collections::BTreeMap;

use crate::kind::Kind;
use crate::refusal::Refusal;

/// A function of the subset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Name, the same in Rust and in every shading language.
    pub name: String,
    /// Whether it is `pub` without restriction.
    pub public: bool,
    /// Names and types of the arguments.
    pub arguments: Vec<(String, Kind)>,
    /// Type of the result.
    pub result: Kind,
    /// First paragraphs of its documentation, a line each.
    pub documentation: Vec<String>,
}

/// All items of the translated files; names are global, as in WGSL.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    /// Functions by name.
    pub functions: BTreeMap<String, Signature>,
    /// Fields of the structs, in order, by name of the struct.
    pub structs: BTreeMap<String, Vec<(String, Kind)>>,
    /// Types of the constants by name.
    pub constants: BTreeMap<String, Kind>,
}

impl Symbols {
    /// Whether an item has this name.
    pub(crate) fn defines(&self, name: &str) -> bool {
        self.functions.contains_key(name) || self.structs.contains_key(name) || self.constants.contains_key(name)
    }

    /// Type named in the source, if it is in the subset.
    pub(crate) fn kind(&self, file: &str, ty: &syn::Type) -> Result<Kind, Refusal> {
        use syn::spanned::Spanned;
        match ty {
            syn::Type::Path(path) if path.qself.is_none() => {
                let Some(ident) = path.path.get_ident() else {
                    return Err(Refusal::at(
                        file,
                        ty.span(),
                        "a type is a single name: use f32, i32, u32, bool or a struct of the subset",
                    ));
                };
                match ident.to_string().as_str() {
                    "f32" => Ok(Kind::F32),
                    "i32" => Ok(Kind::I32),
                    "u32" => Ok(Kind::U32),
                    "bool" => Ok(Kind::Bool),
                    name if self.structs.contains_key(name) => Ok(Kind::Struct(name.to_owned())),
                    name => Err(Refusal::at(
                        file,
                        ty.span(),
                        format!(
                            "type `{name}`: only f32, i32, u32, bool, arrays of them and structs of the subset translate"
                        ),
                    )),
                }
            }
            syn::Type::Array(array) => {
                let element = self.kind(file, &array.elem)?;
                match &array.len {
                    syn::Expr::Lit(syn::ExprLit {
                        lit: syn::Lit::Int(n), ..
                    }) => {
                        let length = n
                            .base10_parse()
                            .map_err(|e| Refusal::at(file, n.span(), e.to_string()))?;
                        Ok(Kind::Array(Box::new(element), length))
                    }
                    other => Err(Refusal::at(file, other.span(), "an array length is a literal")),
                }
            }
            other => Err(Refusal::at(
                file,
                other.span(),
                "this type has no WGSL form: no references, tuples or slices",
            )),
        }
    }
}
