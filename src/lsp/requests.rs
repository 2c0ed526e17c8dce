//! The requests: each has a line in a table and a short function below it.

use gen_lsp_types::*;
use lsp_server::{ErrorCode, RequestId};
use serde_json::{Value, json};

use super::ask::Ask;
use super::capabilities::COMMENT;
use super::convert::Convert;
use super::documents::Snapshot;
use super::refusal::{Refusal, refusal};
use super::whole_file::WholeFile;
use super::{commenting, drawing, outgoing, programs, pull, workspace};
use crate::diagnostics::{Edit, Span};
use crate::features::actions::{self, What};
use crate::features::{
    calls, colours, completion, folding, formatting, hints, hover, lenses, rename, selection,
    signature, symbols, tokens, uses,
};
use crate::format::Options;
use crate::syntax::recognise;

type Answer<T> = Result<T, Refusal>;

/// A handler of a method, with its types erased. It returns the whole answer message.
pub(super) type Handler = Box<dyn Fn(&Ask, &RequestId, Value) -> Answer<String> + Send>;

/// The kind of thread that answers a request: quick requests take turns on shared threads, slow ones get a thread each.
pub(super) enum Lane {
    Quick,
    Slow,
}

/// The handler of a method; `None` if there is none.
pub(super) fn handler(method: &str) -> Option<(Lane, Handler)> {
    #[cfg(test)]
    if method == "test/panic" {
        return Some((
            Lane::Quick,
            Box::new(|_, _, _| panic!("as it was asked for")),
        ));
    }
    let mut find = Find {
        method,
        found: None,
    };
    find.on::<DocumentDiagnosticRequest>(Lane::Quick, pull::of_file)
        .on::<WorkspaceDiagnosticRequest>(Lane::Slow, pull::of_folders)
        .written::<InlayHintRequest>(Lane::Quick, inlay_hints)
        .on::<HoverRequest>(Lane::Slow, hover)
        .on::<SignatureHelpRequest>(Lane::Quick, signature_help)
        .on::<CompletionRequest>(Lane::Quick, complete)
        .on::<DefinitionRequest>(Lane::Quick, definition)
        .on::<ReferencesRequest>(Lane::Quick, references)
        .on::<DocumentHighlightRequest>(Lane::Quick, highlights)
        .on::<PrepareRenameRequest>(Lane::Quick, prepare_rename)
        .on::<RenameRequest>(Lane::Quick, rename_id)
        .on::<DocumentFormattingRequest>(Lane::Quick, format)
        .on::<DocumentRangeFormattingRequest>(Lane::Quick, format_range)
        .on::<DocumentOnTypeFormattingRequest>(Lane::Quick, format_on_type)
        .on::<DocumentSymbolRequest>(Lane::Quick, document_symbols)
        .on::<WorkspaceSymbolRequest>(Lane::Slow, workspace_symbols)
        .on::<CodeActionRequest>(Lane::Quick, code_actions)
        .on::<ResolveAction>(Lane::Slow, resolve_action)
        .on::<CodeLensRequest>(Lane::Quick, code_lenses)
        .on::<DocumentColorRequest>(Lane::Quick, document_colours)
        .on::<ColorPresentationRequest>(Lane::Quick, colour_presentations)
        .on::<FoldingRangeRequest>(Lane::Quick, folding_ranges)
        .on::<SelectionRangeRequest>(Lane::Quick, selection_ranges)
        .on::<SemanticTokensRequest>(Lane::Quick, tokens_full)
        .on::<SemanticTokensDeltaRequest>(Lane::Quick, tokens_delta)
        .on::<SemanticTokensRangeRequest>(Lane::Quick, tokens_range)
        .on::<CallHierarchyPrepareRequest>(Lane::Quick, prepare_calls)
        .on::<CallHierarchyIncomingCallsRequest>(Lane::Quick, incoming_calls)
        .on::<CallHierarchyOutgoingCallsRequest>(Lane::Quick, outgoing_calls)
        .on::<ExecuteCommandRequest>(Lane::Slow, programs::execute)
        .on::<drawing::PreviewRequest>(Lane::Slow, drawing::preview)
        .on::<commenting::CommentRequest>(Lane::Quick, commenting::comment);
    find.found
}

struct Find<'a> {
    method: &'a str,
    found: Option<(Lane, Handler)>,
}

