// Records typed by hand, with VS Code's default settings of suggestions, and hints on the longest ones.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";

/** Twelve records: IDs that begin as others do, types, references, a comment, a file name. */
const RECORDS = [
  "2 11 0 1 0 1",
  "3 12 -1 -1 -1 1 1 1",
  "33 9 0.5 # ball #",
  "2 -701 0.9 0.2 0.1",
  "4 -101 2 3",
  "4 -1 0 0.5 0",
  "5 -102 4 33",
  '33 -301 "moon.png"',
  "6 -101 5 2",
  "6 -2 90 1",
  "9 -501 0 3 8 0 -0.25 -1 0 1 0 45",
  "1 9999 6 0",
];

/** How long a key takes, in milliseconds: from the quickest to the slowest hands. */
const DELAYS = [60, 350, 90, 120, 300, 150, 180, 210, 240, 270, 60, 330];

export async function typing({ page, step, open, line, workspace }) {
  await step("twelve records come out as they are typed", async () => {
    await open("typed.zpg");
    await page.locator(".editor-instance .view-lines").first().click();
    for (const [i, record] of RECORDS.entries()) {
      await page.keyboard.type(record, { delay: DELAYS[i] });
      await page.keyboard.press("Enter");
    }
    await page.keyboard.press("Control+S");
    const wanted = RECORDS.map((r) => `${r}\n`).join("");
    const text = () => readFileSync(join(workspace, "typed.zpg"), "utf8");
    for (let tries = 0; text() === "" && tries < 100; tries += 1) await page.waitForTimeout(50);
    assert.equal(text(), wanted);
  });
  await step("the longest record has all its names", async () => {
    const camera = line("-501");
    for (let tries = 0; !/angle|fov|α/i.test(await camera.innerText()) && tries < 40; tries += 1) {
      await page.waitForTimeout(100);
    }
    const text = (await camera.innerText()).replaceAll("\u00a0", " ");
    assert.equal((text.match(/\p{L}\w*:/gu) ?? []).length, 10, text);
    assert.ok(!text.includes("…"), text);
  });
}
