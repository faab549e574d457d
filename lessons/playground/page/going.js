// On the way to a step: how far it has come, over the picture. Escape ends it, as Pause does.
import { find, show } from "./dom.js";

/** @typedef {import("./app.js").App} App */

/** @param {App} app */
export function setUpGoing(app) {
  const box = find("going", HTMLElement);
  const bar = find("going-bar", HTMLProgressElement);
  const update = () => {
    const { target } = app.player;
    show(box, target > 0);
    if (target === 0) return;
    const { steps } = app.core.numbers();
    find("going-words", HTMLElement).textContent = `Step ${steps} of ${target}`;
    bar.max = target;
    bar.value = steps;
  };
  app.follow(update);
  app.followPictures(update);
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented && app.player.target > 0) app.toggleRunning();
  });
}
