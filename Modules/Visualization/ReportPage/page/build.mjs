// Bundles src/main.js with its libraries into one file, and lists what is in it with its licence: node build.mjs OUTPUT
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "esbuild";

const output = process.argv[2];
const result = await build({
  entryPoints: ["src/main.js"],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  charset: "ascii",
  legalComments: "none",
  metafile: true,
  outfile: join(output, "report.js"),
  logLevel: "warning",
});

// Only what has bytes in the bundle: a package of which nothing was used is not passed on.
const inputs = Object.values(result.metafile.outputs).flatMap(file => Object.entries(file.inputs));
const packages = new Set(inputs.filter(([, use]) => use.bytesInOutput > 0)
  .map(([name]) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(name)?.[1]).filter(Boolean));
const licences = [...packages].sort().map(name => {
  const folder = join("node_modules", name);
  const about = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find(entry => /^licen[cs]e/i.test(entry));
  return { name, version: about.version, licence: about.license, text: file ? readFileSync(join(folder, file), "utf8").trim() : "" };
});
writeFileSync(join(output, "licences.json"), JSON.stringify(licences));
