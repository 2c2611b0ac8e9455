//! The WGSL text evaluated operation by operation, with the error that the WGSL specification allows a GPU.
//!
//! Every f32 carries a bound on how far a conforming GPU may be from it (running error analysis; WGSL section 15.7,
//! "Floating Point Accuracy"):
//!
//! | operation | allowed by WGSL | counted here, against round-to-nearest |
//! |---|---|---|
//! | `+ - *` | correctly rounded, direction free; may be fused | 1 ulp where inexact, else 0 |
//! | `/` | 2.5 ulp for a divisor in [2^-126, 2^126] | 3 ulp |
//! | `sqrt` | as 1 / inverseSqrt: 2 ulp, then a division | 5 ulp |
//! | `abs floor ceil round trunc min max clamp sign select bitcast`, negation, comparison | exact | 0 |
//!
//! Outside the guarantee, by rule: a row in which an input, an intermediate or a result is subnormal (it may be
//! flushed), infinite or NaN (they may be assumed away), or which divides outside the range of the table. Undecided:
//! a row in which a comparison, a rounding to an integer or a bit pattern hangs on less than the bound. Reassociation,
//! which WGSL also allows, is not in the bound: the subset is written so that no result hangs on it.

mod arithmetic;
mod interpreter;

use naga::{BinaryOperator, Expression, Function, Handle, LocalVariable, MathFunction, Module};

/// An f32 and how far a GPU may be from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// Value with every operation rounded to nearest.
    pub value: f32,
    /// Bound on the difference of a conforming GPU.
    pub bound: f64,
}

/// What became of a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// The result, a struct flattened.
    pub results: Vec<Bounded>,
    /// A value or a divisor left the range in which WGSL promises anything.
    pub outside: bool,
    /// A decision hangs on less than the bound.
    pub undecided: bool,
}

/// A parsed text.
pub struct Program {
    module: Module,
}

#[derive(Clone, Debug)]
enum Value {
    Float(Bounded),
    Int(i32, f64),
    Word(u32, f64),
    Bool(bool),
    Composite(Vec<Value>),
    Pointer(Handle<LocalVariable>, Vec<usize>),
}

struct Run<'a> {
    module: &'a Module,
    trace: Trace,
}

type Outcome<T> = Result<T, String>;

impl Program {
    /// Parses the text.
    pub fn parse(wgsl: &str) -> Outcome<Program> {
        let module = naga::front::wgsl::parse_str(wgsl).map_err(|e| e.emit_to_string(wgsl))?;
        Ok(Program { module })
    }

    fn function(&self, name: &str) -> Outcome<&Function> {
        let found = self
            .module
            .functions
            .iter()
            .find(|(_, f)| f.name.as_deref() == Some(name));
        found
            .map(|(_, f)| f)
            .ok_or_else(|| format!("no function {name} in the text"))
    }

    /// Evaluates a function of f32 arguments on a row.
    pub fn evaluate(&self, name: &str, row: &[f32]) -> Outcome<Trace> {
        let mut run = Run {
            module: &self.module,
            trace: Trace::default(),
        };
        let arguments = row.iter().map(|&x| run.float(x, 0.0)).collect();
        let value = run.call(self.function(name)?, arguments)?;
        flatten(&value, &mut run.trace.results)?;
        Ok(run.trace)
    }

    /// Whether the function, or one that it calls, divides (integers count too) or takes a square root.
    pub fn divides(&self, name: &str) -> Outcome<bool> {
        Ok(self.function_divides(self.function(name)?))
    }

    fn function_divides(&self, function: &Function) -> bool {
        function.expressions.iter().any(|(_, expression)| match expression {
            Expression::Binary {
                op: BinaryOperator::Divide,
                ..
            }
            | Expression::Math {
                fun: MathFunction::Sqrt,
                ..
            } => true,
            Expression::CallResult(callee) => self.function_divides(&self.module.functions[*callee]),
            _ => false,
        })
    }
}

