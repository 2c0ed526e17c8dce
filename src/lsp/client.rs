//! The abilities and wishes of the client.

use gen_lsp_types::Uri;
use serde::Deserialize;
use serde_json::Value;

use super::position::Units;
use crate::diagnostics::Language;
use crate::features::hints::Wanted;

/// The abilities of the client.
#[derive(Debug, Clone, Default)]
pub(super) struct Client {
    pub units: Units,
    pub language: Language,
    /// Whether the client asks for diagnostics itself, so that none are sent unasked.
    pub pulls: bool,
    pub snippets: bool,
    /// Whether symbols of a file may be a tree.
    pub symbol_trees: bool,
    pub markdown: bool,
    /// Whether the client shows the text about a parameter. Eglot 1.17, of Emacs 30, fails at the last parameter of a
    /// signature if it has any text.
    pub shows_parameters: bool,
    /// Whether the client asks for the edit of a code action later, once the action is chosen.
    pub resolves_edits: bool,
    /// Whether the server may ask the client to make edits.
    pub applies_edits: bool,
    /// Whether edits may name the version that they are for.
    pub versioned_edits: bool,
    /// Whether the client shows documents when asked to.
    pub shows_documents: bool,
    pub watches_files: bool,
    pub refreshes_hints: bool,
    pub refreshes_diagnostics: bool,
    /// The process of the client: the server ends soon after it.
    pub process: Option<u32>,
}

/// The user's preferences; the client sends them at the start and when they change.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Preferences {
    pub hints: Wanted,
    /// Whether hovers have pictures.
    pub pictures: bool,
    /// Whether there are buttons above records.
    pub lenses: bool,
    /// Whether a client that asks for diagnostics gets those of all scenes in its folders; otherwise only of the open
    /// ones.
    pub whole_folder: bool,
    /// The commands of the client that buttons may call: `zpg.preview`, `zpg.showReferences`.
    pub commands: Vec<String>,
}

impl Default for Preferences {
    fn default() -> Preferences {
        Preferences {
            hints: Wanted::default(),
            pictures: false,
            lenses: true,
            whole_folder: true,
            commands: Vec::new(),
        }
    }
}

impl Preferences {
    /// Reads the preferences that a client sends, either alone or under the key `zpg`. Preferences that cannot be read
    /// change nothing.
    pub(super) fn read(&mut self, sent: &Value) {
        let mut merged = match sent.get("zpg") {
            Some(own) => own.clone(),
            None => sent.clone(),
        };
        let Some(fields) = merged.as_object_mut() else {
            return;
        };
        // A list would be read as the fields of the hints in their order.
        if fields.get("hints").is_some_and(|hints| !hints.is_object()) {
            return;
        }
        // Clients send their commands only once: they are kept.
        fields
            .entry("commands")
            .or_insert_with(|| self.commands.clone().into());
        if let Ok(new) = serde_json::from_value(merged) {
            *self = new;
        }
    }
}

impl Client {
    /// Reads the parameters of `initialize`. Parameters that cannot be understood count as missing.
    ///
    /// The fields are looked up one by one: a deserialiser of all parameters would take half a megabyte of the program.
    pub(super) fn of(sent: &Value, language: Language) -> Client {
        let capability = |path: &str| sent.pointer(&format!("/capabilities/{path}"));
        let can = |path: &str| capability(path) == Some(&Value::Bool(true));
        let list = |path: &str| capability(path).and_then(Value::as_array);
        let text = |path: &str| sent.pointer(path).and_then(Value::as_str);
        let wanted = text("/initializationOptions/lang")
            .or(text("/initializationOptions/zpg/lang"))
            .and_then(Language::of_tag);
        let czech = text("/locale").is_some_and(|l| l.starts_with("cs"));
        let encodings = list("general/positionEncodings");
        let edits_later = list("textDocument/codeAction/resolveSupport/properties");
        Client {
            units: Units::chosen(encodings.map_or(&[], Vec::as_slice)),
            language: wanted.unwrap_or(if czech { Language::Czech } else { language }),
            pulls: capability("textDocument/diagnostic").is_some_and(Value::is_object),
            snippets: can("textDocument/completion/completionItem/snippetSupport"),
            symbol_trees: can("textDocument/documentSymbol/hierarchicalDocumentSymbolSupport"),
            markdown: list("textDocument/hover/contentFormat")
                .is_none_or(|all| all.iter().any(|f| f == "markdown")),
            shows_parameters: text("/clientInfo/name") != Some("Eglot"),
            resolves_edits: edits_later.is_some_and(|all| all.iter().any(|p| p == "edit")),
            applies_edits: can("workspace/applyEdit"),
            versioned_edits: can("workspace/workspaceEdit/documentChanges"),
            shows_documents: can("window/showDocument/support"),
            watches_files: can("workspace/didChangeWatchedFiles/dynamicRegistration"),
            refreshes_hints: can("workspace/inlayHint/refreshSupport"),
            refreshes_diagnostics: can("workspace/diagnostics/refreshSupport"),
            process: sent["processId"].as_u64().and_then(|id| id.try_into().ok()),
        }
    }
}

