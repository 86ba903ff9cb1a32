// The Khronos glTF validator on each file named: prints what it finds, ends with 1 on any error or warning.
// The validator is looked for in GLISSON_NODE_MODULES, then in build/node/node_modules and tests/support/node_modules.
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const places = [process.env.GLISSON_NODE_MODULES, join(here, "../../build/node/node_modules"), join(here, "node_modules")];
const modules = places.find((place) => place && existsSync(join(place, "gltf-validator")));
if (!modules) {
  console.error("gltf-validator is not installed: npm ci --prefix build/node, with tests/support/package.json and its lock copied there");
  process.exit(3);
}
const validator = createRequire(join(resolve(modules), "x.js"))("gltf-validator");

let failed = process.argv.length < 3;
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { uri: file, format: "glb" });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`);
  for (const message of messages) {
    console.log(`  ${message.code} ${message.pointer ?? ""}: ${message.message}`);
  }
  failed = failed || numErrors > 0 || numWarnings > 0;
}
process.exit(failed ? 1 : 0);
