//! Converts results of the features into the protocol's types.

use gen_lsp_types::{
    ActiveParameter, BaseSymbolInformation, CallHierarchyItem, Code, CodeLens, Color,
    ColorInformation, Command, CompletionItem, CompletionItemKind, CompletionItemLabelDetails,
    Contents, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag,
    DocumentHighlight, DocumentHighlightKind, DocumentSymbol, Documentation, Edit as LspEdit,
    FoldingRange, FoldingRangeKind, Hover, InlayHint, InlayHintKind, InsertTextFormat, Label,
    Location, MarkupContent, MarkupKind, Message, OptionalVersionedTextDocumentIdentifier,
    ParameterInformation, ParameterInformationLabel, SelectionRange, SemanticToken, SignatureHelp,
    SignatureInformation, SymbolInformation, SymbolKind, TextDocumentEdit, TextDocumentIdentifier,
    TextEdit, Tooltip, Uri, WorkspaceEdit,
};
use serde_json::json;

use super::client::{Client, Preferences};
use super::documents::Snapshot;
use super::position::Places;
use crate::diagnostics::{Complaint, Edit, Severity, Span};
use crate::features::{
    calls, colours, completion, folding, hints, hover, lenses, problems, signature, symbols,
    tokens, uses,
};

/// Converts answers about one file into the protocol's types.
pub(super) struct Convert<'a> {
    pub file: &'a Snapshot,
    pub client: &'a Client,
    pub places: Places<'a>,
}

