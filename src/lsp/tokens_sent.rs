//! The tokens that a client has, so that it can be told what is different.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use gen_lsp_types::{
    SemanticToken, SemanticTokens, SemanticTokensDelta, SemanticTokensDeltaResponse,
    SemanticTokensEdit, Uri,
};

/// The last tokens that were sent for each open file.
#[derive(Default)]
pub struct TokensSent(Mutex<Sent>);

#[derive(Default)]
struct Sent {
    /// The name of the next result.
    next: u64,
    files: HashMap<Uri, (String, Vec<SemanticToken>)>,
}

impl TokensSent {
    /// Keeps what is sent whole.
    pub fn keep(&self, uri: &Uri, data: Vec<SemanticToken>) -> SemanticTokens {
        let mut sent = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let name = sent.name();
        sent.files.insert(uri.clone(), (name.clone(), data.clone()));
        SemanticTokens {
            result_id: Some(name),
            data,
        }
    }

    /// What is different from the tokens of that name; all, if the client has others.
    pub fn delta(
        &self,
        uri: &Uri,
        previous: &str,
        data: Vec<SemanticToken>,
    ) -> SemanticTokensDeltaResponse {
        let old = {
            let mut sent = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            sent.files.remove(uri).filter(|(name, _)| name == previous)
        };
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

    pub fn forget(&self, uri: &Uri) {
        let mut sent = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        sent.files.remove(uri);
    }
}

impl Sent {
    fn name(&mut self) -> String {
        self.next += 1;
        self.next.to_string()
    }
}

/// One edit: what is between the tokens that are the same at the start and those at the end.
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
