// Which part of the scene is seen, by wheel, two fingers, keys and buttons; and walls around it.
import { button, find } from "./dom.js";
import { placeOf } from "./pointer.js";

/** @typedef {import("./app.js").App} App */

const canvas = find("cairn", HTMLCanvasElement);
const aPress = 1.25; // by which a key or a button makes it larger
const aKey = 60; // [px] by which a key moves it
const aWheel = 0.002; // of the logarithm, for a pixel of the wheel
const line = 16; // [px] of wheels that count lines

/** @typedef {{x: number, y: number, far: number}} Pinch the middle of two fingers, and how far they are apart [px] */

export class View {
  #app;
  /** @type {Pinch | null} */
  #pinch = null;

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
  }

  /** Around a place; without one around the middle of the scene. @param {number} factor @param {{x: number, y: number}} [place] */
  zoom(factor, place) {
    const { x, y } = place ?? this.#middle();
    this.#app.core.zoom(factor, x, y);
    this.#app.player.wake();
  }

  /** @param {number} x [px] @param {number} y [px] */
  pan(x, y) {
    this.#app.core.pan(x, y);
    this.#app.player.wake();
  }

  showAll() {
    this.#app.core.showAll();
    this.#app.player.wake();
  }

  /** Moves what is seen by a key. @param {string} key @returns {boolean} whether it is one of an arrow */
  panByKey(key) {
    const ways = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const way = ways[/** @type {keyof typeof ways} */ (key)];
    if (way) this.pan(way[0] * aKey, way[1] * aKey);
    return Boolean(way);
  }

  /** Of the first scene: halfway between the ends of what is one on the picture. */
  #middle() {
    const { core } = this.#app;
    const { width, height } = canvas.getBoundingClientRect();
    const scale = core.width / width;
    const isScene = (/** @type {number} */ x, /** @type {number} */ y) => core.at(x, y).kind === "scene";
    const places = Array.from({ length: 50 }, (_, i) => (i + 0.5) / 50);
    const ys = places.map((share) => share * height * scale).filter((y) => isScene(core.width / 8, y));
    const y = ((ys[0] ?? 0) + (ys[ys.length - 1] ?? 0)) / 2;
    const xs = places.map((share) => share * core.width).filter((x) => isScene(x, y));
    return { x: ((xs[0] ?? 0) + (xs[xs.length - 1] ?? 0)) / 2, y };
  }

  /** @param {WheelEvent} event @param {boolean} isEmbedded where it scrolls the lesson, but with Ctrl */
  wheel(event, isEmbedded) {
    const place = placeOf(this.#app, event);
    if ((isEmbedded && !event.ctrlKey) || this.#app.core.at(place.x, place.y).kind !== "scene") return;
    event.preventDefault();
    const by = event.deltaY * (event.deltaMode === 0 ? 1 : line) * (event.ctrlKey ? 5 : 1);
    this.zoom(Math.exp(-aWheel * by), place);
  }

  /** @param {TouchEvent} event @returns {Pinch | null} null unless two fingers are on it */
  #fingers(event) {
    if (event.touches.length !== 2) return null;
    const [a, b] = Array.from(event.touches, (touch) => placeOf(this.#app, touch));
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, far: Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1) };
  }

  /** @param {TouchEvent} event */
  touch(event) {
    const now = this.#fingers(event);
    const before = this.#pinch;
    const begins = event.type === "touchstart";
    if (begins && now && this.#app.core.at(now.x, now.y).kind !== "scene") return;
    this.#pinch = begins || before ? now : null;
    if (!this.#pinch || !now) return;
    event.preventDefault();
    if (begins || !before) return;
    this.pan(now.x - before.x, now.y - before.y);
    this.zoom(now.far / before.far, now);
  }
}

/** Walls on all sides of what is seen: one press puts them there, the next takes them out. @param {App} app */
function setUpWalls(app) {
  const { core } = app;
  const walls = button("walls");
  const standing = () =>
    core.bodies().findIndex(({ isThere }, body) => isThere && /^walls-\d+$/.test(core.bodyName(body)));
  walls.addEventListener("click", () =>
    app.act(() => (standing() > 0 ? core.remove(standing()) : core.addWalls())),
  );
  app.follow(() => void (walls.ariaPressed = String(standing() > 0)));
}

/** @param {App} app @param {boolean} isEmbedded */
export function setUpView(app, isEmbedded) {
  const view = new View(app);
  canvas.addEventListener("wheel", (event) => view.wheel(event, isEmbedded), { passive: false });
  for (const type of /** @type {const} */ (["touchstart", "touchmove", "touchend", "touchcancel"]))
    canvas.addEventListener(type, (event) => view.touch(event), { passive: false });
  button("zoom-in").addEventListener("click", () => view.zoom(aPress));
  button("zoom-out").addEventListener("click", () => view.zoom(1 / aPress));
  button("zoom-all").addEventListener("click", () => view.showAll());
  setUpWalls(app);
  return view;
}
