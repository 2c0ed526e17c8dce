// Comments out and in. The editor's own way puts signs around a text, which ends at the first comment within.

import * as vscode from "vscode";
import { LanguageClient, TextEdit } from "vscode-languageclient/node";

export type Mode = "toggle" | "out" | "in";

/** Keys may come faster than answers: each is for the text that the one before has made. */
let last: Promise<void> = Promise.resolve();

export function comment(client: LanguageClient, mode: Mode): Promise<void> {
  const next = last.then(() => run(client, mode));
  last = next.catch(() => {});
  return next;
}

async function run(client: LanguageClient, mode: Mode): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (editor?.document.languageId !== "zpg") {
    return;
  }
  const scene = editor.document;
  // Where the text has changed meanwhile, the edits are for another one.
  for (let tries = 0; tries < 10; tries += 1) {
    const version = scene.version;
    const asked = await client.sendRequest<TextEdit[]>("zpg/comment", {
      textDocument: { uri: client.code2ProtocolConverter.asUri(scene.uri) },
      ranges: editor.selections.map((selection) => client.code2ProtocolConverter.asRange(selection)),
      mode,
    });
    const edits = await client.protocol2CodeConverter.asTextEdits(asked);
    const replace = (change: vscode.TextEditorEdit) =>
      edits.forEach((edit) => change.replace(edit.range, edit.newText));
    if (scene.version === version && (await editor.edit(replace))) {
      return;
    }
  }
}
