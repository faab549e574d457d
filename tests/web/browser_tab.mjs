// What the checks of the playground in a browser share: a count, and tabs that note what goes wrong in them.
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

export const file = resolve(process.argv[2] ?? "out/playground/index.html");
export const screenshots = process.argv[3] && resolve(process.argv[3]);
export const count = { passed: 0, failed: 0 };

export function check(holds, claim, detail = "") {
  if (holds) {
    ++count.passed;
    return;
  }
  ++count.failed;
  console.log(`FAILED ${claim}${detail === "" ? "" : ": " + detail}`);
}

/** Another page at this address, not the same one with another hash. */
export async function goTo(tab, hash = "") {
  await tab.goto("about:blank");
  await tab.goto(pathToFileURL(file).href + hash);
  await tab.waitForSelector("[data-state=ready]", { timeout: 30000 });
}

/**
 * A tab of its own, without a network and with a world at rest, unless told otherwise.
 * `troubles` are errors, and every address that it asks for.
 */
export async function open(browser, hash = "", options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    reducedMotion: "reduce",
    permissions: ["clipboard-read", "clipboard-write"],
    ...options,
  });
  await context.setOffline(true);
  const tab = await context.newPage();
  const troubles = [];
  tab.on("console", (message) => message.type() === "error" && troubles.push(message.text()));
  tab.on("pageerror", (error) => troubles.push(error.message));
  tab.on(
    "request",
    (request) => /^(file|data|blob|about):/.test(request.url()) || troubles.push(request.url()),
  );
  await goTo(tab, hash);
  return { context, tab, troubles };
}

/** Opens a tab, does the checks, and closes it. A page that reports an error has failed. */
export async function inTab(browser, name, options, checks) {
  const { context, tab, troubles } = await open(browser, options.hash ?? "", options.context ?? {});
  try {
    await checks(tab, context);
  } catch (error) {
    check(false, `${name}: the test runs to its end`, error.message);
  }
  check(troubles.length === 0, `${name}: no error, and no request`, troubles.join("; "));
  await context.close();
}

export const numbers = (tab) => tab.evaluate(() => cairn.numbers());
export const bodies = (tab) => tab.evaluate(() => cairn.bodies());
export const status = (tab) => tab.textContent("#status");
export const setting = (tab, name) =>
  tab.evaluate((wanted) => cairn.settings().find((each) => each.name === wanted), name);
/** After the next frame. */
export const drawn = (tab) =>
  tab.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Where a point of the scene [m] is on the screen. */
export async function onScreen(tab, point) {
  await tab.locator("#cairn").scrollIntoViewIfNeeded();
  return tab.evaluate(({ x, y }) => {
    const canvas = document.getElementById("cairn");
    const box = canvas.getBoundingClientRect();
    const place = cairn.place(x, y);
    const scale = box.width / canvas.width;
    return { x: box.left + place.x * scale, y: box.top + place.y * scale };
  }, point);
}

/** A place on the screen that is of this kind: "row" (of that number), or "scene" without a body. */
export async function placeOf(tab, kind, number = -1, from = 0) {
  await tab.locator("#cairn").scrollIntoViewIfNeeded();
  return tab.evaluate(
    ({ kind, number, from }) => {
      const canvas = document.getElementById("cairn");
      const box = canvas.getBoundingClientRect();
      const scale = box.width / canvas.width;
      for (let y = 4; y < canvas.height; y += 6) {
        for (let x = 4 + from * canvas.width; x < canvas.width; x += 6) {
          const under = cairn.at(x, y);
          if (under.kind !== kind || under.number !== number) continue;
          return { x: box.left + x * scale, y: box.top + y * scale };
        }
      }
      return null;
    },
    { kind, number, from },
  );
}

/** The screen's place to the right of one on a bar, where the bar says so many newtons. */
export async function onBar(tab, row, newtons) {
  await tab.locator("#cairn").scrollIntoViewIfNeeded();
  return tab.evaluate(
    ({ row, newtons }) => {
      const canvas = document.getElementById("cairn");
      const box = canvas.getBoundingClientRect();
      const scale = box.width / canvas.width;
      let best = null;
      for (let y = 4; y < canvas.height; y += 6) {
        for (let x = 0; x < canvas.width; ++x) {
          const under = cairn.at(x, y);
          if (under.kind !== "row" || under.number !== row) continue;
          const off = Math.abs(under.x - newtons);
          if (!best || off < best.off) best = { off, x: box.left + x * scale, y: box.top + y * scale };
        }
      }
      return best;
    },
    { row, newtons },
  );
}
