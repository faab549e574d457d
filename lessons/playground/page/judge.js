// What a guess says about who made it: right, close, or which thought led there.
import { number } from "./words.js";

/** @typedef {{is: number, says: string}} Wrong a known wrong answer, and the thought that led there */

const near = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ share) =>
  Math.abs(a - b) <= share * Math.abs(b) + 1e-9;

/**
 * @param {number} said
 * @param {number} end
 * @param {number} now where the row stands while it is asked for
 * @param {Wrong[]} wrong
 */
export function judgement(said, end, now, wrong) {
  if (near(said, end, 0.02) || Math.abs(said - end) < 0.005) return "You have it.";
  const known = wrong.find(({ is }) => near(said, is, 0.02));
  if (known) return known.says;
  if (near(said, now, 0.02)) return "That is where it stands now, and the sweeps go on.";
  if (said * end < 0) return "The other way round: mind the sign.";
  if (near(said, end, 0.15)) return "Close.";
  if (near(said, end / 2, 0.05)) return "Half of it.";
  if (near(said, 2 * end, 0.05)) return "Twice it.";
  if (near(said, 10 * end, 0.1) || near(said, end / 10, 0.1)) return "Ten times off: look at the unit.";
  return Math.abs(said) < Math.abs(end) ? "Too little." : "Too much.";
}

/**
 * @param {number} said
 * @param {number} end
 * @param {string} unit
 * @param {string} [what] that is asked for
 */
export function offWords(said, end, unit, what = "The row ends at") {
  const off = Math.abs(said - end);
  const share = Math.abs(end) < 0.005 ? "" : `, ${Math.round((100 * off) / Math.abs(end))} %`;
  return `You said ${number(said)} ${unit}. ${what} ${number(end)} ${unit}: ${number(off)} ${unit} off${share}.`;
}
