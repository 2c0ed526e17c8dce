//! The semantic tokens that a client has, so that only changes to them have to be sent.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use gen_lsp_types::{
    SemanticToken, SemanticTokens, SemanticTokensDelta, SemanticTokensDeltaResponse,
    SemanticTokensEdit, Uri,
};

/// The last tokens that were sent for each open file.
#[derive(Default)]
pub(super) struct TokensSent(Mutex<Sent>);

#[derive(Default)]
struct Sent {
    /// The name of the next result.
    next: u64,
    /// The open files, each with its last result. Nothing is kept about other files, which are never closed.
    files: HashMap<Uri, Option<Named>>,
}

/// The tokens of a result, and its name.
type Named = (String, Vec<SemanticToken>);

impl TokensSent {
    fn sent(&self) -> MutexGuard<'_, Sent> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Begins to keep the tokens that are sent for a file, which is open now.
    pub(super) fn open(&self, uri: &Uri) {
        self.sent().files.entry(uri.clone()).or_default();
    }

    /// Keeps tokens that are sent whole, under a new name, if the file is open. It may have been closed meanwhile.
    pub(super) fn keep(&self, uri: &Uri, data: Vec<SemanticToken>) -> SemanticTokens {
        let mut sent = self.sent();
        let name = sent.name();
        let kept = sent.files.get_mut(uri).map(|kept| {
            *kept = Some((name.clone(), data.clone()));
            name
        });
        SemanticTokens {
            result_id: kept,
            data,
        }
    }

    /// The difference of `data` from the tokens with the name `previous`; all tokens if the client has others.
    pub(super) fn delta(
        &self,
        uri: &Uri,
        previous: &str,
        data: Vec<SemanticToken>,
    ) -> SemanticTokensDeltaResponse {
        let old = self.sent().files.get_mut(uri).and_then(Option::take);
        let old = old.filter(|(name, _)| name == previous);
        let edits = old.map(|(_, old)| edits(&old, &data));
        let whole = self.keep(uri, data);
        match edits {
            None => whole.into(),
            Some(edits) => SemanticTokensDelta {
                result_id: whole.result_id,
                edits,
            }
            .into(),
        }
    }

    pub(super) fn forget(&self, uri: &Uri) {
        self.sent().files.remove(uri);
    }
}

impl Sent {
    fn name(&mut self) -> String {
        self.next += 1;
        self.next.to_string()
    }
}

/// The edit that replaces all tokens between those that are the same at the start and those that are the same at the
/// end; no edit if all are the same.
fn edits(old: &[SemanticToken], new: &[SemanticToken]) -> Vec<SemanticTokensEdit> {
    let same = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    if same == old.len() && same == new.len() {
        return Vec::new();
    }
    let (old, new) = (&old[same..], &new[same..]);
    let after = (old.iter().rev().zip(new.iter().rev()))
        .take_while(|(a, b)| a == b)
        .count();
    let data = new[..new.len() - after].iter().flat_map(|t| {
        [
            t.delta_line,
            t.delta_start,
            t.length,
            t.token_type,
            t.token_modifiers_bitset,
        ]
    });
    let data: Vec<u32> = data.collect();
    vec![SemanticTokensEdit {
        start: 5 * same as u32,
        delete_count: 5 * (old.len() - after) as u32,
        data: (!data.is_empty()).then_some(data),
    }]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(n: u32) -> Vec<SemanticToken> {
        let token = |i| SemanticToken {
            delta_line: 1,
            delta_start: i,
            length: 1,
            token_type: 0,
            token_modifiers_bitset: 0,
        };
        (0..n).map(token).collect()
    }

    /// Whatever is asked for, and in whatever order: of what is not open, nothing is kept.
    #[test]
    fn only_of_open_files_something_is_kept() {
        let sent = TokensSent::default();
        let uri = Uri::from("file:///a.zpg");
        let kept = || -> usize { sent.sent().files.values().flatten().count() };
        let is_whole = |answer| matches!(answer, SemanticTokensDeltaResponse::SemanticTokens(_));
        assert_eq!(sent.keep(&uri, tokens(3)).result_id, None);
        assert!(is_whole(sent.delta(&uri, "1", tokens(3))));
        assert_eq!(kept(), 0);
        sent.open(&uri);
        let name = sent.keep(&uri, tokens(3)).result_id.expect("a name");
        assert!(!is_whole(sent.delta(&uri, &name, tokens(4))));
        assert!(is_whole(sent.delta(&uri, &name, tokens(5))));
        assert_eq!(kept(), 1);
        // An answer that is made when the file has just been closed.
        sent.forget(&uri);
        assert_eq!(sent.keep(&uri, tokens(3)).result_id, None);
        assert!(sent.sent().files.is_empty());
    }
}
