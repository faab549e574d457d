// The address of the page: what comes behind "#" holds the scene and the settings that differ from the recommended ones.
import { excerpt } from "./words.js";

/**
 * @typedef {object} Address
 * @property {string} scene its name; "" for the first of the list
 * @property {string | null} text the scene file, where it was edited
 * @property {number} at the step to begin at, paused; 0: none
 * @property {boolean} isEmbedded
 * @property {boolean} isGiven there is one at all
 * @property {Map<string, string>} settings
 * @property {string} trouble what of it is left out, and why; "" where nothing is
 */

/** More comes out of a stream than may. */
class TooLong extends Error {}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionStream | DecompressionStream} stream
 * @param {number} most bytes that may come out: a few that were packed can be any number
 * @throws TooLong
 */
export async function through(bytes, stream, most = Infinity) {
  const parts = /** @type {Uint8Array<ArrayBuffer>[]} */ ([]);
  let size = 0;
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    parts.push(value);
    size += value.length;
    if (size <= most) continue;
    reader.cancel().catch(() => {});
    throw new TooLong();
  }
}

/** @param {string} base64 */
function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** @param {string} text */
async function packed(text) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} base64url @param {number} most bytes */
async function unpacked(base64url, most) {
  const bytes = bytesOf(base64url.replaceAll("-", "+").replaceAll("_", "/"));
  const unpackedBytes = await through(bytes, new DecompressionStream("deflate-raw"), most);
  return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(unpackedBytes);
}

/**
 * @param {string} hash with or without "#"
 * @param {number} mostText bytes of a scene file
 * @returns {Promise<Address>}
 */
export async function readAddress(hash, mostText) {
  const words = new URLSearchParams(hash.replace(/^#/, ""));
  const take = (/** @type {string} */ name) => {
    const value = words.get(name);
    words.delete(name);
    return value;
  };
  const scene = take("scene") ?? "";
  const packedText = take("text");
  const step = take("at") ?? "0";
  const isStep = /^\d{1,9}$/.test(step);
  const isEmbedded = take("embed") === "1";
  let text = null;
  let trouble = isStep ? "" : `The step in this address must be a whole number, got "${excerpt(step)}".`;
  try {
    if (packedText !== null) text = await unpacked(packedText, mostText);
  } catch (error) {
    const isTooLong = error instanceof TooLong;
    const why = isTooLong ? `longer than ${mostText} bytes` : "damaged or cut off";
    trouble = `The text of the scene in this address is ${why}, so the scene is as it is in the list.`;
  }
  return {
    scene,
    text,
    at: isStep ? Number(step) : 0,
    isEmbedded,
    isGiven: hash.length > 1,
    settings: new Map(words),
    trouble,
  };
}

/**
 * @param {Omit<Address, "trouble" | "isGiven">} address
 * @returns {Promise<string>} with "#"
 */
export async function writeAddress(address) {
  const words = new URLSearchParams({ scene: address.scene });
  for (const [name, value] of address.settings) words.set(name, value);
  if (address.at > 0) words.set("at", String(address.at));
  if (address.isEmbedded) words.set("embed", "1");
  if (address.text !== null) words.set("text", await packed(address.text));
  return "#" + words.toString();
}
