// A row update moves: its bar grows and its arrow pushes for a moment.

/** @typedef {import("./app.js").App} App */

const duration = 150; // [ms]
const lessMotion = window.matchMedia("(prefers-reduced-motion: reduce)");

/** @param {App} app */
export function setUpMotion(app) {
  const { core, player } = app;
  let done = { updates: 0, steps: 0 };
  let begun = 0; // [ms] 0: nothing moves
  const go = (/** @type {number} */ now) => {
    if (begun === 0) return;
    const share = Math.min(Math.max((now - begun) / duration, 0), 1);
    core.moment(share * (2 - share)); // fast, then slower
    player.wake();
    if (share === 1) begun = 0;
    else requestAnimationFrame(go);
  };
  app.follow(() => {
    const { updates, steps } = core.numbers();
    const isNext = steps === done.steps && updates === done.updates + 1;
    const isSame = steps === done.steps && updates === done.updates;
    done = { updates, steps };
    if (isSame) return;
    const moves = isNext && !player.isRunning && !lessMotion.matches;
    core.moment(moves ? 0 : 1);
    const wasStill = begun === 0;
    begun = moves ? performance.now() : 0;
    if (moves && wasStill) requestAnimationFrame(go);
  });
}
