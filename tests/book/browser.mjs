// The lesson book in a real browser, from files and without a network.
//   node browser.mjs BOOK [SCREENSHOTS]
// The last line is "N passed, N failed". With a second folder it leaves screenshots there, to be looked at.
import { existsSync, mkdirSync, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { brokenPictures, fetchShown, overflow, paleText, playerState } from "./in_page.mjs";
import { checkReaders } from "./reader.mjs";

const fetched = createRequire(join(process.cwd(), "book"));
const { chromium } = fetched("playwright-core");
const axe = fetched.resolve("axe-core/axe.min.js");

const book = resolve(process.argv[2] ?? "out/book");
const screenshots = process.argv[3] && resolve(process.argv[3]);
const widths = [1280, 390];
const themes = ["light", "dark"];
const pages = readdirSync(book).filter((name) => name.endsWith(".html")).sort();
const hasFold = (name) => readFileSync(join(book, name), "utf8").includes('<details class="fold">');
const lessons = pages.filter((name) => name.startsWith("lesson")); // beside them there may be the playground
const browserPath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);

let passed = 0;
let failed = 0;
function check(holds, claim, detail = "") {
  if (holds) { ++passed; return; }
  ++failed;
  console.log(`FAILED ${claim}${detail === "" ? "" : ": " + detail}`);
}

const address = (page, hash = "") => pathToFileURL(join(book, page)).href + hash;

// A tab that notes what goes wrong in it, and every address that it asks for.
async function open(browser, options) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  await context.setOffline(true);
  const tab = await context.newPage();
  const troubles = [];
  tab.on("console", (message) => { if (message.type() === "error") troubles.push(message.text()); });
  tab.on("pageerror", (error) => troubles.push(error.message));
  tab.on("requestfailed", (request) => {
    const isLeft = request.failure()?.errorText === "net::ERR_ABORTED"; // the page, before a picture had come
    if (!isLeft) troubles.push("cannot load " + request.url());
  });
  tab.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) troubles.push("asks for " + request.url());
  });
  return { context, tab, troubles };
}

// Opens what is folded, as a guess does.
const unfold = (tab) => tab.evaluate(() => {
  for (const fold of document.querySelectorAll("details.fold")) fold.open = true;
});

// What axe-core knows of WCAG and of good practice, with all that is folded open. Frames of other pages are theirs.
async function checkAccess(tab, where) {
  await tab.addScriptTag({ path: axe });
  const broken = await tab.evaluate(async () => {
    const { violations } = await globalThis.axe.run({ exclude: [["iframe"]] }, { preload: false });
    return violations.map(({ id, nodes }) => `${id} ${nodes.length} ${nodes[0].html.slice(0, 60)}`).join("; ");
  });
  check(broken === "", `${where}: axe finds nothing`, broken);
}

async function checkLooks(browser) {
  for (const theme of themes) {
    for (const width of widths) {
      const { context, tab, troubles } =
        await open(browser, { colorScheme: theme, viewport: { width, height: 844 } });
      for (const name of pages) {
        const where = `${name} at ${width} px, ${theme}`;
        await tab.goto(address(name));
        await unfold(tab);
        await tab.evaluate(fetchShown);
        const wide = await tab.evaluate(overflow);
        check(wide === "", `${where}: nothing overflows`, wide);
        check(await tab.evaluate(brokenPictures, theme) === 0, `${where}: pictures load, in the theme, with alt text`);
        const pale = await tab.evaluate(paleText);
        check(pale === "", `${where}: text stands out`, pale);
        if (width === widths[0]) await checkAccess(tab, where);
        if (screenshots) {
          await tab.screenshot({ path: join(screenshots, `${name.replace(".html", "")}_${width}_${theme}.png`), fullPage: true });
        }
      }
      check(troubles.length === 0, `pages at ${width} px, ${theme}, load without an error`, troubles.join("; "));
      await context.close();
    }
  }
}

// A page whose answer is folded: the guess opens it, and stands beside the answer, also the next time.
async function checkFold(browser, name) {
  const { context, tab, troubles } = await open(browser, {});
  await tab.goto(address(name));
  check(!(await tab.isVisible("#the-answer")), `${name}: the answer is folded`);
  await tab.fill(".guess input", "0.1, 0.2");
  await tab.click(".guess button");
  check(await tab.isVisible("#the-answer"), `${name}: a guess opens it`);
  const dead = await tab.$$eval(".sections a", (links) => links.filter((link) => !document.querySelector(link.hash)).length);
  check(dead === 0 && await tab.locator(".sections a").count() > 3, `${name}: and lists its sections`);
  const guessed = () => tab.textContent(".guessed");
  check((await guessed()).includes("0.1, 0.2"), `${name}: the guess stands beside the answer`, await guessed());
  await tab.goto("about:blank");
  await tab.goto(address(name));
  check((await guessed()).includes("0.1, 0.2"), `${name}: and is kept`, await guessed());
  await tab.evaluate(() => localStorage.clear());
  await tab.goto("about:blank");
  await tab.goto(address(name, "#run-it"));
  check(await tab.isVisible("#run-it"), `${name}: a link to what lies behind the fold opens it`);
  await context.close();
  check(troubles.length === 0, `${name}: the fold works without an error`, troubles.join("; "));
}

