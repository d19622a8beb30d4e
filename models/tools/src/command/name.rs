//! What a model may be called. Shared with the build script.

/// Checks the stem of a model file, which becomes a Rust module: lower-case ASCII, no keyword.
pub fn check(name: &str) -> Result<(), String> {
    let starts_well = name.starts_with(|c: char| c.is_ascii_lowercase());
    let goes_on_well = name
        .chars()
        .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
    if !starts_well || !goes_on_well {
        return Err(format!(
            "`{name}` cannot name a model: write lower-case letters, digits and `_`, starting with a letter"
        ));
    }
    syn::parse_str::<syn::Ident>(name)
        .map(drop)
        .map_err(|_| format!("`{name}` cannot name a model: it is a Rust keyword"))
}
