// The core: the functions of playground/interface.h, with the types of JavaScript.

/**
 * What emscripten's module offers.
 * @typedef {object} CairnModule
 * @property {Float64Array} HEAPF64
 * @property {Uint8Array} HEAPU8
 * @property {(address: number) => string} UTF8ToString
 * @property {(size: number) => number} _malloc
 * @property {(address: number) => void} _free
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
  "lastStep",
  "touched",
]);
/** @typedef {Record<(typeof numberNames)[number], number>} Numbers */

const bodyWidth = 8;
const rowWidth = 6;
const placeKinds = /** @type {const} */ (["nothing", "scene", "row"]);

/** Says why a text does not go into the core; "" where it does. @param {Uint8Array} bytes @param {number} most */
export function textRefusal(bytes, most) {
  if (bytes.length > most) return `The text must be at most ${most} bytes, got ${bytes.length}.`;
  return bytes.includes(0) ? "The text must have no zero characters." : "";
}

export class Core {
  #module;
  /** Why a text was not even given to the core. */
  #refusal = "";

  /** @param {CairnModule} module */
  constructor(module) {
    this.#module = module;
    /** Bytes of the longest text that it takes. */
    this.mostText = this.#call("most_text");
  }

  /**
   * Calls cairn_NAME with numbers.
   * @param {string} name
   * @param {number[]} values
   * @returns {number}
   */
  #call(name, ...values) {
    return Reflect.get(this.#module, "_cairn_" + name)(...values);
  }
  /**
   * The same with texts, each in memory of its own while the call lasts: the stack has no room for long ones.
   * @param {string} name
   * @param {(number | string)[]} values
   * @returns {boolean} whether it did what was asked; if not, refusal() says why
   */
  #try(name, ...values) {
    const texts = /** @type {number[]} */ ([]);
    this.#refusal = "";
    try {
      const given = values.map((value) => {
        if (typeof value === "number") return value;
        const address = this.#put(value);
        texts.push(address);
        return address;
      });
      return this.#refusal === "" && this.#call(name, ...given) !== 0;
    } finally {
      texts.forEach((address) => this.#module._free(address));
    }
  }
  /** The address of a text in the core; 0 where it does not go there. @param {string} text */
  #put(text) {
    const bytes = new TextEncoder().encode(text);
    const why = textRefusal(bytes, this.mostText);
    const address = why ? 0 : this.#module._malloc(bytes.length + 1);
    if (address === 0) this.#refusal ||= why || "There is not enough memory.";
    else {
      this.#module.HEAPU8.set(bytes, address);
      this.#module.HEAPU8[address + bytes.length] = 0;
    }
    return address;
  }
  /** @param {string} name @param {number[]} values */
  #text(name, ...values) {
    return this.#module.UTF8ToString(this.#call(name, ...values));
  }
  /**
   * A copy of numbers of the core, whose memory may move.
   * @param {number} address
   * @param {number} count
   */
  #array(address, count) {
    return this.#module.HEAPF64.slice(address / 8, address / 8 + count);
  }

  refusal = () => this.#refusal || this.#text("refusal");
  sceneText = () => this.#text("scene_text");
  words = () => this.#text("words");
  plan = () => this.#text("plan");
  fingerprint = () => this.#text("fingerprint");
  restart = () => this.#try("restart");
  sweep = () => this.#try("sweep");
  back = () => this.#try("back");
  undo = () => this.#try("undo");
  reveal = () => void this.#try("reveal");
  letGo = () => void this.#try("let_go");
  draw = () => this.#try("draw");

  /** @type {(text: string, file: string) => boolean} */
  open = (text, file) => this.#try("open", text, file);
  /** @type {(setting: string, value: string) => boolean} */
  set = (setting, value) => this.#try("set", setting, value);
  /** @type {(count: number) => boolean} */
  step = (count) => this.#try("step", count);
  /** @type {(count: number, milliseconds: number) => boolean} */
  stepFor = (count, milliseconds) => this.#try("step_for", count, milliseconds);
  /** @type {(count: number) => boolean} */
  row = (count) => this.#try("row", count);
  /** @type {(x: number, y: number) => boolean} */
  grab = (x, y) => this.#try("grab", x, y);
  /** @type {(x: number, y: number) => boolean} */
  drag = (x, y) => this.#try("drag", x, y);
  /** @type {(x: number, y: number, width: number, height: number) => boolean} */
  addBox = (x, y, width, height) => this.#try("add_box", x, y, width, height);
  /** @type {(x: number, y: number, radius: number) => boolean} */
  addBall = (x, y, radius) => this.#try("add_ball", x, y, radius);
  /** @type {(a: number, from: {x: number, y: number}, b: number, to: {x: number, y: number}) => boolean} */
  addRope = (a, from, b, to) => this.#try("add_rope", a, from.x, from.y, b, to.x, to.y);
  addWalls = () => this.#try("add_walls");
  /** @type {(step: number) => boolean} */
  visit = (step) => this.#try("visit", step);
  /** @type {(updates: number) => boolean} */
  visitRow = (updates) => this.#try("visit_row", updates);
  /** @type {(factor: number, x: number, y: number) => boolean} */
  zoom = (factor, x, y) => this.#try("zoom", factor, x, y);
  /** @type {(x: number, y: number) => boolean} */
  pan = (x, y) => this.#try("pan", x, y);
  showAll = () => void this.#try("show_all");
  /** @type {(body: number) => boolean} */
  remove = (body) => this.#try("remove", body);
  /** @type {(a: number, b: number, x: number, y: number) => boolean} */
  pin = (a, b, x, y) => this.#try("pin", a, b, x, y);
  /** How far the uppermost body has come down since the start [m]. @type {(world: number) => number} */
  fall = (world) => this.#call("fall", world);
  /** @type {(body: number) => string} */
  bodyName = (body) => this.#text("body_name", body);
  /** @type {(row: number) => void} */
  lightRow = (row) => void this.#try("light_row", row);
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
  move = (isMoving) => void this.#try("move", Number(isMoving));
  /** Whether residuals and an equation are shown, and bars of all rows. @type {(panels: number, allRows: number) => boolean} */
  show = (panels, allRows) => this.#try("show", panels, allRows);
  /** How much of the last row update is drawn. @type {(share: number) => boolean} */
  moment = (share) => this.#try("moment", share);
  /** @type {(theme: string) => boolean} */
  theme = (theme) => this.#try("theme", theme);

  /** @returns {Setting[]} */
  settings() {
    return JSON.parse(this.#text("settings"));
  }

  /** @returns {Body[]} the ground first */
  bodies() {
    const count = this.#call("body_count");
    const all = this.#array(this.#call("bodies"), count * bodyWidth);
    return Array.from({ length: count }, (_, i) => {
      const at = i * bodyWidth;
      return { x: all[at], y: all[at + 1], isThere: all[at + 7] > 0, canMove: all[at + 7] === 2 };
    });
  }

  /**
   * What was at each step that can be taken back, and now, the oldest first. Of a body: times [s], heights [m], speeds
   * [m/s], angular velocities [rad/s], NaN where it was not there. Of two: times [s], and forces between them [N].
   * @param {number[]} bodies one or two
   * @returns {number[][]}
   */
  history(bodies) {
    const [name, width] = bodies.length === 1 ? ["body_history", 4] : ["pair_history", 2];
    const count = this.#call("history_count");
    const all = this.#array(this.#call(name, ...bodies), count * width);
    const steps = Array.from({ length: count }, (_, i) => i);
    return Array.from({ length: width }, (_, column) => steps.map((i) => all[i * width + column]));
  }

  /** @returns {Row[]} */
  rows() {
    const count = this.#call("row_count");
    const all = this.#array(this.#call("rows"), count * rowWidth);
    return Array.from({ length: count }, (_, i) => {
      const [now, end, , kind, a, b] = all.subarray(i * rowWidth, (i + 1) * rowWidth);
      return { now, end, kind, a, b };
    });
  }

  /** @returns {Numbers} */
  numbers() {
    const all = this.#array(this.#call("numbers"), numberNames.length);
    return /** @type {Numbers} */ (Object.fromEntries(numberNames.map((name, i) => [name, all[i]])));
  }

  /**
   * What is at a place of the picture [px].
   * @param {number} x
   * @param {number} y
   * @returns {Place}
   */
  at(x, y) {
    const found = this.#array(this.#call("at", x, y), 4);
    return { kind: placeKinds[found[0]] ?? "nothing", number: found[1], x: found[2], y: found[3] };
  }

  /**
   * Where a point of the scene [m] is on the picture [px].
   * @param {number} x
   * @param {number} y
   */
  place(x, y) {
    const found = this.#array(this.#call("place", x, y), 2);
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
