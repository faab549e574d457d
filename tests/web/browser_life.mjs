// What the playground is given and leaves: addresses, files, tabs that nobody sees, worlds that diverge.
import { readFileSync } from "node:fs";
import { bodies, check, drawn, goTo, inTab, numbers, open, setting, status } from "./browser_tab.mjs";

const hashNow = async (tab) => {
  await tab.waitForTimeout(450);
  return tab.evaluate(() => location.hash);
};

async function checkBits(tab) {
  const run = () =>
    tab.evaluate(() => {
      cairn.restart();
      cairn.step(100);
      return cairn.fingerprint();
    });
  const first = await run();
  check(/^[0-9a-f]{16}$/.test(first) && first === (await run()), "the same bits twice", first);
  check((await tab.locator("#scene option").count()) >= 30, "every scene is in the list");
  for (const name of ["pyramid", "chain", "puck"]) {
    await tab.selectOption("#scene", name);
    check((await numbers(tab)).steps === 0 && (await bodies(tab)).length > 3, `${name} opens from the list`);
    check((await tab.textContent("#look")).length > 10, `${name} says what to see`);
  }
}

async function checkAddress(tab) {
  await tab.selectOption("#scene", "stack-offset");
  await tab.fill("#set-sweeps", "4");
  await tab.press("#set-sweeps", "Enter");
  await tab.selectOption("#set-solver", "pgs");
  const hash = await hashNow(tab);
  check(
    hash.includes("scene=stack-offset") && hash.includes("sweeps=4") && hash.includes("solver=pgs"),
    "the address holds scene and settings",
    hash,
  );
  check(!hash.includes("friction"), "and only what differs", hash);
  const print = () => tab.evaluate(() => (cairn.restart(), cairn.step(30), cairn.fingerprint()));
  const before = await print();
  await goTo(tab, hash);
  check(
    (await setting(tab, "sweeps")).value === "4" && before === (await print()),
    "and opens the same again",
  );
  await tab.click("#link");
  const link = await tab.evaluate(() => navigator.clipboard.readText());
  check(
    link.startsWith("file:") && link.endsWith(hash + "&at=30"),
    "the button copies that link, at this step",
    link,
  );
  await tab.click("#scene-file summary");
  const text = (await tab.inputValue("#text")).replace(/^n = \d+/m, "n = 3  # λ");
  await tab.fill("#text", text);
  await tab.click("#run-text");
  const edited = await hashNow(tab);
  check(edited.includes("text="), "an edited text goes into the address", edited);
  await goTo(tab, edited);
  check((await tab.evaluate(() => cairn.sceneText())) === text, "and comes out of it as it was");
}

async function checkGivenAddress(tab) {
  await goTo(tab, "#scene=stack&at=12&sweeps=3");
  check(
    (await numbers(tab)).steps === 12 && (await tab.textContent("#run")) === "Run",
    "a lesson can begin at a step, paused",
  );
  await goTo(tab, "#scene=stack&text=nonsense");
  check(/damaged/.test(await status(tab)), "a damaged text is refused in words", await status(tab));
  await goTo(tab, "#scene=castle");
  check(/castle/.test(await status(tab)), "and so is a scene that is not there", await status(tab));
  await goTo(tab, "#scene=stack&swepes=3");
  check(/swepes/.test(await status(tab)), "and an unknown setting", await status(tab));
}

async function checkEmbedded(tab) {
  const shown = await tab.$$eval(".field, header, #question, #more, #run", (all) =>
    all.filter((each) => each.getClientRects().length > 0).map((each) => each.dataset.setting ?? each.id),
  );
  check(
    shown.sort().join(" ") === "run sweeps warm",
    "in a lesson there are only the settings of the address",
    shown.join(" "),
  );
  check(await tab.isVisible("#whole"), "and a way to the whole playground");
  const wide = await tab.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  check(wide <= 0, "nothing overflows there", String(wide));
}

