//! Function bodies: statements, local names and the value of the last expression.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{Block, Expr, Pat, Stmt};

use crate::kind::Kind;
use crate::names;
use crate::operators::compound;
use crate::refusal::Refusal;
use crate::symbols::Symbols;

/// A local name in WGSL and its type.
#[derive(Clone)]
pub(crate) struct Local {
    pub(crate) text: String,
    pub(crate) kind: Kind,
    mutable: bool,
}

/// A function body on its way to WGSL.
pub(crate) struct Body<'a> {
    pub(crate) file: &'a str,
    pub(crate) symbols: &'a Symbols,
    result: Kind,
    pub(crate) scopes: Vec<BTreeMap<String, Local>>,
    used: BTreeSet<String>,
    pub(crate) lines: Vec<String>,
}

/// What the last expression of a block is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tail {
    /// The result of the function.
    Result,
    /// Nothing: the block is a statement.
    Nothing,
}

impl<'a> Body<'a> {
    /// Empty body of a function with the given result; constants are translated with an empty body too.
    pub(crate) fn new(file: &'a str, symbols: &'a Symbols, result: Kind) -> Self {
        Body {
            file,
            symbols,
            result,
            scopes: vec![BTreeMap::new()],
            used: BTreeSet::new(),
            lines: Vec::new(),
        }
    }

    /// Declares an argument.
    pub(crate) fn argument(&mut self, span: Span, name: &str, kind: Kind) -> Result<(), Refusal> {
        self.declare(span, name, kind, false).map(|_| ())
    }

    /// Lines of the body, indented.
    pub(crate) fn translate(mut self, block: &Block) -> Result<Vec<String>, Refusal> {
        self.block(block, Tail::Result)?;
        Ok(self.lines)
    }

    /// Refusal at `span` in this file.
    pub(crate) fn refuse(&self, span: Span, reason: impl Into<String>) -> Refusal {
        Refusal::at(self.file, span, reason)
    }

