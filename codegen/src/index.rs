//! Finding an equal member of a list: by its hash, so that no member is held twice.

use std::collections::HashMap;
use std::hash::DefaultHasher;
use std::hash::Hash;
use std::hash::Hasher;

/// The positions of the members of a list of distinct values, by hash.
#[derive(Clone, Debug, Default)]
pub struct Index {
    /// The last member with each hash.
    last: HashMap<u64, usize>,
    /// For each member the one before it with the same hash.
    before: Vec<Option<usize>>,
}

impl Index {
    /// Where `value` stands in `list`, every member of which has been pushed; otherwise its hash.
    ///
    /// # Errors
    /// The hash of a value that is not in the list.
    pub fn find<T: Hash + Eq>(&self, list: impl Fn(usize) -> T, value: T) -> Result<usize, u64> {
        let mut hasher = DefaultHasher::new();
        value.hash(&mut hasher);
        let hash = hasher.finish();
        let mut next = self.last.get(&hash).copied();
        while let Some(position) = next {
            if list(position) == value {
                return Ok(position);
            }
            next = self.before[position];
        }
        Err(hash)
    }

    /// Says that a value with this hash is the next member of the list.
    pub fn push(&mut self, hash: u64) {
        let position = self.before.len();
        self.before.push(self.last.insert(hash, position));
    }
}

#[cfg(test)]
mod tests {
    use super::Index;

    #[test]
    fn members_are_told_apart_even_if_their_hashes_are_equal() {
        let list = ["a", "b", "c"];
        let mut index = Index::default();
        let Err(hash) = index.find(|i| list[i], "b") else {
            panic!("found in an empty list");
        };
        list.iter().for_each(|_| index.push(hash));
        assert_eq!(index.find(|i| list[i], "b"), Ok(1));
        assert!(index.find(|i| list[i], "d").is_err());
    }
}
