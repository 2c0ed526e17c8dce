// The real VS Code with the extension as it is packed, in a headless browser; then the tests within its extension
// host (vscode-api). usage: node vscode.mjs EDITORS VSIX ZPG OUT
//
// ZPG is the path of the program, or `packed` where the extension has one.
//
// EDITORS holds what tests/run installs: `vscode` (the server of code-server) and `browser` (playwright-core).

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { files } from "./vscode-window/files.mjs";
import { typing } from "./vscode-window/typing.mjs";

const [editors, vsix, zpg, out] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const { chromium } = createRequire(join(editors, "browser", "x.js"))("playwright-core");
mkdirSync(out, { recursive: true });

// A fresh profile: what is not saved comes back in the next session otherwise.
const home = mkdtempSync(join(tmpdir(), "zpg-vscode-"));
const workspace = join(home, "scenes");
mkdirSync(workspace);
cpSync(join(here, "scene.zpg"), join(workspace, "a.zpg"));
cpSync(join(here, "scene.zpg"), join(workspace, "b.zpg"));
for (const name of ["one", "two", "three"]) cpSync(join(here, "scene.zpg"), join(workspace, `${name}.zpg`));
writeFileSync(join(workspace, "typed.zpg"), "");
writeFileSync(join(workspace, "right.zpg"), "2 9 1\n1 9999 2 0\n");
mkdirSync(join(home, "data", "data", "User"), { recursive: true });
const settings = {
  "files.autoSave": "off",
  "files.hotExit": "off",
  "workbench.startupEditor": "none",
  "workbench.secondarySideBar.defaultVisibility": "hidden",
  "chat.disableAIFeatures": true,
  "extensions.autoUpdate": false,
  "extensions.autoCheckUpdates": false,
  "telemetry.telemetryLevel": "off",
  "editor.inlayHints.enabled": "on",
  "editor.hover.delay": 100,
  "editor.codeActionsOnSave": {},
  "zpg.serverPath": zpg === "packed" ? undefined : join(home, "nowhere", "zpg"),
};
writeFileSync(join(home, "data", "data", "User", "settings.json"), JSON.stringify(settings));

const main = [
  join(editors, "vscode", "out", "server-main.js"),
  "--server-data-dir",
  join(home, "data"),
  "--extensions-dir",
  join(home, "extensions"),
  "--accept-server-license-terms",
];
const installed = spawnSync(process.execPath, [...main, "--install-extension", vsix], { encoding: "utf8" });
assert.equal(installed.status, 0, installed.stdout + installed.stderr);

const port = await new Promise((found) => {
  const probe = createServer().listen(0, "127.0.0.1", () => {
    const { port } = probe.address();
    probe.close(() => found(port));
  });
});
const options = ["--host", "127.0.0.1", "--port", String(port), "--without-connection-token", "--disable-telemetry"];
const server = spawn(
  process.execPath,
  [...main, ...options, "--disable-workspace-trust", "--enable-smoke-test-driver"],
  { detached: true, stdio: "ignore" },
);
const base = `http://127.0.0.1:${port}`;

let failed = 0;
let browser;
try {
  for (let tries = 0; ; tries += 1) {
    if (await fetch(base).then((r) => r.ok, () => false)) break;
    assert.ok(tries < 200, "the server does not start");
    await new Promise((r) => setTimeout(r, 100));
  }
  const flags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [...flags, "--disable-component-update", "--disable-sync"],
  });
  await inTheWindow();
  await inTheHost();
} catch (error) {
  failed += 1;
  console.log(`not ok - ${error.stack}`);
} finally {
  await browser?.close();
  // The extension host outlives the server alone.
  try {
    process.kill(-server.pid, "SIGKILL");
  } catch {}
  rmSync(home, { recursive: true, force: true, maxRetries: 5 });
}
process.exit(failed > 0 ? 1 : 0);

