//! Branches and counted loops.

use std::collections::BTreeMap;

use syn::spanned::Spanned;
use syn::{Expr, Pat};

use crate::body::{Body, Tail};
use crate::kind::Kind;
use crate::refusal::Refusal;

impl Body<'_> {
    pub(crate) fn choice(&mut self, choice: &syn::ExprIf, tail: Tail) -> Result<(), Refusal> {
        let condition = self.typed(&choice.cond, &Kind::Bool)?;
        self.line(format!("if {condition} {{"));
        let mut current = choice;
        loop {
            self.scoped(&current.then_branch, tail)?;
            match current.else_branch.as_ref().map(|(_, branch)| &**branch) {
                Some(Expr::If(next)) => {
                    let condition = self.typed(&next.cond, &Kind::Bool)?;
                    self.line(format!("}} else if {condition} {{"));
                    current = next;
                }
                Some(Expr::Block(last)) => {
                    self.line("} else {".into());
                    self.scoped(&last.block, tail)?;
                    break;
                }
                Some(other) => {
                    return Err(self.refuse(other.span(), "this branch is not in the subset"));
                }
                None if tail == Tail::Result => {
                    return Err(self.refuse(current.span(), "`if` as the result needs an else"));
                }
                None => break,
            }
        }
        self.line("}".into());
        Ok(())
    }

    pub(crate) fn for_loop(&mut self, each: &syn::ExprForLoop) -> Result<(), Refusal> {
        if let Some(label) = &each.label {
            return Err(self.refuse(label.span(), "a loop label"));
        }
        let Expr::Range(range) = &*each.expr else {
            return Err(self.refuse(each.expr.span(), "`for` runs over a range such as 0..6u32"));
        };
        let (Some(start), Some(end)) = (&range.start, &range.end) else {
            return Err(self.refuse(range.span(), "the range needs both ends"));
        };
        let Pat::Ident(ident) = &*each.pat else {
            return Err(self.refuse(each.pat.span(), "the loop variable is one name"));
        };
        for bound in [start, end] {
            if !matches!(&**bound, Expr::Lit(_)) {
                return Err(self.refuse(bound.span(), "loop bounds are literals, so that compilers may unroll"));
            }
        }
        let kind = match self.expression(start)?.kind.unify(&self.expression(end)?.kind) {
            Some(kind @ (Kind::I32 | Kind::U32)) => kind,
            _ => {
                return Err(self.refuse(range.span(), "one bound of the range needs the suffix i32 or u32"));
            }
        };
        let (first, last) = (self.typed(start, &kind)?, self.typed(end, &kind)?);
        let sign = if matches!(range.limits, syn::RangeLimits::Closed(_)) {
            "<="
        } else {
            "<"
        };
        self.scopes.push(BTreeMap::new());
        let name = self.declare(ident.span(), &ident.ident.to_string(), kind.clone(), false)?;
        let header = format!("for (var {name}: {kind} = {first}; {name} {sign} {last}; {name}++) {{");
        let depth = self.scopes.len() - 1;
        self.lines.push("    ".repeat(depth) + &header);
        self.block(&each.body, Tail::Nothing)?;
        self.scopes.pop();
        self.line("}".into());
        Ok(())
    }
}
