//! No start files, for there is no standard library for them to start; `memcpy` and its kin come from the C library.

fn main() {
    println!("cargo:rustc-link-arg=-nostartfiles");
    println!("cargo:rustc-link-arg=-lc");
}
