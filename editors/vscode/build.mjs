// Makes what is packed: the program in one file, and the page of the extension with its pictures within, so that they are
// shown without a net.

import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

await build({
  entryPoints: ["src/extension.ts"],
  outfile: "out/extension.js",
  bundle: true,
  platform: "node",
  format: "cjs",
  external: ["vscode"],
  minify: true,
  target: "node18",
});

const within = (file) => `data:image/png;base64,${readFileSync(file).toString("base64")}`;
const page = readFileSync("README.md", "utf8");
writeFileSync("out/README.md", page.replace(/\]\((images\/[^)]+\.png)\)/g, (_, file) => `](${within(file)})`));
