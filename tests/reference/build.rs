//! Links GSL and libcerf where their features ask for them.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var_os("CARGO_FEATURE_GSL").is_some() {
        println!("cargo::rustc-link-lib=gsl");
        println!("cargo::rustc-link-lib=gslcblas");
        println!("cargo::rustc-link-lib=m");
    }
    if std::env::var_os("CARGO_FEATURE_LIBCERF").is_some() {
        println!("cargo::rustc-link-lib=cerf");
    }
}
