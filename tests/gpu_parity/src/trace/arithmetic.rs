//! Operators, built-ins and casts, each with the error that WGSL allows it.

use naga::{BinaryOperator as B, MathFunction, ScalarKind};

use super::{Bounded, Outcome, Run, Value};

fn ulp(value: f32) -> f64 {
    let exponent = ((value.to_bits() >> 23) & 0xff).max(1) as i32;
    2f64.powi(exponent - 150)
}

impl Run<'_> {
    /// A new f32, with the rule about what lies outside the guarantee.
    pub(super) fn float(&mut self, value: f32, bound: f64) -> Value {
        if value.is_subnormal() || !value.is_finite() {
            self.trace.outside = true;
        }
        Value::Float(Bounded { value, bound })
    }

    pub(super) fn binary(&mut self, op: B, left: Value, right: Value) -> Outcome<Value> {
        match (left, right) {
            (Value::Float(a), Value::Float(b)) => self.float_binary(op, a, b),
            (Value::Bool(a), Value::Bool(b)) => Ok(Value::Bool(match op {
                B::Equal => a == b,
                B::NotEqual => a != b,
                B::And | B::LogicalAnd => a & b,
                B::InclusiveOr | B::LogicalOr => a | b,
                other => return Err(format!("{other:?} on bool")),
            })),
            (Value::Int(a, ea), Value::Int(b, eb)) => {
                let bound = self.integer_bound(op, ea, eb);
                Ok(match op {
                    B::Add => Value::Int(a.wrapping_add(b), bound),
                    B::Subtract => Value::Int(a.wrapping_sub(b), bound),
                    B::Multiply => Value::Int(a.wrapping_mul(b), bound),
                    B::Divide => Value::Int(a.checked_div(b).unwrap_or(a), bound),
                    B::Modulo => Value::Int(a.checked_rem(b).unwrap_or(0), bound),
                    B::And => Value::Int(a & b, bound),
                    B::InclusiveOr => Value::Int(a | b, bound),
                    B::ExclusiveOr => Value::Int(a ^ b, bound),
                    _ => Value::Bool(order(op, a.cmp(&b))?),
                })
            }
            // A shift that drops all that is inexact, such as that to the exponent.
            (Value::Word(a, ea), Value::Word(b, 0.0)) if op == B::ShiftRight && shift_is_sure(a, ea, b) => {
                Ok(Value::Word(a >> (b & 31), 0.0))
            }
            (Value::Word(a, ea), Value::Word(b, eb)) => {
                let bound = self.integer_bound(op, ea, eb);
                Ok(match op {
                    B::Add => Value::Word(a.wrapping_add(b), bound),
                    B::Subtract => Value::Word(a.wrapping_sub(b), bound),
                    B::Multiply => Value::Word(a.wrapping_mul(b), bound),
                    B::Divide => Value::Word(a.checked_div(b).unwrap_or(a), bound),
                    B::Modulo => Value::Word(a.checked_rem(b).unwrap_or(0), bound),
                    B::And => Value::Word(a & b, bound),
                    B::InclusiveOr => Value::Word(a | b, bound),
                    B::ExclusiveOr => Value::Word(a ^ b, bound),
                    B::ShiftLeft => Value::Word(a << (b & 31), bound),
                    B::ShiftRight => Value::Word(a >> (b & 31), bound),
                    _ => Value::Bool(order(op, a.cmp(&b))?),
                })
            }
            (Value::Int(a, ea), Value::Word(b, eb)) => {
                let bound = self.integer_bound(op, ea, eb);
                match op {
                    B::ShiftLeft => Ok(Value::Int(a << (b & 31), bound)),
                    B::ShiftRight => Ok(Value::Int(a >> (b & 31), bound)),
                    other => Err(format!("{other:?} on i32 and u32")),
                }
            }
            (a, b) => Err(format!("{op:?} on {a:?} and {b:?}")),
        }
    }

    /// Bits that came from an inexact f32 keep its bound through masks; anything else on them is undecided.
    pub(super) fn integer_bound(&mut self, op: B, left: f64, right: f64) -> f64 {
        if left + right > 0.0 && !matches!(op, B::And | B::InclusiveOr | B::ExclusiveOr) {
            self.trace.undecided = true;
        }
        left + right
    }

    pub(super) fn float_binary(&mut self, op: B, a: Bounded, b: Bounded) -> Outcome<Value> {
        let (x, y) = (f64::from(a.value), f64::from(b.value));
        Ok(match op {
            B::Add | B::Subtract => {
                let y = if op == B::Add { y } else { -y };
                let value = if op == B::Add {
                    a.value + b.value
                } else {
                    a.value - b.value
                };
                let sum = x + y;
                let back = sum - x;
                let exact = (x - (sum - back)) + (y - back) == 0.0 && sum == f64::from(value);
                // With operands that may be off, it stays exact where the result has the finer of their grids.
                let grid = ulp(value) <= ulp(a.value).min(ulp(b.value));
                let exact = exact && (grid || a.bound + b.bound == 0.0);
                let rounding = if exact { 0.0 } else { ulp(value) };
                self.float(value, a.bound + b.bound + rounding)
            }
            B::Multiply => {
                let value = a.value * b.value;
                let rounding = if x * y == f64::from(value) { 0.0 } else { ulp(value) };
                self.float(
                    value,
                    x.abs() * b.bound + y.abs() * a.bound + a.bound * b.bound + rounding,
                )
            }
            B::Divide => {
                let value = a.value / b.value;
                if !(2f64.powi(-126)..=2f64.powi(126)).contains(&y.abs()) {
                    self.trace.outside = true;
                }
                if b.bound >= y.abs() {
                    self.trace.undecided = true;
                }
                let spread = (a.bound + (x / y).abs() * b.bound) / (y.abs() - b.bound);
                self.float(value, spread + 3.0 * ulp(value))
            }
            _ => {
                if (x - y).abs() <= a.bound + b.bound && a.bound + b.bound > 0.0 {
                    self.trace.undecided = true;
                }
                match a.value.partial_cmp(&b.value) {
                    Some(ordering) => Value::Bool(order(op, ordering)?),
                    None => Value::Bool(op == B::NotEqual),
                }
            }
        })
    }

    pub(super) fn math(&mut self, fun: MathFunction, arguments: &[Bounded]) -> Outcome<Value> {
        use MathFunction as M;
        Ok(match (fun, arguments) {
            (M::Abs, [x]) => self.float(x.value.abs(), x.bound),
            (M::Min, [x, y]) => self.float(x.value.min(y.value), x.bound.max(y.bound)),
            (M::Max, [x, y]) => self.float(x.value.max(y.value), x.bound.max(y.bound)),
            (M::Clamp, [x, low, high]) => {
                let bound = x.bound.max(low.bound).max(high.bound);
                self.float(x.value.max(low.value).min(high.value), bound)
            }
            (M::Floor, [x]) => self.step(*x, f32::floor),
            (M::Ceil, [x]) => self.step(*x, f32::ceil),
            (M::Round, [x]) => self.step(*x, f32::round_ties_even),
            (M::Trunc, [x]) => self.step(*x, f32::trunc),
            (M::Sign, [x]) => self.step(*x, |x| if x == 0.0 { 0.0 } else { x.signum() }),
            (M::Sqrt, [x]) => {
                let value = x.value.sqrt();
                let slope = if value > 0.0 { 0.5 / f64::from(value) } else { 0.0 };
                let rounding = if value == 0.0 { 0.0 } else { 5.0 * ulp(value) };
                self.float(value, slope * x.bound + rounding)
            }
            (fun, _) => return Err(format!("built-in {fun:?}")),
        })
    }

    /// A built-in with steps: exact, unless the step lies within the bound.
    pub(super) fn step(&mut self, x: Bounded, function: impl Fn(f32) -> f32) -> Value {
        let value = function(x.value);
        let ends = [f64::from(x.value) - x.bound, f64::from(x.value) + x.bound];
        if x.bound > 0.0 && ends.iter().any(|&end| function(end as f32) != value) {
            self.trace.undecided = true;
        }
        self.float(value, 0.0)
    }

    pub(super) fn cast(&mut self, value: Value, kind: ScalarKind, convert: bool) -> Outcome<Value> {
        Ok(match (value, kind, convert) {
            (Value::Float(x), ScalarKind::Sint, true) => {
                self.step(x, f32::trunc);
                Value::Int(x.value as i32, 0.0)
            }
            (Value::Float(x), ScalarKind::Uint, true) => {
                self.step(x, f32::trunc);
                Value::Word(x.value as u32, 0.0)
            }
            (Value::Float(x), ScalarKind::Uint, false) => Value::Word(x.value.to_bits(), x.bound),
            (Value::Float(x), ScalarKind::Sint, false) => Value::Int(x.value.to_bits().cast_signed(), x.bound),
            (Value::Word(n, bound), ScalarKind::Float, false) => self.float(f32::from_bits(n), bound),
            (Value::Int(n, bound), ScalarKind::Float, false) => self.float(f32::from_bits(n.cast_unsigned()), bound),
            (Value::Int(n, bound), ScalarKind::Float, true) => {
                let rounding = if f64::from(n) == f64::from(n as f32) {
                    0.0
                } else {
                    ulp(n as f32)
                };
                self.float(n as f32, bound + rounding)
            }
            (Value::Word(n, bound), ScalarKind::Float, true) => {
                let rounding = if f64::from(n) == f64::from(n as f32) {
                    0.0
                } else {
                    ulp(n as f32)
                };
                self.float(n as f32, bound + rounding)
            }
            (Value::Int(n, bound), ScalarKind::Uint, _) => Value::Word(n.cast_unsigned(), bound),
            (Value::Word(n, bound), ScalarKind::Sint, _) => Value::Int(n.cast_signed(), bound),
            (Value::Bool(b), ScalarKind::Uint, true) => Value::Word(u32::from(b), 0.0),
            (Value::Bool(b), ScalarKind::Sint, true) => Value::Int(i32::from(b), 0.0),
            (same @ Value::Float(_), ScalarKind::Float, _) => same,
            (same @ Value::Int(..), ScalarKind::Sint, _) => same,
            (same @ Value::Word(..), ScalarKind::Uint, _) => same,
            (value, kind, _) => return Err(format!("cast of {value:?} to {kind:?}")),
        })
    }
}

/// Whether the bits of an f32 that may be off by a bound give the same after a shift to the right.
fn shift_is_sure(bits: u32, bound: f64, places: u32) -> bool {
    let value = f64::from(f32::from_bits(bits));
    let shifted = |x: f64| (x as f32).to_bits() >> (places & 31);
    bound.is_finite() && shifted(value - bound) == shifted(value) && shifted(value + bound) == shifted(value)
}

fn order(op: B, ordering: std::cmp::Ordering) -> Outcome<bool> {
    Ok(match op {
        B::Equal => ordering.is_eq(),
        B::NotEqual => ordering.is_ne(),
        B::Less => ordering.is_lt(),
        B::LessEqual => ordering.is_le(),
        B::Greater => ordering.is_gt(),
        B::GreaterEqual => ordering.is_ge(),
        other => return Err(format!("operator {other:?}")),
    })
}
