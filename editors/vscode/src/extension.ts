// The client of `zpg lsp`, the commands of the palette, and the preview.

import * as vscode from "vscode";
import { LanguageClient, LanguageClientOptions, ServerOptions } from "vscode-languageclient/node";
import { comment, Mode } from "./comment";
import { Preview } from "./preview";
import { complain, program } from "./program";

let client: LanguageClient | undefined;

/** What says how zpg is installed. */
let page: vscode.Uri;

/** Where the extension is installed. */
let home: vscode.Uri;

/** The start that runs, or has run: one begins where the last has ended. */
let starting: Promise<void> = Promise.resolve();

/** Commands that the server may name in buttons; the others are the server's own. */
const OWN_COMMANDS = ["zpg.preview", "zpg.showReferences"];

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  home = context.extensionUri;
  page = vscode.Uri.joinPath(home, vscode.l10n.t("INSTALL.md"));
  const preview = new Preview(() => client);
  const command = (name: string, run: (...args: any[]) => unknown) =>
    context.subscriptions.push(vscode.commands.registerCommand(name, run));
  command("zpg.preview", async () => (await isRunning()) && preview.open());
  command("zpg.showReferences", showReferences);
  command("zpg.renderScene", () => onScene("zpg.render"));
  command("zpg.planScene", () => onScene("zpg.plan"));
  command("zpg.crosscheckScene", () => onScene("zpg.crosscheck"));
  command("zpg.accuracyOfScene", () => onScene("zpg.accuracy"));
  command("zpg.convertScene", convert);
  const commented = (mode: Mode) => async () => (await isRunning()) && client && comment(client, mode);
  command("zpg.toggleComment", commented("toggle"));
  command("zpg.commentOut", commented("out"));
  command("zpg.commentIn", commented("in"));
  command("zpg.restart", restart);
  const changed = vscode.workspace.onDidChangeConfiguration(
    (e) => ["zpg.serverPath", "zpg.lang"].some((name) => e.affectsConfiguration(name)) && restart(),
  );
  context.subscriptions.push(preview, changed);
  await restart();
}

export async function deactivate(): Promise<void> {
  await stop();
}

async function stop(): Promise<void> {
  const old = client;
  client = undefined;
  await old?.dispose();
}

function restart(): Promise<void> {
  starting = starting.then(async () => {
    await stop();
    await start();
  });
  return starting;
}

async function start(): Promise<void> {
  const found = await program(home);
  if (found.fault !== undefined) {
    // Nothing waits for the answer.
    void complain(found, page, restart);
    return;
  }
  const settings = vscode.workspace.getConfiguration("zpg");
  const server: ServerOptions = { command: found.path, args: ["lsp"] };
  const options: LanguageClientOptions = {
    documentSelector: [{ language: "zpg" }],
    synchronize: { configurationSection: "zpg" },
    initializationOptions: { ...JSON.parse(JSON.stringify(settings)), commands: OWN_COMMANDS },
    initializationFailedHandler: () => false,
    middleware: {
      executeCommand: run,
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
  const made = new LanguageClient("zpg", "ZPG", server, options);
  try {
    await made.start();
    client = made;
  } catch {
    void complain({ path: found.path, fault: "silent" }, page, restart);
  }
}

/** Whether there is a server; says what is wrong where there is none. */
async function isRunning(): Promise<boolean> {
  await starting;
  if (client === undefined) {
    await restart();
  }
  return client !== undefined;
}

/** Runs a command of the server on the scene in the active editor. */
async function onScene(command: string, ...args: unknown[]): Promise<void> {
  const scene = vscode.window.activeTextEditor?.document;
  if (scene?.languageId !== "zpg") {
    void vscode.window.showInformationMessage(vscode.l10n.t("Open a scene first."));
    return;
  }
  if (await isRunning()) {
    await run(command, [scene.uri.toString(), ...args]);
  }
}

/** Runs a command of the server, also for buttons. What goes wrong is said once, and leads to the scene's mistakes. */
async function run(command: string, args: unknown[]): Promise<unknown> {
  const asked = client;
  return vscode.window.withProgress(
    { location: vscode.ProgressLocation.Notification, title: `zpg ${command.slice(4)}`, cancellable: true },
    async (_, cancelled) => {
      try {
        return await asked?.sendRequest("workspace/executeCommand", { command, arguments: args }, cancelled);
      } catch (error) {
        if (!cancelled.isCancellationRequested) {
          // Nothing waits for the answer.
          void refused(error instanceof Error ? error.message : String(error), String(args[0]));
        }
      }
    },
  );
}

/** Says why the server refuses a command on a scene. */
async function refused(message: string, scene: string): Promise<void> {
  const found = vscode.languages.getDiagnostics(vscode.Uri.parse(scene));
  const hasErrors = found.some((d) => d.severity === vscode.DiagnosticSeverity.Error);
  const problems = vscode.l10n.t("Show Problems");
  const chosen = await vscode.window.showErrorMessage(message, ...(hasErrors ? [problems] : []));
  if (chosen === problems) {
    await vscode.commands.executeCommand("workbench.actions.view.problems");
  }
}

async function convert(): Promise<void> {
  const targets = ["pov", "mitsuba", "ply", "obj", "glb", "stl", "json"];
  const target = await vscode.window.showQuickPick(targets, { placeHolder: vscode.l10n.t("Convert the scene to") });
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
