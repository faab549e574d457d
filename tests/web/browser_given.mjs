// What others give the page: texts and links of any size, steps by the thousand, solvers that take for ever.
import { deflateRawSync } from "node:zlib";
import { bodies, check, goTo, inTab, numbers, setting, status } from "./browser_tab.mjs";

const mostText = 1_000_000; // bytes, as the core has it

/** A link's text, as the page packs it. */
const packed = (content) => deflateRawSync(content, { level: 9 }).toString("base64url");

const shownSolver = (tab) => tab.inputValue("#set-solver");

async function checkTexts(tab) {
  const before = await tab.evaluate(() => cairn.fingerprint());
  const tryText = (text) =>
    tab.evaluate((given) => ({ isOpen: cairn.open(given, "scene"), why: cairn.refusal() }), text);
  const long = await tryText("#".repeat(2 * mostText));
  check(!long.isOpen, "a text of two million letters is refused");
  check(long.why === "The text must be at most 1000000 bytes, got 2000000.", "with the limit", long.why);
  const wide = await tryText("λ".repeat(mostText / 2 + 1));
  check(wide.why.includes("got 1000002"), "bytes count, not letters", wide.why);
  const zero = await tryText("title = 'a'\n\0 = 3");
  check(/zero/.test(zero.why), "a text that would be cut off at a zero is refused", zero.why);
  check((await tab.evaluate(() => cairn.fingerprint())) === before, "and the scene is as it was");
  check((await tryText("#".repeat(mostText))).isOpen, "a text as long as may be is run");
  await goTo(tab, "#scene=stack");
  await tab.click("#scene-file summary");
  const pasted = "# " + "x".repeat(1_400_000);
  await tab.evaluate((text) => {
    document.getElementById("text").value = text;
    document.getElementById("text").dispatchEvent(new Event("input"));
  }, pasted);
  await tab.click("#run-text");
  const said = await tab.textContent("#text-refusal");
  check(
    said.includes(`at most ${mostText} bytes, got ${pasted.length}`),
    "the page says so in its words",
    said,
  );
  await tab.click("#step");
  check((await numbers(tab)).steps === 1, "and the world goes on", await status(tab));
}

async function checkLinks(tab) {
  const link = (text) => `#scene=stack-offset&sweeps=3&text=${text}`;
  const isAsInList = async (claim) => {
    const { value } = await setting(tab, "sweeps");
    check((await tab.inputValue("#scene")) === "stack-offset" && value === "3", claim, await status(tab));
    await tab.click("#step");
    check((await numbers(tab)).steps === 1, "and the world takes steps");
  };
  for (const size of [2 * mostText, 200 * mostText]) {
    const bomb = packed(Buffer.alloc(size, "#"));
    const begun = Date.now();
    await goTo(tab, link(bomb));
    const what = `a link of ${bomb.length} letters that unpacks to ${size}`;
    check(/longer than 1000000 bytes/.test(await status(tab)), `${what} is refused`, await status(tab));
    check(Date.now() - begun < 15000, `${what} is given up soon`, String(Date.now() - begun));
    await isAsInList(`${what} leaves the scene and its settings`);
  }
  const good = packed(Buffer.from("title = 'a scene'\n[ground]\n"));
  await goTo(tab, link(good));
  check((await bodies(tab)).length === 1, "a whole link is opened");
  const damaged = {
    "cut off": good.slice(0, good.length / 2),
    empty: "",
    "no base64": "%%%",
    "no text": packed(Buffer.from([0xff, 0xfe, 0x80])),
  };
  for (const [what, text] of Object.entries(damaged)) {
    await goTo(tab, link(text));
    check(/damaged or cut off/.test(await status(tab)), `a link whose text is ${what} is refused`);
    await isAsInList(`a link whose text is ${what} leaves the scene and its settings`);
  }
  await goTo(tab, link("nonsense") + "&embed=1");
  check(await tab.isVisible("#whole"), "in a lesson a damaged link is still in a lesson");
}

