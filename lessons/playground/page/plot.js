// What was chosen, over time: height, speed and turning of a body; or the force between two, once a bar is lit.
import { button, find, make, show } from "./dom.js";
import { number } from "./words.js";

/** @typedef {import("./app.js").App} App */
/**
 * @typedef {object} Curve a quantity over time
 * @property {string} title
 * @property {string} unit
 * @property {boolean} fromZero whether its axis has 0
 * @property {(pixel: number) => number} least what its axis spans at least; a pixel is so many metres wide
 */

const ofBody = /** @type {Curve[]} */ ([
  { title: "height", unit: "m", fromZero: false, least: (pixel) => 10 * pixel },
  { title: "speed", unit: "m/s", fromZero: true, least: (pixel) => 10 * pixel },
  { title: "turning", unit: "rad/s", fromZero: true, least: () => 0.1 },
]);
const ofPair = /** @type {Curve[]} */ ([{ title: "force", unit: "N", fromZero: true, least: () => 1e-3 }]);
const box = 1000; // units that a curve's picture is wide, and high

/** The least of 1, 2, 5, 10, ... that is not below the value. @param {number} value */
function roundUp(value) {
  const ten = 10 ** Math.floor(Math.log10(value));
  return ([1, 2, 5].find((digit) => digit * ten >= value * (1 - 1e-9)) ?? 10) * ten;
}

/**
 * The ends of an axis, at round numbers.
 * @param {number[]} values
 * @param {Curve} curve
 * @param {number} pixel [m]
 */
function ends(values, { fromZero, least }, pixel) {
  const all = values.filter(Number.isFinite);
  if (fromZero || all.length === 0) all.push(0);
  let [from, to] = [Math.min(...all), Math.max(...all)];
  const lacking = least(pixel) - (to - from);
  if (lacking > 0 && !fromZero) from -= lacking / 2;
  if (lacking > 0) to += fromZero ? lacking : lacking / 2;
  const tick = roundUp((to - from) / 4);
  return { from: tick * Math.floor(from / tick + 1e-9), to: tick * Math.ceil(to / tick - 1e-9), tick };
}

/** A number as exact as an axis of that tick can show it. @param {number} value @param {number} tick */
function onAxis(value, tick) {
  const digits = Math.min(Math.max(2 - Math.floor(Math.log10(tick)), 0), 6);
  if (!(Math.abs(value) < 1e6)) return number(value);
  return value
    .toFixed(digits)
    .replace(/^-(0\.?0*)$/, "$1")
    .replace("-", "\u2212");
}

/** One quantity: its name and number, its axes, and its curve. */
class Panel {
  /** The quantity now, in words. */
  words = "";
  curve;
  element;
  #now = make("b");
  #top = make("span");
  #bottom = make("span");
  #first = make("span");
  #last = make("span");
  #line;
  #dot;

  /** @param {Curve} curve */
  constructor(curve) {
    this.curve = curve;
    const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    picture.setAttribute("viewBox", `0 0 ${box} ${box}`);
    picture.setAttribute("preserveAspectRatio", "none");
    picture.setAttribute("aria-hidden", "true");
    const path = () => document.createElementNS("http://www.w3.org/2000/svg", "path");
    this.#line = path();
    this.#dot = path();
    this.#dot.setAttribute("class", "now");
    picture.append(this.#line, this.#dot);
    this.element = make(
      "div",
      { className: "curve" },
      make("p", {}, make("i"), `${curve.title} `, this.#now, ` ${curve.unit}`),
      make("div", { className: "axis" }, this.#top, this.#bottom),
      picture,
      make("div", { className: "times" }, this.#first, this.#last),
    );
  }

  /** @param {number[]} times [s] @param {number[]} values @param {number} pixel [m] @param {number} least [s] */
  draw(times, values, pixel, least) {
    const { from, to, tick } = ends(values, this.curve, pixel);
    const begin = times[0];
    const span = roundUp(Math.max(times[times.length - 1] - begin, least));
    const now = values[values.length - 1];
    this.#now.textContent = onAxis(now, tick);
    this.words = `${this.curve.title} ${this.#now.textContent} ${this.curve.unit}`;
    this.#top.textContent = number(to);
    this.#bottom.textContent = number(from);
    this.#first.textContent = `${begin.toFixed(2)} s`;
    this.#last.textContent = `${(begin + span).toFixed(2)} s`;
    let path = "";
    let dot = "";
    times.forEach((time, i) => {
      const x = (box * (time - begin)) / span;
      const y = box - (box * (values[i] - from)) / (to - from);
      const isThere = Number.isFinite(x) && Number.isFinite(y);
      const point = isThere ? `${x.toFixed(1)} ${y.toFixed(1)}` : "";
      if (isThere) path += (dot ? "L" : "M") + point;
      dot = isThere ? `M${point}h0` : "";
    });
    this.#line.setAttribute("d", path);
    this.#dot.setAttribute("d", dot); // of no length, with round ends
  }
}

class Plot {
  #app;
  #section = find("plot", HTMLElement);
  /** For what the panels were made. */
  #made = "";
  /** @type {Panel[]} */
  #panels = [];

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
  }

  update() {
    const { core, chosen } = this.#app;
    const isThere = chosen.length > 0 && chosen.every((body) => core.bodies()[body]?.isThere);
    show(this.#section, isThere);
    if (!isThere) return;
    const name = chosen.map(core.bodyName).join(" and ");
    if (this.#made !== name) this.#make(name);
    const [times, ...values] = core.history(chosen);
    const pixel = 1 / core.scale();
    const least = 30 / this.#app.player.rate;
    this.#panels.forEach((panel, i) => panel.draw(times, values[i], pixel, least));
    const words = this.#panels.map((panel) => panel.words).join(", ");
    this.#section.setAttribute("aria-label", `${name} at ${times[times.length - 1].toFixed(3)} s: ${words}`);
  }

  /** @param {string} name */
  #make(name) {
    this.#made = name;
    this.#panels = (this.#app.chosen.length === 1 ? ofBody : ofPair).map((curve) => new Panel(curve));
    find("plot-title", HTMLElement).textContent = name;
    find("curves", HTMLElement).replaceChildren(...this.#panels.map(({ element }) => element));
  }
}

/** @param {App} app */
export function setUpPlot(app) {
  const plot = new Plot(app);
  const update = () => plot.update();
  app.follow(update);
  app.followPictures(update);
  button("plot-close").addEventListener("click", () => {
    app.choose();
    update();
  });
}
