//! Expressions: one Rust expression to one WGSL expression with the same tree of operations.

use syn::spanned::Spanned;
use syn::{Expr, Lit, UnOp};

use crate::body::Body;
use crate::kind::Kind;
use crate::operators::{Class, grouped, is_literal, operator};
use crate::refusal::Refusal;
use crate::{builtins, literal};

/// WGSL text of an expression and its type.
pub(crate) struct Value {
    pub(crate) text: String,
    pub(crate) kind: Kind,
}

impl Body<'_> {
    /// Translates an expression.
    pub(crate) fn expression(&self, expression: &Expr) -> Result<Value, Refusal> {
        match expression {
            Expr::Lit(lit) => self.literal(&lit.lit),
            Expr::Paren(inner) => {
                let value = self.expression(&inner.expr)?;
                Ok(Value {
                    text: format!("({})", value.text),
                    kind: value.kind,
                })
            }
            Expr::Path(path) => self.name(path),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Cast(cast) => self.cast(cast),
            Expr::Call(call) => self.call(call),
            Expr::Struct(record) => self.record(record),
            Expr::Field(field) => self.field(field),
            Expr::Index(index) => self.index(index),
            Expr::Array(array) => self.array(array),
            Expr::MethodCall(call) => Err(self.refuse(
                call.method.span(),
                format!(
                    "method call `.{}()`: call the free function of gpu.rs or of a kernel file",
                    call.method
                ),
            )),
            Expr::If(inner) => Err(self.refuse(
                inner.span(),
                "`if` as a value inside an expression: use select, or a statement",
            )),
            Expr::Match(inner) => Err(self.refuse(inner.span(), "`match`: use if, else if and else")),
            Expr::Block(inner) => Err(self.refuse(inner.span(), "a block as a value: name its parts with let")),
            Expr::Tuple(inner) => Err(self.refuse(inner.span(), "a tuple: use a struct with public fields")),
            Expr::Macro(inner) => Err(self.refuse(inner.span(), "a macro")),
            Expr::Closure(inner) => Err(self.refuse(inner.span(), "a closure")),
            Expr::Reference(inner) => Err(self.refuse(inner.span(), "a reference")),
            other => Err(self.refuse(other.span(), "this kind of expression is not in the subset")),
        }
    }

    /// Translates an expression and checks its type.
    pub(crate) fn typed(&self, expression: &Expr, kind: &Kind) -> Result<String, Refusal> {
        let value = self.expression(expression)?;
        if value.kind.unify(kind).as_ref() != Some(kind) {
            return Err(self.refuse(
                expression.span(),
                format!("this is {}, but {kind} is expected", value.kind),
            ));
        }
        Ok(value.text)
    }

    fn literal(&self, lit: &Lit) -> Result<Value, Refusal> {
        let refused = |reason| self.refuse(lit.span(), reason);
        match lit {
            Lit::Float(x) => {
                let text = literal::float(x.base10_digits(), x.suffix()).map_err(refused)?;
                Ok(Value { text, kind: Kind::F32 })
            }
            Lit::Int(n) => {
                let (text, kind) = literal::integer(&n.to_string(), n.base10_digits(), n.suffix()).map_err(refused)?;
                Ok(Value { text, kind })
            }
            Lit::Bool(b) => Ok(Value {
                text: b.value.to_string(),
                kind: Kind::Bool,
            }),
            _ => Err(self.refuse(lit.span(), "only numbers and booleans are in the subset")),
        }
    }

    fn name(&self, path: &syn::ExprPath) -> Result<Value, Refusal> {
        let Some(ident) = path.path.get_ident() else {
            return Err(self.refuse(path.span(), "a path with `::`: import the item with `use` and write its name; associated constants and core::f32::consts are not in the subset"));
        };
        let name = ident.to_string();
        if let Some(local) = self.lookup(&name) {
            return Ok(Value {
                text: local.text.clone(),
                kind: local.kind.clone(),
            });
        }
        match self.symbols.constants.get(&name) {
            Some(kind) => Ok(Value {
                text: name,
                kind: kind.clone(),
            }),
            None => Err(self.refuse(path.span(), format!("`{name}` is not defined in the translated files"))),
        }
    }

    fn unary(&self, unary: &syn::ExprUnary) -> Result<Value, Refusal> {
        let value = self.expression(&unary.expr)?;
        let operand = match *unary.expr {
            Expr::Unary(_) => format!("({})", value.text),
            _ => value.text,
        };
        let sign = match (&unary.op, &value.kind) {
            (UnOp::Neg(_), Kind::F32 | Kind::I32 | Kind::Whole) => "-",
            (UnOp::Not(_), Kind::Bool) => "!",
            (UnOp::Not(_), Kind::I32 | Kind::U32) => "~",
            _ => return Err(self.refuse(unary.span(), format!("this operator on {}", value.kind))),
        };
        Ok(Value {
            text: format!("{sign}{operand}"),
            kind: value.kind,
        })
    }

    fn binary(&self, binary: &syn::ExprBinary) -> Result<Value, Refusal> {
        let Some((sign, class)) = operator(&binary.op) else {
            return Err(self.refuse(binary.span(), "an assignment as a value"));
        };
        if is_literal(&binary.left) && is_literal(&binary.right) {
            return Err(self.refuse(binary.span(), "an operation between two literals is not evaluated in f32 everywhere: write its result, or name a constant"));
        }
        let left = self.expression(&binary.left)?;
        let right = self.expression(&binary.right)?;
        let shift = matches!(sign, "<<" | ">>");
        let kind = if shift && left.kind.is_integer() && right.kind.is_integer() {
            Some(left.kind.clone())
        } else {
            left.kind.unify(&right.kind)
        };
        let Some(kind) = kind else {
            return Err(self.refuse(
                binary.span(),
                format!("operands of different types: {} {sign} {}", left.kind, right.kind),
            ));
        };
        let allowed = match class {
            Class::Arithmetic if sign == "%" => kind.is_integer(),
            Class::Arithmetic => kind.is_integer() || kind == Kind::F32,
            Class::Bits => kind.is_integer() || (kind == Kind::Bool && !shift && sign != "^"),
            Class::Relation => !matches!(kind, Kind::Struct(_) | Kind::Array(..)),
            Class::And | Class::Or => kind == Kind::Bool,
        };
        if !allowed {
            return Err(self.refuse(binary.span(), format!("`{sign}` on {kind} is not in the subset")));
        }
        let left_text = grouped(&binary.left, left.text, class);
        let mut right_text = grouped(&binary.right, right.text, class);
        if shift && right.kind == Kind::I32 {
            right_text = format!("u32({right_text})");
        }
        let kind = if class == Class::Relation { Kind::Bool } else { kind };
        Ok(Value {
            text: format!("{left_text} {sign} {right_text}"),
            kind,
        })
    }

    fn cast(&self, cast: &syn::ExprCast) -> Result<Value, Refusal> {
        let kind = self.symbols.kind(self.file, &cast.ty)?;
        let value = self.expression(&cast.expr)?;
        if !matches!(kind, Kind::F32 | Kind::I32 | Kind::U32) || matches!(value.kind, Kind::Struct(_) | Kind::Array(..))
        {
            return Err(self.refuse(cast.span(), format!("`as` from {} to {kind}", value.kind)));
        }
        Ok(Value {
            text: format!("{kind}({})", value.text),
            kind,
        })
    }

    fn call(&self, call: &syn::ExprCall) -> Result<Value, Refusal> {
        let name = match &*call.func {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        let Some(name) = name else {
            return Err(self.refuse(
                call.func.span(),
                "only functions called by their plain name: import them with `use`",
            ));
        };
        let arguments = call
            .args
            .iter()
            .map(|a| self.expression(a))
            .collect::<Result<Vec<_>, _>>()?;
        let kinds: Vec<Kind> = arguments.iter().map(|a| a.kind.clone()).collect();
        let (target, kind) = if let Some(signature) = self.symbols.functions.get(&name) {
            let fits = signature.arguments.len() == kinds.len()
                && signature
                    .arguments
                    .iter()
                    .zip(&kinds)
                    .all(|((_, want), have)| have.unify(want).as_ref() == Some(want));
            if !fits {
                return Err(self.refuse(call.span(), format!("the arguments do not fit `{name}`")));
            }
            (name.as_str(), signature.result.clone())
        } else {
            match builtins::call(&name, &kinds) {
                Some(found) => found.map_err(|reason| self.refuse(call.span(), reason))?,
                None => {
                    return Err(self.refuse(
                        call.span(),
                        format!("`{name}` is neither a function of the translated files nor a built-in of gpu.rs"),
                    ));
                }
            }
        };
        let list: Vec<String> = arguments.into_iter().map(|a| a.text).collect();
        Ok(Value {
            text: format!("{target}({})", list.join(", ")),
            kind,
        })
    }
}
