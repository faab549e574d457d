// The first minute: scene, bars and one button; what else there is comes once a sweep is done, or when asked for.
import { button, find, show } from "./dom.js";

/** @typedef {import("./app.js").App} App */

/** @param {App} app @param {boolean} isGiven somebody leads here: then everything is there at once */
export function setUpBeginning(app, isGiven) {
  const first = app.scene;
  const rows = find("all-rows", HTMLInputElement);
  const { classList } = document.body;
  rows.checked = classList.contains("embedded"); // the text of a lesson speaks of each
  const apply = () => void app.core.show(Number(!classList.contains("beginning")), Number(rows.checked));
  const begin = (/** @type {boolean} */ isFirst) => {
    classList.toggle("beginning", isFirst);
    show(button("everything"), isFirst);
    apply();
    window.dispatchEvent(new Event("resize")); // the picture may have another height now
    app.player.wake();
  };
  rows.addEventListener("change", () => {
    apply();
    app.player.wake();
  });
  button("everything").addEventListener("click", () => {
    begin(false);
    classList.remove("one-solver");
    button("row").focus();
  });
  classList.toggle("one-solver", !isGiven);
  begin(!isGiven);
  app.follow(() => {
    const { updates, steps, rows: count } = app.core.numbers();
    classList.toggle("touched", updates > 0 || steps > 0);
    const isDone = app.scene !== first || steps > 0 || updates >= count;
    if (isDone && classList.contains("beginning")) begin(false);
  });
}
