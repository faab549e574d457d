// The address of the page: what comes behind "#" holds the scene and the settings that differ from the recommended ones.

/**
 * @typedef {object} Address
 * @property {string} scene its name; "" for the first of the list
 * @property {string | null} text the scene file, where it was edited
 * @property {number} at the step to begin at, paused; 0: none
 * @property {boolean} isEmbedded
 * @property {Map<string, string>} settings
 */

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionStream | DecompressionStream} stream
 */
export async function through(bytes, stream) {
  const answer = new Response(new Blob([bytes]).stream().pipeThrough(stream));
  return new Uint8Array(await answer.arrayBuffer());
}

/** @param {string} base64 */
export function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** @param {string} text */
async function packed(text) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} base64url */
async function unpacked(base64url) {
  const bytes = bytesOf(base64url.replaceAll("-", "+").replaceAll("_", "/"));
  return new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw")));
}

/**
 * @param {string} hash with or without "#"
 * @returns {Promise<Address>}
 * @throws where its text is damaged
 */
export async function readAddress(hash) {
  const words = new URLSearchParams(hash.replace(/^#/, ""));
  const take = (/** @type {string} */ name) => {
    const value = words.get(name);
    words.delete(name);
    return value;
  };
  const scene = take("scene") ?? "";
  const text = take("text");
  const at = Math.max(0, Math.floor(Number(take("at") ?? 0))) || 0;
  const isEmbedded = take("embed") === "1";
  return {
    scene,
    text: text === null ? null : await unpacked(text),
    at,
    isEmbedded,
    settings: new Map(words),
  };
}

/**
 * @param {Address} address
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