/// The folders that the client has open.
pub(super) fn folders(sent: &Value) -> Vec<Uri> {
    let read = |uri: &Value| uri.as_str().map(Uri::from);
    match sent["workspaceFolders"].as_array() {
        Some(all) => all.iter().filter_map(|f| read(&f["uri"])).collect(),
        // Older clients send a single folder.
        None => read(&sent["rootUri"]).into_iter().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn said(sent: Value) -> Client {
        Client::of(&sent, Language::English)
    }

    /// A value of another form than the protocol's is passed over, and so is an unknown one.
    #[test]
    fn what_cannot_be_read_counts_as_not_said() {
        let silent = format!("{:?}", said(json!({})));
        for sent in [
            json!(null),
            json!([1]),
            json!({ "processId": null, "locale": 7, "clientInfo": [], "capabilities": null }),
            json!({ "processId": -1, "capabilities": {
                "general": { "positionEncodings": ["utf-7", 3] },
                "textDocument": {
                    "diagnostic": true,
                    "hover": { "contentFormat": "plaintext" },
                    "codeAction": { "resolveSupport": ["edit"] },
                    "completion": { "completionItem": { "snippetSupport": "yes" } },
                },
                "window": 1,
                "workspace": { "inlayHint": { "refreshSupport": null } },
                "future": { "of": "any kind" },
            } }),
        ] {
            assert_eq!(format!("{:?}", said(sent.clone())), silent, "{sent}");
        }
    }

    /// Settings of any other form change nothing.
    #[test]
    fn settings_that_are_none_count_as_not_said() {
        let mut before = Preferences::default();
        before.read(&json!({
            "hints": { "types": false }, "lenses": false, "pictures": true, "commands": ["zpg.preview"],
        }));
        let no_objects = [
            json!(null),
            json!([]),
            json!([{ "types": false }]),
            json!([{}, true, true, true, []]),
            json!(7),
            json!("on"),
            json!(true),
        ];
        for odd in no_objects {
            let nested = json!({ "hints": odd });
            for sent in [
                &odd,
                &json!({ "zpg": odd }),
                &nested,
                &json!({ "zpg": nested }),
            ] {
                let mut after = before.clone();
                after.read(sent);
                assert_eq!(after, before, "{sent}");
            }
        }
        let mut after = before.clone();
        after.read(&json!({ "zpg": { "lenses": true } }));
        assert_eq!((after.lenses, &after.commands), (true, &before.commands));
    }

    #[test]
    fn what_is_said_counts() {
        let client = said(json!({
            "processId": 4_000_000_000u32,
            "locale": "cs-CZ",
            "clientInfo": { "name": "Eglot" },
            "capabilities": {
                "general": { "positionEncodings": ["utf-7", 3, "utf-16", "utf-32"] },
                "textDocument": {
                    "diagnostic": {},
                    "hover": { "contentFormat": ["plaintext"] },
                    "codeAction": { "resolveSupport": { "properties": ["command", "edit"] } },
                },
            },
        }));
        assert_eq!(client.process, Some(4_000_000_000));
        assert_eq!(client.units, Units::Utf32);
        assert_eq!(client.language, Language::Czech);
        assert!(client.pulls && client.resolves_edits);
        assert!(!client.markdown && !client.shows_parameters && !client.snippets);
    }

    #[test]
    fn folders_are_those_of_the_workspace_or_the_root() {
        let list = json!([{ "uri": "file:///a", "name": "a" }, { "name": "b" }]);
        let root = "file:///r";
        for (sent, all) in [
            (
                json!({ "workspaceFolders": list, "rootUri": root }),
                vec!["file:///a"],
            ),
            (json!({ "workspaceFolders": [], "rootUri": root }), vec![]),
            (
                json!({ "workspaceFolders": null, "rootUri": root }),
                vec![root],
            ),
            (json!({ "rootUri": root }), vec![root]),
            (json!({ "rootUri": null }), vec![]),
            (json!(null), vec![]),
        ] {
            let all: Vec<Uri> = all.into_iter().map(Uri::from).collect();
            assert_eq!(folders(&sent), all, "{sent}");
        }
    }
}
