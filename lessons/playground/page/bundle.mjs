// Makes one file of the playground that needs no other:
//   node bundle.mjs WASM-FOLDER SCENES-FOLDER OUT-FILE
// The first folder has cairn_playground.js and cairn_playground.wasm. It calls esbuild, and nothing else.
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { lettersOf } from "./packing.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const [built, scenes, out] = process.argv.slice(2);
if (!out) {
  console.error("node bundle.mjs WASM-FOLDER SCENES-FOLDER OUT-FILE");
  process.exit(2);
}

const page = (name) => readFileSync(join(here, name), "utf8");
const esbuild = (file, ...options) =>
  execFileSync(
    "esbuild",
    [join(here, file), "--minify", "--charset=utf8", "--log-level=warning", ...options],
    {
      encoding: "utf8",
      maxBuffer: 1 << 26,
    },
  );

// Nothing in an element may look like its end.
const script = (content, attributes = "") =>
  `<script${attributes}>${content.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--")}</script>`;

const texts = Object.fromEntries(
  [here, scenes].flatMap((folder) =>
    readdirSync(folder)
      .filter((name) => name.endsWith(".toml"))
      .sort()
      .map((name) => [basename(name, ".toml"), readFileSync(join(folder, name), "utf8")]),
  ),
);
const zipped = (content) => gzipSync(content, { level: 9, memLevel: 9 });
const packed = (content) => lettersOf(zipped(content));
const wasm = packed(readFileSync(join(built, "cairn_playground.wasm")));
// Scripts, in base 64, which a browser unpacks without one of ours: this one runs them.
const begin = `(async () => {
  for (const id of ["core-script", "page-script"]) {
    const bytes = Uint8Array.from(atob(document.getElementById(id).textContent), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    document.body.append(Object.assign(document.createElement("script"), { text: await new Response(stream).text() }));
  }
})()`;
const parts = {
  style: `<style>${["style", "layout", "plot", "beginning", "view"].map((name) => esbuild(`${name}.css`)).join("")}</style>`,
  scripts: [
    script(packed(JSON.stringify(texts)), ' type="text/plain" id="scenes"'),
    script(wasm, ' type="text/plain" id="wasm"'),
    script(
      zipped(readFileSync(join(built, "cairn_playground.js"))).toString("base64"),
      ' type="text/plain" id="core-script"',
    ),
    script(
      zipped(esbuild("main.js", "--bundle", "--format=iife", "--target=es2022")).toString("base64"),
      ' type="text/plain" id="page-script"',
    ),
    script(begin),
  ].join("\n"),
};
const address = readFileSync(join(here, "../base_address.txt"), "utf8").trim();
const html = page("index.html")
  .replace('data-address=""', () => `data-address="${address}"`)
  .replace(/<!-- (style|scripts) -->/g, (_, name) => parts[name]);
mkdirSync(dirname(out), { recursive: true });
writeFileSync(out, html);
console.log(
  `${out}: ${(Buffer.byteLength(html) / 1e6).toFixed(2)} MB, of which the core ${(wasm.length / 1e6).toFixed(2)} MB`,
);
