//! The fitted tables hold the numbers that their scripts wrote: data/fits/fits.csv has the hash of each.

use std::path::Path;

/// A row of fits.csv.
struct Fit {
    file: String,
    script: String,
    literals: usize,
    hash: u64,
}

fn read(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn fits() -> Vec<Fit> {
    let text = read("data/fits/fits.csv");
    assert_eq!(text.lines().next(), Some("file,script,literals,hash"));
    let rows = text.lines().skip(1).map(|line| {
        let words: Vec<&str> = line.split(',').collect();
        let [file, script, literals, hash] = words[..] else {
            panic!("fits.csv: {line}")
        };
        Fit {
            file: file.to_owned(),
            script: script.to_owned(),
            literals: literals.parse().expect("a count"),
            hash: u64::from_str_radix(hash, 16).expect("a hash"),
        }
    });
    rows.collect()
}

/// Every float literal outside comments, in order.
fn literals(source: &str) -> Vec<f64> {
    let code: Vec<&str> = source
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect();
    let code = code.join("\n");
    let words = code.split(|c: char| c.is_whitespace() || ",;=[](){}".contains(c));
    words
        .filter(|word| word.contains('.'))
        .filter_map(|word| word.parse().ok())
        .collect()
}

/// FNV-1a over the little-endian bits of the numbers.
fn hash(numbers: &[f64]) -> u64 {
    let bytes = numbers.iter().flat_map(|x| x.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[test]
fn every_fitted_table_holds_the_numbers_that_its_script_wrote() {
    for fit in fits() {
        let numbers = literals(&read(&fit.file));
        assert_eq!(numbers.len(), fit.literals, "{}", fit.file);
        assert_eq!(
            hash(&numbers),
            fit.hash,
            "{} differs from what data/fits/{} wrote",
            fit.file,
            fit.script
        );
        assert!(
            read(&format!("data/fits/{}", fit.script)).contains("provenance.write_or_check("),
            "{}",
            fit.script
        );
    }
}

#[test]
fn every_table_that_a_script_wrote_is_listed() {
    let listed: Vec<String> = fits().into_iter().map(|fit| fit.file).collect();
    let mut found = 0;
    for folder in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("src")).expect("src") {
        let Ok(files) = std::fs::read_dir(folder.expect("an entry").path()) else {
            continue;
        };
        for file in files
            .map(|f| f.expect("an entry").path())
            .filter(|f| f.extension().is_some_and(|e| e == "rs"))
        {
            if std::fs::read_to_string(&file)
                .expect("a source")
                .starts_with("// Written by data/fits/")
            {
                let name = file.strip_prefix(env!("CARGO_MANIFEST_DIR")).expect("below the root");
                let name = name.to_string_lossy().replace('\\', "/");
                assert!(listed.contains(&name), "{name} is not in fits.csv");
                found += 1;
            }
        }
    }
    assert_eq!(found, listed.len());
}

#[test]
fn a_changed_last_digit_changes_the_hash() {
    let source = "/// 9.5\nconst A: [f64; 2] = [0.1, -2.5e-07]; // 3.5\nconst B: f32 = 1.0;";
    assert_eq!(literals(source), [0.1, -2.5e-7, 1.0]);
    assert_ne!(
        hash(&literals(source)),
        hash(&literals(&source.replace("2.5e-07", "2.500000000000001e-07")))
    );
    for fit in fits() {
        let mut numbers = literals(&read(&fit.file));
        for i in (0..numbers.len()).step_by(7) {
            let kept = numbers[i];
            numbers[i] = f64::from_bits(kept.to_bits() ^ 1);
            assert_ne!(hash(&numbers), fit.hash, "{}, number {i}", fit.file);
            numbers[i] = kept;
        }
    }
}
