//! Sends diagnostics unasked, from a thread of its own. After several edits of a file only those of the last text are
//! sent.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::thread;

use crossbeam_channel::{Receiver, Sender, unbounded};
use gen_lsp_types::{PublishDiagnosticsParams, Uri};

use super::client::Client;
use super::convert::Convert;
use super::documents::Snapshot;
use super::outgoing::Outgoing;

/// The news to be published.
pub(super) enum News {
    Changed(Arc<Snapshot>),
    Closed(Uri),
}

/// Starts the thread that sends diagnostics. It ends once all senders of news are gone.
pub(super) fn start(client: Arc<Client>, outgoing: Outgoing) -> Sender<News> {
    let (sender, news) = unbounded();
    thread::spawn(move || publish(&client, &outgoing, &news));
    sender
}

fn publish(client: &Client, outgoing: &Outgoing, news: &Receiver<News>) {
    while let Ok(first) = news.recv() {
        let mut latest: HashMap<Uri, Option<Arc<Snapshot>>> = HashMap::new();
        for item in std::iter::once(first).chain(news.try_iter()) {
            match item {
                News::Changed(file) => latest.insert(file.uri.clone(), Some(file)),
                News::Closed(uri) => latest.insert(uri, None),
            };
        }
        for (uri, file) in latest {
            let version = file.as_ref().and_then(|f| f.version);
            let find = || file.map_or_else(Vec::new, |f| Convert::new(&f, client).diagnostics());
            // If the check panics, the last diagnostics stay; the message of the panic is on standard error.
            let Ok(diagnostics) = catch_unwind(AssertUnwindSafe(find)) else {
                continue;
            };
            let params = PublishDiagnosticsParams {
                uri,
                version,
                diagnostics,
            };
            outgoing.notify("textDocument/publishDiagnostics", params);
        }
    }
}
