// The keyboard on the picture: arrows choose a body, Enter uses the tool on it, arrows then pull.
import { find, show } from "./dom.js";
import { litWords, say } from "./words.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./tools.js").Tools} Tools */

const canvas = find("cairn", HTMLCanvasElement);
const marker = find("marker", HTMLElement);
const pullBy = 15; // [px] an arrow key
const directions = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

class Cursor {
  #app;
  #tools;
  #chosen = 0;
  #hand = { x: 0, y: 0 };

  /** @param {App} app @param {Tools} tools */
  constructor(app, tools) {
    this.#app = app;
    this.#tools = tools;
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether the key was for it */
  press(event) {
    if (event.shiftKey || event.altKey || event.ctrlKey || event.metaKey) return false;
    const direction = directions[/** @type {keyof typeof directions} */ (event.key)];
    if (direction) this.#go(direction);
    else if (event.key === "Enter") this.#use();
    else if (event.key.toLowerCase() === "g" && this.#tools.pin) this.#tools.press(0, 0, 0);
    else if (event.key === "Delete") this.#remove();
    else if (event.key === "Escape") return this.#tools.cancel();
    else return false;
    this.#app.player.wake();
    return true;
  }

  /** @param {number[]} direction */
  #go([x, y]) {
    if (this.#tools.isHolding) {
      const by = pullBy / this.#app.core.scale();
      this.#hand.x += x * by;
      this.#hand.y += y * by;
      this.#tools.drag(this.#hand.x, this.#hand.y);
      return;
    }
    const next = this.#nearest(this.#app.core.bodies(), x, y);
    if (next > 0) this.#chosen = next;
    if (this.#chosen > 0) this.#app.choose(this.#chosen);
    if (this.#chosen > 0) say(this.#app.core.bodyName(this.#chosen));
  }

  /** Bodies that can move; and for the second end of a pin all that are there. @param {import("./core.js").Body} [body] */
  #canChoose(body) {
    return body !== undefined && (body.canMove || (body.isThere && this.#tools.pin !== null));
  }

  /**
   * The next body in that direction, from the chosen one; the first where none is chosen.
   * @param {import("./core.js").Body[]} bodies
   * @param {number} x
   * @param {number} y
   */
  #nearest(bodies, x, y) {
    const from = bodies[this.#chosen];
    if (!this.#canChoose(from)) return bodies.findIndex((body) => body.canMove);
    let best = -1;
    let least = Infinity;
    bodies.forEach((body, i) => {
      const along = (body.x - from.x) * x + (body.y - from.y) * y;
      const across = Math.abs((body.x - from.x) * y) + Math.abs((body.y - from.y) * x);
      const far = along + 2 * across;
      if (
        i === 0 ||
        i === this.#chosen ||
        !this.#canChoose(body) ||
        along <= 1e-6 ||
        across > 2 * along ||
        far >= least
      )
        return;
      [best, least] = [i, far];
    });
    return best;
  }

  #use() {
    const body = this.#app.core.bodies()[this.#chosen];
    if (this.#tools.isHolding) return this.#tools.letGo();
    if (!this.#canChoose(body)) return say("Choose a body first, with the arrow keys.");
    if (this.#tools.isDrawn) {
      const over = { x: body.x, y: body.y + 90 / this.#app.core.scale() };
      return this.#tools.put(over, over);
    }
    this.#hand = { x: body.x, y: body.y };
    this.#tools.press(this.#chosen, body.x, body.y);
  }

  #remove() {
    if (!this.#app.core.bodies()[this.#chosen]?.canMove)
      return say("Choose a body first, with the arrow keys.");
    const tool = this.#tools.tool;
    this.#tools.tool = "remove";
    this.#tools.press(this.#chosen, 0, 0);
    this.#tools.tool = tool;
  }

  /** Puts the ring around the chosen body, or the pin to be. */
  mark() {
    const { core } = this.#app;
    const { pin } = this.#tools;
    const hasFocus = document.activeElement === canvas;
    const body = hasFocus && this.#chosen > 0 ? core.bodies()[this.#chosen] : undefined;
    const point = body && this.#canChoose(body) ? body : pin;
    show(marker, point !== null);
    if (point === null) return;
    const place = core.place(point.x, point.y);
    const scale = canvas.clientWidth / core.width;
    marker.style.transform = `translate(${place.x * scale}px, ${place.y * scale}px)`;
  }
}

/** Plots what is between the two bodies of a row. @param {App} app @param {number} row */
export function chooseRow(app, row) {
  const { a, b } = app.core.rows()[row];
  app.choose(a, b);
}

/**
 * Lights up the next row, or the one before.
 * @param {App} app
 * @param {number} by 1 or -1
 */
export function lightNext(app, by) {
  const { lit, rows } = app.core.numbers();
  if (rows === 0) return say("There are no rows now.");
  const next = ((((lit < 0 && by < 0 ? 0 : lit) + by) % rows) + rows) % rows;
  chooseRow(app, next);
  lightRow(app, next);
}

/** @param {App} app @param {number} row */
export function lightRow(app, row) {
  app.act(() => (app.core.lightRow(row), true), litWords(app.core, row));
}

/** @param {App} app @param {Tools} tools */
export function setUpCursor(app, tools) {
  const cursor = new Cursor(app, tools);
  canvas.addEventListener("keydown", (event) => {
    if (!cursor.press(event)) return;
    event.preventDefault();
    event.stopPropagation();
  });
  canvas.addEventListener("focus", () => app.player.wake());
  canvas.addEventListener("blur", () => {
    tools.cancel();
    app.player.wake();
  });
  app.followPictures(() => cursor.mark());
}
