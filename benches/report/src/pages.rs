//! Generated text inside written pages: what stands between `<!-- report:begin NAME -->` and
//! `<!-- report:end NAME -->` is replaced by the table NAME. In doc comments the prefix of the begin line
//! (`//! `, `/// `, blanks) is put before every generated line.

use std::path::{Path, PathBuf};

const BEGIN: &str = "<!-- report:begin ";
const END: &str = "<!-- report:end ";
const CLOSE: &str = " -->";

fn marker<'a>(line: &'a str, kind: &str) -> Option<(&'a str, &'a str)> {
    let start = line.find(kind)?;
    let name = line[start + kind.len()..].strip_suffix(CLOSE)?;
    Some((&line[..start], name.trim()))
}

/// The page with its generated parts renewed by `table`; an error names the line.
pub fn renew(page: &str, table: impl Fn(&str) -> Result<String, String>) -> Result<String, String> {
    let mut out = String::with_capacity(page.len());
    let mut lines = page.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        out.push_str(line);
        out.push('\n');
        if marker(line, END).is_some() {
            return Err(format!("line {}: an end without a begin", number + 1));
        }
        let Some((prefix, name)) = marker(line, BEGIN) else {
            continue;
        };
        let bare = prefix.trim_end();
        let text = table(name).map_err(|e| format!("line {}: {e}", number + 1))?;
        for generated in std::iter::once("")
            .chain(text.trim_end().lines())
            .chain(std::iter::once(""))
        {
            let full = if generated.is_empty() {
                bare.to_string()
            } else {
                format!("{prefix}{generated}")
            };
            out.push_str(&full);
            out.push('\n');
        }
        let end = lines
            .by_ref()
            .map(|(_, l)| l)
            .find(|l| marker(l, END).is_some() || marker(l, BEGIN).is_some());
        match end.and_then(|l| marker(l, END).map(|m| (l, m.1))) {
            Some((end_line, end_name)) if end_name == name => {
                out.push_str(end_line);
                out.push('\n');
            }
            Some((_, other)) => {
                return Err(format!("line {}: \"{name}\" begins and \"{other}\" ends", number + 1));
            }
            None => return Err(format!("line {}: \"{name}\" has no end", number + 1)),
        }
    }
    if !page.ends_with('\n') {
        out.pop();
    }
    Ok(out)
}

/// All pages below the root that may carry generated parts: README.md, docs/**/*.md, data/**/*.md, src/**/*.rs; sorted.
pub fn files(root: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    if root.join("README.md").is_file() {
        found.push(PathBuf::from("README.md"));
    }
    for (folder, extension) in [("docs", "md"), ("data", "md"), ("src", "rs")] {
        gather(root, Path::new(folder), extension, &mut found)?;
    }
    found.sort();
    Ok(found)
}

fn gather(root: &Path, folder: &Path, extension: &str, found: &mut Vec<PathBuf>) -> std::io::Result<()> {
    let path = root.join(folder);
    if !path.is_dir() {
        return Ok(());
    }
    for item in std::fs::read_dir(path)? {
        let item = item?;
        let inner = folder.join(item.file_name());
        if item.file_type()?.is_dir() {
            gather(root, &inner, extension, found)?;
        } else if inner.extension().is_some_and(|e| e == extension) {
            found.push(inner);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_lines(name: &str) -> Result<String, String> {
        if name == "t" {
            Ok("| a |\n| b |\n".to_string())
        } else {
            Err(format!("unknown table \"{name}\""))
        }
    }

    #[test]
    fn old_text_is_replaced_and_the_prefix_is_kept() {
        let page = "//! x\n//! <!-- report:begin t -->\n//! old\n//! <!-- report:end t -->\nfn f() {}\n";
        let new = "//! x\n//! <!-- report:begin t -->\n//!\n//! | a |\n//! | b |\n//!\n//! <!-- report:end t -->\nfn f() {}\n";
        assert_eq!(renew(page, two_lines).as_deref(), Ok(new));
        assert_eq!(renew(new, two_lines).as_deref(), Ok(new));
        assert_eq!(renew("no parts", two_lines).as_deref(), Ok("no parts"));
    }

    #[test]
    fn broken_markers_are_named_by_line() {
        for (page, word) in [
            ("\n<!-- report:begin t -->\n", "line 2: \"t\" has no end"),
            ("<!-- report:end t -->\n", "line 1: an end"),
            ("<!-- report:begin t -->\n<!-- report:end u -->\n", "\"u\" ends"),
            (
                "<!-- report:begin t -->\n<!-- report:begin t -->\n<!-- report:end t -->",
                "no end",
            ),
            (
                "<!-- report:begin u -->\n<!-- report:end u -->\n",
                "line 1: unknown table",
            ),
        ] {
            let error = renew(page, two_lines).expect_err(page);
            assert!(error.contains(word), "{error}");
        }
    }
}
