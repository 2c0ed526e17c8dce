//! Code actions that change a whole file. Their edits are computed once an action is chosen: for a large scene this
//! takes long, and clients ask for actions at every move of the cursor.

use gen_lsp_types::{CodeAction, Command};
use serde_json::{Value, json};

use super::ask::Ask;
use super::convert::Convert;
use super::documents::Snapshot;
use super::refusal::Refusal;
use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Edit};
use crate::features::{actions, rename};

/// An action of a whole file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WholeFile {
    /// Applies all safe fixes.
    FixAll,
    /// Numbers all IDs anew.
    Renumber,
}

impl WholeFile {
    pub(super) const ALL: [WholeFile; 2] = [WholeFile::FixAll, WholeFile::Renumber];

    /// The action's kind in the protocol.
    pub(super) fn kind(self) -> &'static str {
        match self {
            WholeFile::FixAll => "source.fixAll.zpg",
            WholeFile::Renumber => "refactor.rewrite.renumber",
        }
    }

    /// The command that takes the URI of an open file and asks the client for the edit.
    pub(super) fn command(self) -> &'static str {
        match self {
            WholeFile::FixAll => "zpg.fixAll",
            WholeFile::Renumber => "zpg.renumber",
        }
    }

    fn title(self) -> &'static str {
        match self {
            WholeFile::FixAll => "lsp-fix-all",
            WholeFile::Renumber => "lsp-renumber",
        }
    }

    /// Whether the action may have something to do, by a quick check.
    pub(super) fn is_of_use(self, analysis: &Analysis) -> bool {
        match self {
            WholeFile::FixAll => actions::has_safe_fixes(analysis),
            WholeFile::Renumber => rename::can_renumber(analysis),
        }
    }

    pub(super) fn edits(self, file: &Snapshot) -> Vec<Edit> {
        match self {
            WholeFile::FixAll => actions::fix_all(file.analysis(), &file.settings()),
            WholeFile::Renumber => rename::renumber(file.analysis()).unwrap_or_default(),
        }
    }

    /// The action as it is offered. A client that resolves actions gets the edit once it has chosen the action. Another
    /// one gets the edit at once if it asks for this kind, or later by a command. `None` for a client that can do
    /// neither.
    pub(super) fn offer(self, ask: &Ask, convert: &Convert, by_kind: bool) -> Option<CodeAction> {
        let uri = json!(convert.file.uri);
        let title = ask.client.language.say(self.title(), &[]);
        let mut action = CodeAction {
            title: title.clone(),
            kind: Some(self.kind().to_owned().into()),
            ..CodeAction::default()
        };
        match () {
            () if ask.client.resolves_edits => action.data = Some(json!({ "uri": uri })),
            () if by_kind => {
                let edits = self.edits(convert.file);
                if edits.is_empty() {
                    return None;
                }
                action.edit = Some(convert.workspace_edit(&edits));
            }
            () if ask.client.applies_edits => {
                action.command = Some(Command {
                    title,
                    tooltip: None,
                    command: self.command().to_owned(),
                    arguments: Some(vec![uri]),
                });
            }
            () => return None,
        }
        Some(action)
    }

    /// Has the client make the edit, if there is something to do.
    ///
    /// # Errors
    ///
    /// There is no such file, or the client makes no edits that the server asks for.
    pub(super) fn apply(self, ask: &Ask, file: &Snapshot) -> Result<Value, Refusal> {
        if file.is_missing {
            let why = Complaint::new("lsp-missing").with("path", file.name());
            return Err(ask.refuse(&why));
        }
        if !ask.client.applies_edits {
            let why = Complaint::new("lsp-no-edits").with("kind", self.kind());
            return Err(ask.refuse(&why));
        }
        let edits = self.edits(file);
        if !edits.is_empty() {
            let edit = ask.convert(file).workspace_edit(&edits);
            let label = ask.client.language.say(self.title(), &[]);
            let params = json!({ "label": label, "edit": edit });
            ask.outgoing.request("workspace/applyEdit", params);
        }
        Ok(Value::Null)
    }
}
