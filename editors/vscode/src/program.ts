// The program that the extension needs: where it is, and what is said when it is nowhere.

import { execFile } from "node:child_process";
import { homedir } from "node:os";
import { join } from "node:path";
import * as vscode from "vscode";

/** In the language of the editor. */
const t = vscode.l10n.t;

/** What speaks against a program. */
export type Fault = "missing" | "forbidden" | "strange" | "silent";

/** A program to start, or what is wrong with it. */
export type Program = { path: string; fault?: Fault };

/** How long it may take to say its version, in milliseconds. */
const PATIENCE = 10000;

/**
 * What the setting names. Where it is left alone, the program that is packed with the extension; some packages have
 * none. A name that is not in the PATH is looked for where cargo installs, too.
 */
export async function program(extension: vscode.Uri): Promise<Program> {
  const settings = vscode.workspace.getConfiguration("zpg");
  const named = settings.get<string>("serverPath") || "zpg";
  const set = settings.inspect<string>("serverPath");
  if ((set?.workspaceFolderValue ?? set?.workspaceValue ?? set?.globalValue) === undefined) {
    const name = process.platform === "win32" ? "zpg.exe" : "zpg";
    const packed = vscode.Uri.joinPath(extension, "program", "bin", name).fsPath;
    if ((await faultOf(packed)) === undefined) {
      return { path: packed };
    }
  }
  const path = named.replace(/^~(?=[/\\])/, homedir());
  const fault = await faultOf(path);
  if (fault === "missing" && isName(path)) {
    const installed = join(homedir(), ".cargo", "bin", path);
    if ((await faultOf(installed)) === undefined) {
      return { path: installed };
    }
  }
  return { path, fault };
}

/** Whether it is looked for in the PATH. */
function isName(path: string): boolean {
  return !/[/\\]/.test(path);
}

function faultOf(path: string): Promise<Fault | undefined> {
  return new Promise((resolve) => {
    execFile(path, ["--version"], { timeout: PATIENCE }, (error, out) => {
      if (error === null) {
        resolve(out.startsWith("zpg ") ? undefined : "strange");
        return;
      }
      const faults: Record<string, Fault> = { ENOENT: "missing", EACCES: "forbidden" };
      resolve(faults[String(error.code)] ?? "strange");
    });
  });
}

/** What is wrong, and what to do about it. */
function message({ path, fault }: Program): string {
  const cure = t("Install it, or set zpg.serverPath to where it is.");
  switch (fault) {
    case "missing":
      return isName(path)
        ? t("The program {0}, which finds the mistakes in scenes, is not in the PATH. {1}", path, cure)
        : t("The program zpg, which finds the mistakes in scenes, is not at {0}. {1}", path, cure);
    case "forbidden":
      return t("You may not run {0}. Allow it (chmod +x), or set zpg.serverPath to another zpg.", path);
    case "silent":
      return t("{0} was started and does not answer. The view Output: ZPG has what it said.", path);
    default:
      return t("{0} is not zpg: it does not say its version. Set zpg.serverPath to where zpg is.", path);
  }
}

/** Says what is wrong; `again` is what starts it. */
export async function complain(wrong: Program, page: vscode.Uri, again: () => Promise<void>): Promise<void> {
  const [how, settings, retry] = [t("How to Install"), t("Open Settings"), t("Try Again")];
  const chosen = await vscode.window.showErrorMessage(message(wrong), how, settings, retry);
  switch (chosen) {
    case how:
      return vscode.commands.executeCommand("markdown.showPreview", page);
    case settings:
      // Where the program runs elsewhere than the window, it has settings there.
      return vscode.env.remoteName === undefined
        ? vscode.commands.executeCommand("workbench.action.openSettings", "zpg.serverPath")
        : vscode.commands.executeCommand("workbench.action.openRemoteSettings", { query: "zpg.serverPath" });
    case retry:
      return again();
  }
}
