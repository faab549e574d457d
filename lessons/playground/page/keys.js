// Keys for everything that has a button, and the dialog that names them.
import { button, find, keep, kept, make, takesKeys } from "./dom.js";
import { lightNext } from "./cursor.js";

/** @typedef {import("./app.js").App} App */

/** The keys, the buttons that they press, and what the dialog says of them. */
const keys = [
  { key: " ", shown: "Space", button: "run", says: "run, or pause" },
  { key: "r", shown: "R", button: "row", says: "one row update" },
  { key: "s", shown: "S", button: "sweep", says: "to the end of the sweep" },
  { key: "ArrowRight", shown: "→", button: "step", says: "one step" },
  { key: "ArrowLeft", shown: "←", button: "back", says: "back by a step" },
  { key: "Home", shown: "Home", button: "restart", says: "from the start once more" },
  { key: "m", shown: "M", button: "slow", says: "slow motion" },
  { key: "z", shown: "Z", button: "undo", says: "undo a change of the scene" },
  { key: "h", shown: "H", button: "tool-hand", says: "hand" },
  { key: "b", shown: "B", button: "tool-box", says: "box" },
  { key: "x", shown: "X", button: "tool-remove", says: "remove" },
  { key: "p", shown: "P", button: "tool-pin", says: "pin" },
  { key: "o", shown: "O", button: "tool-ball", says: "ball" },
  { key: "t", shown: "T", button: "tool-rope", says: "rope" },
  { key: "+", shown: "+", button: "zoom-in", says: "nearer; the wheel and two fingers do it, too" },
  { key: "=", button: "zoom-in" }, // the same key without Shift
  { key: "-", shown: "−", button: "zoom-out", says: "further away" },
  { key: "0", shown: "0", button: "zoom-all", says: "the whole scene" },
  { key: "w", shown: "W", button: "walls", says: "walls around what is seen, or none" },
  { key: "d", shown: "D", button: "theme", says: "dark or light" },
  { key: "?", shown: "?", button: "keys", says: "these keys" },
];

/** What has no button. */
const others = [
  { shown: "Shift + arrows", says: "move what is seen; so does a pull on an empty place" },
  { shown: "J, K", says: "light up the next row, or the one before" },
  { shown: "Tab", says: "to the next control; the picture is one" },
  { shown: "Escape", says: "on the way to a step: end it here" },
  { shown: "Ctrl+Enter", says: "in the scene file: run the text" },
];

const onPicture = [
  { shown: "← ↑ → ↓", says: "choose a body and plot it, or pull what the hand holds" },
  { shown: "Enter", says: "use the tool on that body; once more lets go" },
  { shown: "Delete", says: "remove that body" },
  { shown: "G", says: "with Pin or Rope begun: on to the ground" },
  { shown: "Escape", says: "let go" },
];

/** @param {KeyboardEvent} event */
function isForElement(event) {
  if (takesKeys(event.target)) return true;
  const onButton = event.target instanceof Element && event.target.closest("button, summary, a") !== null;
  return onButton && (event.key === " " || event.key === "Enter");
}

/** @param {App} app @param {import("./view.js").View} view */
export function setUpKeys(app, view) {
  const dialog = find("keys-dialog", HTMLDialogElement);
  const isOn = find("letters", HTMLInputElement);
  isOn.checked = kept("cairn-letters") !== "off";
  isOn.addEventListener("change", () => keep("cairn-letters", isOn.checked ? "on" : "off"));
  const list = find("keys-list", HTMLElement);
  for (const [title, some] of /** @type {const} */ ([
    ["Everywhere", [...keys, ...others]],
    ["While the picture has the focus", onPicture],
  ])) {
    const lines = some.flatMap(({ shown, says }) =>
      shown ? [make("dt", {}, make("kbd", { textContent: shown })), make("dd", { textContent: says })] : [],
    );
    list.append(make("section", {}, make("h3", { textContent: title }), make("dl", {}, ...lines)));
  }
  button("keys").addEventListener("click", () => dialog.showModal());
  button("keys-close").addEventListener("click", () => dialog.close());
  document.addEventListener("keydown", (event) => {
    const isUndo = event.key === "z" && (event.ctrlKey || event.metaKey) && !takesKeys(event.target);
    if (!isUndo && (event.altKey || event.ctrlKey || event.metaKey)) return;
    if (event.defaultPrevented || isForElement(event) || (event.key.length === 1 && !isOn.checked)) return;
    const letter = event.key.toLowerCase();
    if (event.shiftKey && view.panByKey(event.key)) return event.preventDefault();
    const found = keys.find(({ key }) => key === event.key || key === letter);
    if (found) document.getElementById(found.button)?.click();
    else if (letter === "j" || letter === "k") lightNext(app, letter === "j" ? 1 : -1);
    else return;
    event.preventDefault();
  });
}
