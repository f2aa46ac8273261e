//! Lists of choices.

use std::ops::Deref;

use serde::de::{Deserialize, Deserializer, Error};

/// Choices, at least one and none twice.
#[derive(Debug, Clone, PartialEq)]
pub struct Several<T>(Vec<T>);

impl<T, const N: usize> From<[T; N]> for Several<T> {
    /// Of at least one, all different.
    fn from(choices: [T; N]) -> Self {
        const { assert!(N > 0, "at least one choice") };
        Self(choices.into())
    }
}

impl<T> Deref for Several<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<'de, T: Deserialize<'de> + PartialEq> Deserialize<'de> for Several<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let list = Vec::<T>::deserialize(deserializer)?;
        if list.is_empty() {
            return Err(D::Error::custom("expected a list of at least one, found none"));
        }
        match (1..list.len()).find(|&index| list[..index].contains(&list[index])) {
            Some(index) => {
                let message = format!("entry {} of the list stands in it before", index + 1);
                Err(D::Error::custom(message))
            }
            None => Ok(Self(list)),
        }
    }
}
