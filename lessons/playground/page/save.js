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
  const link = make("a", { id: "book", href: URL.createObjectURL(content), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  say(`Saved ${name}.`);
}

/** @param {App} app @param {number} at the step to begin at */
function addressOf(app, at = 0) {
  const changed = app.core.settings().filter(({ value, recommended }) => value !== recommended);
  const text = app.core.sceneText();
  return writeAddress({
    scene: app.scene,
    text: text === app.file.text ? null : text,
    at,
    isEmbedded: false,
    settings: new Map(changed.map(({ name, value }) => [name, value])),
  });
}

/** Where others find this page; "" where it lies in a file, and is published nowhere. */
const publicAddress = () =>
  location.protocol === "file:" ? (document.body.dataset.address ?? "") : location.href.replace(/#.*/, "");

/** The book stands beside a published page. */
function showBook() {
  const address = document.body.dataset.address;
  if (address) button("link").before(make("a", { href: `${address}book/index.html` }, "Book"));
}

/** @param {App} app */
async function copyLink(app) {
  const { steps, touched } = app.core.numbers();
  const address = publicAddress();
  const link = (address || location.href.replace(/#.*/, "")) + (await addressOf(app, touched ? 0 : steps));
  if (!(await copy(link))) return say(link);
  const isLeftOut = touched ? ", but not what was done to it since its start" : ", at this step";
  const where = address ? "" : " It leads to a file on this computer: others cannot open it.";
  say(`The link is copied: it holds the scene and the settings${isLeftOut}.${where}`);
}

/**
 * Keeps the address up with scene and settings. Another scene is another place of the browser's history, so that its
 * Back leads to the scene before.
 * @param {App} app
 */
function setUpAddress(app) {
  let timer = 0;
  let { opened } = app;
  let isLed = false; // here by the address itself
  window.addEventListener("hashchange", () => (isLed = true));
  const write = async () => {
    const hash = await addressOf(app);
    const isNew = app.opened !== opened && !isLed;
    [opened, isLed] = [app.opened, false];
    if (hash === location.hash) return;
    try {
      history[isNew ? "pushState" : "replaceState"](null, "", hash);
    } catch {
      /* an address longer than the browser takes; the button still copies it */
    }
  };
  app.follow(() => {
    clearTimeout(timer);
    timer = setTimeout(write, pause);
  });
}

/** @param {App} app @param {boolean} isEmbedded then the address belongs to the lesson */
export function setUpSaving(app, isEmbedded) {
  if (!isEmbedded) setUpAddress(app);
  showBook();
  button("link").addEventListener("click", () => copyLink(app));
  button("picture").addEventListener("click", () => {
    app.core.draw(); // a browser forgets what it has shown
    find("cairn", HTMLCanvasElement).toBlob((blob) => blob && download(app.own.name + ".png", blob));
  });
  button("save-scene").addEventListener("click", () =>
    download(app.own.name + ".toml", new Blob([app.core.sceneText()], { type: "application/toml" })),
  );
  find("whole", HTMLAnchorElement).addEventListener("click", async (event) => {
    event.preventDefault();
    window.open(location.href.replace(/#.*/, "") + (await addressOf(app)));
  });
}
