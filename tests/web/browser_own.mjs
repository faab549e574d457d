// What a text of one's own is called, what Back of the browser leads to, and whom a link reaches.
import { readFileSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { check, file, goTo, inTab, numbers, setting, status } from "./browser_tab.mjs";

const settled = 500; // [ms] after which the address is up to date

const slide = `title = "Two boxes, one slide"
look = "The lower one slides."
[ground]
half_width = 8
[[stack]]
n = 2
box = [1, 1]
`;

const run = async (tab, text) => {
  if (!(await tab.isVisible("#text"))) await tab.click("#scene-file summary");
  await tab.fill("#text", text);
  await tab.click("#run-text");
};
const saved = async (tab, button) => {
  const [download] = await Promise.all([tab.waitForEvent("download"), tab.click(button)]);
  return download.suggestedFilename();
};
const chosen = (tab) => tab.$eval("#scene", (list) => list.selectedOptions[0].textContent);

async function checkName(tab) {
  await run(tab, slide);
  check((await chosen(tab)) === "Two boxes, one slide", "an own text has its own name", await chosen(tab));
  check((await tab.textContent("#look")) === "The lower one slides.", "and its own hint");
  check((await saved(tab, "#save-scene")) === "two-boxes-one-slide.toml", "and is saved under it");
  check((await saved(tab, "#picture")) === "two-boxes-one-slide.png", "as its picture is");
  check(/^Two boxes/.test(await tab.textContent("#canvas-now")), "and is read aloud with it");
  await run(tab, slide.replace(/^title.*\n/, ""));
  check((await chosen(tab)) === "a scene of your own", "without a title it says so", await chosen(tab));
  check((await saved(tab, "#save-scene")) === "scene-of-your-own.toml", "in the name of its file, too");
  await tab.selectOption("#scene", "stack");
  check((await chosen(tab)) === "a stack of ten boxes", "the list leads back");
  check((await tab.locator("#scene option[value=own]").count()) === 0, "where there is no own one any more");
  const text = await tab.inputValue("#text");
  await run(tab, text.replace(/^n = \d+/m, "n = 4"));
  check((await chosen(tab)) === "a stack of ten boxes, changed", "a changed scene says that it is");
  check((await saved(tab, "#save-scene")) === "stack-changed.toml", "and does not take the name of the file");
}

async function checkBack(tab) {
  const count = () => tab.evaluate(() => history.length);
  await tab.waitForTimeout(settled);
  const before = await count();
  await tab.fill("#set-sweeps", "4");
  await tab.press("#set-sweeps", "Enter");
  await tab.waitForTimeout(settled);
  check((await count()) === before, "a setting is no place to go back to");
  await tab.selectOption("#scene", "pyramid");
  await tab.waitForTimeout(settled);
  await run(tab, slide);
  await tab.waitForTimeout(settled);
  check((await count()) === before + 2, "another scene and another text are", String(await count()));
  await tab.goBack();
  await tab.waitForFunction(() => /^title = ".*pyramid/m.test(cairn.sceneText()));
  check((await tab.inputValue("#scene")) === "pyramid", "Back leads to the scene before");
  await tab.waitForTimeout(settled);
  await tab.goBack();
  await tab.waitForFunction(() => document.getElementById("scene").value === "stack");
  check((await setting(tab, "sweeps")).value === "4", "with its settings");
  await tab.waitForTimeout(settled);
  await tab.goForward();
  await tab.waitForFunction(() => document.getElementById("scene").value === "pyramid");
  await tab.waitForTimeout(settled);
  await tab.goForward();
  await tab.waitForFunction(() => document.getElementById("scene").value === "own");
  check((await tab.evaluate(() => cairn.sceneText())) === slide, "and forwards again");
}

const copied = async (tab) => {
  await tab.click("#link");
  await tab.waitForFunction(() => /link is copied/.test(document.getElementById("status").textContent));
  return tab.evaluate(() => navigator.clipboard.readText());
};

async function checkLink(tab) {
  await tab.evaluate(() => cairn.step(25));
  const print = await tab.evaluate(() => cairn.fingerprint());
  const link = await copied(tab);
  check(/[#&]at=25(&|$)/.test(link), "a link holds the step", link);
  check(/others cannot open it/.test(await status(tab)), "of a file it says so", await status(tab));
  const books = await tab.getByRole("link", { name: "Book" }).count();
  check(books === 0, "it leads to no book, which need not be there");
  await goTo(tab, new URL(link).hash);
  await tab.waitForFunction(() => cairn.numbers().steps === 25);
  check((await tab.evaluate(() => cairn.fingerprint())) === print, "and opens the same again");
  await tab.evaluate(() => (cairn.grab(0, 9.5), cairn.step(5), cairn.letGo()));
  const touched = await copied(tab);
  check(!/at=/.test(touched), "what a hand did is not in it", touched);
  check(/not what was done to it/.test(await status(tab)), "and it says so", await status(tab));
}

/** The same page, built where it is published. */
async function checkPublished(tab) {
  const folder = mkdtempSync(join(tmpdir(), "cairn-published-"));
  const page = readFileSync(file, "utf8").replace(
    /data-address="[^"]*"/,
    'data-address="https://name.example/cairn/"',
  );
  writeFileSync(join(folder, "index.html"), page);
  await tab.goto(pathToFileURL(join(folder, "index.html")).href + "#scene=pyramid");
  await tab.waitForSelector("[data-state=ready]");
  const link = await copied(tab);
  check(link === "https://name.example/cairn/#scene=pyramid", "a link leads to where it is published", link);
  check(!/others cannot/.test(await status(tab)), "which others can open", await status(tab));
  check((await numbers(tab)).steps === 0, "at its start there is no step in it");
  const book = await tab.getByRole("link", { name: "Book" }).getAttribute("href");
  check(book === "https://name.example/cairn/book/index.html", "the book stands beside it", book);
}

export async function checkOwn(browser) {
  const scene = { hash: "#scene=stack", context: { reducedMotion: "no-preference" } };
  await inTab(browser, "own text", scene, checkName);
  await inTab(browser, "back", scene, checkBack);
  await inTab(browser, "link", scene, checkLink);
  await inTab(browser, "published", scene, checkPublished);
}