impl Find<'_> {
    fn on<R: Request>(
        &mut self,
        lane: Lane,
        answer: fn(&Ask, R::Params) -> Answer<R::Result>,
    ) -> &mut Self {
        self.add::<R>(lane, move |ask, id, params| {
            outgoing::answer(id, answer(ask, params)?)
        })
    }

    /// Adds a request whose answer is written piece by piece.
    fn written<R: Request>(
        &mut self,
        lane: Lane,
        answer: fn(&Ask, &RequestId, R::Params) -> Answer<String>,
    ) -> &mut Self {
        self.add::<R>(lane, answer)
    }

    fn add<R: Request>(
        &mut self,
        lane: Lane,
        answer: impl Fn(&Ask, &RequestId, R::Params) -> Answer<String> + Send + 'static,
    ) -> &mut Self {
        if self.found.is_none() && String::from(R::METHOD) == self.method {
            let handler = move |ask: &Ask, id: &RequestId, params: Value| {
                let params = serde_json::from_value(params)
                    .map_err(|e| refusal(ErrorCode::InvalidParams, e.to_string()))?;
                answer(ask, id, params)
            };
            self.found = Some((lane, Box::new(handler)));
        }
        self
    }
}

impl Snapshot {
    /// The options for formatting the file. `None` if `zpg fmt` would not write to it: the file is excluded or no
    /// scene, or its settings cannot be read.
    fn style(&self) -> Option<Options> {
        let config = self.config.as_ref().ok()?;
        let analysis = self.analysis();
        let is_scene = analysis.is_scene() && recognise::is_scene(&analysis.source.text);
        let is_left = self.is_excluded() || !is_scene;
        (!is_left).then_some(config.format)
    }
}

/// Answers with the hints of a range, written one by one. Some clients ask for the whole file, and the hints of a long
/// file are a hundred megabytes as text, and more as values.
fn inlay_hints(ask: &Ask, id: &RequestId, p: InlayHintParams) -> Answer<String> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    let visible = convert.places.span(p.range);
    let all = hints::hints(
        file.analysis(),
        visible,
        ask.preferences.hints,
        ask.client.language,
    );
    outgoing::answer_list(id, all.map(|h| convert.hint(h)))
}

fn hover(ask: &Ask, p: HoverParams) -> Answer<Option<Hover>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    let analysis = convert.file.analysis();
    let Some(mut found) = hover::hover(analysis, offset, ask.client.language) else {
        return Ok(None);
    };
    if ask.preferences.pictures
        && let Some(id) = found.id
        && let Some(picture) = drawing::hover_picture(analysis, id, &ask.cancelled)
    {
        found.markdown.push_str(&picture);
    }
    Ok(Some(convert.hover(found)))
}

fn signature_help(ask: &Ask, p: SignatureHelpParams) -> Answer<Option<SignatureHelp>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    let found = signature::signature(convert.file.analysis(), offset, ask.client.language);
    Ok(found.map(|s| convert.signature(s)))
}

fn complete(ask: &Ask, p: CompletionParams) -> Answer<Option<CompletionResponse>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    if convert.file.is_missing {
        return Ok(None);
    }
    let found = completion::completion(convert.file.analysis(), offset, ask.client.language);
    // The client has to ask again once it is known whether a number or a name is typed: they are compared with
    // different words. A word that is typed in full is not proposed, so that the client has to ask again while a
    // proposal may become one.
    let is_text = |p: &completion::Proposal| !p.insert.has_places();
    let is_incomplete = found.word.start == found.word.end || found.proposals.iter().any(is_text);
    let items = convert.completion(found);
    Ok(Some(
        CompletionList {
            is_incomplete,
            items,
            ..CompletionList::default()
        }
        .into(),
    ))
}

fn definition(ask: &Ask, p: DefinitionParams) -> Answer<Option<DefinitionResponse>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    let found = uses::definition(convert.file.analysis(), offset);
    Ok(found.map(|(id, _)| Definition::Location(convert.location(id)).into()))
}

fn references(ask: &Ask, p: ReferenceParams) -> Answer<Option<Vec<Location>>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    let with_definition = p.context.include_declaration;
    let all = uses::references(convert.file.analysis(), offset, with_definition);
    Ok(Some(all.iter().map(|o| convert.location(o.span)).collect()))
}

