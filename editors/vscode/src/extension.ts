// The client of `zpg lsp`, the commands of the palette, and the preview.

import * as vscode from "vscode";
import { LanguageClient, LanguageClientOptions, ServerOptions } from "vscode-languageclient/node";
import { Preview } from "./preview";

let client: LanguageClient | undefined;

/** Commands that the server may name in buttons; the others are the server's own. */
const OWN_COMMANDS = ["zpg.preview", "zpg.showReferences"];

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const preview = new Preview(() => client);
  const command = (name: string, run: (...args: any[]) => unknown) =>
    context.subscriptions.push(vscode.commands.registerCommand(name, run));
  command("zpg.preview", () => preview.open());
  command("zpg.showReferences", showReferences);
  command("zpg.renderScene", () => onScene("zpg.render"));
  command("zpg.planScene", () => onScene("zpg.plan"));
  command("zpg.crosscheckScene", () => onScene("zpg.crosscheck"));
  command("zpg.accuracyOfScene", () => onScene("zpg.accuracy"));
  command("zpg.convertScene", convert);
  command("zpg.restart", async () => {
    await stop();
    await start();
  });
  context.subscriptions.push(preview);
  await start();
}

export function deactivate(): Thenable<void> | undefined {
  return stop();
}

async function stop(): Promise<void> {
  const old = client;
  client = undefined;
  await old?.dispose();
}

async function start(): Promise<void> {
  const settings = vscode.workspace.getConfiguration("zpg");
  const path = settings.get<string>("serverPath") || "zpg";
  const server: ServerOptions = { command: path, args: ["lsp"] };
  const options: LanguageClientOptions = {
    documentSelector: [{ language: "zpg" }],
    synchronize: { configurationSection: "zpg" },
    initializationOptions: { ...JSON.parse(JSON.stringify(settings)), commands: OWN_COMMANDS },
    initializationFailedHandler: () => false,
    middleware: {
      window: {
        // Pictures are no texts: the editor chooses how to show them.
        showDocument: async (params, token, next) => {
          if (!params.uri.endsWith(".png")) {
            return next(params, token);
          }
          await vscode.commands.executeCommand("vscode.open", vscode.Uri.parse(params.uri), vscode.ViewColumn.Beside);
          return { success: true };
        },
      },
    },
  };
  client = new LanguageClient("zpg", "ZPG", server, options);
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    await sayWhatIsMissing(path, error);
  }
}

async function sayWhatIsMissing(path: string, error: unknown): Promise<void> {
  const settings = "Open Settings";
  const again = "Try Again";
  const chosen = await vscode.window.showErrorMessage(
    `zpg could not be started as "${path}". Install it (cargo install --path . in the folder of zpg), ` +
      `or set zpg.serverPath to where it is. ${error instanceof Error ? error.message : ""}`,
    settings,
    again,
  );
  if (chosen === settings) {
    await vscode.commands.executeCommand("workbench.action.openSettings", "zpg.serverPath");
  } else if (chosen === again) {
    await start();
  }
}

/** Runs a command of the server on the scene in the active editor. */
async function onScene(command: string, ...args: unknown[]): Promise<void> {
  const scene = vscode.window.activeTextEditor?.document;
  if (scene?.languageId !== "zpg" || client === undefined) {
    void vscode.window.showInformationMessage("Open a scene first.");
    return;
  }
  const asked = client;
  const params = { command, arguments: [asked.code2ProtocolConverter.asUri(scene.uri), ...args] };
  await vscode.window.withProgress(
    { location: vscode.ProgressLocation.Notification, title: `zpg ${command.slice(4)}`, cancellable: true },
    async (_, cancelled) => {
      try {
        await asked.sendRequest("workspace/executeCommand", params, cancelled);
      } catch (error) {
        if (!cancelled.isCancellationRequested) {
          void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
        }
      }
    },
  );
}

async function convert(): Promise<void> {
  const targets = ["pov", "mitsuba", "ply", "obj", "glb", "json"];
  const target = await vscode.window.showQuickPick(targets, { placeHolder: "Convert the scene to" });
  if (target !== undefined) {
    await onScene("zpg.convert", target);
  }
}

/** What a "used by" button does: it shows the references to the ID at a place. */
async function showReferences(uri: string, at: { line: number; character: number }): Promise<void> {
  const scene = vscode.Uri.parse(uri);
  const place = new vscode.Position(at.line, at.character);
  const found = await vscode.commands.executeCommand<vscode.Location[]>(
    "vscode.executeReferenceProvider",
    scene,
    place,
  );
  await vscode.commands.executeCommand("editor.action.showReferences", scene, place, found);
}
