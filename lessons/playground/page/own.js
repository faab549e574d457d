// What a text of one's own is called: by its title, and where it has that of the scene it came from, by that one.

/** @typedef {import("./app.js").SceneFile} SceneFile */

/** What a key of the whole scene says. @param {string} text @param {string} key */
export const said = (text, key) => new RegExp(`^${key} *= *"?([^"\\n]*)`, "m").exec(text)?.[1] ?? "";

/** @param {string} title */
const fileName = (title) =>
  title
    .toLowerCase()
    .normalize("NFKD")
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "")
    .slice(0, 40) || "scene-of-your-own";

/**
 * The file itself, where the text is still that of the file.
 * @param {SceneFile} file
 * @param {string} text
 * @returns {SceneFile}
 */
export function ownFile(file, text) {
  if (text === file.text) return file;
  const title = said(text, "title");
  const look = said(text, "look");
  const own = { ...file, text, look };
  if (title === file.title) return { ...own, name: `${file.name}-changed`, title: `${title}, changed` };
  return { ...own, name: fileName(title), title: title || "a scene of your own" };
}
