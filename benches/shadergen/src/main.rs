//! Writes the WGSL, GLSL and HLSL text of the library, or with `--check` tells whether it is current.

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (check, root) = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => (false, shadergen::root()),
        ["--check"] => (true, shadergen::root()),
        ["--root", root] => (false, root.into()),
        ["--check", "--root", root] => (true, root.into()),
        _ => {
            eprintln!("usage: shadergen [--check] [--root REPOSITORY]");
            return ExitCode::from(2);
        }
    };
    let files = match shadergen::library(&root).and_then(|translation| shadergen::outputs(&translation)) {
        Ok(files) => files,
        Err(reason) => {
            eprintln!("shadergen: {reason}");
            return ExitCode::from(2);
        }
    };
    let mut code = ExitCode::SUCCESS;
    for file in files.iter().filter(|file| file.is_stale(&root)) {
        let path = root.join("src/shader").join(file.path);
        if check {
            eprintln!(
                "shadergen: src/shader/{} is stale: run `cargo run -p shadergen`",
                file.path
            );
            code = ExitCode::FAILURE;
        } else if let Err(e) = write(&path, &file.text) {
            eprintln!("shadergen: {}: {e}", path.display());
            code = ExitCode::from(2);
        } else {
            println!("wrote src/shader/{}", file.path);
        }
    }
    code
}

fn write(path: &std::path::Path, text: &str) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(path, text)
}
