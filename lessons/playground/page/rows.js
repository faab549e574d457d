// The rows of the next step as a list: of the body that was pressed, or of all; it scrolls, and sorts by each column.
import { button, find, make } from "./dom.js";
import { lightRow } from "./cursor.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./core.js").Row & {index: number, kindWord: string, names: string}} Listed */

const part = find("rows", HTMLDetailsElement);
const pause = 250; // [ms] between two lists while the world runs
/** Three digits are enough in a list. @param {number} value [N] */
function short(value) {
  if (Math.abs(value) < 5e-4) return "0";
  const text =
    Math.abs(value) < 1e6 ? String(Number(Number(value.toPrecision(3)).toFixed(3))) : value.toExponential(1);
  return text.replaceAll("-", "\u2212");
}

const kinds = ["joint", "normal", "friction"];

/** @type {[title: string, key: (row: Listed) => number | string][]} */
const columns = [
  ["Row", ({ index }) => index],
  ["Kind", ({ kindWord }) => kindWord],
  ["Between", ({ names }) => names],
  ["Now, N", ({ now }) => -Math.abs(now)],
  ["End, N", ({ end }) => -Math.abs(end)],
];

class Rows {
  #app;
  #body = make("tbody");
  #heads = columns.map(([title], i) => {
    const press = make("button", {
      type: "button",
      id: `sort-${i}`,
      textContent: title,
      title: "Sort by this",
    });
    press.addEventListener("click", () => this.#sortBy(i));
    return make("th", { scope: "col" }, press);
  });
  #sorted = 0;
  #written = 0;
  /** The body or the two for which the list was opened. */
  #openedFor = "";

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
    const head = make("thead", {}, make("tr", {}, ...this.#heads));
    find("rows-list", HTMLElement).append(make("table", {}, head, this.#body));
    this.#sortBy(0);
  }

  /** @param {number} column */
  #sortBy(column) {
    this.#sorted = column;
    this.#heads.forEach((head, i) => (head.ariaSort = i === column ? "ascending" : "none"));
    this.write();
  }

  /** @returns {Listed[]} */
  #listed() {
    const { core, chosen } = this.#app;
    const rows = core.rows().map((row, index) => ({
      ...row,
      index,
      kindWord: kinds[row.kind] ?? "",
      names: `${core.bodyName(row.a)}, ${core.bodyName(row.b)}`,
    }));
    const key = columns[this.#sorted][1];
    return rows
      .filter(({ a, b }) => chosen.every((body) => body === a || body === b))
      .sort((one, other) => (key(one) < key(other) ? -1 : Number(key(one) > key(other))));
  }

  /** A body or a pair that was just chosen opens the list; closed, it stays closed until the next. */
  update() {
    const { chosen, player } = this.#app;
    const wanted = chosen.join();
    if (wanted !== this.#openedFor && wanted) part.open = true;
    if (wanted === this.#openedFor && player.isRunning && performance.now() - this.#written < pause) return;
    this.#openedFor = wanted;
    this.write();
  }

  write() {
    const { core, chosen } = this.#app;
    const of = chosen.length > 0 ? ` of ${chosen.map(core.bodyName).join(" and ")}` : "";
    const rows = part.open ? this.#listed() : [];
    const title = `Rows${of}` + (part.open ? `: ${rows.length}` : "");
    find("rows-title", HTMLElement).textContent = title;
    this.#written = performance.now();
    while (this.#body.rows.length > rows.length) this.#body.deleteRow(-1);
    const { lit, predicted, revealed } = core.numbers();
    rows.forEach(({ index, kindWord, names, now, end }, i) => {
      const line = this.#body.rows[i] ?? this.#body.appendChild(this.#line());
      const isAsked = index === predicted && revealed === 0;
      const cells = [String(index + 1), kindWord, names, short(now), isAsked ? "?" : short(end)];
      cells.forEach((text, k) => {
        const cell = line.cells[k].firstElementChild ?? line.cells[k];
        if (cell.textContent !== text) cell.textContent = text;
      });
      line.dataset.row = String(index);
      line.classList.toggle("lit", index === lit);
    });
  }

  #line() {
    const light = make("button", { type: "button", title: "Light it up" });
    const line = make("tr", {}, make("td", {}, light), ...columns.slice(1).map(() => make("td")));
    light.addEventListener("click", () => lightRow(this.#app, Number(line.dataset.row)));
    return line;
  }
}

/** @param {App} app */
export function setUpRows(app) {
  const rows = new Rows(app);
  app.follow(() => rows.update());
  app.followPictures(() => rows.update());
  part.addEventListener("toggle", () => rows.write());
  button("rows-all").addEventListener("click", () => {
    app.choose();
    app.changed();
  });
}
