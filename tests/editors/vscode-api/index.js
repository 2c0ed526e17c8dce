// Runs within VS Code's extension host, with the zpg extension as it is installed.
const vscode = require("vscode");
const assert = require("node:assert/strict");

async function until(what, check) {
  const start = Date.now();
  for (;;) {
    const result = await check();
    if (result) return result;
    if (Date.now() - start > 30000) throw new Error(`timed out: ${what}`);
    await new Promise((r) => setTimeout(r, 50));
  }
}

let scene;
const call = (command, ...args) => vscode.commands.executeCommand(command, scene.uri, ...args);
const errors = () =>
  vscode.languages.getDiagnostics(scene.uri).filter((d) => d.severity === vscode.DiagnosticSeverity.Error);

const tests = {
  async "the extension starts"() {
    const folder = vscode.workspace.workspaceFolders[0].uri;
    scene = await vscode.workspace.openTextDocument(vscode.Uri.joinPath(folder, "b.zpg"));
    await vscode.window.showTextDocument(scene);
    assert.equal(scene.languageId, "zpg");
    await until("active", () => vscode.extensions.getExtension("zpg.zpg").isActive);
  },
  async "diagnostics"() {
    const all = await until("diagnostics", () => errors().length && errors());
    assert.equal(all[0].code, "E003");
    assert.equal(all[0].range.start.line, 2);
  },
  async "hints"() {
    const all = await call("vscode.executeInlayHintProvider", new vscode.Range(0, 0, 99, 0));
    assert.deepEqual(all.slice(0, 3).map((h) => h.label), ["sphere", "x:", "y:"]);
  },
  async "hover"() {
    const [hover] = await call("vscode.executeHoverProvider", new vscode.Position(4, 7));
    assert.match(hover.contents[0].value, /ball[^]*data:image\/png/);
  },
  async "signature"() {
    const help = await call("vscode.executeSignatureHelpProvider", new vscode.Position(0, 7));
    assert.equal(help.signatures[0].label, "ID 11 x y z r");
    assert.equal(help.activeParameter, 1);
  },
  async "completion"() {
    const list = await call("vscode.executeCompletionItemProvider", new vscode.Position(4, 7));
    const labels = list.items.map((i) => i.label.label ?? i.label);
    assert.ok(labels.includes("2") && labels.includes("3"), labels.join());
  },
  async "definition and references"() {
    const [found] = await call("vscode.executeDefinitionProvider", new vscode.Position(4, 7));
    assert.equal((found.range ?? found.targetRange).start.line, 0);
    const all = await call("vscode.executeReferenceProvider", new vscode.Position(0, 0));
    assert.equal(all.length, 3);
  },
  async "symbols"() {
    const all = await call("vscode.executeDocumentSymbolProvider");
    const top = all.find((s) => s.name.startsWith("1 "));
    assert.equal(top.children[0].name, "6 union");
  },
  async "folding, selection, colours, tokens, lenses, calls"() {
    const [selection] = await call("vscode.executeSelectionRangeProvider", [new vscode.Position(0, 7)]);
    assert.ok(selection.parent.parent);
    const [colour] = await call("vscode.executeDocumentColorProvider");
    assert.equal(colour.range.start.line, 1);
    const [shown] = await vscode.commands.executeCommand("vscode.executeColorPresentationProvider", colour.color, {
      uri: scene.uri,
      range: colour.range,
    });
    assert.equal(shown.label, "0.9 0.2 0.1");
    const tokens = await call("vscode.provideDocumentSemanticTokens");
    assert.ok(tokens.data.length > 100);
    const lenses = await call("vscode.executeCodeLensProvider", 20);
    const titles = lenses.map((l) => l.command.title);
    assert.ok(titles.includes("Preview") && !titles.some((t) => t.startsWith("used")), titles.join());
    const [ball] = await call("vscode.prepareCallHierarchy", new vscode.Position(0, 0));
    const calls = await vscode.commands.executeCommand("vscode.provideIncomingCalls", ball);
    assert.equal(calls[0].from.name, "5 union");
  },
  async "a fix"() {
    const actions = await call("vscode.executeCodeActionProvider", errors()[0].range);
    const titles = actions.map((a) => a.title);
    assert.ok(titles.some((t) => t.startsWith("Explain E003")), titles.join());
    await vscode.workspace.applyEdit(actions.find((a) => a.title === "write `0.5`").edit);
    await until("no errors", () => errors().length === 0);
  },
  async "rename, and why not"() {
    const edit = await call("vscode.executeDocumentRenameProvider", new vscode.Position(0, 0), "77");
    await vscode.workspace.applyEdit(edit);
    assert.match(scene.getText(), /-101 77 3/);
    const refused = call("vscode.executeDocumentRenameProvider", new vscode.Position(0, 0), "5");
    await assert.rejects(async () => {
      const edit = await refused;
      if (!edit?.size) throw new Error("refused");
    });
  },
  async "format"() {
    const edits = await call("vscode.executeFormatDocumentProvider", { tabSize: 2, insertSpaces: true });
    const edit = new vscode.WorkspaceEdit();
    edit.set(scene.uri, edits);
    await vscode.workspace.applyEdit(edit);
    assert.match(scene.lineAt(0).text, /^77 11 {2,}0 1 0 {2}1 {2}# ball #$/);
  },
  async "comment out and in"() {
    const before = scene.getText();
    const editor = vscode.window.activeTextEditor;
    const toggled = async (selections, command = "zpg.toggleComment") => {
      editor.selections = selections;
      await vscode.commands.executeCommand(command);
    };
    const line = (n) => new vscode.Selection(n, 4, n, 4);
    await toggled([line(0)]);
    assert.equal(scene.lineAt(0).text, "0 # ~ 77 11  0 1 0  1  ~~ ball ~~ #");
    await vscode.commands.executeCommand("zpg.toggleComment");
    assert.equal(scene.getText(), before);
    const all = new vscode.Selection(0, 3, scene.lineCount, 0);
    for (const selections of [[line(0), line(2)], [all]]) {
      await toggled(selections);
      assert.notEqual(scene.getText(), before);
      await vscode.commands.executeCommand("zpg.toggleComment");
      assert.equal(scene.getText(), before);
    }
    // Faster than it is answered.
    editor.selections = [all];
    await Promise.all([1, 2, 3, 4].map(() => vscode.commands.executeCommand("zpg.toggleComment")));
    assert.equal(scene.getText(), before);
    await toggled([all], "zpg.commentOut");
    await toggled([all], "zpg.commentIn");
    assert.equal(scene.getText(), before);
    // The editor's own ways, as in its menus, do nothing.
    for (const own of ["commentLine", "blockComment", "addCommentLine", "removeCommentLine"]) {
      for (const selection of [line(0), all]) {
        await toggled([selection], `editor.action.${own}`);
        assert.equal(scene.getText(), before, own);
      }
    }
  },
};

exports.run = async () => {
  let bad = 0;
  for (const [name, test] of Object.entries(tests)) {
    try {
      await test();
      console.log(`ok - ${name}`);
    } catch (error) {
      bad += 1;
      console.log(`not ok - ${name}: ${error.stack}`);
    }
  }
  if (bad > 0) throw new Error(`${bad} failed`);
};