fn highlights(ask: &Ask, p: DocumentHighlightParams) -> Answer<Option<Vec<DocumentHighlight>>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    let all = uses::highlights(convert.file.analysis(), offset).into_iter();
    Ok(Some(
        all.map(|(span, kind)| convert.highlight(span, kind))
            .collect(),
    ))
}

fn prepare_rename(ask: &Ask, p: PrepareRenameParams) -> Answer<Option<PrepareRenameResult>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    match rename::prepare(convert.file.analysis(), offset) {
        Ok(span) => Ok(Some(convert.places.range(span).into())),
        Err(_) if convert.file.is_missing => Ok(None),
        Err(why) => Err(ask.refuse(&why)),
    }
}

fn rename_id(ask: &Ask, p: RenameParams) -> Answer<Option<WorkspaceEdit>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    match rename::rename(convert.file.analysis(), offset, &p.new_name) {
        Ok(edits) => Ok(Some(convert.workspace_edit(&edits))),
        Err(_) if convert.file.is_missing => Ok(None),
        Err(why) => Err(ask.refuse(&why)),
    }
}

fn format(ask: &Ask, p: DocumentFormattingParams) -> Answer<Option<Vec<TextEdit>>> {
    let file = ask.file(&p.text_document)?;
    let Some(style) = file.style() else {
        return Ok(None);
    };
    let edits = formatting::whole(file.analysis(), &style);
    Ok(Some(ask.convert(file).text_edits(&edits)))
}

fn format_range(ask: &Ask, p: DocumentRangeFormattingParams) -> Answer<Option<Vec<TextEdit>>> {
    let file = ask.file(&p.text_document)?;
    let Some(style) = file.style() else {
        return Ok(None);
    };
    let (first, mut last) = (p.range.start.line as usize, p.range.end.line as usize);
    // A selection of whole lines ends at the start of the next line.
    if p.range.end.character == 0 && last > first {
        last -= 1;
    }
    let edits = formatting::lines(file.analysis(), &style, first..=last);
    Ok(Some(ask.convert(file).text_edits(&edits)))
}

fn format_on_type(ask: &Ask, p: DocumentOnTypeFormattingParams) -> Answer<Option<Vec<TextEdit>>> {
    let file = ask.file(&p.text_document)?;
    let Some(style) = file.style() else {
        return Ok(None);
    };
    let convert = ask.convert(file);
    let offset = convert.places.offset(p.position);
    let edits = formatting::on_line_break(file.analysis(), &style, offset);
    Ok(Some(convert.text_edits(&edits)))
}

fn document_symbols(ask: &Ask, p: DocumentSymbolParams) -> Answer<Option<DocumentSymbolResponse>> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    let all = symbols::symbols(file.analysis(), ask.client.language);
    if !ask.client.symbol_trees {
        let mut flat = Vec::new();
        convert.flat_symbols(all, None, &mut flat);
        return Ok(Some(flat.into()));
    }
    let all: Vec<DocumentSymbol> = all.into_iter().map(|s| convert.symbol(s)).collect();
    Ok(Some(all.into()))
}

fn workspace_symbols(
    ask: &Ask,
    p: WorkspaceSymbolParams,
) -> Answer<Option<WorkspaceSymbolResponse>> {
    Ok(Some(workspace::symbols(ask, &p.query).into()))
}

fn code_actions(ask: &Ask, p: CodeActionParams) -> Answer<Option<Vec<CodeActionResponse>>> {
    let file = ask.file(&p.text_document)?;
    if file.is_excluded() || file.is_missing {
        return Ok(None);
    }
    let convert = ask.convert(file);
    let analysis = file.analysis();
    let wants = |kind: &str| {
        let only = p.context.only.as_ref();
        only.is_none_or(|only| {
            only.iter().any(|k| {
                let asked = k.to_string();
                asked.is_empty() || kind == asked || kind.starts_with(&format!("{asked}."))
            })
        })
    };
    let mut out: Vec<CodeActionResponse> = Vec::new();
    if wants("quickfix") {
        let span = convert.places.span(p.range);
        for action in actions::actions(analysis, span, ask.client.language) {
            out.push(action_of(&convert, &p.context.diagnostics, action).into());
        }
    }
    // Actions that are not about a finding are offered only when they are asked for, by kind or by hand.
    let is_automatic = p.context.trigger_kind == Some(CodeActionTriggerKind::Automatic);
    let by_kind = p.context.only.is_some();
    let by_hand = by_kind || !is_automatic;
    if wants(COMMENT) && by_hand {
        out.extend(commenting::action(ask, &convert, p.range).map(Into::into));
    }
    for action in WholeFile::ALL {
        if wants(action.kind()) && by_hand && action.is_of_use(analysis) {
            out.extend(action.offer(ask, &convert, by_kind).map(Into::into));
        }
    }
    Ok(Some(out))
}

