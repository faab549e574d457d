// Numbers and sentences, as they stand on the page and as they are read aloud.
import { find } from "./dom.js";

const status = find("status", HTMLElement);

/**
 * Says a sentence: on the page, and to those who hear it.
 * @param {string} text
 */
export function say(text) {
  status.classList.remove("refused");
  if (status.textContent !== text) status.textContent = text;
}

/**
 * Says why something was not done.
 * @param {string} text
 */
export function sayRefusal(text) {
  status.textContent = text;
  status.classList.add("refused");
}

/** Whether what was said last is such a why. */
export const isRefusal = () => status.classList.contains("refused");

/**
 * The beginning of what somebody else wrote, as it may stand in a sentence.
 * @param {string} text
 */
export const excerpt = (text) => (text.length > 60 ? text.slice(0, 60) + "…" : text);

/**
 * A number with four digits, or fewer where they say nothing.
 * @param {number} value
 */
export function number(value) {
  if (!Number.isFinite(value)) return "not a number";
  const short = Number(value.toPrecision(4));
  const size = Math.abs(short);
  const text = size !== 0 && (size < 1e-3 || size >= 1e6) ? short.toExponential(1) : String(short);
  return text.replaceAll("-", "\u2212");
}

/**
 * Reads a number as a student types it; NaN for anything else.
 * @param {string} text
 */
export function numberIn(text) {
  const plain = text.trim().replaceAll("\u2212", "-").replace(",", ".");
  return plain === "" ? NaN : Number(plain);
}

const kinds = ["joint row", "normal row", "friction row"];

/**
 * A row in words: "row 3, the normal row between stack.1 and stack.2".
 * @param {import("./core.js").Core} core
 * @param {number} index from 0
 */
export function rowWords(core, index) {
  const row = core.rows()[index];
  if (!row) return `row ${index + 1}`;
  const bodies = `${core.bodyName(row.a)} and ${core.bodyName(row.b)}`;
  return `row ${index + 1}, the ${kinds[row.kind] ?? "row"} between ${bodies}`;
}

/**
 * What is said of a row that lights up; where it ends is not said to those who are asked.
 * @param {import("./core.js").Core} core
 * @param {number} index from 0
 */
export function litWords(core, index) {
  const row = core.rows()[index];
  const { predicted, revealed } = core.numbers();
  const end = predicted === index && revealed === 0 ? "" : `, and ends at ${number(row.end)} N`;
  return `Lit: ${rowWords(core, index)}. It gives ${number(row.now)} N${end}.`;
}