fn flatten(value: &Value, out: &mut Vec<Bounded>) -> Outcome<()> {
    match value {
        Value::Float(x) => out.push(*x),
        Value::Composite(parts) => {
            for part in parts {
                flatten(part, out)?;
            }
        }
        other => return Err(format!("the result {other:?} is not made of f32")),
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trace(body: &str, row: &[f32]) -> Trace {
        let names: Vec<String> = ["x: f32", "y: f32"][..row.len()]
            .iter()
            .map(ToString::to_string)
            .collect();
        let text = format!("fn f({}) -> f32 {{ {body} }}", names.join(", "));
        Program::parse(&text)
            .and_then(|program| program.evaluate("f", row))
            .unwrap_or_else(|e| panic!("{e}"))
    }

    #[test]
    fn exact_operations_have_no_bound_and_others_that_of_the_table() {
        assert_eq!(
            trace("return x * 2.0 + y;", &[1.5, 0.25]).results,
            [Bounded {
                value: 3.25,
                bound: 0.0
            }]
        );
        let third = trace("return x / y;", &[1.0, 3.0]).results[0];
        assert_eq!((third.value, third.bound), (1.0f32 / 3.0, 3.0 * 2f64.powi(-25)));
        let product = trace("return x * y;", &[1.1, 1.3]).results[0];
        assert_eq!((product.value, product.bound), (1.1f32 * 1.3, 2f64.powi(-23)));
        assert_eq!(trace("return sqrt(x);", &[4.0]).results[0].bound, 5.0 * 2f64.powi(-22));
    }

    #[test]
    fn the_bound_grows_with_the_condition_of_a_difference() {
        let trace = trace("return x / 3.0 - y;", &[1.0, 0.333_333_3]);
        assert!(trace.results[0].bound >= 3.0 * 2f64.powi(-25));
        assert!(trace.results[0].value.abs() < 1e-7);
    }

    #[test]
    fn subnormal_infinite_and_missing_numbers_are_outside() {
        assert!(trace("return x;", &[1e-40]).outside);
        assert!(trace("return x * y;", &[1e-20, 1e-20]).outside);
        assert!(trace("return x * y;", &[1e30, 1e30]).outside);
        assert!(trace("return x;", &[f32::NAN]).outside);
        assert!(trace("return 1.0 / x;", &[0.0]).outside);
        assert!(!trace("return x + 1.0;", &[0.0]).outside);
    }

    #[test]
    fn a_decision_within_the_bound_is_undecided() {
        assert!(trace("if x / 3.0 < y { return 1.0; } return 2.0;", &[1.0, 0.333_333_34]).undecided);
        assert!(!trace("if x / 3.0 < y { return 1.0; } return 2.0;", &[1.0, 0.4]).undecided);
        assert!(trace("return round(x / 3.0);", &[1.5]).undecided);
        assert!(!trace("return round(x);", &[0.5]).undecided);
    }

    #[test]
    fn a_shift_is_sure_where_all_that_is_inexact_is_dropped() {
        let exponent = "return f32(bitcast<u32>(x / 3.0) >> 23u);";
        assert!(!trace(exponent, &[4.0]).undecided);
        assert!(trace(exponent, &[3.0]).undecided);
        assert!(trace("return f32(bitcast<u32>(x / 3.0) >> 1u);", &[4.0]).undecided);
    }

    #[test]
    fn loops_locals_and_bits_are_evaluated() {
        let body = "var s = 0.0; for (var i: u32 = 0u; i < 6u; i++) { if i == 4u { continue; } s += x; } \
                    let n = bitcast<u32>(s) & 0x7fffffffu; return bitcast<f32>(n);";
        assert_eq!(trace(body, &[-1.5]).results, [Bounded { value: 7.5, bound: 0.0 }]);
    }

    #[test]
    fn divisions_are_found_through_calls() {
        let text = "fn g(x: f32) -> f32 { return 1.0 / x; } fn f(x: f32) -> f32 { return g(x); } fn h(x: f32) -> f32 { return x * 0.5; }";
        let program = Program::parse(text).expect("valid WGSL");
        assert_eq!(
            ["f", "g", "h"].map(|name| program.divides(name)),
            [Ok(true), Ok(true), Ok(false)]
        );
    }
}
