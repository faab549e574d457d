// What a student takes along: a link, a picture, the scene file. And the address, which is that link.
import { button, find, make } from "./dom.js";
import { say } from "./words.js";
import { writeAddress } from "./address.js";

/** @typedef {import("./app.js").App} App */

const pause = 300; // [ms] after the last act; browsers allow an address to change only so often

/** @param {string} text @returns {Promise<boolean>} whether it is on the clipboard */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = make("textarea", { value: text });
    document.body.append(field);
    field.select();
    const isDone = document.execCommand("copy");
    field.remove();
    return isDone;
  }
}

/** @param {string} name @param {Blob} content */
function download(name, content) {
  const link = make("a", { href: URL.createObjectURL(content), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  say(`Saved ${name}.`);
}

/** @param {App} app */
function addressOf(app) {
  const changed = app.core.settings().filter(({ value, recommended }) => value !== recommended);
  const text = app.core.sceneText();
  return writeAddress({
    scene: app.scene,
    text: text === app.file.text ? null : text,
    at: 0,
    isEmbedded: false,
    settings: new Map(changed.map(({ name, value }) => [name, value])),
  });
}

/**
 * Keeps the address up with scene and settings.
 * @param {App} app
 */
function setUpAddress(app) {
  let timer = 0;
  app.follow(() => {
    clearTimeout(timer);
    timer = setTimeout(async () => {
      const hash = await addressOf(app);
      if (hash === location.hash) return;
      try {
        history.replaceState(null, "", hash);
      } catch {
        /* an address longer than the browser takes; the button still copies it */
      }
    }, pause);
  });
}

/** @param {App} app @param {boolean} isEmbedded then the address belongs to the lesson */
export function setUpSaving(app, isEmbedded) {
  if (!isEmbedded) setUpAddress(app);
  button("link").addEventListener("click", async () => {
    const link = location.href.replace(/#.*/, "") + (await addressOf(app));
    say((await copy(link)) ? "The link is copied: it holds the scene and the settings." : link);
  });
  button("picture").addEventListener("click", () => {
    app.core.draw(); // a browser forgets what it has shown
    find("cairn", HTMLCanvasElement).toBlob((blob) => blob && download(app.scene + ".png", blob));
  });
  button("save-scene").addEventListener("click", () =>
    download(app.scene + ".toml", new Blob([app.core.sceneText()], { type: "application/toml" })),
  );
  find("whole", HTMLAnchorElement).addEventListener("click", async (event) => {
    event.preventDefault();
    window.open(location.href.replace(/#.*/, "") + (await addressOf(app)));
  });
}