/** What people see and do. */
async function inTheWindow() {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  page.setDefaultTimeout(30000);
  let number = 0;
  const step = async (name, run) => {
    number += 1;
    const file = `${String(number).padStart(2, "0")}-${name.replaceAll(" ", "-")}.png`;
    try {
      await run();
      await page.screenshot({ path: join(out, file) });
      console.log(`ok - ${name}`);
    } catch (error) {
      failed += 1;
      await page.screenshot({ path: join(out, `failed-${file}`) });
      console.log(`not ok - ${name}: ${error.message.split("\n").slice(0, 3).join(" ")}`);
    }
  };
  const palette = async (command) => {
    const input = page.locator(".quick-input-widget input").first();
    // A frame that is just being closed swallows the key.
    for (let tries = 0; tries < 8 && !(await input.isVisible()); tries += 1) {
      if (tries > 0) await page.evaluate(() => document.activeElement?.blur());
      await page.keyboard.press("F1");
      await input.waitFor({ timeout: 3000 }).catch(() => {});
    }
    await page.keyboard.type(command);
    await page.locator(".quick-input-list .monaco-list-row", { hasText: command }).first().click();
  };
  const line = (text) => page.locator(".editor-instance .view-line", { hasText: text }).first();
  const lines = async () => {
    const all = await page.locator(".editor-instance .view-line").allInnerTexts();
    return all.map((text) => text.replaceAll("\u00a0", " "));
  };
  const until = async (what, check) => {
    for (let tries = 0; tries < 200; tries += 1) {
      if (check(await lines())) return;
      await page.waitForTimeout(50);
    }
    throw new Error(`${what}: ${JSON.stringify(await lines())}`);
  };

  /** Waits for a message, and presses one of its buttons; the driver of the tests lets none pop up. */
  const complaint = async (text, button) => {
    const shown = page.locator(".notifications-center .notification-list-item", { hasText: text }).first();
    for (let tries = 0; !(await shown.isVisible()); tries += 1) {
      assert.ok(tries < 20, `no message with ${text}`);
      await palette("Notifications: Show Notifications");
      await page.waitForTimeout(250);
    }
    if (button) {
      await shown.locator(".monaco-button", { hasText: button }).click();
      await shown.waitFor({ state: "detached" });
    }
  };
  /** Sets where zpg is, in the editor of settings that a button has opened. */
  const set = async (path) => {
    const input = page.locator(".settings-editor .setting-item-contents", { hasText: "Server Path" }).locator("input");
    await input.fill(path);
    await page.waitForTimeout(500);
    await palette("View: Close Editor");
  };

  await step("a scene is opened", async () => {
    await page.goto(`${base}/?folder=${workspace}`);
    await page.locator(".explorer-folders-view .monaco-list-row", { hasText: "a.zpg" }).dblclick();
    await page.locator(".editor-instance .view-line").first().waitFor();
  });
  if (zpg !== "packed") {
    await step("zpg is not there", () => complaint(`is not at ${join(home, "nowhere", "zpg")}`, "Open Settings"));
    await step("the setting is wrong", () => set("zpg-is-nowhere"));
    await step("zpg is not in the PATH", async () => {
      await complaint("zpg-is-nowhere, which finds the mistakes in scenes, is not in the PATH", "How to Install");
      const frame = page.frameLocator("iframe.webview.ready").frameLocator("#active-frame");
      await frame.getByText("cargo install --path .").first().waitFor();
    });
    await step("a command says so too", async () => {
      await palette("View: Close Editor");
      await palette("ZPG: Render");
      await complaint("zpg-is-nowhere", "Open Settings");
    });
    // The server starts as soon as the setting is right.
    await step("the setting is right", () => set(zpg));
  }
  await step("a squiggle", () => page.locator(".squiggly-error").first().waitFor());
  await step("hints", () => until("no hints", (all) => all.some((l) => /11\s*sphere\s*x:\s*0\s*y:\s*1/.test(l))));
  await step("a colour box", () => page.locator(".colorpicker-color-decoration").first().waitFor());
  await step("lenses", () => page.locator(".codelens-decoration", { hasText: "Render" }).first().waitFor());
  await step("a hover with a picture", async () => {
    const image = page.locator(".monaco-hover img").first();
    // A hover waits 0.4 s for its picture, which is not enough on a busy machine.
    for (let tries = 0; !(await image.isVisible()); tries += 1) {
      assert.ok(tries < 10, "no hover with a picture");
      await page.mouse.move(640, 700);
      await page.locator(".monaco-hover").first().waitFor({ state: "hidden" });
      await line("-101").hover({ position: { x: 8, y: 8 } });
      await image.waitFor({ timeout: 3000 }).catch(() => {});
    }
    assert.match(await image.getAttribute("src"), /^data:image\/png/);
    assert.ok(await image.evaluate((i) => i.complete && i.naturalWidth === 192));
  });
  await step("a fix is offered", async () => {
    await page.keyboard.press("Escape");
    await page.locator(".editor-instance .view-line").first().click();
    await page.keyboard.press("F8");
    await page.waitForTimeout(300);
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+.");
    await page.locator(".action-widget .monaco-list-row", { hasText: "write `0.5`" }).waitFor();
  });
  await step("the fix is applied", async () => {
    await page.keyboard.press("Enter");
    await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
    await until("0.5", (all) => all.some((l) => l.includes("0.5")));
  });
  await step("rename", async () => {
    await page.keyboard.press("Control+Home");
    await page.keyboard.press("F2");
    await page.locator(".rename-box input.rename-input").waitFor({ state: "visible" });
    await page.waitForFunction(() => document.activeElement?.classList.contains("rename-input"));
    await page.locator(".rename-box input.rename-input").fill("77");
    await page.keyboard.press("Enter");
    await until("77 thrice", (all) => all.filter((l) => /(^|\D)77(\D|$)/.test(l)).length === 3);
  });
  await step("format", async () => {
    await palette("Format Document");
    // Columns of a type stand under each other: the ball's y behind more blanks than one.
    await until("columns", (all) => all.some((l) => /^77 11\D* {2,}\D*0/.test(l)));
  });
  await step("comment out and in", async () => {
    await page.locator(".editor-instance .view-line").first().click();
    const out = (line) => line.startsWith("0 # ~ ");
    for (const [keys, count] of [[["Control+Home", "Control+/"], 1], [["Control+a", "Shift+Alt+a"], 7]]) {
      for (const key of keys) await page.keyboard.press(key);
      await until("out", (all) => all.filter(out).length === count && all[0].includes("~~ ball ~~"));
      await page.keyboard.press(keys.at(-1));
      await until("in", (all) => all.filter(out).length === 0 && all[0].includes("# ball #"));
    }
    await page.keyboard.press("Control+Home");
    // The menu's own command finds nothing to put around a line.
    await palette("Toggle Line Comment");
    await page.waitForTimeout(300);
    await until("nothing", (all) => all.filter(out).length === 0 && all[0].includes("# ball #"));
  });
  await step("completion", async () => {
    await page.keyboard.press("Control+End");
    await page.keyboard.type("80 sph");
    await page.keyboard.press("Control+Space");
    await page.locator(".suggest-widget .monaco-list-row", { hasText: "sphere" }).first().waitFor();
  });
  await step("what was typed is gone", async () => {
    await page.keyboard.press("Escape");
    for (let i = 0; i < 6; i += 1) await page.keyboard.press("Backspace");
  });
  await step("the preview follows", async () => {
    await palette("ZPG: Open Preview");
    const frame = page.frameLocator("iframe.webview.ready").frameLocator("#active-frame");
    const source = () => frame.locator("#picture").getAttribute("src");
    await frame.locator("#picture[data-width='480']").waitFor({ state: "attached" });
    const before = await source();
    await page.locator(".editor-instance .view-line").first().click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("78 -501 4 3 6 -4 -2 -6 0 1 0 30");
    await page.keyboard.press("Enter");
    for (let tries = 0; (await source()) === before; tries += 1) {
      assert.ok(tries < 200, "the picture stays as it is");
      await page.waitForTimeout(50);
    }
    await page.waitForTimeout(500);
  });
  await step("render", async () => {
    await page.locator(".editor-instance .view-line").first().click();
    await palette("ZPG: Render");
    await page.locator(".tab", { hasText: "a.png" }).first().waitFor();
    await page.waitForTimeout(500);
  });
  await step("all is saved and closed", async () => {
    await palette("File: Save All Files");
    await palette("View: Close All Editors");
  });
  const open = async (name) => {
    await page.locator(".explorer-folders-view .monaco-list-row", { hasText: name }).dblclick();
    await page.locator(`.tab.active[data-resource-name="${name}"]`).waitFor();
    await page.locator(".editor-instance .view-line").first().waitFor();
  };
  const tools = { page, step, open, palette, line, workspace };
  await typing(tools);
  await files(tools);
  await page.close();
}

/** The same through the editor's own interface, in the process where extensions run. */
async function inTheHost() {
  const page = await browser.newPage({ viewport: { width: 1000, height: 700 } });
  const uri = (path) => `vscode-remote://127.0.0.1:${port}${path}`;
  let ended;
  const exit = new Promise((resolve) => (ended = resolve));
  await page.exposeFunction("codeAutomationLog", (_, args) => {
    const text = args.map(String).join(" ");
    if (/ok - /.test(text)) console.log(text.slice(text.search(/(not )?ok - /)));
  });
  await page.exposeFunction("codeAutomationExit", (code) => ended(code));
  const payload = [
    ["extensionDevelopmentPath", uri(join(here, "vscode-api"))],
    ["extensionTestsPath", uri(join(here, "vscode-api", "index.js"))],
  ];
  await page.goto(`${base}/?folder=${workspace}&payload=${encodeURIComponent(JSON.stringify(payload))}`);
  const code = await Promise.race([exit, new Promise((r) => setTimeout(() => r("timed out"), 60000))]);
  if (code !== 0) {
    failed += 1;
    await page.screenshot({ path: join(out, "failed-host.png") });
    console.log(`not ok - the tests in the host: ${code}`);
  }
  await page.close();
}