async function checkSearch(browser) {
  const { context, tab, troubles } = await open(browser, {});
  await tab.goto(address("index.html"));
  await tab.fill(".search input", "warm start");
  await tab.press(".search input", "Enter");
  await tab.waitForSelector(".results a");
  const first = await tab.getAttribute(".results a", "href");
  check(first === "glossary.html#warm-start", "the search finds a term in the glossary first", first);
  const shown = () => tab.$$eval(".results li", (items) => items
    .filter((item) => item.querySelector("a").href.includes("#the-answer"))
    .map((item) => item.querySelector("p").textContent));
  const hidden = "Behind the question of this lesson.";
  await tab.goto(address("search.html", "?q=answer"));
  const before = await shown();
  check(before.length > 0 && before.every((text) => text === hidden), "and shows nothing of an answer", before.join("; "));
  const page = (await tab.getAttribute(".results a[href$='#the-answer']", "href")).split("#")[0];
  await tab.evaluate((name) => localStorage.setItem("cairn-guess-" + name, "1"), page);
  await tab.reload();
  check((await shown()).some((text) => text !== hidden), "until its question has a guess");
  await tab.goto(address("search.html", "?q=warm+start"));
  await tab.click(".results a");
  check(await tab.isVisible("#warm-start"), "and leads to it");
  check(troubles.length === 0, "the search works without an error", troubles.join("; "));
  await context.close();
}

async function checkPlayer(browser, name) {
  const { context, tab, troubles } = await open(browser, {});
  await tab.clock.install();
  await tab.goto(address(name));
  await unfold(tab);
  const ids = await tab.$$eval(".frames > li", (items) => items.map((item) => item.id));
  const stands = async (index, claim) => {
    const state = await tab.evaluate(playerState);
    const spoken = state.spoken === state.caption && state.caption.includes("Frame " + ids[index].slice(6) + " ");
    check(state.shown === ids[index] && state.slider === index && spoken, `${name}: ${claim}`, JSON.stringify(state));
    return state;
  };
  await stands(0, "the first frame is shown, alone");
  await tab.focus(".controls input");
  await tab.keyboard.press("ArrowRight");
  const state = await stands(1, "the right arrow goes on");
  check(state.hash === "#" + ids[1], `${name}: the address follows`, state.hash);
  await tab.keyboard.press("End");
  await stands(ids.length - 1, "End goes to the end");
  await tab.keyboard.press("ArrowRight");
  await stands(ids.length - 1, "and nothing goes past it");
  await tab.keyboard.press("Home");
  await stands(0, "Home goes back");
  const box = await tab.locator(".controls input").boundingBox();
  await tab.mouse.click(box.x + box.width - 2, box.y + box.height / 2);
  await stands(ids.length - 1, "a click at the end of the slider shows the last frame");
  await tab.click(".previous");
  await stands(ids.length - 2, "the button goes back");
  await tab.keyboard.press("Home");
  await tab.click(".play");
  await tab.clock.runFor(1600);
  await stands(1, "the film runs");
  await tab.clock.runFor(1600 * ids.length);
  await stands(ids.length - 1, "and ends at the last frame");
  check(await tab.textContent(".play") === "Play", `${name}: after which it can be played again`);
  await tab.click(".caption summary");
  check(await tab.isVisible(".caption details p"), `${name}: the description is shown on demand`);
  await tab.click(".previous");
  check(await tab.isVisible(".caption details p"), `${name}: and stays for other frames`);
  const middle = Math.floor(ids.length / 2);
  await tab.goto("about:blank");
  await tab.goto(address(name, "#" + ids[middle]));
  await stands(middle, "a link opens its frame");
  check(await tab.evaluate(() => Math.abs(document.querySelector(".player").getBoundingClientRect().top) < 100),
    `${name}: and brings it into view`);
  check(troubles.length === 0, `${name}: the player works without an error`, troubles.join("; "));
  await context.close();
}

