"""Files that change while a scene is open, for clients that are sent diagnostics: settings and pictures."""

import struct
import zlib

from lsprotocol import types as lsp

SCENE = "2 9 1\n3 11  0 1 0  1\n1 9999 2 0\n"


def png() -> bytes:
    """A white picture of one pixel."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    data = zlib.compress(b"\0\xff\xff\xff")
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


async def test_settings_come_change_and_go(start):
    server = await start()
    server.open("a.zpg", SCENE)
    await server.published("a.zpg", {"N602", "N603", "W310"})
    server.write("zpg.toml", '[lint]\nW310 = "off"\n')
    server.on_disk(zpg_toml=lsp.FileChangeType.Created)
    await server.published("a.zpg", {"N602", "N603"})
    server.write("zpg.toml", '[lint]\nnotes = "off"\n')
    server.on_disk(zpg_toml=lsp.FileChangeType.Changed)
    await server.published("a.zpg", {"W310"})
    (server.folder / "zpg.toml").unlink()
    server.on_disk(zpg_toml=lsp.FileChangeType.Deleted)
    await server.published("a.zpg", {"N602", "N603", "W310"})


async def test_a_picture_comes_and_goes(start):
    server = await start()
    scene = "2 9 1\n2 -301 wood.png\n1 9999 2 0\n"
    server.write("a.zpg", scene)
    server.open("a.zpg", scene)
    await server.published("a.zpg", {"E210", "N602", "N603"})
    server.write("wood.png", png())
    server.on_disk(wood_png=lsp.FileChangeType.Created)
    await server.published("a.zpg", {"N602", "N603"})
    (server.folder / "wood.png").rename(server.folder / "oak.png")
    server.on_disk(wood_png=lsp.FileChangeType.Deleted, oak_png=lsp.FileChangeType.Created)
    await server.published("a.zpg", {"E210", "N602", "N603"})
    server.edit("a.zpg", "wood", "oak")
    await server.published("a.zpg", {"N602", "N603"})


async def test_a_scene_is_renamed(start):
    """The client closes the old name and opens the new one, whose settings may be others."""
    server = await start()
    server.write("zpg.toml", '[lint.per-file-ignores]\n"b.zpg" = ["W310", "notes"]\n')
    server.open("a.zpg", SCENE)
    await server.published("a.zpg", {"N602", "N603", "W310"})
    server.close("a.zpg")
    server.open("b.zpg", SCENE)
    await server.published("a.zpg", set())
    await server.published("b.zpg", set())
    server.edit("b.zpg", "2 9 1", "2 9 0,5")
    await server.published("b.zpg", {"E003"})