fn action_of(convert: &Convert, shown: &[Diagnostic], action: actions::Action) -> CodeAction {
    let kind = Some(CodeActionKind::QuickFix);
    let findings = convert.file.analysis().findings();
    // The diagnostic of the finding, as the client has it.
    let mends = |finding: usize| {
        let d = findings.get(finding)?;
        let range = convert.places.range(d.span);
        let code = Some(Code::String(d.code.as_str().to_owned()));
        let own = shown.iter().find(|s| s.range == range && s.code == code);
        own.map(|d| vec![d.clone()])
    };
    let title = action.title;
    match action.what {
        What::Fix {
            finding,
            edits,
            preferred,
        } => CodeAction {
            title,
            kind,
            diagnostics: mends(finding),
            is_preferred: preferred.then_some(true),
            edit: Some(convert.workspace_edit(&edits)),
            ..CodeAction::default()
        },
        What::Allow { finding, edits } => CodeAction {
            title,
            kind,
            diagnostics: mends(finding),
            edit: Some(convert.workspace_edit(&edits)),
            ..CodeAction::default()
        },
        What::Explain(code) => CodeAction {
            command: Some(Command {
                title: title.clone(),
                tooltip: None,
                command: programs::EXPLAIN.to_owned(),
                arguments: Some(vec![json!(code.as_str())]),
            }),
            title,
            kind,
            ..CodeAction::default()
        },
    }
}

/// `codeAction/resolve`: the client sends an action back, and gets the same action with its edit.
enum ResolveAction {}

impl Request for ResolveAction {
    const METHOD: LspRequestMethod<'static> = CodeActionResolveRequest::METHOD;
    const MESSAGE_DIRECTION: MessageDirection = CodeActionResolveRequest::MESSAGE_DIRECTION;
    type Params = Value;
    type Result = Value;
}

fn resolve_action(ask: &Ask, mut action: Value) -> Answer<Value> {
    if !action.is_object() {
        return Err(refusal(ErrorCode::InvalidParams, "no code action"));
    }
    let uri = action.pointer("/data/uri").and_then(Value::as_str);
    let chosen = WholeFile::ALL
        .into_iter()
        .find(|w| action["kind"] == w.kind());
    if let (Some(uri), Some(chosen)) = (uri, chosen) {
        let uri = Uri::from(uri);
        let file = ask.file(&TextDocumentIdentifier { uri })?;
        let edits = chosen.edits(file);
        if !edits.is_empty() {
            action["edit"] = json!(ask.convert(file).workspace_edit(&edits));
        }
    }
    Ok(action)
}

fn code_lenses(ask: &Ask, p: CodeLensParams) -> Answer<Option<Vec<CodeLens>>> {
    let file = ask.file(&p.text_document)?;
    if !ask.preferences.lenses {
        return Ok(None);
    }
    let convert = ask.convert(file);
    let all = lenses::lenses(file.analysis());
    let shown = all.iter().filter_map(|l| convert.lens(l, &ask.preferences));
    Ok(Some(shown.collect()))
}

fn document_colours(ask: &Ask, p: DocumentColorParams) -> Answer<Vec<ColorInformation>> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    Ok((colours::colours(file.analysis()).iter())
        .map(|c| convert.colour(c))
        .collect())
}

fn colour_presentations(ask: &Ask, p: ColorPresentationParams) -> Answer<Vec<ColorPresentation>> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    let picked = [p.color.red, p.color.green, p.color.blue].map(f64::from);
    let edit = colours::repaint(file.analysis(), convert.places.span(p.range), picked);
    let presentation = |edit: Edit| ColorPresentation {
        label: edit.text.split_whitespace().collect::<Vec<_>>().join(" "),
        text_edit: Some(convert.text_edit(&edit)),
        additional_text_edits: None,
    };
    Ok(edit.into_iter().map(presentation).collect())
}

