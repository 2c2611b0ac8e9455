//! Values with parts: struct literals, fields, arrays and indexing.

use syn::spanned::Spanned;

use crate::body::Body;
use crate::expression::Value;
use crate::kind::Kind;
use crate::refusal::Refusal;

impl Body<'_> {
    pub(crate) fn record(&self, record: &syn::ExprStruct) -> Result<Value, Refusal> {
        let name = record.path.get_ident().map(ToString::to_string).unwrap_or_default();
        let Some(fields) = self.symbols.structs.get(&name) else {
            return Err(self.refuse(record.span(), "this struct is not defined in the translated files"));
        };
        if let Some(rest) = &record.rest {
            return Err(self.refuse(rest.span(), "`..` in a struct literal: name every field"));
        }
        let mut list = Vec::new();
        for (field, kind) in fields {
            let found = record
                .fields
                .iter()
                .find(|f| matches!(&f.member, syn::Member::Named(n) if n == field));
            match found {
                Some(given) => list.push(self.typed(&given.expr, kind)?),
                None => {
                    return Err(self.refuse(record.span(), format!("field `{field}` is missing")));
                }
            }
        }
        Ok(Value {
            text: format!("{name}({})", list.join(", ")),
            kind: Kind::Struct(name),
        })
    }

    pub(crate) fn field(&self, field: &syn::ExprField) -> Result<Value, Refusal> {
        let base = self.expression(&field.base)?;
        let kind = match (&base.kind, &field.member) {
            (Kind::Struct(name), syn::Member::Named(member)) => self.symbols.structs[name]
                .iter()
                .find(|(n, _)| member == n)
                .map(|(n, kind)| (n, kind.clone())),
            _ => None,
        };
        match kind {
            Some((member, kind)) => Ok(Value {
                text: format!("{}.{member}", base.text),
                kind,
            }),
            None => Err(self.refuse(field.span(), "no such field in a struct of the subset")),
        }
    }

    pub(crate) fn index(&self, index: &syn::ExprIndex) -> Result<Value, Refusal> {
        let base = self.expression(&index.expr)?;
        let place = self.expression(&index.index)?;
        match base.kind {
            Kind::Array(element, _) if place.kind.is_integer() => Ok(Value {
                text: format!("{}[{}]", base.text, place.text),
                kind: *element,
            }),
            _ => Err(self.refuse(index.span(), "only arrays are indexed, by an integer")),
        }
    }

    pub(crate) fn array(&self, array: &syn::ExprArray) -> Result<Value, Refusal> {
        let values = array
            .elems
            .iter()
            .map(|e| self.expression(e))
            .collect::<Result<Vec<_>, _>>()?;
        let Some(first) = values.first().map(|v| v.kind.clone()) else {
            return Err(self.refuse(array.span(), "an empty array"));
        };
        if first == Kind::Whole || values.iter().any(|v| v.kind != first) {
            return Err(self.refuse(array.span(), "array elements of one type, integers with a suffix"));
        }
        let kind = Kind::Array(Box::new(first), values.len());
        let list: Vec<String> = values.into_iter().map(|v| v.text).collect();
        Ok(Value {
            text: format!("{kind}({})", list.join(", ")),
            kind,
        })
    }
}
