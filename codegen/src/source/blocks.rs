//! Blocks without a brace, to be named where the brackets do not match: the bracket itself tells little.

use crate::ast::KEYWORDS;

/// The keywords that a brace follows directly.
const BLOCKS: [&str; 4] = ["flow", "residual", "update", "start"];

/// Line and column, counted from 1.
type Place = (usize, usize);

/// What has been seen of keywords and braces so far.
#[derive(Default)]
pub(super) struct Blocks {
    word: String,
    word_begins: Place,
    /// A keyword, its brace still to come.
    awaiting: Option<(String, Place)>,
    /// The first keyword without its brace.
    pub(super) unopened: Option<(String, Place)>,
    /// The first brace that is open where the next statement begins.
    pub(super) unclosed: Option<Place>,
}

impl Blocks {
    /// Takes in the next character outside comments and strings; `open` are the brackets around it.
    pub(super) fn take(&mut self, character: char, at: Place, open: &[(char, usize, usize)]) {
        let is_letter = character.is_alphanumeric() || character == '_';
        if !is_letter {
            self.end_word(open);
        }
        // A slash may begin a comment.
        if !character.is_whitespace()
            && character != '/'
            && let Some(keyword) = self.awaiting.take()
            && character != '{'
        {
            self.unopened.get_or_insert(keyword);
        }
        if is_letter {
            if self.word.is_empty() {
                self.word_begins = at;
            }
            self.word.push(character);
        }
    }

    fn end_word(&mut self, open: &[(char, usize, usize)]) {
        let word = std::mem::take(&mut self.word);
        if let [_, .., ('{', line, column)] = *open
            && KEYWORDS.contains(&word.as_str())
        {
            self.unclosed.get_or_insert((line, column));
        }
        if BLOCKS.contains(&word.as_str()) {
            self.awaiting = Some((word, self.word_begins));
        }
    }
}
