//! What a misspelt word was meant to be.

/// The candidate with the name most like `word` by Jaro and Winkler, from 0 to 1, if one reaches `least`; of equals the
/// last. A larger `least` misses typing errors, a smaller one suggests what nobody meant.
pub fn most_similar<'n, C>(
    word: &str,
    candidates: impl IntoIterator<Item = (&'n str, C)>,
    least: f64,
) -> Option<C> {
    let scored = candidates
        .into_iter()
        .map(|(name, candidate)| (strsim::jaro_winkler(word, name), candidate))
        .filter(|(similarity, _)| *similarity >= least);
    let best = scored.max_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, candidate)| candidate)
}
