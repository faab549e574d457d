// Light or dark: as the system has it, or as the student chose here or in the lesson book.
import { button, keep, kept } from "./dom.js";
import { say } from "./words.js";

const system = window.matchMedia("(prefers-color-scheme: dark)");

const theme = () => document.documentElement.dataset.theme || (system.matches ? "dark" : "light");

/** @param {import("./app.js").App} app */
export function setUpTheme(app) {
  const apply = () => {
    app.core.theme(theme());
    button("theme").textContent = theme() === "dark" ? "Light" : "Dark";
    app.player.wake();
  };
  const chosen = kept("cairn-theme");
  if (chosen === "light" || chosen === "dark") document.documentElement.dataset.theme = chosen;
  button("theme").addEventListener("click", () => {
    const other = theme() === "dark" ? "light" : "dark";
    document.documentElement.dataset.theme = other;
    keep("cairn-theme", other);
    apply();
    say(`The page is ${other}.`);
  });
  system.addEventListener("change", apply);
  apply();
}