async function checkWords(tab) {
  const words = {
    "scene=stack&at=soon": /step in this address must be a whole number, got "soon"/,
    "scene=stack&at=-3": /whole number, got "-3"/,
    "scene=stack&at=100001": /from 1 to 100000/,
    [`scene=${"x".repeat(5000)}`]: /^There is no scene "x{60}…" in the list\.$/,
    [`scene=stack&${"y".repeat(1e6)}=1`]: /^The address has a setting that is too long: "y{60}…", "1"\.$/,
    [`scene=stack&${Array.from({ length: 5000 }, (_, i) => `a${i}=1`).join("&")}`]: /5000 settings/,
  };
  for (const [address, expected] of Object.entries(words)) {
    await goTo(tab, "#" + address);
    const said = await status(tab);
    check(expected.test(said), `${address.slice(0, 30)} is refused in words`, said.slice(0, 200));
    check((await numbers(tab)).steps === 0 && (await bodies(tab)).length > 3, "and a scene is open");
  }
  await tab.evaluate(() => localStorage.setItem("cairn-theme", "plaid"));
  await goTo(tab, "#scene=stack");
  const theme = await tab.evaluate(() => document.documentElement.dataset.theme);
  check(theme === "light", "a kept theme that is none is as good as none", theme);
}

/** Frames in a second. */
const frames = (tab) =>
  tab.evaluate(async () => {
    let count = 0;
    const begun = performance.now();
    while (performance.now() - begun < 1000) {
      await new Promise((done) => requestAnimationFrame(done));
      ++count;
    }
    return count;
  });

async function checkGoing(tab) {
  const begun = Date.now();
  await goTo(tab, "#scene=stack&at=100000");
  check(
    Date.now() - begun < 8000,
    "an address with very many steps opens at once",
    String(Date.now() - begun),
  );
  check(await tab.isVisible("#going"), "and says that it is on its way");
  const before = (await numbers(tab)).steps;
  check((await frames(tab)) >= 4, "the page draws in between");
  const { steps } = await numbers(tab);
  check(steps > before && steps < 100000, "while it goes on", `${before}, ${steps}`);
  const shown = await tab.$eval("#going-bar", ({ value, max }) => ({ value, max }));
  check(shown.max === 100000 && shown.value > before, "with its progress", JSON.stringify(shown));
  check((await tab.textContent("#run")) === "Pause", "Pause is offered");
  await tab.keyboard.press("Escape");
  const ended = (await numbers(tab)).steps;
  await tab.waitForTimeout(300);
  check((await numbers(tab)).steps === ended && ended < 100000, "Escape ends it");
  check(!(await tab.isVisible("#going")) && (await tab.textContent("#run")) === "Run", "and the world rests");
  await goTo(tab, "#scene=stack&at=100000");
  await tab.click("#run");
  check(!(await tab.isVisible("#going")), "so does Pause", await status(tab));
  await goTo(tab, "#scene=stack&at=100000");
  await tab.selectOption("#scene", "chain");
  await tab.waitForTimeout(300);
  check((await numbers(tab)).steps === 0, "another scene does not go on to that step");
  await goTo(tab, "#scene=stack&at=700");
  await tab.waitForSelector("#going", { state: "hidden", timeout: 20000 });
  check((await numbers(tab)).steps === 700, "it ends at the step that was asked for");
  check(/^Step 700/.test(await status(tab)), "and says so", await status(tab));
}

async function checkSlowSolver(tab) {
  const begun = Date.now();
  await goTo(tab, "#scene=pyramid&solver=reference&at=60");
  await tab.waitForFunction(
    () => /longer than 0\.5 s/.test(document.getElementById("status").textContent),
    null,
    {
      timeout: 30000,
    },
  );
  check(true, "the exact solver is refused where it would hold the page up");
  check(Date.now() - begun < 20000, "within seconds", String(Date.now() - begun));
  await goTo(tab, "#scene=pyramid&at=60");
  await tab.waitForFunction(() => cairn.numbers().steps === 60, null, { timeout: 30000 });
  const solver = await shownSolver(tab);
  const longest = await tab.evaluate(async () => {
    const list = document.getElementById("set-solver");
    list.value = "reference";
    const then = performance.now();
    list.dispatchEvent(new Event("change"));
    await new Promise((done) => requestAnimationFrame(done));
    return performance.now() - then;
  });
  check(longest < 4000, "choosing it holds the page up for a moment only", `${longest} ms`);
  check(/take another solver/.test(await status(tab)), "and says what to do", await status(tab));
  check((await shownSolver(tab)) === solver, "the choice goes back", await shownSolver(tab));
  await tab.selectOption("#set-solver", "newton");
  await tab.click("#step");
  check((await numbers(tab)).steps === 61, "and another one goes on", await status(tab));
}

export async function checkGiven(browser) {
  const light = { hash: "#scene=stack", context: { colorScheme: "light" } };
  await inTab(browser, "texts", light, checkTexts);
  await inTab(browser, "links", light, checkLinks);
  await inTab(browser, "words of addresses", light, checkWords);
  await inTab(browser, "on the way to a step", light, checkGoing);
  await inTab(browser, "a slow solver", light, checkSlowSolver);
}