    /// The innermost local of this name.
    pub(crate) fn lookup(&self, name: &str) -> Option<&Local> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name))
    }

    pub(crate) fn line(&mut self, text: String) {
        self.lines.push("    ".repeat(self.scopes.len()) + &text);
    }

    /// WGSL name of a new local: its own, or with a letter behind it where the function has it already.
    pub(crate) fn declare(&mut self, span: Span, name: &str, kind: Kind, mutable: bool) -> Result<String, Refusal> {
        if let Some(reason) = names::objection(name) {
            return Err(self.refuse(span, reason));
        }
        if self.symbols.defines(name) {
            return Err(self.refuse(
                span,
                format!("`{name}` is also an item of the translated files: naga would rename one of them"),
            ));
        }
        let text = std::iter::once(name.to_owned())
            .chain(('b'..='z').map(|letter| format!("{name}_{letter}")))
            .find(|text| !self.used.contains(text) && !self.symbols.defines(text))
            .ok_or_else(|| self.refuse(span, format!("`{name}` is declared too often")))?;
        self.used.insert(text.clone());
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(
                name.to_owned(),
                Local {
                    text: text.clone(),
                    kind,
                    mutable,
                },
            );
        }
        Ok(text)
    }

    pub(crate) fn block(&mut self, block: &Block, tail: Tail) -> Result<(), Refusal> {
        let last = block.stmts.len().wrapping_sub(1);
        if tail == Tail::Result && !matches!(block.stmts.last(), Some(Stmt::Expr(..))) {
            return Err(self.refuse(block.span(), "the block ends without a value"));
        }
        for (i, statement) in block.stmts.iter().enumerate() {
            match statement {
                Stmt::Local(local) => self.local(local)?,
                Stmt::Expr(expression, semicolon) => {
                    if i == last && tail == Tail::Result && semicolon.is_none() {
                        self.tail(expression)?;
                    } else {
                        self.statement(expression)?;
                    }
                }
                Stmt::Item(item) => {
                    return Err(self.refuse(item.span(), "an item inside a function: move it to the file"));
                }
                Stmt::Macro(call) => return Err(self.refuse(call.span(), "a macro")),
            }
        }
        Ok(())
    }

    pub(crate) fn scoped(&mut self, block: &Block, tail: Tail) -> Result<(), Refusal> {
        self.scopes.push(BTreeMap::new());
        let done = self.block(block, tail);
        self.scopes.pop();
        done
    }

    fn local(&mut self, local: &syn::Local) -> Result<(), Refusal> {
        let (pattern, annotation) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(self.symbols.kind(self.file, &typed.ty)?)),
            other => (other, None),
        };
        let Pat::Ident(ident) = pattern else {
            return Err(self.refuse(local.pat.span(), "a pattern in let: bind one name"));
        };
        if ident.by_ref.is_some() || ident.subpat.is_some() {
            return Err(self.refuse(local.pat.span(), "a pattern in let: bind one name"));
        }
        let name = ident.ident.to_string();
        let mutable = ident.mutability.is_some();
        let Some(init) = &local.init else {
            let Some(kind) = annotation else {
                return Err(self.refuse(local.span(), "a declaration without a value needs its type"));
            };
            let text = self.declare(ident.span(), &name, kind.clone(), true)?;
            self.line(format!("var {text}: {kind};"));
            return Ok(());
        };
        if let Some((_, diverge)) = &init.diverge {
            return Err(self.refuse(diverge.span(), "let-else"));
        }
        let (value, kind) = match &annotation {
            Some(kind) => (self.typed(&init.expr, kind)?, kind.clone()),
            None => {
                let value = self.expression(&init.expr)?;
                if value.kind == Kind::Whole {
                    return Err(self.refuse(
                        init.expr.span(),
                        "an integer without a type: add a suffix or an annotation",
                    ));
                }
                (value.text, value.kind)
            }
        };
        let text = self.declare(ident.span(), &name, kind.clone(), mutable)?;
        let word = if mutable { "var" } else { "let" };
        let annotation = annotation.map(|kind| format!(": {kind}")).unwrap_or_default();
        self.line(format!("{word} {text}{annotation} = {value};"));
        Ok(())
    }

    fn tail(&mut self, expression: &Expr) -> Result<(), Refusal> {
        match expression {
            Expr::If(choice) => self.choice(choice, Tail::Result),
            Expr::Return(_) => self.statement(expression),
            other => {
                let text = self.typed(other, &self.result)?;
                self.line(format!("return {text};"));
                Ok(())
            }
        }
    }

    fn statement(&mut self, expression: &Expr) -> Result<(), Refusal> {
        match expression {
            Expr::Return(give) => match &give.expr {
                Some(value) => {
                    let text = self.typed(value, &self.result)?;
                    self.line(format!("return {text};"));
                }
                None => return Err(self.refuse(give.span(), "return without a value")),
            },
            Expr::Assign(assign) => {
                let (place, kind) = self.place(&assign.left)?;
                let value = self.typed(&assign.right, &kind)?;
                self.line(format!("{place} = {value};"));
            }
            Expr::Binary(binary) => {
                let Some((sign, integer)) = compound(&binary.op) else {
                    return Err(self.refuse(binary.span(), "an expression whose value is not used"));
                };
                let (place, kind) = self.place(&binary.left)?;
                let value = self.typed(&binary.right, &kind)?;
                if integer && !kind.is_integer() {
                    return Err(self.refuse(binary.span(), format!("`{sign}` on {kind} is not in the subset")));
                }
                self.line(format!("{place} {sign} {value};"));
            }
            Expr::If(choice) => self.choice(choice, Tail::Nothing)?,
            Expr::ForLoop(each) => self.for_loop(each)?,
            Expr::Break(leave) if leave.label.is_none() && leave.expr.is_none() => self.line("break;".into()),
            Expr::Continue(next) if next.label.is_none() => self.line("continue;".into()),
            Expr::While(inner) => {
                return Err(self.refuse(inner.span(), "`while`: use `for` with literal bounds"));
            }
            Expr::Loop(inner) => {
                return Err(self.refuse(inner.span(), "`loop`: use `for` with literal bounds"));
            }
            Expr::Match(inner) => {
                return Err(self.refuse(inner.span(), "`match`: use if, else if and else"));
            }
            Expr::Macro(inner) => return Err(self.refuse(inner.span(), "a macro")),
            other => return Err(self.refuse(other.span(), "this statement is not in the subset")),
        }
        Ok(())
    }

    /// Left side of an assignment.
    fn place(&self, left: &Expr) -> Result<(String, Kind), Refusal> {
        let mut root = left;
        loop {
            match root {
                Expr::Field(field) => root = &field.base,
                Expr::Index(index) => root = &index.expr,
                Expr::Path(path) => {
                    let local = path.path.get_ident().and_then(|name| self.lookup(&name.to_string()));
                    if !local.is_some_and(|local| local.mutable) {
                        return Err(self.refuse(left.span(), "only a local declared with `let mut` is assigned"));
                    }
                    let value = self.expression(left)?;
                    return Ok((value.text, value.kind));
                }
                other => {
                    return Err(self.refuse(other.span(), "this cannot be assigned in the subset"));
                }
            }
        }
    }
}
