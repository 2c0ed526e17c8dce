// A picture beside the scene that follows what is typed.

import * as vscode from "vscode";
import type { LanguageClient } from "vscode-languageclient/node";
import { ProgressType } from "vscode-languageclient/node";

interface Picture {
  png: string;
  width: number;
  height: number;
  id: number | null;
}

/** How long nobody types before a new picture is asked for, in milliseconds. */
const PAUSE = 60;

export class Preview implements vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private scene: vscode.TextDocument | undefined;
  private alone = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private asking: vscode.CancellationTokenSource | undefined;
  private count = 0;
  private readonly listeners: vscode.Disposable[];

  constructor(private readonly client: () => LanguageClient | undefined) {
    this.listeners = [
      vscode.workspace.onDidChangeTextDocument((e) => e.document === this.scene && this.later()),
      vscode.window.onDidChangeTextEditorSelection(
        (e) => this.alone && e.textEditor.document === this.scene && this.later(),
      ),
      vscode.window.onDidChangeActiveTextEditor((editor) => {
        if (editor?.document.languageId === "zpg" && editor.document !== this.scene) {
          this.scene = editor.document;
          this.later();
        }
      }),
    ];
  }

  open(): void {
    this.scene = vscode.window.activeTextEditor?.document ?? this.scene;
    if (this.panel === undefined) {
      this.panel = vscode.window.createWebviewPanel(
        "zpg.preview",
        vscode.l10n.t("Preview"),
        { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
        { enableScripts: true, retainContextWhenHidden: true },
      );
      this.panel.onDidDispose(() => (this.panel = undefined));
      this.panel.webview.onDidReceiveMessage((message) => {
        this.alone = message.alone ?? this.alone;
        this.later();
      });
      this.panel.webview.html = page(this.alone);
    }
    this.later();
  }

  dispose(): void {
    this.panel?.dispose();
    this.listeners.forEach((listener) => listener.dispose());
  }

  private later(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.draw(), PAUSE);
  }

  private async draw(): Promise<void> {
    const client = this.client();
    const { panel, scene } = this;
    if (panel === undefined || scene === undefined || client === undefined) {
      return;
    }
    this.asking?.cancel();
    const asking = new vscode.CancellationTokenSource();
    this.asking = asking;
    const editor = vscode.window.visibleTextEditors.find((e) => e.document === scene);
    const token = `preview-${(this.count += 1)}`;
    const show = (picture: Picture) => {
      if (!asking.token.isCancellationRequested) {
        void panel.webview.postMessage({ picture });
      }
    };
    const coarse = client.onProgress(new ProgressType<Picture>(), token, show);
    try {
      const params = {
        textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(scene),
        position: this.alone && editor ? client.code2ProtocolConverter.asPosition(editor.selection.active) : null,
        width: 480,
        height: 360,
        partialResultToken: token,
      };
      show(await client.sendRequest<Picture>("zpg/preview", params, asking.token));
    } catch (error) {
      // An edit has come in between: its picture is asked for already.
      const code = (error as { code?: number }).code;
      if (code !== -32800 && code !== -32801 && !asking.token.isCancellationRequested) {
        void panel.webview.postMessage({ error: error instanceof Error ? error.message : String(error) });
      }
    } finally {
      coarse.dispose();
    }
  }
}

/** The page; `alone` is what its box says at first. */
function page(alone: boolean): string {
  const label = vscode.l10n.t("the object at the cursor alone");
  return `<!DOCTYPE html>
<html>
<head>
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<style>
  body { display: flex; flex-direction: column; gap: 8px; padding: 8px; }
  img { width: 100%; max-width: 960px; image-rendering: auto; }
  #error { color: var(--vscode-errorForeground); }
</style>
</head>
<body>
<label><input type="checkbox" id="alone"${alone ? " checked" : ""}> ${label}</label>
<div id="error"></div>
<img id="picture" alt="">
<script>
  const host = acquireVsCodeApi();
  const of = (id) => document.getElementById(id);
  of("alone").addEventListener("change", () => host.postMessage({ alone: of("alone").checked }));
  window.addEventListener("message", ({ data }) => {
    of("error").textContent = data.error ?? "";
    if (data.picture) {
      of("picture").src = "data:image/png;base64," + data.picture.png;
      of("picture").dataset.width = data.picture.width;
      of("picture").dataset.id = data.picture.id ?? "";
    }
  });
  host.postMessage({});
</script>
</body>
</html>`;
}
