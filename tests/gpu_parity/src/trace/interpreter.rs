//! Statements and expressions of the parsed text.

use naga::{Block, Expression, Function, Handle, Literal, ScalarKind, Statement, TypeInner, UnaryOperator};

use super::{Bounded, Outcome, Run, Value};

enum Flow {
    Next,
    Break,
    Continue,
    Return(Value),
}

struct Frame<'a> {
    function: &'a Function,
    arguments: Vec<Value>,
    values: Vec<Option<Value>>,
    locals: Vec<Value>,
}

impl Run<'_> {
    pub(super) fn call(&mut self, function: &Function, arguments: Vec<Value>) -> Outcome<Value> {
        let mut frame = Frame {
            function,
            arguments,
            values: vec![None; function.expressions.len()],
            locals: Vec::new(),
        };
        for (_, local) in function.local_variables.iter() {
            let value = match local.init {
                Some(init) => self.evaluate(&frame, init)?,
                None => self.zero(local.ty)?,
            };
            frame.locals.push(value);
        }
        match self.block(&mut frame, &function.body)? {
            Flow::Return(value) => Ok(value),
            _ => Err("the function ends without a value".into()),
        }
    }

    fn zero(&mut self, ty: Handle<naga::Type>) -> Outcome<Value> {
        Ok(match &self.module.types[ty].inner {
            TypeInner::Scalar(scalar) => match scalar.kind {
                ScalarKind::Float => Value::Float(Bounded { value: 0.0, bound: 0.0 }),
                ScalarKind::Sint => Value::Int(0, 0.0),
                ScalarKind::Uint => Value::Word(0, 0.0),
                ScalarKind::Bool => Value::Bool(false),
                other => return Err(format!("scalar kind {other:?}")),
            },
            TypeInner::Struct { members, .. } => {
                Value::Composite(members.iter().map(|m| self.zero(m.ty)).collect::<Outcome<_>>()?)
            }
            TypeInner::Array {
                base,
                size: naga::ArraySize::Constant(n),
                ..
            } => Value::Composite(vec![self.zero(*base)?; n.get() as usize]),
            other => return Err(format!("type {other:?}")),
        })
    }

    fn block(&mut self, frame: &mut Frame, block: &Block) -> Outcome<Flow> {
        for statement in block.iter() {
            match statement {
                Statement::Emit(range) => {
                    for handle in range.clone() {
                        frame.values[handle.index()] = None;
                        let value = self.evaluate(frame, handle)?;
                        frame.values[handle.index()] = Some(value);
                    }
                }
                Statement::Block(inner) => match self.block(frame, inner)? {
                    Flow::Next => {}
                    other => return Ok(other),
                },
                Statement::If {
                    condition,
                    accept,
                    reject,
                } => {
                    let branch = if self.truth(frame, *condition)? { accept } else { reject };
                    match self.block(frame, branch)? {
                        Flow::Next => {}
                        other => return Ok(other),
                    }
                }
                Statement::Loop {
                    body,
                    continuing,
                    break_if,
                } => loop {
                    match self.block(frame, body)? {
                        Flow::Break => break,
                        Flow::Next | Flow::Continue => {}
                        give => return Ok(give),
                    }
                    self.block(frame, continuing)?;
                    if let Some(condition) = break_if
                        && self.truth(frame, *condition)?
                    {
                        break;
                    }
                },
                Statement::Break => return Ok(Flow::Break),
                Statement::Continue => return Ok(Flow::Continue),
                Statement::Return { value: Some(value) } => {
                    return Ok(Flow::Return(self.evaluate(frame, *value)?));
                }
                Statement::Store { pointer, value } => {
                    let Value::Pointer(local, path) = self.evaluate(frame, *pointer)? else {
                        return Err("a store to what is not a local".into());
                    };
                    let value = self.evaluate(frame, *value)?;
                    let mut place = &mut frame.locals[local.index()];
                    for step in path {
                        match place {
                            Value::Composite(parts) => place = &mut parts[step],
                            other => return Err(format!("a field of {other:?}")),
                        }
                    }
                    *place = value;
                }
                Statement::Call {
                    function,
                    arguments,
                    result,
                } => {
                    let values = arguments
                        .iter()
                        .map(|a| self.evaluate(frame, *a))
                        .collect::<Outcome<Vec<_>>>()?;
                    let value = self.call(&self.module.functions[*function], values)?;
                    if let Some(result) = result {
                        frame.values[result.index()] = Some(value);
                    }
                }
                other => return Err(format!("statement {other:?}")),
            }
        }
        Ok(Flow::Next)
    }

    fn truth(&mut self, frame: &Frame, condition: Handle<Expression>) -> Outcome<bool> {
        match self.evaluate(frame, condition)? {
            Value::Bool(b) => Ok(b),
            other => Err(format!("condition {other:?}")),
        }
    }

    fn literal(&self, literal: Literal) -> Outcome<Value> {
        Ok(match literal {
            Literal::F32(value) => Value::Float(Bounded { value, bound: 0.0 }),
            Literal::I32(n) => Value::Int(n, 0.0),
            Literal::U32(n) => Value::Word(n, 0.0),
            Literal::Bool(b) => Value::Bool(b),
            other => return Err(format!("literal {other:?}")),
        })
    }

    fn constant(&mut self, handle: Handle<Expression>) -> Outcome<Value> {
        match &self.module.global_expressions[handle] {
            Expression::Literal(literal) => self.literal(*literal),
            Expression::Constant(constant) => self.constant(self.module.constants[*constant].init),
            Expression::ZeroValue(ty) => self.zero(*ty),
            Expression::Compose { components, .. } => Ok(Value::Composite(
                components.iter().map(|c| self.constant(*c)).collect::<Outcome<_>>()?,
            )),
            other => Err(format!("constant {other:?}")),
        }
    }

    fn evaluate(&mut self, frame: &Frame, handle: Handle<Expression>) -> Outcome<Value> {
        if let Some(value) = &frame.values[handle.index()] {
            return Ok(value.clone());
        }
        match &frame.function.expressions[handle] {
            Expression::Literal(literal) => self.literal(*literal),
            Expression::Constant(constant) => self.constant(self.module.constants[*constant].init),
            Expression::ZeroValue(ty) => self.zero(*ty),
            Expression::FunctionArgument(i) => Ok(frame.arguments[*i as usize].clone()),
            Expression::LocalVariable(local) => Ok(Value::Pointer(*local, Vec::new())),
            Expression::Compose { components, .. } => Ok(Value::Composite(
                components
                    .iter()
                    .map(|c| self.evaluate(frame, *c))
                    .collect::<Outcome<_>>()?,
            )),
            Expression::AccessIndex { base, index } => {
                let base = self.evaluate(frame, *base)?;
                access(base, *index as usize)
            }
            Expression::Access { base, index } => {
                let base = self.evaluate(frame, *base)?;
                match self.evaluate(frame, *index)? {
                    Value::Int(i, _) => access(base, usize::try_from(i).map_err(|e| e.to_string())?),
                    Value::Word(i, _) => access(base, i as usize),
                    other => Err(format!("index {other:?}")),
                }
            }
            Expression::Load { pointer } => {
                let Value::Pointer(local, path) = self.evaluate(frame, *pointer)? else {
                    return Err("a load from what is not a local".into());
                };
                path.iter()
                    .try_fold(frame.locals[local.index()].clone(), |value, step| access(value, *step))
            }
            Expression::Unary { op, expr } => {
                let value = self.evaluate(frame, *expr)?;
                match (op, value) {
                    (UnaryOperator::Negate, Value::Float(x)) => Ok(self.float(-x.value, x.bound)),
                    (UnaryOperator::Negate, Value::Int(n, bound)) => Ok(Value::Int(n.wrapping_neg(), bound)),
                    (UnaryOperator::LogicalNot, Value::Bool(b)) => Ok(Value::Bool(!b)),
                    (UnaryOperator::BitwiseNot, Value::Int(n, bound)) => Ok(Value::Int(!n, bound)),
                    (UnaryOperator::BitwiseNot, Value::Word(n, bound)) => Ok(Value::Word(!n, bound)),
                    (op, value) => Err(format!("{op:?} {value:?}")),
                }
            }
            Expression::Binary { op, left, right } => {
                let left = self.evaluate(frame, *left)?;
                let right = self.evaluate(frame, *right)?;
                self.binary(*op, left, right)
            }
            Expression::Select {
                condition,
                accept,
                reject,
            } => {
                let (accept, reject) = (self.evaluate(frame, *accept)?, self.evaluate(frame, *reject)?);
                Ok(if self.truth(frame, *condition)? { accept } else { reject })
            }
            Expression::Math {
                fun, arg, arg1, arg2, ..
            } => {
                let mut floats = Vec::with_capacity(3);
                for handle in [Some(*arg), *arg1, *arg2].into_iter().flatten() {
                    match self.evaluate(frame, handle)? {
                        Value::Float(x) => floats.push(x),
                        other => return Err(format!("{fun:?} of {other:?}")),
                    }
                }
                self.math(*fun, &floats)
            }
            Expression::As { expr, kind, convert } => {
                let value = self.evaluate(frame, *expr)?;
                self.cast(value, *kind, convert.is_some())
            }
            other => Err(format!("expression {other:?}")),
        }
    }
}

fn access(value: Value, index: usize) -> Outcome<Value> {
    match value {
        Value::Composite(mut parts) if index < parts.len() => Ok(parts.swap_remove(index)),
        Value::Pointer(local, mut path) => {
            path.push(index);
            Ok(Value::Pointer(local, path))
        }
        other => Err(format!("part {index} of {other:?}")),
    }
}
