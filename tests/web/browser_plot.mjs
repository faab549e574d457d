// The plot of what was chosen: its numbers are the core's, as far back as Back leads.
import {
  bodies,
  check,
  drawn,
  goTo,
  inTab,
  numbers,
  onScreen,
  placeOf,
  screenshots,
} from "./browser_tab.mjs";
import { join } from "node:path";

const falling = `title = "a ball that falls"
[ground]
[[body]]
name = "ball"
circle = 0.5
position = [0, 6]
restitution = 0.5
[[body]]
name = "brick"
box = [1, 1]
position = [1.5, 0.5]
`;

const run = async (tab, text) => {
  await tab.click("#scene-file summary");
  await tab.fill("#text", text);
  await tab.click("#run-text");
  await tab.click("#scene-file summary");
};
const press = async (tab, body) => {
  const place = await onScreen(tab, (await bodies(tab))[body]);
  await tab.mouse.click(place.x, place.y);
  await drawn(tab);
};
/** The number of each curve, as it stands on the page. */
const shown = (tab) =>
  tab.$$eval(".curve b", (all) => all.map((each) => Number(each.textContent.replace("\u2212", "-"))));
const history = (tab, ...chosen) => tab.evaluate((all) => cairn.history(all), chosen);
/** How many points the first curve has. */
const points = (tab) =>
  tab.$eval(".curve path", (path) => path.getAttribute("d").match(/[ML]/g)?.length ?? 0);

async function checkBody(tab) {
  await run(tab, falling);
  check(!(await tab.isVisible("#plot")), "nothing is plotted before something is chosen");
  await press(tab, 1);
  check((await tab.textContent("#plot-title")) === "ball", "a press on a body plots it");
  check((await points(tab)) === 1, "from one step on", String(await points(tab)));
  await tab.click("#run");
  await tab.waitForFunction(() => cairn.numbers().steps > 20);
  await tab.click("#run");
  await drawn(tab);
  const [times, heights, speeds] = await history(tab, 1);
  const [, speed] = await shown(tab);
  const { steps, time } = await numbers(tab);
  const { y } = (await bodies(tab))[1];
  // As many digits as its axis shows: the farther the ball has fallen, the fewer.
  const written = await tab.textContent(".curve b");
  check(
    /\.\d\d/.test(written) && written === y.toFixed(written.split(".")[1].length),
    "the height is the core's",
    `${written}, ${y}`,
  );
  check(Math.abs(speed - 10 * time) < 1e-2, "and the speed that of a fall, g t", `${speed}, ${10 * time}`);
  check(heights.at(-1) === y && times.at(-1) === time, "the newest step is now");
  check(times.length === steps + 1 && (await points(tab)) === steps + 1, "every step has a point");
  check(Math.abs(speeds[5] - (10 * 5) / 60) < 1e-9, "the fifth, too", String(speeds[5]));
  const label = await tab.getAttribute("#plot", "aria-label");
  check(label.startsWith("ball at ") && label.includes(`height ${written} m`), "in words", label);
  await tab.click("#back");
  await drawn(tab);
  check((await points(tab)) === steps, "Back cuts the curve", `${await points(tab)}, ${steps}`);
  check((await history(tab, 1))[1].at(-1) === (await bodies(tab))[1].y, "to where the world is");
  await tab.evaluate(() => cairn.step(700));
  await tab.click("#step");
  await drawn(tab);
  check((await points(tab)) === 601, "as many steps as Back may take", String(await points(tab)));
  await tab.click("#restart");
  await drawn(tab);
  check((await points(tab)) === 1 && (await tab.isVisible("#plot")), "Restart begins the curve anew");
  await press(tab, 2);
  check((await tab.textContent("#plot-title")) === "brick", "another body, another plot");
  check((await shown(tab)).join() === "0.5,0,0", "which stands still", (await shown(tab)).join());
  await tab.selectOption("#scene", "chain");
  check(!(await tab.isVisible("#plot")), "another scene has no plot yet");
}

/** Ten boxes of 1 kg stand on the floor. */
async function checkForce(tab) {
  await tab.evaluate(() => cairn.step(60));
  await tab.click("#step");
  const bar = await placeOf(tab, "row", 0);
  await tab.mouse.click(bar.x, bar.y);
  await drawn(tab);
  const [force] = await shown(tab);
  check(Math.abs(force - 100) < 2, "a press on a bar plots the force between two bodies", String(force));
  check(/ and stack\.1$/.test(await tab.textContent("#plot-title")), "with their names");
  const [, forces] = await history(tab, 0, 1);
  check(Math.abs(forces.at(-1) - force) < 0.1 && forces.length === 62, "as the core has it", forces.at(-1));
  await tab.click("#plot-close");
  check(!(await tab.isVisible("#plot")), "Close ends it");
}

async function checkKeyboard(tab) {
  await tab.focus("#cairn");
  await tab.keyboard.press("ArrowRight");
  await drawn(tab);
  check(await tab.isVisible("#plot"), "arrows on the picture choose what is plotted");
  const name = await tab.textContent("#plot-title");
  await tab.keyboard.press("Delete");
  await drawn(tab);
  check(!(await tab.isVisible("#plot")), `${name} is removed, and its plot with it`);
}

/** Numbers at the ends of the range leave no error in the page. */
async function checkWild(tab) {
  await run(tab, falling.replace("restitution = 0.5", "velocity = [1.7e308, 0]\ngravity_scale = 0"));
  await press(tab, 1);
  await tab.evaluate(() => cairn.step(200));
  await tab.click("#step");
  await drawn(tab);
  check(await tab.isVisible("#plot"), "a body that leaves all numbers is still plotted");
}

async function look(tab, width, theme) {
  for (const [name, hash] of [
    ["plot", "#scene=double-pendulum"],
    ["plot_lesson", "#scene=stack&friction=0&warm=off&sweeps=10&embed=1"],
  ]) {
    await goTo(tab, hash);
    await tab.focus("#cairn");
    await tab.keyboard.press("ArrowRight");
    await tab.evaluate(() => cairn.step(150));
    await tab.click("#step");
    await drawn(tab);
    const wide = await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    check(wide <= 0, `${name}, ${width} px: nothing overflows`, String(wide));
    if (screenshots)
      await tab.screenshot({ path: join(screenshots, `${name}_${width}_${theme}.png`), fullPage: true });
  }
}

export async function checkPlot(browser) {
  const scene = { hash: "#scene=stack" };
  await inTab(browser, "plot of a body", scene, checkBody);
  await inTab(browser, "plot of a force", scene, checkForce);
  await inTab(browser, "plot by keyboard", scene, checkKeyboard);
  await inTab(browser, "plot of wild numbers", scene, checkWild);
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [390, 820, 1280, 1920]) {
      const context = { viewport: { width, height: width === 390 ? 844 : 800 }, colorScheme };
      await inTab(browser, `plot at ${width} px`, { context }, (tab) => look(tab, width, colorScheme));
    }
  }
}
