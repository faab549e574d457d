// Attempts that the core makes for questions and challenges, and what is measured of them.

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./core.js").Core} Core */
/**
 * @typedef {object} Trial
 * @property {string} scene of the list
 * @property {Record<string, string>} [set] settings
 * @property {[string, string]} [edit] a piece of its text, and what stands there instead
 * @property {number} [rows] row updates
 * @property {number} [sweeps]
 * @property {number} [steps]
 *
 * @typedef {"first" | "lowest" | "left" | "fall" | "far"} Measure
 */

/** @type {Record<Measure, {unit: string, of: (core: Core) => number}>} */
export const measures = {
  first: { unit: "N", of: (core) => core.rows()[0].now },
  lowest: {
    unit: "N",
    of: (core) => {
      const rows = core.rows().filter(({ kind }) => kind === 1);
      return rows
        .filter(({ a, b }) => a === rows[0].a && b === rows[0].b)
        .reduce((sum, { now }) => sum + now, 0);
    },
  },
  left: { unit: "", of: (core) => core.numbers().residual },
  fall: { unit: "mm", of: (core) => 1000 * core.fall(0) },
  far: {
    unit: "m",
    of: (core) => {
      const { x, y } = core.bodies().slice(-1)[0];
      return Math.hypot(x, y);
    },
  },
};

/**
 * Opens the scene and goes as far as the trial says. @returns {boolean} whether nothing was refused
 * @param {App} app @param {Partial<Trial>} trial
 */
export function attempt(app, { scene = "", set = {}, edit, rows = 0, sweeps = 0, steps = 0 }) {
  const { core } = app;
  const file = app.scenes.find(({ name }) => name === scene);
  return (
    app.open(scene, edit && file?.text.replace(...edit)) &&
    Object.entries(set).every(([name, value]) => core.set(name, value)) &&
    (rows === 0 || core.row(rows)) &&
    Array.from({ length: sweeps }).every(() => core.sweep()) &&
    (steps === 0 || core.step(steps))
  );
}

/** @param {App} app @param {Partial<Trial>} trial @param {Measure} measure @returns {number} NaN where something was refused */
export const measured = (app, trial, measure) => (attempt(app, trial) ? measures[measure].of(app.core) : NaN);
