"""Diagnostics that the client asks for: of an open file, and of all scenes in the folder."""

from conftest import codes_of
from lsprotocol import types as lsp

WRONG = "2 9 0,5\n1 9999 2 0\n"
RIGHT = "# ball #\n2 9 0.5\n1 9999 2 0\n"


async def document(server, name, known=None):
    params = lsp.DocumentDiagnosticParams(server.of(name), previous_result_id=known)
    return await server.client.text_document_diagnostic_async(params)


async def folder(server, known):
    """The reports by names of files; `known` keeps their names from one time to the next, as a client does."""
    previous = [lsp.PreviousResultId(uri, value) for uri, value in known.items()]
    answer = await server.client.workspace_diagnostic_async(lsp.WorkspaceDiagnosticParams(previous))
    for report in answer.items:
        known.pop(report.uri, None)
        if report.result_id is not None:
            known[report.uri] = report.result_id
    uris = [report.uri for report in answer.items]
    assert len(uris) == len(set(uris))
    return {report.uri.removeprefix(server.uri("") + "/"): report for report in answer.items}


def changed(reports):
    return {name for name, report in reports.items() if report.kind == "full"}


async def test_an_unchanged_file_is_not_told_again(start):
    server = await start(pulls=True)
    assert server.client.offered.diagnostic_provider.workspace_diagnostics
    server.open("a.zpg", WRONG)
    first = await document(server, "a.zpg")
    assert first.kind == "full" and "E003" in codes_of(first.items)
    again = await document(server, "a.zpg", first.result_id)
    assert (again.kind, again.result_id) == ("unchanged", first.result_id)
    server.edit("a.zpg", "0,5", "0.5")
    mended = await document(server, "a.zpg", first.result_id)
    assert mended.kind == "full" and "E003" not in codes_of(mended.items)
    server.edit("a.zpg", "0.5", "0,5")
    # The same text as at first, and another report all the same.
    broken = await document(server, "a.zpg", mended.result_id)
    assert broken.items == first.items and broken.result_id != first.result_id
    assert server.client.diagnostics == {}, "diagnostics are sent unasked"


async def test_settings_change_the_report(start):
    server = await start(pulls=True)
    server.open("a.zpg", RIGHT + "3 9 1\n")
    first = await document(server, "a.zpg")
    assert "W310" in codes_of(first.items)
    server.write("zpg.toml", '[lint]\nW310 = "off"\n')
    server.on_disk(zpg_toml=lsp.FileChangeType.Created)
    second = await document(server, "a.zpg", first.result_id)
    assert second.kind == "full" and "W310" not in codes_of(second.items)
    assert server.client.diagnostic_refresh_count == 1


async def test_the_folder(start):
    server = await start(pulls=True)
    server.write("wrong.zpg", WRONG)
    server.write("right.zpg", RIGHT)
    server.write("part/turned (1).zpg", WRONG)
    server.write("old/left.zpg", WRONG)
    server.write("notes.txt", WRONG)
    server.write("zpg.toml", 'exclude = ["old"]\n')
    known = {}
    reports = await folder(server, known)
    turned = "part/turned%20(1).zpg"
    assert changed(reports) == {"wrong.zpg", "right.zpg", turned, "old/left.zpg"}
    assert "E003" in codes_of(reports["wrong.zpg"].items) and reports["wrong.zpg"].version is None
    assert "E003" not in codes_of(reports["right.zpg"].items)
    assert not reports["old/left.zpg"].items
    assert changed(await folder(server, known)) == set()
    # Written, created, renamed, deleted.
    server.write("right.zpg", WRONG + "3 9 1\n")
    server.write("new.zpg", WRONG)
    (server.folder / "wrong.zpg").rename(server.folder / "renamed.zpg")
    (server.folder / "part/turned (1).zpg").unlink()
    reports = await folder(server, known)
    assert changed(reports) == {"right.zpg", "new.zpg", "wrong.zpg", "renamed.zpg", turned}
    assert not reports["wrong.zpg"].items and not reports[turned].items
    assert all("E003" in codes_of(reports[name].items) for name in ("right.zpg", "new.zpg", "renamed.zpg"))
    # A client may have lost the name of its report: it is told of each file that is gone in every report.
    gone = {"wrong.zpg", turned}
    reports = await folder(server, known)
    assert changed(reports) == gone and not any(reports[name].items for name in gone)
    # An open file is as the client has it; closed, as it is on disk.
    server.open("new.zpg", RIGHT)
    reports = await folder(server, known)
    assert changed(reports) == {"new.zpg"} | gone and reports["new.zpg"].version == 1
    assert "E003" not in codes_of(reports["new.zpg"].items)
    server.close("new.zpg")
    assert "E003" in codes_of((await folder(server, known))["new.zpg"].items)
    # Settings change them all.
    server.write("zpg.toml", '[lint]\nE003 = "off"\n')
    server.on_disk(zpg_toml=lsp.FileChangeType.Changed)
    reports = await folder(server, known)
    assert changed(reports) == {"right.zpg", "new.zpg", "renamed.zpg", "old/left.zpg"} | gone


async def test_a_picture_changes_the_scenes_that_show_it(start):
    server = await start(pulls=True)
    server.write("shows.zpg", "2 9 1\n2 -301 wood.png\n1 9999 2 0\n")
    server.write("right.zpg", RIGHT)
    known = {}
    assert "E210" in codes_of((await folder(server, known))["shows.zpg"].items)
    server.write("wood.png", b"\x89PNG\r\n\x1a\n")
    server.on_disk(wood_png=lsp.FileChangeType.Created)
    reports = await folder(server, known)
    assert changed(reports) == {"shows.zpg"} and "E210" not in codes_of(reports["shows.zpg"].items)


async def test_clients_that_write_uris_in_another_way(start):
    server = await start(pulls=True)
    server.write("a (1).zpg", WRONG)
    known = {}
    await folder(server, known)
    (uri, name), = known.items()
    other = {uri.replace("(", "%28").replace(")", "%29"): name}
    params = lsp.WorkspaceDiagnosticParams([lsp.PreviousResultId(*item) for item in other.items()])
    answer = await server.client.workspace_diagnostic_async(params)
    assert [report.kind for report in answer.items] == ["unchanged"]
