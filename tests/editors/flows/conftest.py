"""A server for each test, started as ZPG, with a client that is pytest-lsp's. `tests/editors.rs` runs these tests."""

import asyncio
import os
from pathlib import Path

import pytest
from lsprotocol import types as lsp
from pytest_lsp import LanguageClient
from pytest_lsp.client import make_test_lsp_client

PATIENCE = 20


class Server:
    """A server and what a test says to it. Files are named by their paths in the folder."""

    def __init__(self, client: LanguageClient, folder: Path):
        self.client = client
        self.folder = folder
        self.texts: dict[str, tuple[int, str]] = {}

    def uri(self, name: str) -> str:
        return (self.folder / name).as_uri()

    def of(self, name: str) -> lsp.TextDocumentIdentifier:
        return lsp.TextDocumentIdentifier(self.uri(name))

    def write(self, name: str, text: str | bytes) -> None:
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())

    def open(self, name: str, text: str) -> None:
        self.texts[name] = (1, text)
        item = lsp.TextDocumentItem(self.uri(name), "zpg", 1, text)
        self.client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))

    def close(self, name: str) -> None:
        del self.texts[name]
        self.client.text_document_did_close(lsp.DidCloseTextDocumentParams(self.of(name)))

    def edit(self, name: str, old: str, new: str) -> None:
        """Replaces the first `old` in a file of characters that are one unit each."""
        version, text = self.texts[name]
        at = text.index(old)
        start, end = (position(text, i) for i in (at, at + len(old)))
        change = lsp.TextDocumentContentChangePartial(lsp.Range(start, end), new)
        self.texts[name] = (version + 1, text[:at] + new + text[at + len(old) :])
        document = lsp.VersionedTextDocumentIdentifier(version=version + 1, uri=self.uri(name))
        self.client.text_document_did_change(lsp.DidChangeTextDocumentParams(document, [change]))

    def on_disk(self, **changes: lsp.FileChangeType) -> None:
        """Says that files have changed; `_` stands for the dot in their names."""
        events = [lsp.FileEvent(self.uri(name.replace("_", ".")), kind) for name, kind in changes.items()]
        self.client.workspace_did_change_watched_files(lsp.DidChangeWatchedFilesParams(events))

    async def published(self, name: str, codes: set[str]) -> None:
        """Waits until the diagnostics that were sent for a file have these codes."""
        for _ in range(PATIENCE * 100):
            if codes_of(self.client.diagnostics.get(self.uri(name), [])) == codes:
                return
            await asyncio.sleep(0.01)
        pytest.fail(f"{codes_of(self.client.diagnostics[self.uri(name)])} where {codes} are wanted")


def position(text: str, at: int) -> lsp.Position:
    line = text.count("\n", 0, at)
    return lsp.Position(line, at - (text.rfind("\n", 0, at) + 1))


def codes_of(diagnostics) -> set[str]:
    return {str(d.code) for d in diagnostics}


@pytest.fixture
async def start(tmp_path):
    """Starts servers, and ends them: each says goodbye in order."""
    clients = []

    async def start(pulls=False, encodings=None) -> Server:
        client = make_test_lsp_client()
        clients.append(client)
        await client.start_io(os.environ["ZPG"], "lsp")
        text = lsp.TextDocumentClientCapabilities(
            diagnostic=lsp.DiagnosticClientCapabilities() if pulls else None,
            publish_diagnostics=None if pulls else lsp.PublishDiagnosticsClientCapabilities(),
        )
        workspace = lsp.WorkspaceClientCapabilities(
            diagnostics=lsp.DiagnosticWorkspaceClientCapabilities(refresh_support=True),
            did_change_watched_files=lsp.DidChangeWatchedFilesClientCapabilities(dynamic_registration=False),
        )
        capabilities = lsp.ClientCapabilities(
            text_document=text,
            workspace=workspace,
            general=lsp.GeneralClientCapabilities(position_encodings=encodings),
        )
        folders = [lsp.WorkspaceFolder(tmp_path.as_uri(), "scenes")]
        params = lsp.InitializeParams(capabilities, workspace_folders=folders)
        client.offered = (await client.initialize_session(params)).capabilities
        return Server(client, tmp_path)

    yield start
    for client in clients:
        await asyncio.wait_for(client.shutdown_async(None), PATIENCE)
        client.exit(None)
        # ZPG may be a shell with more programs in a row: they end with their input.
        client._server.stdin.close()
        await asyncio.wait_for(client._server.wait(), PATIENCE)
        await client.stop()
        assert client.error is None