impl<'a> Convert<'a> {
    pub(super) fn new(file: &'a Snapshot, client: &'a Client) -> Convert<'a> {
        let places = Places::new(&file.analysis().source, client.units);
        Convert {
            file,
            client,
            places,
        }
    }

    fn uri(&self) -> Uri {
        self.file.uri.clone()
    }

    pub(super) fn location(&self, span: Span) -> Location {
        Location {
            uri: self.uri(),
            range: self.places.range(span),
        }
    }

    pub(super) fn diagnostic(&self, problem: &problems::Problem) -> Diagnostic {
        let severity = match problem.severity {
            Severity::Error => DiagnosticSeverity::Error,
            Severity::Warning => DiagnosticSeverity::Warning,
            Severity::Note => DiagnosticSeverity::Information,
            Severity::Style => DiagnosticSeverity::Hint,
        };
        let related = problem.related.iter().map(|(span, message)| {
            let location = self.location(*span);
            DiagnosticRelatedInformation {
                location,
                message: message.clone(),
            }
        });
        let related: Vec<_> = related.collect();
        Diagnostic {
            range: self.places.range(problem.span),
            severity: Some(severity),
            code: problem.code.map(|c| Code::String(c.as_str().to_owned())),
            code_description: None,
            source: Some("zpg".to_owned()),
            message: Message::String(problem.message.clone()),
            tags: problem
                .unnecessary
                .then(|| vec![DiagnosticTag::Unnecessary]),
            related_information: (!related.is_empty()).then_some(related),
            data: None,
        }
    }

    /// The diagnostic about the settings of the file's folder.
    pub(super) fn config_diagnostic(&self, complaint: &Complaint) -> Diagnostic {
        Diagnostic {
            range: self.places.range(Span::default()),
            severity: Some(DiagnosticSeverity::Error),
            source: Some("zpg".to_owned()),
            message: Message::String(complaint.wording(self.client.language)),
            ..Diagnostic::default()
        }
    }

    /// All diagnostics of the file.
    pub(super) fn diagnostics(&self) -> Vec<Diagnostic> {
        if self.file.is_excluded() || self.file.is_missing {
            return Vec::new();
        }
        let config = self
            .file
            .config
            .as_ref()
            .err()
            .map(|c| self.config_diagnostic(c));
        let problems = problems::problems(self.file.analysis(), self.client.language);
        let all = problems.iter().map(|p| self.diagnostic(p));
        config.into_iter().chain(all).collect()
    }

    pub(super) fn text_edit(&self, edit: &Edit) -> TextEdit {
        TextEdit {
            range: self.places.range(edit.span),
            new_text: edit.text.clone(),
        }
    }

    pub(super) fn text_edits(&self, edits: &[Edit]) -> Vec<TextEdit> {
        edits.iter().map(|e| self.text_edit(e)).collect()
    }

    pub(super) fn workspace_edit(&self, edits: &[Edit]) -> WorkspaceEdit {
        let edits = self.text_edits(edits);
        if !self.client.versioned_edits {
            return WorkspaceEdit {
                changes: Some([(self.uri(), edits)].into()),
                ..WorkspaceEdit::default()
            };
        }
        let file = OptionalVersionedTextDocumentIdentifier {
            version: self.file.version,
            text_document_identifier: TextDocumentIdentifier { uri: self.uri() },
        };
        let edits = edits.into_iter().map(LspEdit::TextEdit).collect();
        let edit = TextDocumentEdit {
            text_document: file,
            edits,
        };
        WorkspaceEdit {
            document_changes: Some(vec![edit.into()]),
            ..WorkspaceEdit::default()
        }
    }

    pub(super) fn markup(&self, markdown: String) -> MarkupContent {
        let kind = match self.client.markdown {
            true => MarkupKind::Markdown,
            false => MarkupKind::PlainText,
        };
        MarkupContent {
            kind,
            value: markdown,
        }
    }

    pub(super) fn hover(&self, hover: hover::Hover) -> Hover {
        Hover {
            contents: Contents::MarkupContent(self.markup(hover.markdown)),
            range: Some(self.places.range(hover.span)),
        }
    }

    pub(super) fn hint(&self, hint: hints::Hint) -> InlayHint {
        let is_name = hint.kind == hints::Kind::Parameter;
        InlayHint {
            position: self.places.position(hint.at),
            label: Label::String(hint.text),
            kind: Some(match is_name {
                true => InlayHintKind::Parameter,
                false => InlayHintKind::Type,
            }),
            text_edits: None,
            tooltip: Some(Tooltip::String(hint.doc)),
            padding_left: (!is_name).then_some(true),
            padding_right: None,
            data: None,
        }
    }

    pub(super) fn signature(&self, signature: signature::Signature) -> SignatureHelp {
        // Offsets in labels are counted in UTF-16, whatever units were agreed on.
        let units = |byte: usize| signature.label[..byte].encode_utf16().count() as u32;
        let parameters = signature.params.iter().map(|p| ParameterInformation {
            label: ParameterInformationLabel::Tuple((units(p.at.0), units(p.at.1))),
            documentation: (self.client.shows_parameters)
                .then(|| Documentation::String(p.doc.clone())),
        });
        let parameters: Vec<_> = parameters.collect();
        // A number behind the last parameter means that none is active.
        let active = signature.active.unwrap_or(parameters.len()) as u32;
        let only = SignatureInformation {
            label: signature.label,
            documentation: Some(Documentation::String(signature.doc)),
            parameters: Some(parameters),
            active_parameter: None,
        };
        SignatureHelp {
            signatures: vec![only],
            active_signature: Some(0),
            active_parameter: Some(ActiveParameter::Int(active)),
        }
    }

    pub(super) fn completion(&self, completion: completion::Completion) -> Vec<CompletionItem> {
        let range = self.places.range(completion.word);
        let all = completion.proposals.into_iter().enumerate();
        all.map(|(i, p)| self.proposal(i, p, range)).collect()
    }

    fn proposal(
        &self,
        place: usize,
        proposal: completion::Proposal,
        range: gen_lsp_types::Range,
    ) -> CompletionItem {
        let has_places = proposal.insert.has_places();
        let (text, format) = match has_places && self.client.snippets {
            true => (proposal.insert.snippet(), InsertTextFormat::Snippet),
            false => (proposal.insert.plain(), InsertTextFormat::PlainText),
        };
        let kind = match proposal.kind {
            completion::Sort::Shape => CompletionItemKind::Class,
            completion::Sort::Operation => CompletionItemKind::Operator,
            completion::Sort::Other => CompletionItemKind::Keyword,
            completion::Sort::Scene => CompletionItemKind::Snippet,
            completion::Sort::Id => CompletionItemKind::Variable,
            completion::Sort::Value => CompletionItemKind::Value,
            completion::Sort::File => CompletionItemKind::File,
        };
        let doc = (!proposal.doc.is_empty()).then(|| self.markup(proposal.doc));
        CompletionItem {
            label: proposal.label,
            label_details: Some(CompletionItemLabelDetails {
                detail: None,
                description: Some(proposal.detail.clone()),
            }),
            kind: Some(kind),
            detail: Some(proposal.detail),
            documentation: doc.map(Documentation::MarkupContent),
            sort_text: Some(format!("{place:04}")),
            filter_text: Some(proposal.filter),
            insert_text_format: Some(format),
            text_edit: Some(
                TextEdit {
                    range,
                    new_text: text,
                }
                .into(),
            ),
            ..CompletionItem::default()
        }
    }

    pub(super) fn highlight(&self, span: Span, kind: Option<uses::Kind>) -> DocumentHighlight {
        DocumentHighlight {
            range: self.places.range(span),
            kind: Some(match kind {
                None => DocumentHighlightKind::Text,
                Some(uses::Kind::Reference) => DocumentHighlightKind::Read,
                Some(uses::Kind::Definition | uses::Kind::Change) => DocumentHighlightKind::Write,
            }),
        }
    }

    #[allow(deprecated)]
    pub(super) fn symbol(&self, symbol: symbols::Symbol) -> DocumentSymbol {
        let children: Vec<_> = symbol
            .children
            .into_iter()
            .map(|s| self.symbol(s))
            .collect();
        DocumentSymbol {
            name: symbol.name,
            detail: Some(symbol.detail).filter(|d| !d.is_empty()),
            kind: symbol_kind(symbol.sort),
            tags: None,
            deprecated: None,
            range: self.places.range(symbol.span),
            selection_range: self.places.range(symbol.id_span),
            children: (!children.is_empty()).then_some(children),
        }
    }

    /// Appends the symbols of a tree one after the other, each with the name of the symbol that it is in.
    #[allow(deprecated)]
    pub(super) fn flat_symbols(
        &self,
        symbols: Vec<symbols::Symbol>,
        within: Option<&str>,
        out: &mut Vec<SymbolInformation>,
    ) {
        for symbol in symbols {
            out.push(SymbolInformation {
                deprecated: None,
                location: self.location(symbol.span),
                base_symbol_information: BaseSymbolInformation {
                    name: symbol.name.clone(),
                    kind: symbol_kind(symbol.sort),
                    tags: None,
                    container_name: within.map(str::to_owned),
                },
            });
            self.flat_symbols(symbol.children, Some(&symbol.name), out);
        }
    }

    pub(super) fn call_item(&self, node: calls::Node) -> CallHierarchyItem {
        CallHierarchyItem {
            name: node.name,
            kind: symbol_kind(node.sort),
            tags: None,
            detail: Some(node.detail),
            uri: self.uri(),
            range: self.places.range(node.span),
            selection_range: self.places.range(node.id_span),
            data: Some(json!(node.id)),
        }
    }

    pub(super) fn fold(&self, fold: &folding::Fold) -> FoldingRange {
        FoldingRange {
            start_line: fold.first as u32,
            end_line: fold.last as u32,
            kind: match fold.kind {
                folding::Kind::Section => Some(FoldingRangeKind::Region),
                folding::Kind::Comment => Some(FoldingRangeKind::Comment),
                folding::Kind::Record => None,
            },
            ..FoldingRange::default()
        }
    }

    /// Converts nested spans, from the smallest to the largest.
    pub(super) fn selection(&self, spans: &[Span]) -> SelectionRange {
        let mut out: Option<SelectionRange> = None;
        for span in spans.iter().rev() {
            out = Some(SelectionRange {
                range: self.places.range(*span),
                parent: out.map(Box::new),
            });
        }
        out.unwrap_or_default()
    }

    pub(super) fn colour(&self, colour: &colours::Colour) -> ColorInformation {
        let [red, green, blue] = colour.shown.map(|x| x as f32);
        ColorInformation {
            range: self.places.range(colour.span),
            color: Color {
                red,
                green,
                blue,
                alpha: 1.0,
            },
        }
    }

    /// Converts tokens. Each position is counted from that of the token before. A comment of several lines becomes a
    /// token in each line.
    pub(super) fn tokens(&self, all: &[tokens::Meaning]) -> Vec<SemanticToken> {
        let source = &self.file.analysis().source;
        let mut out = Vec::with_capacity(all.len());
        let mut last = gen_lsp_types::Position::default();
        let mut add = |span: Span, token: &tokens::Meaning| {
            let at = self.places.position(span.start);
            let delta_line = at.line - last.line;
            let length = self.places.length(span);
            if length == 0 {
                return;
            }
            out.push(SemanticToken {
                delta_line,
                delta_start: at.character - if delta_line == 0 { last.character } else { 0 },
                length,
                token_type: token.role as u32,
                token_modifiers_bitset: u32::from(token.defines),
            });
            last = at;
        };
        for token in all {
            let is_comment = token.role == tokens::Role::Comment;
            if !is_comment || !source.slice(token.span).contains(['\n', '\r']) {
                add(token.span, token);
                continue;
            }
            let lines = source.line_index(token.span.start)..=source.line_index(token.span.end);
            for line in lines {
                let line = source.line_span(line);
                let start = line.start.max(token.span.start);
                let end = line.end.min(token.span.end);
                if start < end {
                    add(Span::new(start, end), token);
                }
            }
        }
        out
    }

    /// Converts a button; `None` if only some clients have its command, and this client does not.
    pub(super) fn lens(&self, lens: &lenses::Lens, preferences: &Preferences) -> Option<CodeLens> {
        let language = self.client.language;
        let has = |command: &str| preferences.commands.iter().any(|c| c == command);
        let uri = json!(self.uri());
        let (title, command, arguments) = match lens.action {
            lenses::Action::Render => (language.say("lsp-render", &[]), "zpg.render", vec![uri]),
            lenses::Action::Crosscheck => {
                let title = language.say("lsp-crosscheck", &[]);
                (title, "zpg.crosscheck", vec![uri])
            }
            lenses::Action::Preview if has("zpg.preview") => {
                (language.say("lsp-preview", &[]), "zpg.preview", vec![uri])
            }
            lenses::Action::Uses(_, count) if has("zpg.showReferences") => {
                let values = [("count", crate::diagnostics::Value::Count(count as u64))];
                let at = self.places.position(lens.span.start);
                let arguments = vec![uri, json!(at)];
                (
                    language.say("lsp-used", &values),
                    "zpg.showReferences",
                    arguments,
                )
            }
            lenses::Action::Preview | lenses::Action::Uses(..) => return None,
        };
        Some(CodeLens {
            range: self.places.range(lens.span),
            command: Some(Command {
                title,
                tooltip: None,
                command: command.to_owned(),
                arguments: Some(arguments),
            }),
            data: None,
        })
    }
}

