// A control for each setting of the core: a switch, a choice, or a slider beside a number.
import { find, make, show } from "./dom.js";
import { numberIn } from "./words.js";

/** @typedef {import("./core.js").Setting} Setting */
/** @typedef {import("./app.js").App} App */
/** @typedef {{element: HTMLElement, update: (setting: Setting) => void}} Field */
/** @typedef {(value: string, isDone: boolean) => boolean} Apply sets it; the student is done with it, or still pulls */

const shownFirst = [
  "solver",
  "other",
  "sweeps",
  "warm",
  "gravity",
  "friction",
  "bounce",
  "mass-ratio",
  "policy",
];
const sliderEnd = 1000;

/** @param {Setting} setting */
const isSwitch = ({ choices }) => choices.length === 2 && choices.includes("on") && choices.includes("off");

/** Wide ranges are drawn as powers. @param {Setting} setting */
const isWide = ({ least, most }) => least > 0 && most / least >= 50;

/**
 * The value at a place of the slider from 0 to sliderEnd.
 * @param {Setting} setting
 * @param {number} place
 */
function valueAt(setting, place) {
  const { least, most } = setting;
  const share = place / sliderEnd;
  if (isWide(setting)) return Number((least * (most / least) ** share).toPrecision(2));
  const digits = most - least > 2 ? 0 : 2;
  return Number((least + (most - least) * share).toFixed(digits));
}

/**
 * @param {Setting} setting
 * @param {number} value
 */
function placeOf(setting, value) {
  const { least, most } = setting;
  if (isWide(setting)) return (sliderEnd * Math.log(value / least)) / Math.log(most / least);
  return (sliderEnd * (value - least)) / (most - least);
}

/** @param {string} word @param {Setting} setting */
function choiceWords(word, { meanings }) {
  return meanings.length > 0 ? word : word.replaceAll("-", " ");
}

/** @param {Setting} setting @param {Apply} apply */
function makeSwitch(setting, apply) {
  const box = make("input", { type: "checkbox", id: "set-" + setting.name });
  box.addEventListener("change", () => {
    if (!apply(box.checked ? "on" : "off", true)) box.checked = !box.checked;
  });
  return { inputs: [box], update: (/** @type {Setting} */ { value }) => void (box.checked = value === "on") };
}

/** @param {Setting} setting @param {Apply} apply */
function makeChoice(setting, apply) {
  const options = setting.choices.map((word, i) => {
    const meaning = setting.meanings[i] ? `: ${setting.meanings[i]}` : "";
    return make("option", { value: word, textContent: choiceWords(word, setting) + meaning });
  });
  const list = make("select", { id: "set-" + setting.name }, ...options);
  let now = setting.value;
  list.addEventListener("change", () => {
    if (!apply(list.value, true)) list.value = now;
  });
  return { inputs: [list], update: (/** @type {Setting} */ { value }) => void (list.value = now = value) };
}

/** @param {Setting} setting @param {Apply} apply */
function makeNumber(setting, apply) {
  const slider = make("input", { type: "range", min: "0", max: String(sliderEnd), step: "any" });
  slider.ariaLabel = setting.title;
  const text = make("input", { type: "text", inputMode: "decimal", autocomplete: "off" });
  text.id = "set-" + setting.name;
  let now = setting; // its limits, too, are those of the scene
  const pull = (/** @type {boolean} */ isDone) => {
    const isTaken = apply(String(valueAt(now, Number(slider.value))), isDone);
    if (isDone && !isTaken) update(now);
  };
  slider.addEventListener("input", () => pull(false));
  slider.addEventListener("change", () => pull(true));
  // One tick of the slider is the next value, not a thousandth of its way.
  slider.addEventListener("keydown", (event) => {
    const up = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (!up) return;
    event.preventDefault();
    let place = placeOf(now, Number(now.value));
    const begun = valueAt(now, place);
    while (place >= 0 && place <= sliderEnd && valueAt(now, place) === begun) place += up;
    apply(String(valueAt(now, Math.min(Math.max(place, 0), sliderEnd))), true);
  });
  text.addEventListener("change", () => {
    const value = numberIn(text.value);
    const isTaken = apply(Number.isNaN(value) ? text.value : String(value), true);
    text.ariaInvalid = String(!isTaken);
  });
  const update = (/** @type {Setting} */ changed) => {
    now = changed;
    text.value = now.value.replaceAll("-", "\u2212");
    text.ariaInvalid = "false";
    slider.value = String(placeOf(now, Number(now.value)));
    slider.ariaValueText = `${now.value} ${now.unit}`.trim();
  };
  text.addEventListener("blur", () => update(now));
  return { inputs: [slider, text], update };
}

/**
 * @param {Setting} setting
 * @param {Apply} apply
 * @returns {Field}
 */
function makeField(setting, apply) {
  const kind = isSwitch(setting) ? makeSwitch : setting.choices.length > 0 ? makeChoice : makeNumber;
  const { inputs, update } = kind(setting, apply);
  const label = make("label", { htmlFor: "set-" + setting.name, textContent: setting.title });
  const again = make("button", { type: "button", className: "recommended" });
  const row = make("div", { className: "inputs" }, ...inputs);
  if (setting.unit) row.append(make("span", { className: "unit", textContent: setting.unit }));
  const head = make("div", { className: "head" }, label, again);
  const element = make("div", { className: isSwitch(setting) ? "field switch" : "field" }, head, row);
  element.dataset.setting = setting.name;
  let recommended = setting.recommended;
  again.addEventListener("click", () => {
    apply(recommended, true);
    inputs[inputs.length - 1].focus();
  });
  return {
    element,
    update: (now) => {
      recommended = now.recommended;
      const differs = now.value !== recommended;
      element.classList.toggle("differs", differs);
      again.textContent = `Back to ${choiceWords(recommended, now)}`;
      again.ariaLabel = `${now.title}: ${again.textContent}`;
      again.title = "What the scene recommends";
      show(again, differs);
      update(now);
    },
  };
}

/**
 * Puts the controls on the page, and keeps them as the core has them.
 * @param {App} app
 */
export function setUpControls(app) {
  /** @type {Map<string, Field>} */
  const fields = new Map();
  const first = find("settings-first", HTMLElement);
  const more = find("settings-more", HTMLElement);
  let shown = "";
  const add = (/** @type {Setting} */ setting) => {
    const field = makeField(setting, (value, isDone) => {
      if (isDone) return app.act(() => app.core.set(setting.name, value));
      const isTaken = app.core.set(setting.name, value);
      app.changed();
      return isTaken;
    });
    fields.set(setting.name, field);
    (shownFirst.includes(setting.name) ? first : more).append(field.element);
  };
  app.follow(() => {
    const settings = app.core.settings();
    const now = JSON.stringify(settings);
    if (now === shown) return;
    shown = now;
    if (fields.size === 0) {
      const place = (/** @type {Setting} */ { name }) => (shownFirst.indexOf(name) + 99) % 99;
      [...settings].sort((a, b) => place(a) - place(b)).forEach(add);
    }
    for (const setting of settings) fields.get(setting.name)?.update(setting);
    find("all-recommended", HTMLButtonElement).hidden = settings.every((s) => s.value === s.recommended);
  });
  find("all-recommended", HTMLButtonElement).addEventListener("click", () => {
    app.act(() =>
      app.core
        .settings()
        .every(
          (setting) =>
            setting.value === setting.recommended || app.core.set(setting.name, setting.recommended),
        ),
    );
  });
}
