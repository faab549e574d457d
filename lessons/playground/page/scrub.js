// The time line: every step that is kept, and every row update of the step that comes next.
import { find } from "./dom.js";

/** @typedef {import("./app.js").App} App */

const step = find("scrub-step", HTMLInputElement);
const row = find("scrub-row", HTMLInputElement);

/** @param {HTMLInputElement} slider @param {number} least @param {number} now @param {number} most */
function place(slider, least, now, most) {
  [slider.min, slider.max, slider.value] = [least, most, now].map(String);
  slider.disabled = most <= least;
  slider.ariaValueText = `${now} of ${most}`;
}

/** @param {App} app */
export function setUpScrub(app) {
  const { core } = app;
  const follow = () => {
    const { steps, canGoBack, lastStep, updates, allUpdates } = core.numbers();
    place(step, steps - canGoBack, steps, lastStep);
    place(row, 0, updates, allUpdates);
  };
  app.follow(follow);
  app.followPictures(follow);
  step.addEventListener("input", () => app.actPaused(() => core.visit(Number(step.value))));
  row.addEventListener("input", () => app.actPaused(() => core.visitRow(Number(row.value))));
}
