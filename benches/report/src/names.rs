//! Finding functions and methods by name, with a suggestion where a name is unknown.

use reference::registry::{Call, Function, Method, Origin, Precision, functions, methods};

/// `f64` or `f32`.
pub fn precision(p: Precision) -> &'static str {
    match p {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    }
}

/// `ours`, `published` or `peer`.
pub fn origin(o: Origin) -> &'static str {
    match o {
        Origin::Ours => "ours",
        Origin::Published => "published",
        Origin::Peer => "peer",
    }
}

/// `scalar` or `slice`.
pub fn call(c: &Call) -> &'static str {
    if c.is_slice() { "slice" } else { "scalar" }
}

/// The registered function of a name, or what to say about the unknown one.
pub fn function(name: &str) -> Result<&'static Function, String> {
    functions().iter().find(|f| f.name == name).ok_or_else(|| {
        let known: Vec<&str> = functions().iter().map(|f| f.name).collect();
        unknown("function", name, &known)
    })
}

/// The methods of a function, in the order of the registry.
pub fn methods_of(function: &str) -> impl Iterator<Item = &'static Method> {
    methods().iter().filter(move |m| m.function == function)
}

/// The sentence for an unknown name: what was asked, the nearest known name if one is near, all known names.
pub fn unknown(kind: &str, name: &str, known: &[&str]) -> String {
    let near = known
        .iter()
        .map(|k| (distance(name, k), *k))
        .min()
        .filter(|(d, k)| *d <= 2.max(k.len() / 3));
    let hint = near.map_or(String::new(), |(_, k)| format!("; did you mean {k}?"));
    format!("unknown {kind} \"{name}\"{hint}\nknown: {}", known.join(", "))
}

/// Edits (insert, delete, replace, swap of neighbours) that lead from one word to the other.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0_usize; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replace = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut best = replace.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    best = best.min(rows[i - 2][j - 2] + 1);
                }
                best
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_counted() {
        for (a, b, d) in [
            ("", "abc", 3),
            ("sine", "sine", 0),
            ("sien", "sine", 1),
            ("sinc", "sine", 1),
            ("ab", "ba", 1),
        ] {
            assert_eq!(distance(a, b), d, "{a} {b}");
        }
    }

    #[test]
    fn a_near_name_is_suggested_and_a_far_one_is_not() {
        let known = ["sine_integral", "sinc_squared_integral"];
        assert!(unknown("function", "sine_integal", &known).contains("did you mean sine_integral?"));
        assert!(!unknown("function", "polygon", &known).contains("did you mean"));
    }
}
