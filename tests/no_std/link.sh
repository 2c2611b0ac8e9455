#!/usr/bin/env bash
# Links the library into a program without std and without a C library, and runs it.
set -euo pipefail
cd "$(dirname "$0")"
if [ "$(uname -sm)" != "Linux x86_64" ]; then
    printf '\n********\nSKIPPED: the no_std link proof needs Linux on x86-64\n********\n'
    exit 0
fi
export RUSTFLAGS="-C link-arg=-nostartfiles -C link-arg=-nostdlib -C link-arg=-static -C relocation-model=static"
# With a target named, the flags reach the program alone, not the build scripts.
cargo build --release --locked --target x86_64-unknown-linux-gnu --target-dir ../../target/no_std
../../target/no_std/x86_64-unknown-linux-gnu/release/no_std_proof
echo "no_std link proof: linked and ran"
