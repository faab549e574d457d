// Every control of the playground, by mouse and by keyboard: what has no line here fails.
import { check, goTo, inTab, setting, status } from "./browser_tab.mjs";

const divergent = `title = "gone"
gravity = [0, 0]
[[body]]
circle = 0.5
velocity = [1.7e308, 0]
`;

const manySweeps = `title = "many"
[recommended]
solver = "si"
iterations = 300
[[body]]
circle = 0.5
`;

/** Brings an act of the core, which no control has done, to the page. */
const tell = (tab) => tab.dblclick("#slow");
const edit = async (tab) => {
  await tab.evaluate(() => cairn.addBox(4, 3, 1, 1));
  await tell(tab);
};
const other = async (tab) => {
  await tab.evaluate(() => cairn.set("sweeps", "3"));
  await tell(tab);
};
const diverge = async (tab) => {
  await tab.evaluate((text) => cairn.open(text, "gone"), divergent);
  await tab.evaluate(() => cairn.step(200));
  await tab.click("#step");
};
const download = (tab) => tab.waitForEvent("download", { timeout: 3000 });
const press = (selector) => (tab) => tab.click(selector);

const keepScale = (tab) => tab.evaluate(() => (globalThis.was = cairn.scale()));
const openRows = press("#rows > summary");
const isSorted = (column) => ({
  before: async (tab) => {
    await openRows(tab);
    await tab.click(`#sort-${(column + 1) % 5}`);
  },
  holds: `document.getElementById("sort-${column}").parentElement.ariaSort === "ascending"`,
});
const chooseBody = async (tab) => {
  await tab.focus("#cairn");
  await tab.keyboard.press("ArrowRight");
  await tab.waitForSelector("#plot:not([hidden])");
};

/**
 * By the id of each control: what comes before it is used, what then holds in the page, or what the browser then does.
 * "in" is the address, where it is another.
 */
const controls = {
  skip: { holds: () => document.activeElement.id === "cairn" },
  link: { holds: async () => (await navigator.clipboard.readText()).includes("#scene=stack") },
  picture: { does: download },
  "save-scene": { does: download },
  keys: { holds: () => document.getElementById("keys-dialog").open },
  "keys-close": { before: press("#keys"), holds: () => !document.getElementById("keys-dialog").open },
  letters: { before: press("#keys"), holds: () => localStorage.getItem("cairn-letters") === "off" },
  theme: { holds: () => document.documentElement.dataset.theme === "dark" },
  scene: { holds: () => !cairn.sceneText().includes("a stack of ten boxes") },
  original: { before: edit, holds: () => cairn.bodies().length === 11 },
  cairn: {
    holds: () => cairn.numbers().lit >= 0 || /stack/.test(document.getElementById("status").textContent),
  },
  "diverged-back": { before: diverge, holds: () => document.getElementById("diverged").hidden },
  run: { holds: () => document.getElementById("run").textContent === "Pause" },
  row: { holds: () => cairn.numbers().updates === 1 },
  sweep: { holds: () => cairn.numbers().updates === 40 },
  step: { holds: () => cairn.numbers().steps === 1 },
  back: { before: press("#step"), holds: () => cairn.numbers().steps === 0 },
  restart: { before: press("#step"), holds: () => cairn.numbers().steps === 0 },
  slow: { holds: () => document.getElementById("slow").ariaPressed === "true" },
  "tool-hand": {
    before: press("label:has(#tool-pin)"),
    holds: () => document.getElementById("tool-hand").checked,
  },
  "tool-box": { holds: () => document.getElementById("tool-box").checked },
  "tool-remove": { holds: () => document.getElementById("tool-remove").checked },
  "tool-pin": { holds: () => document.getElementById("tool-pin").checked },
  "plot-close": {
    before: chooseBody,
    holds: () => document.getElementById("plot").hidden,
  },
  "tool-ball": { holds: () => document.getElementById("tool-ball").checked },
  "tool-rope": { holds: () => document.getElementById("tool-rope").checked },
  "zoom-in": { before: keepScale, holds: () => cairn.scale() > globalThis.was },
  "zoom-out": { before: keepScale, holds: () => cairn.scale() < globalThis.was },
  "zoom-all": {
    before: async (tab) => (await keepScale(tab), await tab.keyboard.press("+")),
    holds: () => cairn.scale() === globalThis.was,
  },
  "scrub-step": {
    before: async (tab) => {
      await tab.evaluate(() => (cairn.step(5), cairn.visit(0)));
      await tell(tab);
    },
    holds: () => cairn.numbers().steps > 0,
    isSlider: true,
  },
  "scrub-row": { holds: () => cairn.numbers().updates > 0, isSlider: true },
  rows: { holds: () => document.querySelectorAll("#rows tbody tr").length === 40 },
  "rows-all": {
    before: chooseBody,
    holds: () => document.getElementById("rows-title").textContent === "Rows: 40",
  },
  "sort-0": isSorted(0),
  "sort-1": isSorted(1),
  "sort-2": isSorted(2),
  "sort-3": isSorted(3),
  "sort-4": isSorted(4),
  undo: { before: edit, holds: () => cairn.bodies().length === 11 },
  answer: {
    before: press("#question-try"),
    holds: () => Math.abs(cairn.numbers().prediction - 47) < 1e-9,
    text: "47",
  },
  "question-see": { before: press("#question-try"), holds: () => cairn.numbers().revealed === 1 },
  "question-try": { holds: () => cairn.numbers().predicted >= 0 },
  "question-lit": { before: press("#row"), holds: () => cairn.numbers().predicted === 0 },
  "question-next": { holds: () => /Warm, each/.test(document.getElementById("question-text").textContent) },
  "challenge-list": { holds: () => /Five boxes/.test(document.getElementById("challenge-text").textContent) },
  "challenge-begin": {
    holds: () => cairn.settings().find(({ name }) => name === "warm").value === "off",
  },
  "challenge-check": { holds: () => /^(Done|Not yet)\./.test(document.getElementById("status").textContent) },
  race: {
    holds: () => cairn.settings().find(({ name }) => name === "other").value === "jacobi-split",
  },
  "all-rows": { before: press("#step"), holds: () => document.getElementById("all-rows").checked },
  everything: { in: "", holds: () => document.getElementById("side").getClientRects().length > 0 },
  legend: { holds: () => document.getElementById("legend").open },
  whole: { in: "#scene=stack&embed=1", does: (tab) => tab.context().waitForEvent("page", { timeout: 3000 }) },
  "all-recommended": {
    before: other,
    holds: () => cairn.settings().every(({ value, recommended }) => value === recommended),
  },
  "settings-rest": { holds: () => document.getElementById("settings-rest").open },
  "scene-file": { holds: () => document.getElementById("scene-file").open },
  "plan-part": { holds: () => document.getElementById("plan").textContent.includes("bodies") },
  text: { before: press("#scene-file summary"), holds: () => text.value.startsWith("# 47"), text: "# 47" },
  "run-text": {
    before: async (tab) => {
      await tab.click("#scene-file summary");
      await tab.fill("#text", "title = 'nothing'\n");
    },
    holds: () => cairn.sceneText() === "title = 'nothing'\n",
  },
};

