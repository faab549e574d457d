// The playground begins here: takes the core out of the page, opens what the address asks for, and sets up all parts.
import { App } from "./app.js";
import { readAddress, through } from "./address.js";
import { bytesOfLetters } from "./packing.mjs";
import { Core } from "./core.js";
import { Tools } from "./tools.js";
import { button, find, show } from "./dom.js";
import { excerpt, number, say, sayRefusal } from "./words.js";
import { sceneFiles, setUpScenes } from "./scenes.js";
import { setUpBeginning } from "./beginning.js";
import { setUpChallenges } from "./challenges.js";
import { setUpControls } from "./controls.js";
import { setUpCursor } from "./cursor.js";
import { setUpGoing } from "./going.js";
import { setUpKeys } from "./keys.js";
import { setUpLegend } from "./legend.js";
import { setUpMotion } from "./motion.js";
import { setUpPlot } from "./plot.js";
import { setUpPointer } from "./pointer.js";
import { setUpQuiz } from "./quiz.js";
import { setUpRows } from "./rows.js";
import { setUpSaving } from "./save.js";
import { setUpScrub } from "./scrub.js";
import { setUpTheme } from "./theme.js";
import { setUpView } from "./view.js";

/** @typedef {import("./address.js").Address} Address */

/** Emscripten's; bundle.mjs puts it before this script. */
const makeCairn =
  /** @type {(options: {wasmBinary: Uint8Array}) => Promise<import("./core.js").CairnModule>} */ (
    Reflect.get(globalThis, "makeCairn")
  );

/** What the bundler has put into the page. @param {string} id */
const unpacked = (id) =>
  through(bytesOfLetters(find(id, HTMLScriptElement).textContent ?? ""), new DecompressionStream("gzip"));

async function loadCore() {
  return new Core(await makeCairn({ wasmBinary: await unpacked("wasm") }));
}

/**
 * The height of a picture of that width [px]: a narrow one has its rows below the scene; a wide one leaves room for the
 * line of numbers and the buttons. What is asked stands on the screen with it.
 * @param {number} width
 */
function heightFor(width) {
  const { classList } = document.body;
  const below = classList.contains("asking") ? find("question", HTMLElement).offsetHeight + 24 : 280;
  const isBounded = classList.contains("asking") || (width < 600 && classList.contains("beginning"));
  const most = isBounded ? Math.max(window.innerHeight - below, 1.1 * Math.min(width, 400)) : Infinity;
  if (width < 600) return Math.round(Math.min(1.6 * width, most));
  if (width < 900) return Math.round(Math.min(0.7 * width, most));
  return Math.round(Math.min(Math.max(Math.min(0.6 * width, window.innerHeight - 260), 440), most));
}

/** The picture has the size that the page has for it. @param {App} app */
function setUpSize(app) {
  const canvas = find("cairn", HTMLCanvasElement);
  const frame = find("frame", HTMLElement);
  const pause = 80; // [ms] while a window is pulled
  let timer = 0;
  const resize = () => {
    const width = Math.max(320, Math.round(frame.clientWidth));
    const height = heightFor(width);
    let scale = Math.min(Math.max(window.devicePixelRatio, 1), 3);
    const pixels = () => [Math.round(scale * width), Math.round(scale * height)];
    if (canvas.width === pixels()[0] && canvas.height === pixels()[1]) return;
    do [canvas.width, canvas.height] = pixels();
    while (!app.core.resize(width, height, scale) && (scale /= 2) >= 0.5); // a picture has only so many
    app.core.draw();
    app.player.wake();
  };
  const resizeSoon = () => {
    clearTimeout(timer);
    timer = setTimeout(resize, pause);
  };
  new ResizeObserver(resizeSoon).observe(frame);
  window.addEventListener("resize", resizeSoon); // also when the page is zoomed
  resize();
}

/** @param {App} app */
function setUpButtons(app) {
  const { core } = app;
  /** @type {Record<string, () => void>} */
  const acts = {
    run: () => app.toggleRunning(),
    slow: () => app.toggleSlow(),
    row: () => app.actPaused(() => core.row(1)),
    sweep: () => app.actPaused(() => core.sweep()),
    step: () => app.actPaused(() => core.step(1)),
    back: () => app.actPaused(() => core.back()),
    "diverged-back": () => app.actPaused(() => core.back()),
    restart: () => app.act(() => app.restart()),
    undo: () => app.act(() => core.undo()),
  };
  const plan = find("plan-part", HTMLDetailsElement);
  const writePlan = () => plan.open && (find("plan", HTMLElement).textContent = core.plan());
  plan.addEventListener("toggle", writePlan);
  find("skip", HTMLAnchorElement).addEventListener("click", (event) => {
    event.preventDefault(); // the address holds the scene
    find("cairn", HTMLCanvasElement).focus();
  });
  for (const [id, act] of Object.entries(acts)) button(id).addEventListener("click", act);
  app.follow(() => {
    const { player } = app;
    button("run").textContent = player.isRunning ? "Pause" : "Run";
    button("slow").ariaPressed = String(player.isSlow);
    const { diverged, rows } = core.numbers();
    show(find("diverged", HTMLElement), diverged === 1);
    const bodies = core.bodies().filter(({ isThere }) => isThere).length;
    const now = `${app.own.title}: ${bodies} bodies with the ground, ${rows} rows.`;
    find("canvas-now", HTMLElement).textContent = now;
    writePlan();
  });
}