async function checkEnlarging(browser, name) {
  const { context, tab } = await open(browser, { viewport: { width: 390, height: 844 } });
  await tab.goto(address(name));
  await unfold(tab);
  const shown = () => tab.evaluate(() => {
    const image = [...document.querySelectorAll(".frames img")].find((each) => each.getClientRects().length > 0);
    return { width: image.clientWidth, whole: image.naturalWidth };
  });
  const fitted = await shown();
  check(fitted.width <= 390 && fitted.whole >= 640, `${name}: a frame fits a narrow page`, JSON.stringify(fitted));
  await tab.click(".enlarge");
  const large = await shown();
  check(large.width === large.whole, `${name}: and is shown in full size on demand`, JSON.stringify(large));
  const wide = await tab.evaluate(overflow);
  check(wide === "", `${name}: within a frame that can be moved`, wide);
  if (screenshots) {
    await tab.locator(".player").screenshot({ path: join(screenshots, `${name.replace(".html", "")}_enlarged.png`) });
  }
  await tab.click(".enlarge");
  check((await shown()).width === fitted.width, `${name}: and fits again`);
  await context.close();
}

async function checkTheme(browser) {
  const { context, tab } = await open(browser, { colorScheme: "light" });
  await tab.goto(address(lessons[0]));
  // A picture changes its source some time after the theme.
  const areThere = async (theme) => {
    await tab.evaluate(fetchShown);
    for (let i = 0; i < 50 && await tab.evaluate(brokenPictures, theme) > 0; ++i) await tab.waitForTimeout(100);
    return await tab.evaluate(brokenPictures, theme) === 0;
  };
  const paper = () => tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await paper();
  await tab.click("button.theme");
  check(await paper() !== light, "the button makes the page dark");
  check(await areThere("dark"), "and its pictures");
  await tab.emulateMedia({ media: "print" });
  check(await paper() === "rgb(255, 255, 255)", "paper is white all the same");
  check(await areThere("light"), "and all frames are on it, light");
  await tab.emulateMedia({ media: "screen" });
  await tab.goto(address("index.html"));
  check(await paper() !== light, "the choice holds for the next page");
  await context.close();
}

async function checkKeyboard(browser, name) {
  const { context, tab } = await open(browser, {});
  await tab.goto(address(name));
  await unfold(tab);
  await tab.keyboard.press("Tab");
  check(await tab.evaluate(() => document.activeElement.className) === "skip", `${name}: first comes the skip link`);
  const reached = new Set(["skip"]);
  let unmarked = "";
  for (let i = 0; i < 200; ++i) {
    await tab.keyboard.press("Tab");
    const focus = await tab.evaluate(() => {
      const at = document.activeElement;
      return { tag: at.tagName, name: at.className || at.tagName, outline: getComputedStyle(at).outlineStyle };
    });
    if (focus.tag === "BODY") break;
    if (focus.outline === "none") unmarked = focus.name;
    reached.add(focus.name);
  }
  for (const wanted of ["theme", "previous", "play", "next", "INPUT", "SUMMARY", "PRE", "A"]) {
    check(reached.has(wanted), `${name}: the keyboard reaches ${wanted}`);
  }
  check(unmarked === "", `${name}: what has the focus is marked`, unmarked);
  await context.close();
}

async function checkWithoutScript(browser, name) {
  const { context, tab } = await open(browser, { javaScriptEnabled: false });
  await tab.goto(address(name));
  const folds = tab.locator("details.fold > summary");
  if (await folds.count() > 0) await folds.first().click();
  const items = tab.locator(".frames > li");
  const visible = await Promise.all((await items.all()).map((item) => item.isVisible()));
  check(visible.length > 0 && visible.every(Boolean), `${name}: without its script every frame is shown`);
  check(!(await tab.isVisible(".controls")), `${name}: and no button that does nothing`);
  await context.close();
}

if (!browserPath) {
  console.log("There is no chromium here.\n0 passed, 1 failed");
  process.exit(1);
}
if (screenshots) mkdirSync(screenshots, { recursive: true });
const browser = await chromium.launch({ executablePath: browserPath, args: ["--no-sandbox"] });
try {
  check(lessons.length > 0, "the book has lessons");
  await checkLooks(browser);
  for (const name of new Set([lessons[0], lessons.at(-1)])) await checkPlayer(browser, name);
  await checkEnlarging(browser, lessons.at(-1));
  for (const name of pages.filter(hasFold).slice(0, 1)) await checkFold(browser, name);
  const { context, tab, troubles } = await open(browser, {});
  await checkReaders(tab, book, lessons, check);
  check(troubles.length === 0, "guesses, search and print work without an error", troubles.join("; "));
  await context.close();
  await checkSearch(browser);
  await checkTheme(browser);
  await checkKeyboard(browser, lessons.at(-1));
  await checkWithoutScript(browser, lessons.at(-1));
} catch (error) {
  check(false, "the test runs to its end", error.message);
} finally {
  await browser.close();
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
