"""Requests that are cancelled, that are nonsense, and places in all units."""

import asyncio
import os
from pathlib import Path

import pytest
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException


def slow_scene() -> str:
    """Mirrors that face each other."""
    lines = ["2 -201 0.1 0.9 0", "3 9 1", "3 -299 0 2"]
    for i in range(4, 40):
        lines += [f"{i} -105 3", f"{i} -1 {i % 6 * 2} {i // 6 * 2} 0"]
    lines += ["100 -101 4 5"] + [f"{95 + i} -101 {94 + i} {i}" for i in range(6, 40)]
    return "\n".join([*lines, "1 9999 134 0\n"])


def descendants(process: int) -> list[Path]:
    """A process and all below it, as folders of /proc."""
    children = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            parent = (folder / "stat").read_text().rpartition(")")[2].split()[1]
        except OSError:
            continue
        children.setdefault(int(parent), []).append(folder)
    found, new = [], [Path(f"/proc/{process}")]
    while new:
        found += new
        new = [child for folder in new for child in children.get(int(folder.name), [])]
    return found


def seconds(process: int) -> float:
    """CPU time of a process and all below it."""
    ticks = 0
    for folder in descendants(process):
        user, system = (folder / "stat").read_text().rpartition(")")[2].split()[11:13]
        ticks += int(user) + int(system)
    return ticks / os.sysconf("SC_CLK_TCK")


def renders(process: int) -> bool:
    """Whether the server has a program running that renders."""
    return any(b"render" in (folder / "cmdline").read_bytes().split(b"\0") for folder in descendants(process))


async def until(check) -> None:
    for _ in range(2000):
        if check():
            return
        await asyncio.sleep(0.01)
    pytest.fail("it takes too long")


async def cancelled(server, asked, name: str) -> None:
    """Cancels a request, which is answered with that."""
    server.client.cancel_request(lsp.CancelParams(name))
    with pytest.raises(JsonRpcException) as refused:
        await asyncio.wait_for(asked, 20)
    assert refused.value.code == -32800


async def test_a_picture_that_is_cancelled_is_drawn_no_further(start):
    server = await start()
    server.open("a.zpg", slow_scene())
    process = server.client._server.pid
    params = {"textDocument": {"uri": server.uri("a.zpg")}, "width": 1024, "height": 1024}
    asked = asyncio.ensure_future(server.client.protocol.send_request_async("zpg/preview", params, "picture"))
    before = seconds(process)
    await until(lambda: seconds(process) > before + 0.1)
    assert not asked.done()
    await cancelled(server, asked, "picture")
    # Whatever is in work ends at once: then the server rests.
    await asyncio.sleep(0.1)
    before = seconds(process)
    await asyncio.sleep(0.5)
    assert seconds(process) - before < 0.1


async def test_a_program_that_is_cancelled_ends(start):
    server = await start()
    server.open("a.zpg", slow_scene())
    process = server.client._server.pid
    params = lsp.ExecuteCommandParams("zpg.render", [server.uri("a.zpg"), "4000x4000"])
    asked = asyncio.ensure_future(
        server.client.protocol.send_request_async("workspace/executeCommand", params, "render")
    )
    await until(lambda: renders(process))
    await cancelled(server, asked, "render")
    await until(lambda: not renders(process))
    # Neither the picture nor a draft of it stays.
    await until(lambda: list(server.folder.iterdir()) == [])


@pytest.mark.parametrize(
    "method, params, code",
    [
        ("textDocument/hover", lsp.HoverParams(lsp.TextDocumentIdentifier("x"), lsp.Position(0, 0)), -32602),
        ("textDocument/documentSymbol", lsp.DocumentSymbolParams(lsp.TextDocumentIdentifier("")), -32602),
        ("zpg/preview", {"textDocument": {"uri": 7}}, -32602),
        ("zpg/nothing", {}, -32601),
        ("workspace/executeCommand", lsp.ExecuteCommandParams("rm", ["-r"]), -32602),
    ],
)
async def test_nonsense_is_refused_and_the_next_request_answered(start, method, params, code):
    server = await start()
    server.open("a.zpg", "2 9 1\n")
    with pytest.raises(JsonRpcException) as refused:
        await asyncio.wait_for(server.client.protocol.send_request_async(method, params), 20)
    assert refused.value.code == code
    hover = lsp.HoverParams(server.of("a.zpg"), lsp.Position(0, 2))
    assert await server.client.text_document_hover_async(hover) is not None


@pytest.mark.parametrize("unit, column", [("utf-8", 18), ("utf-16", 15), ("utf-32", 14)])
async def test_places_in_all_units(start, unit, column):
    """The reference stands behind a letter of two bytes and a picture of four, on a line that a single CR begins."""
    server = await start(encodings=[lsp.PositionEncodingKind(unit)])
    assert server.client.offered.position_encoding == unit
    server.open("a.zpg", "2 9 1\r\n3 9 2\r4 # ž😀 # -101 2 3\n")
    here = lsp.Position(2, column)
    found = await server.client.text_document_definition_async(lsp.DefinitionParams(server.of("a.zpg"), here))
    assert found.range.start == lsp.Position(0, 0)
    back = lsp.ReferenceParams(lsp.ReferenceContext(False), server.of("a.zpg"), lsp.Position(0, 0))
    (use,) = await server.client.text_document_references_async(back)
    assert use.range == lsp.Range(here, lsp.Position(2, column + 1))
    # An edit behind them, in the same units.
    document = lsp.VersionedTextDocumentIdentifier(version=2, uri=server.uri("a.zpg"))
    change = lsp.TextDocumentContentChangePartial(use.range, "3")
    server.client.text_document_did_change(lsp.DidChangeTextDocumentParams(document, [change]))
    found = await server.client.text_document_definition_async(lsp.DefinitionParams(server.of("a.zpg"), here))
    assert found.range.start == lsp.Position(1, 0)