fn folding_ranges(ask: &Ask, p: FoldingRangeParams) -> Answer<Option<Vec<FoldingRange>>> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    let all = folding::folds(file.analysis());
    Ok(Some(all.iter().map(|f| convert.fold(f)).collect()))
}

fn selection_ranges(ask: &Ask, p: SelectionRangeParams) -> Answer<Option<Vec<SelectionRange>>> {
    let file = ask.file(&p.text_document)?;
    if file.is_missing {
        return Ok(None);
    }
    let convert = ask.convert(file);
    let all = p.positions.iter().map(|&position| {
        let offset = convert.places.offset(position);
        convert.selection(&selection::selection(file.analysis(), offset))
    });
    Ok(Some(all.collect()))
}

/// The span of the whole file.
fn everything(file: &Snapshot) -> Span {
    Span::new(0, file.analysis().source.text.len() as u32)
}

fn tokens_full(ask: &Ask, p: SemanticTokensParams) -> Answer<Option<SemanticTokens>> {
    let file = ask.file(&p.text_document)?;
    let all = tokens::tokens(file.analysis(), everything(file));
    let data = ask.convert(file).tokens(&all);
    Ok(Some(ask.tokens_sent.keep(&file.uri, data)))
}

fn tokens_delta(
    ask: &Ask,
    p: SemanticTokensDeltaParams,
) -> Answer<Option<SemanticTokensDeltaResponse>> {
    let file = ask.file(&p.text_document)?;
    let all = tokens::tokens(file.analysis(), everything(file));
    let data = ask.convert(file).tokens(&all);
    Ok(Some(ask.tokens_sent.delta(
        &file.uri,
        &p.previous_result_id,
        data,
    )))
}

fn tokens_range(ask: &Ask, p: SemanticTokensRangeParams) -> Answer<Option<SemanticTokens>> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    let all = tokens::tokens(file.analysis(), convert.places.span(p.range));
    Ok(Some(SemanticTokens {
        result_id: None,
        data: convert.tokens(&all),
    }))
}

fn prepare_calls(
    ask: &Ask,
    p: CallHierarchyPrepareParams,
) -> Answer<Option<Vec<CallHierarchyItem>>> {
    let (convert, offset) = ask.place(&p.text_document_position_params)?;
    let node = calls::prepare(convert.file.analysis(), offset, ask.client.language);
    Ok(node.map(|n| vec![convert.call_item(n)]))
}

/// The file and the entity's ID of a call hierarchy item that was sent before.
fn called<'a>(ask: &'a Ask, item: &CallHierarchyItem) -> Answer<(Convert<'a>, u32)> {
    let uri = item.uri.clone();
    let convert = ask.convert(ask.file(&TextDocumentIdentifier { uri })?);
    let id = item.data.as_ref().and_then(Value::as_u64);
    Ok((
        convert,
        id.and_then(|id| u32::try_from(id).ok()).unwrap_or(0),
    ))
}

fn incoming_calls(
    ask: &Ask,
    p: CallHierarchyIncomingCallsParams,
) -> Answer<Option<Vec<CallHierarchyIncomingCall>>> {
    let (convert, id) = called(ask, &p.item)?;
    let all = calls::incoming(convert.file.analysis(), id, ask.client.language).into_iter();
    let all = all.map(|call| CallHierarchyIncomingCall {
        from_ranges: call.at.iter().map(|s| convert.places.range(*s)).collect(),
        from: convert.call_item(call.node),
    });
    Ok(Some(all.collect()))
}

fn outgoing_calls(
    ask: &Ask,
    p: CallHierarchyOutgoingCallsParams,
) -> Answer<Option<Vec<CallHierarchyOutgoingCall>>> {
    let (convert, id) = called(ask, &p.item)?;
    let all = calls::outgoing(convert.file.analysis(), id, ask.client.language).into_iter();
    let all = all.map(|call| CallHierarchyOutgoingCall {
        from_ranges: call.at.iter().map(|s| convert.places.range(*s)).collect(),
        to: convert.call_item(call.node),
    });
    Ok(Some(all.collect()))
}