/// The protocol's names of the roles of tokens, in the order of the roles.
pub(super) fn token_types() -> Vec<String> {
    let name = |role: tokens::Role| match role {
        tokens::Role::Id => "variable",
        tokens::Role::Type => "type",
        tokens::Role::Reference => "reference",
        tokens::Role::Number => "number",
        tokens::Role::Coordinate => "coordinate",
        tokens::Role::Colour => "colour",
        tokens::Role::Angle => "angle",
        tokens::Role::File => "string",
        tokens::Role::Comment => "comment",
        tokens::Role::Void => "operator",
    };
    tokens::Role::ALL
        .iter()
        .map(|&r| name(r).to_owned())
        .collect()
}

pub(super) fn symbol_kind(sort: symbols::Sort) -> SymbolKind {
    match sort {
        symbols::Sort::Section => SymbolKind::Namespace,
        symbols::Sort::Render => SymbolKind::Module,
        symbols::Sort::Operation => SymbolKind::Operator,
        symbols::Sort::Shape => SymbolKind::Object,
        symbols::Sort::Property => SymbolKind::Property,
        symbols::Sort::Texture => SymbolKind::Struct,
        symbols::Sort::Colour => SymbolKind::Constant,
        symbols::Sort::Light => SymbolKind::Event,
        symbols::Sort::Camera => SymbolKind::Interface,
        symbols::Sort::Undefined => SymbolKind::Null,
    }
}
