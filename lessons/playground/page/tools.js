// The tools of a student's hand, whoever guides them: a pointer or the keyboard.
import { find } from "./dom.js";
import { say, sayRefusal } from "./words.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {"hand" | "box" | "ball" | "rope" | "remove" | "pin"} Tool */

const hints = {
  hand: "Hand: press on a body and pull it; its height and speed are plotted. Press on a bar to light up its row.",
  box: "Box: draw a box in the scene. A short press makes one of middle size.",
  ball: "Ball: draw a ball in the scene. A short press makes one of middle size.",
  rope: "Rope: pull it from one place to another, or press on both. It is pinned to the bodies there, or to the ground.",
  remove: "Remove: press on the body that shall go.",
  pin: "Pin: press on a body where the pin shall be, then on another body or on the ground.",
};
const usualBox = 60; // [px]

export class Tools {
  /** @type {Tool} */
  tool = "hand";
  isHolding = false;
  /** Where a pin shall be, or a rope begin, once its first body is known. @type {{body: number, x: number, y: number} | null} */
  pin = null;
  #app;

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
    for (const input of document.querySelectorAll("input[name=tool]")) {
      input.addEventListener("change", () => this.choose(/** @type {HTMLInputElement} */ (input).value));
    }
  }

  /** Whether it draws a body out. */
  get isDrawn() {
    return this.tool === "box" || this.tool === "ball";
  }

  /** @param {string} tool */
  choose(tool) {
    this.letGo();
    this.tool = /** @type {Tool} */ (tool);
    this.pin = null;
    find("tool-" + tool, HTMLInputElement).checked = true;
    say(hints[this.tool]);
    this.#app.player.wake();
  }

  /**
   * Uses the tool on a body at a point [m]; body -1 is nothing, 0 the ground. What is drawn out has its own ways.
   * @param {number} body
   * @param {number} x
   * @param {number} y
   */
  press(body, x, y) {
    if (body > 0) this.#app.choose(body);
    if (this.tool === "hand") this.#grab(body, x, y);
    if (this.tool === "remove" && body > 0) this.#remove(body);
    if (this.tool === "pin") this.#pin(body, x, y);
    if (this.tool === "rope") this.#rope(Math.max(body, 0), x, y);
  }

  /** @param {number} body @param {number} x @param {number} y */
  #grab(body, x, y) {
    if (body <= 0) return;
    const { core, player } = this.#app;
    this.isHolding = core.grab(x, y);
    if (!this.isHolding) return sayRefusal(core.refusal() || `${core.bodyName(body)} cannot move.`);
    const rest = player.isRunning ? "" : " The world is paused: run it, or take steps, and the body follows.";
    say(core.words() + rest);
    player.wake();
  }

  /** @param {number} x @param {number} y */
  drag(x, y) {
    if (!this.isHolding) return;
    this.#app.core.drag(x, y);
    this.#app.player.wake();
  }

  letGo() {
    if (!this.isHolding) return;
    this.isHolding = false;
    this.#app.core.letGo();
    this.#app.act(() => true);
  }

  /** @param {number} body */
  #remove(body) {
    this.#app.act(() => this.#app.core.remove(body));
  }

  /** @param {number} body @param {number} x @param {number} y */
  #pin(body, x, y) {
    const { core } = this.#app;
    if (this.pin === null) {
      if (body <= 0) return say("Press on a body first; the ground can come second.");
      this.pin = { body, x, y };
      say(`A pin through ${core.bodyName(body)}, and what else? Press on another body, or on the ground.`);
    } else {
      const { body: first, x: pinX, y: pinY } = this.pin;
      const second = Math.max(body, 0);
      if (second === first) return say("A pin needs another body, or the ground.");
      this.pin = null;
      this.#app.act(() => core.pin(second, first, pinX, pinY));
    }
    this.#app.player.wake();
  }

  /** @param {number} body @param {number} x @param {number} y */
  #rope(body, x, y) {
    const { core } = this.#app;
    const begun = this.pin;
    if (begun === null) {
      this.pin = { body, x, y };
      say(`A rope from ${core.bodyName(body)}, and to where? Press on another body, or on the ground.`);
    } else {
      this.pin = null;
      this.#app.act(() => core.addRope(begun.body, begun, body, { x, y }));
    }
    this.#app.player.wake();
  }

  /**
   * Puts a box or a ball between two corners [m]; one of middle size where they are next to each other.
   * @param {{x: number, y: number}} from
   * @param {{x: number, y: number}} to
   */
  put(from, to) {
    const { core } = this.#app;
    const usual = Number((usualBox / core.scale()).toPrecision(2));
    let [width, height] = [Math.abs(to.x - from.x), Math.abs(to.y - from.y)];
    if (Math.max(width, height) * core.scale() < usualBox / 6) [width, height] = [usual, usual];
    const middle = [(from.x + to.x) / 2, (from.y + to.y) / 2];
    const radius = Math.max(width, height) / 2;
    this.#app.act(() =>
      this.tool === "ball"
        ? core.addBall(middle[0], middle[1], radius)
        : core.addBox(middle[0], middle[1], width, height),
    );
  }

  /** Forgets what has been begun. @returns {boolean} whether there was anything */
  cancel() {
    const was = this.isHolding || this.pin !== null;
    this.letGo();
    if (this.pin !== null) say(this.tool === "rope" ? "No rope." : "No pin.");
    this.pin = null;
    this.#app.player.wake();
    return was;
  }
}
