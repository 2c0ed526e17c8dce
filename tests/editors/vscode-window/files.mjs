// Scenes that are clicked through, renamed and deleted; what is said where a scene has errors; the preview's box.

import assert from "node:assert/strict";
import { renameSync, rmSync } from "node:fs";
import { join } from "node:path";

export async function files({ page, step, open, palette, workspace }) {
  const explorer = (name) => page.locator(".explorer-folders-view .monaco-list-row", { hasText: name }).first();
  /** The files that the list of problems names; it holds only the rows that are in sight, so it is folded first. */
  const named = async () => {
    const list = page.locator(".markers-panel .monaco-list").first();
    if (await list.isVisible()) {
      await list.focus();
      await page.keyboard.press("Control+ArrowLeft");
      await page.waitForTimeout(100);
    }
    return page.locator(".markers-panel .monaco-list-row .file-icon .label-name").allInnerTexts();
  };
  const problems = async (what, check) => {
    for (let tries = 0; tries < 80; tries += 1) {
      if (check(await named())) return;
      await page.waitForTimeout(150);
    }
    throw new Error(`${what}: ${await named()}`);
  };
  /** All that was said since the last call; the driver of the tests lets no message pop up. */
  const said = async () => {
    await palette("Notifications: Show Notifications");
    await page.waitForTimeout(500);
    const all = page.locator(".notifications-center .notification-list-item-message");
    const texts = await all.allInnerTexts();
    await palette(texts.length > 0 ? "Notifications: Clear All Notifications" : "Notifications: Hide Notifications");
    return texts;
  };

  await step("clicking through scenes is quiet", async () => {
    await said();
    await palette("Problems: Focus on Problems View");
    const scenes = ["one.zpg", "two.zpg", "three.zpg"];
    for (let i = 0; i < 12; i += 1) {
      await explorer(scenes[i % 3]).click();
      await page.waitForTimeout([40, 150, 400, 900][i % 4]);
    }
    await problems("not all scenes", (all) => scenes.every((name) => all.includes(name)));
    assert.deepEqual(await said(), []);
  });
  await step("findings go with the name", async () => {
    await explorer("three.zpg").click();
    await page.waitForTimeout(1000);
    await page.keyboard.press("F2");
    await page.locator(".explorer-folders-view input").waitFor();
    await page.locator(".explorer-folders-view input").fill("four.zpg");
    await page.keyboard.press("Enter");
    await problems("renamed", (all) => all.includes("four.zpg") && !all.includes("three.zpg"));
    // Behind the editor's back. A file that is open yet keeps its findings, so another one is shown in its place.
    await explorer("one.zpg").click();
    await page.locator('.tab[data-resource-name="four.zpg"]').waitFor({ state: "detached" });
    renameSync(join(workspace, "four.zpg"), join(workspace, "five.zpg"));
    await problems("renamed outside", (all) => all.includes("five.zpg") && !all.includes("four.zpg"));
    rmSync(join(workspace, "five.zpg"));
    await problems("deleted", (all) => !all.includes("five.zpg") && all.includes("one.zpg"));
    assert.deepEqual(await said(), []);
  });
  await step("render says of errors one line that leads to problems", async () => {
    await open("two.zpg");
    await palette("View: Hide Panel");
    for (const press of [
      () => palette("ZPG: Render"),
      () => page.locator(".codelens-decoration a", { hasText: "Render" }).first().click(),
    ]) {
      await press();
      const item = page.locator(".notifications-center .notification-list-item", { hasText: "an error, in line" });
      for (let tries = 0; !(await item.first().isVisible()); tries += 1) {
        assert.ok(tries < 20, "nothing is said");
        await palette("Notifications: Show Notifications");
        await page.waitForTimeout(250);
      }
      await page.waitForTimeout(1000);
      const texts = await page.locator(".notifications-center .notification-list-item-message").allInnerTexts();
      assert.equal(texts.length, 1, texts.join(" | "));
      assert.match(texts[0], /^the scene has an error, in line 3: .*decimal comma$/);
      await item.locator(".monaco-button", { hasText: "Show Problems" }).click();
      await page.locator(".markers-panel").first().waitFor({ state: "visible" });
      await palette("View: Hide Panel");
    }
  });
  /** The page that was opened last. */
  const webview = () => page.locator("iframe.webview.ready").last().contentFrame().frameLocator("#active-frame");
  await step("the box of the preview says what is drawn", async () => {
    const tab = page.locator(".tab", { hasText: "Preview" });
    const preview = async () => {
      await open("right.zpg");
      await page.locator(".editor-instance .view-line").first().click();
      await page.keyboard.press("Control+Home");
      await palette("ZPG: Open Preview");
      await webview().locator("#picture[data-id]").waitFor({ state: "attached" });
      // What a tab says under the pointer lies above the box.
      await page.mouse.move(1000, 600);
    };
    const drawn = (alone) => webview().locator(`#picture[data-id='${alone ? 2 : ""}']`).waitFor({ state: "attached" });
    for (const alone of [true, false]) {
      await preview();
      await webview().locator("#alone").setChecked(alone);
      await drawn(alone);
      await tab.click();
      await palette("View: Close Editor");
      await tab.waitFor({ state: "detached" });
      await preview();
      await drawn(alone);
      assert.equal(await webview().locator("#alone").isChecked(), alone);
    }
    await palette("View: Close All Editors");
  });
  await step("the page of the extension has pictures", async () => {
    await page.keyboard.press("Control+Shift+X");
    const entry = page.locator(".extension-list-item", { hasText: "ZPG scenes" }).first();
    await entry.waitFor();
    await entry.click();
    const shown = (image) => image.evaluate((i) => i.complete && i.naturalWidth);
    const icon = page.locator(".extension-editor .header img").first();
    await icon.waitFor();
    assert.ok((await shown(icon)) >= 128);
    await webview().locator("img").first().waitFor();
    const pictures = await webview().locator("img").all();
    assert.ok(pictures.length >= 2, `${pictures.length} pictures`);
    for (const picture of pictures) assert.ok((await shown(picture)) >= 128);
  });
}
