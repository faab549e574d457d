// Bytes as text that needs a quarter more room, where base64 needs a third: four bytes are five digits to base 85.
// bundle.mjs writes it, and the page reads it.

const first = 40; // "(": from there to "~" there are 85 letters without "<" and "\\", which a script may not have
const [skipped, alsoSkipped] = [60, 92];

/**
 * The first letter says how many bytes at the end are none.
 * @param {Uint8Array} bytes
 */
export function lettersOf(bytes) {
  const none = (4 - (bytes.length % 4)) % 4;
  const view = new DataView(new Uint8Array([...bytes, ...new Array(none).fill(0)]).buffer);
  const codes = [first + none];
  for (let at = 0; at < view.byteLength; at += 4) {
    const digits = [];
    for (let value = view.getUint32(at), i = 0; i < 5; ++i, value = Math.floor(value / 85)) {
      const code = first + (value % 85);
      const shifted = code + Number(code >= skipped);
      digits.unshift(shifted + Number(shifted >= alsoSkipped));
    }
    codes.push(...digits);
  }
  return codes.map((code) => String.fromCharCode(code)).join("");
}

/** @param {string} letters */
export function bytesOfLetters(letters) {
  const bytes = new DataView(new ArrayBuffer(((letters.length - 1) / 5) * 4));
  for (let at = 1, to = 0; at < letters.length; at += 5, to += 4) {
    let value = 0;
    for (let i = at; i < at + 5; ++i) {
      const code = letters.charCodeAt(i);
      value = value * 85 + code - first - Number(code > skipped) - Number(code > alsoSkipped);
    }
    bytes.setUint32(to, value);
  }
  return new Uint8Array(bytes.buffer, 0, bytes.byteLength - (letters.charCodeAt(0) - first));
}
