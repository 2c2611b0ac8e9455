//! Tables of numbers in CSV: reading, and comparing a committed one with a measured one.

/// Title words and rows of numbers of a CSV text, or what is wrong with it and where.
pub fn read(text: &str) -> Result<(Vec<String>, Vec<Vec<f64>>), String> {
    let mut lines = text.lines();
    let header: Vec<String> = lines
        .next()
        .ok_or("the file is empty")?
        .split(',')
        .map(str::to_string)
        .collect();
    let mut rows = Vec::new();
    for (i, line) in lines.enumerate() {
        let row: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        let row = row.map_err(|e| format!("line {}: {e}", i + 2))?;
        if row.len() != header.len() {
            return Err(format!(
                "line {}: {} columns, {} expected",
                i + 2,
                row.len(),
                header.len()
            ));
        }
        rows.push(row);
    }
    Ok((header, rows))
}

/// Whether two files of numbers agree: the columns named in `loose` within 10 %, those in `free` in any way, all others
/// to the last character. Says where they first differ.
pub fn same_table(committed: &str, fresh: &str, loose: &[&str], free: &[&str]) -> Result<(), String> {
    let header: Vec<&str> = fresh.lines().next().unwrap_or_default().split(',').collect();
    if committed.lines().count() != fresh.lines().count() {
        return Err(format!(
            "{} lines, {} expected",
            committed.lines().count(),
            fresh.lines().count()
        ));
    }
    for (number, (a, b)) in committed.lines().zip(fresh.lines()).enumerate() {
        let (a_words, b_words): (Vec<&str>, Vec<&str>) = (a.split(',').collect(), b.split(',').collect());
        let same = a_words.len() == b_words.len()
            && a_words.iter().zip(&b_words).enumerate().all(|(i, (x, y))| {
                let name = header.get(i).unwrap_or(&"");
                x == y || (number > 0 && (free.contains(name) || loose.contains(name) && near(x, y)))
            });
        if !same {
            return Err(format!(
                "line {}: \"{a}\" is committed, \"{b}\" is measured",
                number + 1
            ));
        }
    }
    Ok(())
}

/// Whether two numbers in text agree within 10 %.
pub fn near(a: &str, b: &str) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => a == b || (a - b).abs() <= 0.1 * a.abs().max(b.abs()) || (a.is_nan() && b.is_nan()),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loose_columns_may_differ_by_a_tenth_and_others_not_at_all() {
        let a = "x,own,peer\n1,2,3.00\n";
        assert!(same_table(a, "x,own,peer\n1,2,3.20\n", &["peer"], &[]).is_ok());
        assert!(same_table(a, "x,own,peer\n1,2,3.40\n", &["peer"], &[]).is_err());
        assert!(
            same_table(a, "x,own,peer\n1,2.01,3.00\n", &["peer"], &[])
                .expect_err("own")
                .contains("line 2")
        );
        assert!(same_table(a, "x,own,peer\n", &["peer"], &[]).is_err());
        assert!(same_table(a, "x,own,peer\n1,2,9\n", &[], &["peer"]).is_ok());
    }
}
