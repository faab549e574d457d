// The list of scenes, and the text of the one that is open, edited and run in place.
import { button, find, make, show } from "./dom.js";
import { said } from "./own.js";
import { say, sayRefusal } from "./words.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./app.js").SceneFile} SceneFile */

const list = find("scene", HTMLSelectElement);
const text = find("text", HTMLTextAreaElement);
const own = make("option", { value: "own" }); // while the text is no longer that of the list
const refusal = find("text-refusal", HTMLElement);

/**
 * The scenes in their order, with what their first lines say of them.
 * @param {Record<string, string>} texts
 * @returns {SceneFile[]}
 */
export function sceneFiles(texts) {
  return Object.entries(texts)
    .map(([name, text]) => ({
      name,
      title: said(text, "title") || name,
      look: said(text, "look"),
      order: Number(said(text, "order") || 1000),
      text,
    }))
    .sort((a, b) => a.order - b.order || (a.name < b.name ? -1 : 1));
}

/** Puts the cursor to the line that a refusal names. */
function goToRefusedLine() {
  const line = Number(/:(\d+):\d+:/.exec(refusal.textContent ?? "")?.[1] ?? 0);
  if (line === 0) return;
  const lines = text.value.split("\n");
  const begin = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
  text.focus();
  text.setSelectionRange(begin, begin + (lines[line - 1] ?? "").length);
}

/** @param {App} app */
function runText(app) {
  const isDone = app.act(() => app.open(app.scene, text.value));
  refusal.textContent = isDone ? "" : app.core.refusal();
  show(refusal, !isDone);
  if (isDone) text.dataset.edited = "";
  else {
    sayRefusal("The text was not run.");
    goToRefusedLine();
  }
}

/** @param {App} app */
function followCore(app) {
  const now = app.core.sceneText();
  if (!text.dataset.edited && text.value !== now) text.value = now;
  const { look, title } = app.own;
  const isChanged = now !== app.file.text;
  own.textContent = title;
  if (isChanged) list.append(own);
  else own.remove();
  list.value = isChanged ? own.value : app.scene;
  find("look", HTMLElement).textContent = look;
  show(button("original"), isChanged || Boolean(text.dataset.edited));
}

/** @param {App} app */
export function setUpScenes(app) {
  list.append(...app.scenes.map(({ name, title }) => make("option", { value: name, textContent: title })));
  const openNew = (/** @type {string} */ name) => {
    text.dataset.edited = "";
    show(refusal, false);
    const { title } = app.scenes.find((scene) => scene.name === name) ?? app.file;
    app.act(() => app.open(name), `Opened: ${title}.`);
  };
  list.addEventListener("change", () => openNew(list.value));
  text.addEventListener("input", () => {
    text.dataset.edited = "yes";
    show(button("original"), true);
  });
  button("run-text").addEventListener("click", () => runText(app));
  button("original").addEventListener("click", () => {
    openNew(app.scene);
    say("The scene is as it is in the list.");
  });
  text.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    runText(app);
  });
  app.follow(() => followCore(app));
}
