// Every control of the playground, by mouse and by keyboard: what has no line here fails.
import { check, goTo, inTab, setting, status } from "./browser_tab.mjs";
import { controls, tell } from "./control_list.mjs";

const manySweeps = `title = "many"
[recommended]
solver = "si"
iterations = 300
[[body]]
circle = 0.5
`;

/** What can be used, by id; a summary by that of its details. Settings and the way to the book are tested apart. */
const found = () =>
  [...document.querySelectorAll("a, button, canvas, input, select, summary, textarea")]
    .filter((each) => !each.closest(".field") && each.id !== "book")
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