/** What can be used, by id; a summary by that of its details. Those of settings have a test of their own. */
const found = () =>
  [...document.querySelectorAll("a, button, canvas, input, select, summary, textarea")]
    .filter((each) => !each.closest(".field"))
    .map((each) => each.id || each.parentElement.id);

const folded = ["rows", "settings-rest", "scene-file", "plan-part", "legend"];
const lists = ["scene", "challenge-list"];
const selectorOf = (id) => (folded.includes(id) ? `#${id} > summary` : `#${id}`);

/** Chooses the next word of a list. */
const nextOf = (list) => list.options[(list.selectedIndex + 1) % list.options.length].value;

const mouse = {
  async use(tab, selector) {
    const radio = selector.startsWith("#tool-") ? `label:has(${selector})` : selector;
    await tab.click(radio, selector === "#cairn" ? { position: await barPlace(tab) } : {});
  },
  async choose(tab, selector) {
    await tab.selectOption(selector, await tab.$eval(selector, nextOf));
  },
  async pull(tab, slider) {
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox();
    await tab.mouse.click(box.x + 0.8 * box.width, box.y + box.height / 2);
  },
};

const keyboard = {
  async use(tab, selector) {
    await tab.focus(selector);
    const canBeReached = await tab.evaluate(() => document.activeElement.tabIndex >= 0);
    check(canBeReached, `${selector} can be reached with Tab`);
    const isLink = await tab.$eval(selector, (element) => element.tagName === "A");
    await tab.keyboard.press(selector === "#cairn" ? "ArrowRight" : isLink ? "Enter" : "Space");
  },
  async choose(tab, selector) {
    const isLast = await tab.$eval(selector, (list) => list.selectedIndex === list.options.length - 1);
    await tab.focus(selector);
    await tab.keyboard.press(isLast ? "ArrowUp" : "ArrowDown");
  },
  async pull(tab, slider) {
    await slider.press("ArrowRight");
  },
};

/** The middle of the first bar, from the corner of the picture. */
const barPlace = (tab) =>
  tab.evaluate(() => {
    const canvas = document.getElementById("cairn");
    const scale = canvas.clientWidth / canvas.width;
    for (let y = 4; y < canvas.height; y += 6)
      for (let x = 4; x < canvas.width; x += 6)
        if (cairn.at(x, y).kind === "row") return { x: x * scale, y: (y + 6) * scale };
  });