/** Writes the numbers of now, as often as they can be read. @param {App} app */
function setUpNumbers(app) {
  const pause = 300; // [ms], for which the time of a step is averaged: browsers measure coarsely
  let written = 0;
  let sum = 0;
  let count = 0;
  app.followPictures(() => {
    const { time, steps, updates, allUpdates, sweep, residual, milliseconds } = app.core.numbers();
    sum += milliseconds;
    ++count;
    if (app.player.isRunning && performance.now() - written < pause) return;
    const parts = [`Step ${steps}`, `${time.toFixed(3)} s`];
    if (updates > 0)
      parts.push(`sweep ${sweep}`, `row update ${updates} of ${allUpdates}`, `residual ${number(residual)}`);
    else if (steps > 0) parts.push(`${(sum / count).toFixed(2)} ms to compute a step`);
    find("numbers", HTMLElement).textContent = parts.join(" · ");
    written = performance.now();
    [sum, count] = [0, 0];
  });
}

/** The settings of the address, as far as the core takes them. @param {App} app @param {Address} address */
function setAsAddressed({ core }, { settings }) {
  const most = 100; // more letters, or settings, than any have
  if (settings.size > most) return `The address has ${settings.size} settings, more than there are.`;
  let words = "";
  for (const [name, value] of settings) {
    if (name.length > most || value.length > most)
      words ||= `The address has a setting that is too long: "${excerpt(name)}", "${excerpt(value)}".`;
    else if (!core.set(name, value)) words ||= core.refusal();
  }
  return words;
}

/**
 * Opens what the address asks for, at rest, as a reader expects who has yet to press a button.
 * @param {App} app
 * @param {Address} address
 */
function openAddress(app, address) {
  const { player } = app;
  const isKnown = address.scene === "" || app.scenes.some(({ name }) => name === address.scene);
  let words = isKnown ? "" : `There is no scene "${excerpt(address.scene)}" in the list.`;
  const file = isKnown && address.scene ? address.scene : app.scenes[0].name;
  if (!app.open(file, address.text ?? undefined)) {
    words = app.core.refusal();
    app.open(file);
  }
  words ||= address.trouble;
  words = setAsAddressed(app, address) || words;
  if (words) sayRefusal(words);
  else if (address.at > 0) say(`Going to step ${address.at}.`);
  else if (address.isGiven) say("It stands still. Press Run, or go row by row.");
  else say("Nothing holds the boxes yet. Press One row: the first contact pushes.");
  if (address.at > 0) player.goTo(address.at);
  else player.pause();
  app.changed();
}

/** In a lesson only the picture, the buttons and the settings that its address names. @param {App} app @param {Address} address */
function embed(app, address) {
  document.body.classList.add("embedded");
  for (const field of document.querySelectorAll(".field")) {
    if (!(field instanceof HTMLElement)) continue;
    find("settings-first", HTMLElement).append(field);
    show(field, address.settings.has(field.dataset.setting ?? ""));
  }
  const seen = new IntersectionObserver(([entry]) => app.player.setInView(entry.isIntersecting));
  seen.observe(find("frame", HTMLElement));
}

let asked = 0;

/** Opens what the address asks for, unless it has become another meanwhile. @param {App} app */
async function followAddress(app) {
  const number = ++asked;
  const address = await readAddress(location.hash, app.core.mostText);
  if (number === asked) openAddress(app, address);
}

async function begin() {
  const core = await loadCore();
  if (!core.draw()) throw new Error(core.refusal()); // a browser without WebGL2
  const scenes = JSON.parse(new TextDecoder().decode(await unpacked("scenes")));
  const app = new App(core, sceneFiles(scenes));
  const tools = new Tools(app);
  const address = await readAddress(location.hash, core.mostText);
  setUpTheme(app);
  setUpScenes(app);
  setUpControls(app);
  const view = setUpView(app, address.isEmbedded);
  setUpPointer(app, tools, view);
  setUpCursor(app, tools);
  setUpKeys(app, view);
  setUpScrub(app);
  setUpRows(app);
  setUpGoing(app);
  setUpPlot(app);
  setUpQuiz(app);
  setUpChallenges(app);
  setUpButtons(app);
  setUpLegend();
  setUpNumbers(app);
  openAddress(app, address);
  setUpSaving(app, address.isEmbedded);
  if (address.isEmbedded) embed(app, address);
  setUpBeginning(app, address.isGiven);
  setUpMotion(app);
  setUpSize(app);
  window.addEventListener("hashchange", () => followAddress(app));
  Object.assign(globalThis, { cairn: core }); // for those who look under the bonnet
  document.body.dataset.state = "ready";
}

begin().catch((error) => {
  const trouble = find("trouble", HTMLElement);
  trouble.textContent = `The playground cannot begin: ${error.message ?? error}`;
  show(trouble, true);
});
