//! Pictures for hovers and previews. They are drawn on threads of their own, one fewer than there are
//! processors, so that everything else is answered meanwhile.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gen_lsp_types::{
    LspRequestMethod, MessageDirection, Position, ProgressToken, Request, TextDocumentIdentifier,
};
use lsp_server::ErrorCode;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::ask::Ask;
use super::programs;
use super::refusal::{Refusal, refusal};
use crate::analysis::Analysis;
use crate::diagnostics::{Complaint, Error, Language};
use crate::features::picture::{Stage, Subject};
use crate::features::uses;
use crate::syntax::table::{Kind, RecordKind};

/// `zpg/preview`: a small picture of the scene, or of the object at a place.
pub(super) enum PreviewRequest {}

impl Request for PreviewRequest {
    const METHOD: LspRequestMethod<'static> = LspRequestMethod::new("zpg/preview");
    const MESSAGE_DIRECTION: MessageDirection = MessageDirection::ClientToServer;
    type Params = PreviewParams;
    type Result = Preview;
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct PreviewParams {
    pub text_document: TextDocumentIdentifier,
    /// The place of the object to draw, fitted into view; without a place the scene is drawn, as its camera sees it.
    #[serde(default)]
    pub position: Option<Position>,
    /// The picture's size in pixels, from 16 to 1024.
    #[serde(default = "width")]
    pub width: u32,
    #[serde(default = "height")]
    pub height: u32,
    /// The token under which a coarse picture is sent before the answer.
    #[serde(default)]
    pub partial_result_token: Option<ProgressToken>,
}

fn width() -> u32 {
    480
}

fn height() -> u32 {
    360
}

/// A picture of a scene or an object.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Preview {
    /// A PNG in base64.
    pub png: String,
    pub width: u32,
    pub height: u32,
    /// The ID of the object that is drawn alone; `None` if the scene is drawn.
    pub id: Option<u32>,
    /// The version of the file; `None` if it is not open.
    pub version: Option<i32>,
}

/// The threads that draw; `None` if they cannot be started.
fn pool() -> Option<&'static rayon::ThreadPool> {
    static POOL: OnceLock<Option<rayon::ThreadPool>> = OnceLock::new();
    let made = POOL.get_or_init(|| {
        let processors = thread::available_parallelism().map_or(1, |n| n.get());
        let threads = rayon::ThreadPoolBuilder::new().num_threads((processors - 1).max(1));
        threads.build().ok()
    });
    made.as_ref()
}

fn draw(stage: &Stage, size: [u32; 2], stop: &Arc<AtomicBool>) -> Result<Option<Vec<u8>>, Error> {
    match pool() {
        Some(pool) => pool.install(|| stage.draw(size, stop)),
        None => stage.draw(size, stop),
    }
}

/// The sides of the requested picture are this many times those of the coarse one.
const COARSE: u32 = 4;

/// Draws the picture that is asked for, after a coarse one if the client takes partial results.
pub(super) fn preview(ask: &Ask, p: PreviewParams) -> Result<Preview, Refusal> {
    let file = ask.file(&p.text_document)?;
    let analysis = file.analysis();
    let size = [p.width, p.height].map(|n| n.clamp(16, 1024));
    let place = p.position.map(|at| ask.convert(file).places.offset(at));
    let id = place.and_then(|offset| object_at(analysis, offset));
    let subject = id.map_or(Subject::Scene, Subject::Object);
    let language = ask.client.language;
    let failed = |e: Error| refusal(ErrorCode::RequestFailed, said(&e, language));
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    let stage = Stage::new(analysis, subject, aspect).map_err(|e| {
        programs::trouble(file, language).map_or_else(|| failed(e), |why| ask.refuse(&why))
    })?;
    let taken = |size: [u32; 2]| -> Result<Preview, Refusal> {
        let png = draw(&stage, size, &ask.cancelled).map_err(failed)?;
        let png = png.ok_or_else(|| refusal(ErrorCode::RequestCanceled, "stopped"))?;
        Ok(Preview {
            png: STANDARD.encode(png),
            width: size[0],
            height: size[1],
            id,
            version: file.version,
        })
    };
    if let Some(token) = &p.partial_result_token {
        let coarse = taken(size.map(|n| (n / COARSE).max(1)))?;
        let value = json!({ "token": token, "value": coarse });
        ask.outgoing.notify("$/progress", value);
    }
    taken(size)
}

fn said(error: &Error, language: Language) -> String {
    match error {
        Error::Scene { why, .. } | Error::Request(why) => why.wording(language),
        Error::Finding(d) => d.wording(language).message,
        Error::Interrupted => Complaint::new("lsp-stopped").wording(language),
    }
}

/// The ID of the object that is named at an offset, or else of the object that the record there is about. `None` for
/// any other entity, as for the render record, which stands for the scene.
fn object_at(analysis: &Analysis, offset: u32) -> Option<u32> {
    let named = uses::id_at(analysis, offset).map(|(id, _)| id);
    let around = || crate::features::token_at_offset::record_at(analysis, offset).map(|r| r.id);
    let id = named.or_else(around)?;
    let is_object = crate::features::entity::entity(analysis, id)?.kind == Some(Kind::Object);
    is_object.then_some(id)
}

/// The largest number of nodes of a scene that is drawn in a hover.
const MAX_NODES: usize = 20_000;
/// Longest time that a picture in a hover may take.
const MAX_DRAWING_TIME: Duration = Duration::from_millis(400);

/// The largest length of a hover's picture in base64: editors cut off longer texts, or freeze.
const MAX_BASE64: usize = 70_000;

/// A picture of an entity, in Markdown as VS Code reads it. `None` if the scene is too large, or the picture is not
/// ready in time or too long.
pub(super) fn hover_picture(
    analysis: &Analysis,
    id: u32,
    cancelled: &Arc<AtomicBool>,
) -> Option<String> {
    if analysis.scene.nodes.len() > MAX_NODES {
        return None;
    }
    let is_render = (analysis.definition(id)).is_some_and(|r| r.kind == RecordKind::Render);
    let subject = match is_render {
        true => Subject::Scene,
        false => Subject::Object(id),
    };
    let end = Instant::now() + MAX_DRAWING_TIME;
    let stage = Stage::new(analysis, subject, 4.0 / 3.0).ok()?;
    let stop = Arc::new(AtomicBool::new(false));
    let (done, alarm) = crossbeam_channel::bounded::<()>(1);
    let picture = thread::scope(|scope| {
        scope.spawn(|| {
            while !cancelled.load(Ordering::Relaxed) {
                let step = end.saturating_duration_since(Instant::now());
                let step = step.min(Duration::from_millis(20));
                // Either the picture is ready, or its thread has ended.
                let is_over = !matches!(
                    alarm.recv_timeout(step),
                    Err(crossbeam_channel::RecvTimeoutError::Timeout)
                );
                if is_over || Instant::now() >= end {
                    break;
                }
            }
            stop.store(true, Ordering::Relaxed);
        });
        let picture = [[192, 144], [96, 72]].into_iter().find_map(|size| {
            let png = draw(&stage, size, &stop).ok()??;
            let text = STANDARD.encode(png);
            (text.len() < MAX_BASE64).then_some((text, size))
        });
        drop(done);
        picture
    });
    let (png, [width, height]) = picture?;
    Some(format!(
        "\n---\n\n![{id}](data:image/png;base64,{png}|width={width},height={height})\n"
    ))
}