async function write(tab, selector, words, way) {
  if (way === mouse) await tab.click(selector, { position: { x: 20, y: 12 } });
  else await tab.focus(selector);
  await tab.keyboard.press("Control+a");
  await tab.keyboard.type(words);
  if (selector === "#answer") await tab.keyboard.press("Tab");
}

async function useOne(tab, id, way) {
  const control = controls[id];
  await goTo(tab, control.in ?? "#scene=stack");
  await tab.evaluate(() => localStorage.clear());
  await control.before?.(tab);
  const selector = selectorOf(id);
  const done = control.does?.(tab);
  if (control.text) await write(tab, selector, control.text, way);
  else if (control.isSlider) await way.pull(tab, tab.locator(selector));
  else if (lists.includes(id)) await way.choose(tab, selector);
  else await way.use(tab, selector);
  const claim = `${id} works by ${way === mouse ? "mouse" : "keyboard"}`;
  if (done) return check(Boolean(await done.catch(() => null)), claim);
  const holds = await tab.waitForFunction(control.holds, null, { timeout: 3000 }).catch(() => null);
  check(holds !== null, claim, await status(tab));
}

async function checkControls(tab, way) {
  const ids = await tab.evaluate(found);
  check(ids.join() === [...new Set(ids)].join(), "each control has a name of its own", ids.join());
  const without = ids.filter((id) => !controls[id]);
  check(without.length === 0, "each control of the page has a test", without.join());
  const gone = Object.keys(controls).filter((id) => !ids.includes(id));
  check(gone.length === 0, "each control that is tested is on the page", gone.join());
  for (const id of ids) {
    if (id !== "skip" || way === keyboard) await useOne(tab, id, way); // which is seen while it has the focus
  }
}

async function checkSettings(tab, way) {
  await tab.click("#settings-rest summary");
  const names = await tab.$$eval(".field", (fields) => fields.map(({ dataset }) => dataset.setting));
  const all = await tab.evaluate(() => cairn.settings().map(({ name }) => name));
  check(names.length === all.length, "there is a control for each setting", names.join());
  for (const name of names) {
    const field = tab.locator(`.field[data-setting="${name}"]`);
    const uses = [];
    for (const input of await field.locator("input, select").all()) {
      const [tag, type, id] = await input.evaluate((each) => [each.tagName, each.type, each.id]);
      if (tag === "SELECT") uses.push(() => way.choose(tab, `#${id}`));
      else if (type === "checkbox") uses.push(() => way.use(tab, `#${id}`));
      else if (type === "range") uses.push(() => way.pull(tab, input));
      else
        uses.push(async () => {
          await write(tab, `#${id}`, name === "beta" ? "0.4" : "12", way);
          await tab.keyboard.press("Enter");
        });
    }
    for (const use of uses) {
      await use();
      const now = await setting(tab, name);
      check(now.value !== now.recommended, `the control of ${name} sets it`, await status(tab));
      const isMarked = await field.evaluate((each) => each.classList.contains("differs"));
      check(isMarked, `${name} is marked where it differs`);
      await way.use(tab, `.field[data-setting="${name}"] .recommended`);
      const then = await setting(tab, name);
      check(then.value === then.recommended, `${name} goes back to what is recommended`, then.value);
    }
  }
}

/** Values beyond the usual ends of a slider stay as the scene has them. */
async function checkLimits(tab) {
  await tab.click("#settings-rest summary");
  check((await tab.inputValue("#set-rate")) === "1000", "a scene may have more steps a second than usual");
  await tab.evaluate((text) => cairn.open(text, "many"), manySweeps);
  await tell(tab);
  const slider = tab.locator('.field[data-setting="sweeps"] input[type=range]');
  check((await tab.inputValue("#set-sweeps")) === "300", "and more sweeps");
  check((await slider.inputValue()) === "1000", "and the slider is at its end, not beyond");
  await slider.press("ArrowLeft");
  check((await setting(tab, "sweeps")).value === "299", "from which it goes on by ones");
  await tab.click('.field[data-setting="sweeps"] .recommended');
  check((await setting(tab, "sweeps")).value === "300", "and there is a way back");
}

/** Beside each other: most of the time is for loading the page anew. */
export async function checkAllControls(browser) {
  const hash = "#scene=stack";
  const light = { hash, context: { colorScheme: "light" } };
  await Promise.all([
    inTab(browser, "controls by mouse", light, (tab) => checkControls(tab, mouse)),
    inTab(browser, "controls by keyboard", light, (tab) => checkControls(tab, keyboard)),
  ]);
  await inTab(browser, "settings by mouse", { hash }, (tab) => checkSettings(tab, mouse));
  await inTab(browser, "settings by keyboard", { hash }, (tab) => checkSettings(tab, keyboard));
  await inTab(browser, "limits", { hash: "#scene=painleve" }, checkLimits);
}
