// Light or dark: as the system has it, or as the student chose here or in the lesson book.
import { button, keep, kept } from "./dom.js";
import { say } from "./words.js";

const system = window.matchMedia("(prefers-color-scheme: dark)");

const keptTheme = kept("cairn-theme");
let chosen = keptTheme === "light" || keptTheme === "dark" ? keptTheme : null;

const theme = () => chosen ?? (system.matches ? "dark" : "light");
/** The style goes by it. */
const paint = () => (document.documentElement.dataset.theme = theme());
paint(); // before anything is seen

/** @param {import("./app.js").App} app */
export function setUpTheme(app) {
  const apply = () => {
    paint();
    app.core.theme(theme());
    button("theme").textContent = theme() === "dark" ? "Light" : "Dark";
    app.player.wake();
  };
  button("theme").addEventListener("click", () => {
    chosen = theme() === "dark" ? "light" : "dark";
    keep("cairn-theme", chosen);
    apply();
    say(`The page is ${chosen}.`);
  });
  system.addEventListener("change", apply);
  apply();
}
