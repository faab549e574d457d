// What a mouse, a pen or a finger does on the picture.
import { find, show } from "./dom.js";
import { chooseRow } from "./cursor.js";
import { litWords } from "./words.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./tools.js").Tools} Tools */
/** @typedef {import("./view.js").View} View */

const canvas = find("cairn", HTMLCanvasElement);
const rubber = find("rubber", HTMLElement);
const leastPull = 10; // [px] of a rope that is pulled, not pressed

/**
 * Where an event is on the picture [px].
 * @param {App} app
 * @param {{clientX: number, clientY: number}} event
 */
export function placeOf(app, event) {
  const box = canvas.getBoundingClientRect();
  const scale = app.core.width / box.width;
  return { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
}

class Pointer {
  #app;
  #tools;
  #view;
  /** What is under way. @type {"" | "hand" | "press" | "bar" | "draw" | "rope" | "pan"} */
  #drag = "";
  #row = -1;
  #from = { x: 0, y: 0 };

  /** @param {App} app @param {Tools} tools @param {View} view */
  constructor(app, tools, view) {
    this.#app = app;
    this.#tools = tools;
    this.#view = view;
  }

  /** Whether the tool can do something with the body there. @param {import("./core.js").Place} under */
  #isOfUse(under) {
    if (under.number <= 0) return false;
    return this.#tools.tool !== "hand" || this.#app.core.bodies()[under.number].canMove;
  }

  /** Whether the tool can do something where there is no body. */
  get #isAnywhere() {
    return this.#tools.isDrawn || this.#tools.tool === "rope";
  }

  /** Whether a press there does something, so that a finger there must not scroll the page. */
  wants(/** @type {{clientX: number, clientY: number}} */ event) {
    const { x, y } = placeOf(this.#app, event);
    const under = this.#app.core.at(x, y);
    if (under.kind === "row") return this.#isPredicted(under.number);
    return under.kind === "scene" && (this.#isAnywhere || this.#isOfUse(under));
  }

  /** @param {number} row */
  #isPredicted(row) {
    const { predicted, revealed } = this.#app.core.numbers();
    return predicted === row && revealed === 0;
  }

  down(/** @type {PointerEvent} */ event) {
    if (!event.isPrimary || event.button !== 0) return;
    const { x, y } = placeOf(this.#app, event);
    const { core } = this.#app;
    const under = core.at(x, y);
    this.#from = { x, y };
    if (under.kind === "row") this.#pressBar(under);
    if (under.kind === "scene") this.#pressScene(under, event.pointerType);
    if (this.#drag !== "") canvas.setPointerCapture(event.pointerId);
  }

  /** @param {import("./core.js").Place} under */
  #pressBar(under) {
    this.#row = under.number;
    this.#drag = this.#isPredicted(under.number) ? "bar" : "press";
    if (this.#drag === "bar") this.#pullBar(under.x);
  }

  /** @param {number} newtons */
  #pullBar(newtons) {
    if (this.#app.core.predict(this.#row, newtons)) this.#app.changed();
  }

  /** Lights a row, or puts it out; not where a finger only scrolls the page. */
  #light() {
    const { core } = this.#app;
    const isLit = core.numbers().lit === this.#row;
    const words = isLit ? "No row is lit." : litWords(core, this.#row);
    if (!isLit) chooseRow(this.#app, this.#row);
    this.#app.act(() => (core.lightRow(isLit ? -1 : this.#row), true), words);
  }

  /** A finger on an empty place scrolls the page; two fingers move the scene. @param {import("./core.js").Place} under @param {string} by */
  #pressScene(under, by) {
    const { tool } = this.#tools;
    if (this.#tools.isDrawn) this.#drag = "draw";
    else this.#tools.press(under.number, under.x, under.y);
    if (this.#tools.isHolding) this.#drag = "hand";
    if (tool === "rope" && this.#tools.pin) this.#drag = "rope";
    if (tool === "hand" && under.number <= 0 && by !== "touch") this.#drag = "pan";
  }

  move(/** @type {PointerEvent} */ event) {
    const { x, y } = placeOf(this.#app, event);
    const { core } = this.#app;
    if (this.#drag === "hand") {
      const under = core.at(x, y);
      const point = under.kind === "scene" ? under : core.point(x, y);
      this.#tools.drag(point.x, point.y);
    }
    if (this.#drag === "draw") this.#stretch(x, y);
    if (this.#drag === "rope") this.#span(x, y);
    if (this.#drag === "pan") {
      this.#view.pan(x - this.#from.x, y - this.#from.y);
      this.#from = { x, y };
    }
    if (this.#drag === "bar") {
      const under = core.at(x, this.#from.y);
      if (under.kind === "row") this.#pullBar(under.x);
    }
    if (this.#drag === "") canvas.style.cursor = this.#cursor(x, y);
  }

  up(/** @type {PointerEvent} */ event) {
    const { x, y } = placeOf(this.#app, event);
    const { core } = this.#app;
    if (this.#drag === "hand") this.#tools.letGo();
    show(rubber, false);
    if (this.#drag === "draw") this.#tools.put(core.point(this.#from.x, this.#from.y), core.point(x, y));
    const isPulled = Math.hypot(x - this.#from.x, y - this.#from.y) > leastPull;
    const end = core.at(x, y);
    if (this.#drag === "rope" && isPulled && end.kind === "scene")
      this.#tools.press(end.number, end.x, end.y);
    if (this.#drag === "bar") this.#app.act(() => true);
    const under = core.at(x, y);
    if (this.#drag === "press" && under.kind === "row" && under.number === this.#row) this.#light();
    this.#drag = "";
  }

  /** The system has taken the pointer away, or Escape was pressed. */
  cancel() {
    show(rubber, false);
    this.#drag = "";
    this.#tools.cancel();
  }

  /** @param {number} x @param {number} y */
  #cursor(x, y) {
    const under = this.#app.core.at(x, y);
    if (under.kind === "row") return this.#isPredicted(under.number) ? "ew-resize" : "pointer";
    if (under.kind !== "scene") return "default";
    if (this.#isAnywhere) return "crosshair";
    if (this.#isOfUse(under)) return this.#tools.tool === "hand" ? "grab" : "pointer";
    return this.#tools.tool === "hand" ? "move" : "default";
  }

  /** Draws the box or ball that is pulled out. @param {number} x @param {number} y */
  #stretch(x, y) {
    const scale = canvas.clientWidth / this.#app.core.width;
    rubber.style.left = Math.min(x, this.#from.x) * scale + "px";
    rubber.style.top = Math.min(y, this.#from.y) * scale + "px";
    rubber.style.transform = "";
    rubber.style.borderRadius = this.#tools.tool === "ball" ? "50%" : "0";
    rubber.style.width = Math.abs(x - this.#from.x) * scale + "px";
    rubber.style.height = Math.abs(y - this.#from.y) * scale + "px";
    show(rubber, true);
  }

  /** Draws the rope that is pulled. @param {number} x @param {number} y */
  #span(x, y) {
    const scale = canvas.clientWidth / this.#app.core.width;
    const way = { x: x - this.#from.x, y: y - this.#from.y };
    rubber.style.left = this.#from.x * scale + "px";
    rubber.style.top = this.#from.y * scale + "px";
    rubber.style.width = Math.hypot(way.x, way.y) * scale + "px";
    rubber.style.height = "0";
    rubber.style.transform = `rotate(${Math.atan2(way.y, way.x)}rad)`;
    show(rubber, true);
  }
}

/** @param {App} app @param {Tools} tools @param {View} view */
export function setUpPointer(app, tools, view) {
  const pointer = new Pointer(app, tools, view);
  canvas.addEventListener("pointerdown", (event) => pointer.down(event));
  canvas.addEventListener("pointermove", (event) => pointer.move(event));
  canvas.addEventListener("pointerup", (event) => pointer.up(event));
  canvas.addEventListener("pointercancel", () => pointer.cancel());
  canvas.addEventListener("keydown", (event) => event.key === "Escape" && pointer.cancel());
  // A finger scrolls the page, but where it takes hold of something.
  const onTouch = (/** @type {TouchEvent} */ event) => {
    if (event.touches.length === 2) pointer.cancel(); // they move the scene
    if (event.touches.length === 1 && pointer.wants(event.touches[0])) event.preventDefault();
  };
  canvas.addEventListener("touchstart", onTouch, { passive: false });
}
