#!/usr/bin/env node
// Runs the program of the package for this system and processor, which npm installs beside this one.
"use strict";

const { spawn } = require("node:child_process");

const platform = `${process.platform}-${process.arch}`;

function program() {
  const name = process.platform === "win32" ? "zpg.exe" : "zpg";
  try {
    return require.resolve(`@zpg/${platform}/bin/${name}`);
  } catch {
    console.error(
      `error: the package @zpg/${platform}, which holds the program zpg, is not installed; ` +
        "npm leaves it out with --omit=optional, and where there is no zpg for this system\n" +
        `chyba: balíček @zpg/${platform} s programem zpg není nainstalován; ` +
        "npm ho vynechá při --omit=optional a tam, kde zpg pro tento systém není",
    );
    process.exit(2);
  }
}

const child = spawn(program(), process.argv.slice(2), { stdio: "inherit" });
// The terminal sends Ctrl-C to both; what is sent to this process alone is passed on. The program decides how it ends.
process.on("SIGINT", () => {});
for (const signal of ["SIGTERM", "SIGHUP"]) {
  process.on(signal, () => child.kill(signal));
}
child.on("error", (error) => {
  console.error(`error: cannot run ${child.spawnfile}: ${error.message}`);
  process.exit(2);
});
child.on("exit", (code, signal) => {
  if (signal === null) {
    process.exit(code);
  }
  process.removeAllListeners(signal);
  process.kill(process.pid, signal);
});
