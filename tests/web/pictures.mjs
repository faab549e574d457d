// Holds the pictures that WebGL2 draws in Chromium against those that were drawn here:
//   node pictures.mjs WASM-FOLDER LIST
// LIST is what cairn_web_pictures printed. A rasterizer may round corners to a sixteenth of a pixel (OpenGL ES 3.0 asks for
// four bits). An edge's coverage is then off by as much, and that of a pixel in a corner by twice as much: 32 of 256. And
// only pixels on edges may differ: by more than 4 of 256 at most one in a hundred.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const { chromium } = createRequire(join(process.cwd(), "here.js"))("playwright-core");
const [built, list] = process.argv.slice(2);
const most = 32;
const mostPixels = 0.01;
const difference = 4;

/** What the page does: draws with the core, and counts where it differs from the picture. */
const compare = async ({ wasm, text, png, width, height, scale, theme, steps, rows, difference }) => {
  const bytes = Uint8Array.from(atob(wasm), (letter) => letter.charCodeAt(0));
  const canvas = document.createElement("canvas");
  canvas.id = "cairn";
  canvas.width = scale * width;
  canvas.height = scale * height;
  document.body.replaceChildren(canvas);
  // eslint-disable-next-line no-undef
  const core = await makeCairn({ wasmBinary: bytes.buffer });
  const done = (name, types, values) => core.ccall(name, "number", types, values) === 1;
  const refusals = [
    done("cairn_open", ["string", "string"], [text, "scene"]),
    done("cairn_step", ["number"], [steps]),
    rows === 0 || done("cairn_row", ["number"], [rows]),
    done("cairn_resize", ["number", "number", "number"], [width, height, scale]),
    done("cairn_theme", ["string"], [theme]),
    done("cairn_draw", [], []),
  ].filter((was) => !was).length;
  if (refusals > 0) return { refusal: core.ccall("cairn_refusal", "string", [], []) };
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const pixels = (source) => {
    const copy = document.createElement("canvas");
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext("2d");
    context.drawImage(source, 0, 0);
    return context.getImageData(0, 0, copy.width, copy.height).data;
  };
  const here = pixels(canvas);
  const there = pixels(image);
  let far = 0;
  let largest = 0;
  for (let i = 0; i < here.length; i += 4) {
    let most = 0;
    for (let k = i; k < i + 3; ++k) {
      const gap = Math.abs(here[k] - there[k]);
      most = Math.max(most, gap);
    }
    if (most > difference) ++far;
    largest = Math.max(largest, most);
  }
  return { far: far / (canvas.width * canvas.height), largest };
};

const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const wasm = readFileSync(join(built, "cairn_playground.wasm")).toString("base64");
let passed = 0;
let failed = 0;
for (const line of readFileSync(list, "utf8").trim().split("\n")) {
  const [file, width, height, scale, theme, steps, rows, scene] = line.split(" ");
  const tab = await browser.newPage();
  await tab.setContent("<!doctype html><title>picture</title>");
  await tab.addScriptTag({ path: join(built, "cairn_playground.js") });
  const found = await tab.evaluate(compare, {
    wasm,
    text: readFileSync(scene, "utf8"),
    png: readFileSync(file).toString("base64"),
    width: Number(width),
    height: Number(height),
    scale: Number(scale),
    theme,
    steps: Number(steps),
    rows: Number(rows),
    difference,
  });
  const holds = !found.refusal && found.largest <= most && found.far <= mostPixels;
  console.log(`${holds ? "ok    " : "FAILED"} ${file} ${JSON.stringify(found)}`);
  if (holds) ++passed;
  else ++failed;
  await tab.close();
}
await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 && passed > 0 ? 0 : 1);
