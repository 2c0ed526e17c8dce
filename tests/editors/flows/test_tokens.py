"""Semantic tokens: the whole, what is different, and those of a range."""

import random

from conftest import position
from lsprotocol import types as lsp

SCENE = "0 # parts #\n" + "".join(
    f"{i} 11  {i % 7} 1 {i // 7}  1 # ball #\n{i} -701 0.9 0.2 0.1\n" for i in range(2, 30)
)


async def full(server):
    answer = await server.client.text_document_semantic_tokens_full_async(lsp.SemanticTokensParams(server.of("a.zpg")))
    return answer.result_id, list(answer.data)


async def delta(server, known):
    params = lsp.SemanticTokensDeltaParams(server.of("a.zpg"), known)
    return await server.client.text_document_semantic_tokens_full_delta_async(params)


def placed(data):
    """Tokens with their lines and columns."""
    line = column = 0
    for lines, columns, *rest in zip(*[iter(data)] * 5):
        line, column = line + lines, columns + (0 if lines else column)
        yield line, column, *rest


async def test_differences_add_up_to_the_whole(start):
    server = await start()
    server.open("a.zpg", SCENE)
    name, data = await full(server)
    choice = random.Random(5)
    for i in range(60):
        text = server.texts["a.zpg"][1]
        old = choice.choice(["1 #", "-701", "\n", "ball", " ", "9", "# "])
        server.edit("a.zpg", old if old in text else "0", choice.choice(["", "7", "4 -101 2 3\n", "# x #", "\n", old]))
        answer = await delta(server, name)
        for edit in sorted(answer.edits, key=lambda e: -e.start):
            data[edit.start : edit.start + edit.delete_count] = edit.data or []
        name = answer.result_id
        if i % 10 == 9:
            name, whole = await full(server)
            assert data == whole, server.texts["a.zpg"][1]


async def test_a_client_that_has_other_tokens_gets_all(start):
    server = await start()
    server.open("a.zpg", SCENE)
    name, data = await full(server)
    answer = await delta(server, name + "0")
    assert list(answer.data) == data
    # Nothing has changed since.
    assert not (await delta(server, answer.result_id)).edits


async def test_a_range_is_a_part_of_the_whole(start):
    server = await start()
    server.open("a.zpg", SCENE)
    _, data = await full(server)
    start_, end = SCENE.index("5 -701"), SCENE.index("12 11") + 5
    lines = range(position(SCENE, start_).line, position(SCENE, end).line + 1)
    where = lsp.Range(position(SCENE, start_), position(SCENE, end))
    params = lsp.SemanticTokensRangeParams(server.of("a.zpg"), where)
    part = await server.client.text_document_semantic_tokens_range_async(params)
    within = [t for t in placed(data) if t[0] in lines]
    # Of the last line only its first two numbers are asked for.
    first = list(placed(part.data))
    assert first == within[: len(first)] and within[len(first)][0] == lines[-1]