async function checkHidden(tab) {
  const hide = (isHidden) =>
    tab.evaluate((hidden) => {
      Object.defineProperty(document, "hidden", { configurable: true, get: () => hidden });
      document.dispatchEvent(new Event("visibilitychange"));
    }, isHidden);
  await tab.click("#run");
  await tab.waitForFunction(() => cairn.numbers().steps > 2);
  await hide(true);
  const { steps } = await numbers(tab);
  await tab.waitForTimeout(300);
  check((await numbers(tab)).steps === steps, "a tab that nobody sees computes nothing");
  await hide(false);
  await tab.waitForFunction((before) => cairn.numbers().steps > before, steps);
  check((await numbers(tab)).steps < steps + 15, "and goes on where it was, without catching up");
  await tab.click("#run");
  await tab.waitForTimeout(500); // what was asked for before is drawn
  const pictures = await tab.evaluate(async () => {
    const draw = cairn.draw;
    let drawnNow = 0;
    cairn.draw = () => (++drawnNow, draw());
    await new Promise((done) => setTimeout(done, 300));
    return drawnNow;
  });
  check(pictures === 0, "a world at rest is not drawn again and again", String(pictures));
}

async function checkSaving(tab) {
  const save = async (button) => {
    const [download] = await Promise.all([tab.waitForEvent("download"), tab.click(button)]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  };
  const picture = await save("#picture");
  check(
    picture.name === "stack.png" && picture.bytes.subarray(1, 4).toString() === "PNG",
    "the picture is saved",
    picture.name,
  );
  check(picture.bytes.length > 5000, "with something on it", String(picture.bytes.length));
  const scene = await save("#save-scene");
  check(
    scene.name === "stack.toml" && scene.bytes.toString() === (await tab.evaluate(() => cairn.sceneText())),
    "and the scene file",
  );
}

// It leaves the range of numbers, 1.797e308, in the second second.
const divergent = `title = "a ball that leaves all numbers"
gravity = [0, 0]
[[body]]
name = "ball"
circle = 0.5
velocity = [1.7e308, 0]
`;

async function checkDiverged(tab) {
  await tab.click("#scene-file summary");
  await tab.fill("#text", divergent);
  await tab.click("#run-text");
  await tab.evaluate(() => cairn.step(60));
  await tab.click("#run");
  await tab.waitForSelector("#diverged:not([hidden])", { timeout: 5000 });
  check(/diverged|finite/.test(await tab.textContent("#diverged")), "a diverged world says so in words");
  check((await tab.textContent("#run")) === "Run", "and stops");
  const { steps } = await numbers(tab);
  await tab.click("#diverged-back");
  check(
    !(await tab.isVisible("#diverged")) && (await numbers(tab)).steps < steps,
    "and offers the step before",
    await status(tab),
  );
}

async function checkTheme(tab) {
  const paper = () => tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await paper();
  await tab.click("#theme");
  check((await paper()) !== light, "the switch makes the page dark");
  await tab.reload();
  await tab.waitForSelector("[data-state=ready]");
  check((await paper()) !== light, "and the choice holds");
}

/** A browser that cannot draw says so, instead of an empty page. */
async function checkWithoutDrawing(tab) {
  await tab.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null));
  await tab.reload();
  await tab.waitForSelector("#trouble:not([hidden])");
  const words = await tab.textContent("#trouble");
  check(/cannot begin.*WebGL2.*hardware acceleration/.test(words), "without WebGL2 the page says why", words);
}

export async function checkLife(browser) {
  const scene = { hash: "#scene=stack" };
  await inTab(browser, "bits", scene, checkBits);
  await inTab(browser, "address", scene, checkAddress);
  await inTab(browser, "given address", scene, checkGivenAddress);
  await inTab(browser, "embedded", { hash: "#scene=stack&sweeps=4&warm=on&embed=1" }, checkEmbedded);
  await inTab(browser, "hidden", { context: { reducedMotion: "no-preference" } }, checkHidden);
  await inTab(browser, "saving", scene, checkSaving);
  await inTab(browser, "diverged", scene, checkDiverged);
  await inTab(browser, "without drawing", scene, checkWithoutDrawing);
  await inTab(browser, "theme", { ...scene, context: { colorScheme: "light" } }, checkTheme);
  const { context, tab } = await open(browser);
  check((await tab.textContent("#run")) === "Run", "who wishes for less motion finds a world at rest");
  await context.close();
}
