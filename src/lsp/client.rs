//! What the client can and wants.

use gen_lsp_types::InitializeParams;
use serde::Deserialize;
use serde_json::Value;

use super::position::Units;
use crate::diagnostics::Language;
use crate::features::hints::Wanted;

/// What the client can.
#[derive(Debug, Clone, Default)]
pub struct Client {
    pub units: Units,
    pub language: Language,
    /// It asks for diagnostics itself, so none are sent unasked.
    pub pulls: bool,
    pub snippets: bool,
    pub markdown: bool,
    /// It shows what is said of a parameter. Eglot 1.17, of Emacs 30, fails at the last parameter of a signature
    /// if anything is said of it.
    pub shows_parameters: bool,
    /// Code actions may get their edits later.
    pub resolves_edits: bool,
    /// Edits may name the version that they are for.
    pub versioned_edits: bool,
    /// It shows documents when asked to.
    pub shows_documents: bool,
    pub watches_files: bool,
    pub refreshes_hints: bool,
    pub refreshes_diagnostics: bool,
    /// The process that is to be outlived by no server.
    pub process: Option<i32>,
}

/// What the user wants; the client sends it at the start and when it changes.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Preferences {
    pub hints: Wanted,
    /// Pictures in hovers.
    pub pictures: bool,
    /// Buttons above records.
    pub lenses: bool,
    /// Findings of all scenes in the folder, for clients that ask for them; not only of the open ones.
    pub whole_folder: bool,
    /// Commands of the client's own that buttons may call: `zpg.preview`, `zpg.showReferences`.
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
    /// Reads what a client sends, as it is or under `zpg`. What cannot be understood changes nothing.
    pub fn read(&mut self, sent: &Value) {
        let mut merged = match sent.get("zpg") {
            Some(own) => own.clone(),
            None => sent.clone(),
        };
        // Commands are told once.
        if let Some(fields) = merged.as_object_mut() {
            fields
                .entry("commands")
                .or_insert_with(|| self.commands.clone().into());
        }
        if let Ok(new) = serde_json::from_value(merged) {
            *self = new;
        }
    }
}

impl Client {
    pub fn of(params: &InitializeParams, language: Language) -> Client {
        let all = &params.capabilities;
        let text = all.text_document.as_ref();
        let workspace = all.workspace.as_ref();
        let window = all.window.as_ref();
        let offered = all
            .general
            .as_ref()
            .and_then(|g| g.position_encodings.as_deref());
        let czech = params
            .locale
            .as_deref()
            .is_some_and(|l| l.starts_with("cs"));
        let item = text.and_then(|t| t.completion.as_ref()?.completion_item.as_ref());
        let formats = text.and_then(|t| t.hover.as_ref()?.content_format.as_deref());
        let resolves = text.and_then(|t| t.code_action.as_ref()?.resolve_support.as_ref());
        Client {
            units: Units::chosen(offered),
            language: if czech { Language::Czech } else { language },
            pulls: text.is_some_and(|t| t.diagnostic.is_some()),
            snippets: item.and_then(|i| i.snippet_support) == Some(true),
            markdown: formats.is_none_or(|f| f.contains(&gen_lsp_types::MarkupKind::Markdown)),
            shows_parameters: params
                .client_info
                .as_ref()
                .is_none_or(|c| c.name != "Eglot"),
            resolves_edits: resolves.is_some_and(|r| r.properties.iter().any(|p| p == "edit")),
            versioned_edits: workspace.and_then(|w| w.workspace_edit.as_ref()?.document_changes)
                == Some(true),
            shows_documents: window.and_then(|w| Some(w.show_document.as_ref()?.support))
                == Some(true),
            watches_files: workspace
                .and_then(|w| w.did_change_watched_files.as_ref()?.dynamic_registration)
                == Some(true),
            refreshes_hints: workspace.and_then(|w| w.inlay_hint.as_ref()?.refresh_support)
                == Some(true),
            refreshes_diagnostics: workspace.and_then(|w| w.diagnostics.as_ref()?.refresh_support)
                == Some(true),
            process: params.process_id,
        }
    }
}
