// What a lesson leads to stands still until its reader presses what the text names; so does Restart.
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { check, goTo, inTab, numbers, status } from "./browser_tab.mjs";

const lessons = join(dirname(fileURLToPath(import.meta.url)), "../../lessons");

/** The address that each lesson leads to, by its folder. */
const addresses = readdirSync(lessons)
  .filter((name) => /^\d\d_/.test(name))
  .flatMap((name) => {
    const text = readFileSync(join(lessons, name, "README.md"), "utf8");
    return [...text.matchAll(/\.\.\/playground\/README\.md "(#[^"]*)"/g)].map(([, hash]) => [name, hash]);
  });

const isStillAt = async (tab, step) =>
  (await numbers(tab)).steps === step && (await tab.textContent("#run")) === "Run";

/** A reader reads first. */
async function checkLesson(tab, name, hash) {
  await goTo(tab, hash + "&embed=1");
  await tab.waitForTimeout(2000);
  check(await isStillAt(tab, 0), `${name} stands still at step 0`, String((await numbers(tab)).steps));
  check(/stands still.*Run.*row by row/.test(await status(tab)), `${name} says so`, await status(tab));
  await tab.click("#run");
  await tab.waitForFunction(() => cairn.numbers().steps > 2);
  await tab.click("#restart");
  await tab.waitForTimeout(300);
  check(await isStillAt(tab, 0), `${name}: Restart stands still at step 0`, await status(tab));
}

async function checkLessons(tab) {
  check(addresses.length >= 12, "lessons lead to the playground", String(addresses.length));
  for (const [name, hash] of addresses) await checkLesson(tab, name, hash);
}

async function checkAt(tab) {
  await goTo(tab, "#scene=stack&at=12");
  await tab.waitForTimeout(1000);
  check(await isStillAt(tab, 12), "what is led to a step stands still there", await status(tab));
}

/** The number that the text of lesson 3 has: the first row gets 4 N. */
async function checkRow(tab) {
  await tab.waitForTimeout(2000);
  await tab.click("#row");
  const [{ now }] = await tab.evaluate(() => cairn.rows());
  check(Math.abs(now - 4) < 0.01, "the first row of lesson 3 gets 4 N", String(now));
}

export async function checkStill(browser) {
  const context = { reducedMotion: "no-preference" };
  const [, third] = addresses.find(([name]) => name.startsWith("03"));
  await inTab(browser, "lessons at rest", { context }, checkLessons);
  await inTab(browser, "at a step", { context }, checkAt);
  await inTab(browser, "the first row", { hash: third + "&embed=1", context }, checkRow);
}
