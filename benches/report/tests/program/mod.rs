//! The program `report`, run with arguments and a standard input.

use std::io::Write;
use std::process::{Command, Output, Stdio};

/// What the program says to these arguments and this input.
pub fn report(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_report"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("piped");
    let input = input.as_bytes().to_vec();
    // A refused row ends the reading; what is still unwritten then meets a closed pipe.
    let writer = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the program ends");
    writer.join().expect("the writer ends");
    output
}

/// The lines of an output.
pub fn lines(bytes: &[u8]) -> Vec<String> {
    String::from_utf8(bytes.to_vec())
        .expect("UTF-8")
        .lines()
        .map(str::to_string)
        .collect()
}

/// The numbers of each line of standard output.
pub fn rows(output: &Output) -> Vec<Vec<f64>> {
    let numbers = |line: &String| line.split(' ').map(|word| word.parse().expect("a number")).collect();
    lines(&output.stdout).iter().map(numbers).collect()
}
