// What a mouse, a pen or a finger does on the picture.
import { find, show } from "./dom.js";
import { chooseRow } from "./cursor.js";
import { litWords } from "./words.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./tools.js").Tools} Tools */

const canvas = find("cairn", HTMLCanvasElement);
const rubber = find("rubber", HTMLElement);

/**
 * Where an event is on the picture [px].
 * @param {App} app
 * @param {{clientX: number, clientY: number}} event
 */
function placeOf(app, event) {
  const box = canvas.getBoundingClientRect();
  const scale = app.core.width / box.width;
  return { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
}

class Pointer {
  #app;
  #tools;
  /** What is under way. @type {"" | "hand" | "press" | "bar" | "box"} */
  #drag = "";
  #row = -1;
  #from = { x: 0, y: 0 };

  /** @param {App} app @param {Tools} tools */
  constructor(app, tools) {
    this.#app = app;
    this.#tools = tools;
  }

  /** Whether the tool can do something with the body there. @param {import("./core.js").Place} under */
  #isOfUse(under) {
    if (under.number <= 0) return false;
    return this.#tools.tool !== "hand" || this.#app.core.bodies()[under.number].canMove;
  }

  /** Whether a press there does something, so that a finger there must not scroll the page. */
  wants(/** @type {{clientX: number, clientY: number}} */ event) {
    const { x, y } = placeOf(this.#app, event);
    const under = this.#app.core.at(x, y);
    if (under.kind === "row") return this.#isPredicted(under.number);
    return under.kind === "scene" && (this.#tools.tool === "box" || this.#isOfUse(under));
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
    if (under.kind === "scene") this.#pressScene(under);
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

  /** @param {import("./core.js").Place} under */
  #pressScene(under) {
    if (this.#tools.tool === "box") this.#drag = "box";
    else this.#tools.press(under.number, under.x, under.y);
    if (this.#tools.isHolding) this.#drag = "hand";
  }

  move(/** @type {PointerEvent} */ event) {
    const { x, y } = placeOf(this.#app, event);
    const { core } = this.#app;
    if (this.#drag === "hand") {
      const under = core.at(x, y);
      const point = under.kind === "scene" ? under : core.point(x, y);
      this.#tools.drag(point.x, point.y);
    }
    if (this.#drag === "box") this.#stretch(x, y);
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
    if (this.#drag === "box") {
      show(rubber, false);
      this.#tools.box(core.point(this.#from.x, this.#from.y), core.point(x, y));
    }
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
    if (this.#tools.tool === "box") return "crosshair";
    if (this.#isOfUse(under)) return this.#tools.tool === "hand" ? "grab" : "pointer";
    return "default";
  }

  /** Draws the box that is pulled out. @param {number} x @param {number} y */
  #stretch(x, y) {
    const scale = canvas.clientWidth / this.#app.core.width;
    rubber.style.left = Math.min(x, this.#from.x) * scale + "px";
    rubber.style.top = Math.min(y, this.#from.y) * scale + "px";
    rubber.style.width = Math.abs(x - this.#from.x) * scale + "px";
    rubber.style.height = Math.abs(y - this.#from.y) * scale + "px";
    show(rubber, true);
  }
}

/** @param {App} app @param {Tools} tools */
export function setUpPointer(app, tools) {
  const pointer = new Pointer(app, tools);
  canvas.addEventListener("pointerdown", (event) => pointer.down(event));
  canvas.addEventListener("pointermove", (event) => pointer.move(event));
  canvas.addEventListener("pointerup", (event) => pointer.up(event));
  canvas.addEventListener("pointercancel", () => pointer.cancel());
  canvas.addEventListener("keydown", (event) => event.key === "Escape" && pointer.cancel());
  // A finger scrolls the page, but where it takes hold of something.
  const onTouch = (/** @type {TouchEvent} */ event) => {
    if (event.touches.length === 1 && pointer.wants(event.touches[0])) event.preventDefault();
  };
  canvas.addEventListener("touchstart", onTouch, { passive: false });
}
