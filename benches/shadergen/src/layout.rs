//! Text layout: lines of at most 100 columns, comments, and the banner of a file.

const WIDTH: usize = 100;

/// Appends `line`, broken at blanks where it is longer than 100 columns.
pub(crate) fn push_wrapped(out: &mut String, line: &str) {
    let indent = line.len() - line.trim_start().len();
    let comment = line.trim_start().starts_with("//");
    let lead = if comment {
        " ".repeat(indent) + "// "
    } else {
        " ".repeat(indent + 4)
    };
    let mut rest = line.trim_end().to_owned();
    while rest.len() > WIDTH {
        let floor = rest.len() - rest.trim_start().len() + if comment { 3 } else { 0 };
        let cut = (floor + 1..=WIDTH).rev().find(|&i| rest.as_bytes()[i] == b' ');
        let Some(cut) = cut.or_else(|| (WIDTH..rest.len()).find(|&i| rest.as_bytes()[i] == b' ')) else {
            break;
        };
        out.push_str(rest[..cut].trim_end());
        out.push('\n');
        rest = lead.clone() + rest[cut + 1..].trim_start();
    }
    out.push_str(&rest);
    out.push('\n');
}

/// Appends the lines as `//` comments.
pub(crate) fn push_comment(out: &mut String, indent: &str, lines: &[String]) {
    for line in lines {
        if line.is_empty() {
            out.push_str(&format!("{indent}//\n"));
        } else {
            push_wrapped(out, &format!("{indent}// {line}"));
        }
    }
}

/// Documentation up to its first heading or code block, a line each, without blank lines at the ends.
pub(crate) fn documentation(attributes: &[syn::Attribute]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for attribute in attributes {
        if let syn::Meta::NameValue(pair) = &attribute.meta
            && pair.path.is_ident("doc")
            && let syn::Expr::Lit(syn::ExprLit {
                lit: syn::Lit::Str(text),
                ..
            }) = &pair.value
        {
            lines.extend(
                text.value()
                    .lines()
                    .map(|line| ascii(line.strip_prefix(' ').unwrap_or(line).trim_end())),
            );
            if text.value().is_empty() {
                lines.push(String::new());
            }
        }
    }
    let end = lines
        .iter()
        .position(|line| line.starts_with('#') || line.starts_with("```"))
        .unwrap_or(lines.len());
    lines.truncate(end);
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// The line with the usual mathematical signs in ASCII; what has no spelling here is left as it is.
fn ascii(line: &str) -> String {
    const SPELLING: [(&str, &str); 10] = [
        ("²", "^2"),
        ("³", "^3"),
        ("π", "pi"),
        ("≤", "<="),
        ("≥", ">="),
        ("∞", "inf"),
        ("·", "*"),
        ("×", "x"),
        ("–", "-"),
        ("−", "-"),
    ];
    SPELLING
        .iter()
        .fold(line.to_owned(), |text, (sign, spelling)| text.replace(sign, spelling))
}

/// Sources named anywhere in the documentation, such as `VWH18 Eq. 29`, each once and in order.
pub(crate) fn citations(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for (start, tag) in ["VWH18", "WVJH17", "RGB16", "KGK19", "BB17", "DLMF"]
        .iter()
        .flat_map(|tag| text.match_indices(tag))
    {
        let rest = &text[start + tag.len()..];
        let mut end = 0;
        for word in [" Eqs. ", " Eq. ", " "] {
            if let Some(numbers) = rest.strip_prefix(word) {
                let digits = numbers
                    .bytes()
                    .take_while(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-'))
                    .count();
                let digits = numbers[..digits].trim_end_matches(['.', '-']).len();
                if digits > 0 {
                    end = word.len() + digits;
                }
                break;
            }
        }
        let name = format!("{tag}{}", &rest[..end]);
        if end > 0 && !found.contains(&name) {
            found.push(name);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_break_at_blanks_and_keep_every_word() {
        let line = format!("    let x = {};", vec!["alpha + beta"; 20].join(" * "));
        let mut out = String::new();
        push_wrapped(&mut out, &line);
        assert!(out.lines().all(|l| l.len() <= WIDTH), "{out}");
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&out), words(&line));
    }

    #[test]
    fn a_broken_comment_stays_a_comment() {
        let mut out = String::new();
        push_comment(&mut out, "", &["word ".repeat(60)]);
        assert!(out.lines().count() > 2);
        assert!(out.lines().all(|l| l.starts_with("// ")));
    }

    #[test]
    fn citations_are_found_once_with_their_equations() {
        let text = "See VWH18 Eqs. 27-29 and VWH18 Eq. 29; VWH18 Eq. 29. DLMF 6.2.17 too; BB17 without number.";
        assert_eq!(citations(text), ["VWH18 Eqs. 27-29", "VWH18 Eq. 29", "DLMF 6.2.17"]);
    }
}
