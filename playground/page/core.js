// The core: the functions of playground/interface.h, with the types of JavaScript.

/**
 * What emscripten's module offers.
 * @typedef {object} CairnModule
 * @property {Float64Array} HEAPF64
 * @property {(name: string, result: string | null, parameters: string[]) => (...values: any[]) => any} cwrap
 *
 * @typedef {object} Setting
 * @property {string} name
 * @property {string} title
 * @property {string} value
 * @property {string} recommended what the scene recommends
 * @property {string} unit
 * @property {number} least
 * @property {number} most
 * @property {string[]} choices the words that it takes; without any it takes numbers
 * @property {string[]} meanings of the choices, in more words; none where they are clear
 *
 * @typedef {object} Body
 * @property {number} x [m]
 * @property {number} y [m]
 * @property {boolean} isThere it was not removed
 * @property {boolean} canMove
 *
 * @typedef {object} Row
 * @property {number} now its impulse over the step [N]
 * @property {number} end where the sweeps would end [N]
 * @property {number} kind 0 joint, 1 normal, 2 friction
 * @property {number} a
 * @property {number} b
 *
 * @typedef {object} Place what is at a place of the picture
 * @property {"nothing" | "scene" | "row"} kind
 * @property {number} number body, -1 for none; or row
 * @property {number} x [m], on a bar [N]
 * @property {number} y [m]
 */

const numberNames = /** @type {const} */ ([
  "time",
  "steps",
  "rows",
  "contacts",
  "updates",
  "allUpdates",
  "sweep",
  "residual",
  "milliseconds",
  "lit",
  "diverged",
  "canGoBack",
  "predicted",
  "prediction",
  "revealed",
]);
/** @typedef {Record<(typeof numberNames)[number], number>} Numbers */

const bodyWidth = 8;
const rowWidth = 6;
const placeKinds = /** @type {const} */ (["nothing", "scene", "row"]);

export class Core {
  #module;
  /** @type {Map<string, (...values: any[]) => any>} */
  #functions = new Map();

  /** @param {CairnModule} module */
  constructor(module) {
    this.#module = module;
  }

  /**
   * Calls cairn_NAME; texts go in and out as strings.
   * @param {string} name
   * @param {"number" | "string" | null} result
   * @param {(number | string)[]} values
   * @returns {any}
   */
  #call(name, result, ...values) {
    let found = this.#functions.get(name);
    if (!found) {
      found = this.#module.cwrap(
        "cairn_" + name,
        result,
        values.map((value) => typeof value),
      );
      this.#functions.set(name, found);
    }
    return found(...values);
  }
  /**
   * @param {string} name
   * @param {(number | string)[]} values
   * @returns {boolean} whether it did what was asked; if not, refusal() says why
   */
  #try(name, ...values) {
    return this.#call(name, "number", ...values) !== 0;
  }
  /** @param {string} name */
  #text(name) {
    return /** @type {string} */ (this.#call(name, "string"));
  }
  /**
   * A copy of numbers of the core, whose memory may move.
   * @param {number} address
   * @param {number} count
   */
  #array(address, count) {
    return this.#module.HEAPF64.slice(address / 8, address / 8 + count);
  }

  refusal = () => this.#text("refusal");
  sceneText = () => this.#text("scene_text");
  words = () => this.#text("words");
  plan = () => this.#text("plan");
  fingerprint = () => this.#text("fingerprint");
  restart = () => this.#try("restart");
  sweep = () => this.#try("sweep");
  back = () => this.#try("back");
  undo = () => this.#try("undo");
  reveal = () => this.#call("reveal", null);
  letGo = () => this.#call("let_go", null);
  draw = () => this.#try("draw");

  /** @type {(text: string, file: string) => boolean} */
  open = (text, file) => this.#try("open", text, file);
  /** @type {(setting: string, value: string) => boolean} */
  set = (setting, value) => this.#try("set", setting, value);
  /** @type {(count: number) => boolean} */
  step = (count) => this.#try("step", count);
  /** @type {(count: number) => boolean} */
  row = (count) => this.#try("row", count);
  /** @type {(x: number, y: number) => boolean} */
  grab = (x, y) => this.#try("grab", x, y);
  /** @type {(x: number, y: number) => boolean} */
  drag = (x, y) => this.#try("drag", x, y);
  /** @type {(x: number, y: number, width: number, height: number) => boolean} */
  addBox = (x, y, width, height) => this.#try("add_box", x, y, width, height);
  /** @type {(body: number) => boolean} */
  remove = (body) => this.#try("remove", body);
  /** @type {(a: number, b: number, x: number, y: number) => boolean} */
  pin = (a, b, x, y) => this.#try("pin", a, b, x, y);
  /** @type {(body: number) => string} */
  bodyName = (body) => this.#call("body_name", "string", body);
  /** @type {(row: number) => void} */
  lightRow = (row) => this.#call("light_row", null, row);
  /** @type {(row: number, newtons: number) => boolean} */
  predict = (row, newtons) => this.#try("predict", row, newtons);
  /** Of the picture [px]. */
  width = 0;
  /** @type {(width: number, height: number, scale: number) => boolean} */
  resize = (width, height, scale) => {
    this.width = width;
    return this.#try("resize", width, height, scale);
  };
  /** @type {(isMoving: boolean) => void} */
  move = (isMoving) => this.#call("move", null, Number(isMoving));
  /** @type {(theme: string) => boolean} */
  theme = (theme) => this.#try("theme", theme);

  /** @returns {Setting[]} */
  settings() {
    return JSON.parse(this.#text("settings"));
  }

  /** @returns {Body[]} the ground first */
  bodies() {
    const count = this.#call("body_count", "number");
    const all = this.#array(this.#call("bodies", "number"), count * bodyWidth);
    return Array.from({ length: count }, (_, i) => {
      const at = i * bodyWidth;
      return { x: all[at], y: all[at + 1], isThere: all[at + 7] > 0, canMove: all[at + 7] === 2 };
    });
  }

  /** @returns {Row[]} */
  rows() {
    const count = this.#call("row_count", "number");
    const all = this.#array(this.#call("rows", "number"), count * rowWidth);
    return Array.from({ length: count }, (_, i) => {
      const [now, end, , kind, a, b] = all.subarray(i * rowWidth, (i + 1) * rowWidth);
      return { now, end, kind, a, b };
    });
  }

  /** @returns {Numbers} */
  numbers() {
    const all = this.#array(this.#call("numbers", "number"), numberNames.length);
    return /** @type {Numbers} */ (Object.fromEntries(numberNames.map((name, i) => [name, all[i]])));
  }

  /**
   * What is at a place of the picture [px].
   * @param {number} x
   * @param {number} y
   * @returns {Place}
   */
  at(x, y) {
    const found = this.#array(this.#call("at", "number", x, y), 4);
    return { kind: placeKinds[found[0]] ?? "nothing", number: found[1], x: found[2], y: found[3] };
  }

  /**
   * Where a point of the scene [m] is on the picture [px].
   * @param {number} x
   * @param {number} y
   */
  place(x, y) {
    const found = this.#array(this.#call("place", "number", x, y), 2);
    return { x: found[0], y: found[1] };
  }

  /**
   * Which point of the scene [m] a place of the picture [px] is, also beyond the scene's edge.
   * @param {number} x
   * @param {number} y
   */
  point(x, y) {
    const origin = this.place(0, 0);
    const scale = this.scale();
    return { x: (x - origin.x) / scale, y: (origin.y - y) / scale };
  }

  /** Pixels a metre. */
  scale() {
    return this.place(1, 0).x - this.place(0, 0).x;
  }
}
