// What changes while a scene runs, what is added to it, and the time line.
import {
  bodies,
  check,
  drawn,
  goTo,
  inTab,
  numbers,
  onScreen,
  placeOf,
  setting,
  status,
} from "./browser_tab.mjs";

const sum = (tab) =>
  tab.evaluate(() =>
    cairn.rows().reduce((all, { kind, a, now }) => all + (kind === 1 && a === 0 ? now : 0), 0),
  );

async function checkLive(tab) {
  await tab.click("#run");
  await tab.waitForFunction(() => cairn.numbers().steps > 20);
  await tab.fill("#set-gravity", "4");
  await tab.press("#set-gravity", "Enter");
  for (const [name, value] of [
    ["friction", "0.8"],
    ["bounce", "0.2"],
    ["other", "newton"],
  ])
    await tab.selectOption("#set-" + name, value);
  const { steps } = await numbers(tab);
  check(steps > 20, "gravity, friction, bounce and a second solver change without a restart", String(steps));
  await tab.waitForFunction((before) => cairn.numbers().steps > before, steps);
  check((await tab.textContent("#run")) === "Pause", "and the scene runs on");
  await tab.click("#run");
  await tab.fill("#set-mass-ratio", "2");
  await tab.press("#set-mass-ratio", "Enter");
  check(
    /Mass of the uppermost body: 2 ×/.test(await status(tab)),
    "words say what changed",
    await status(tab),
  );
  await tab.selectOption("#set-solver", "newton");
  await tab.evaluate(() => cairn.step(300));
  check(Math.abs((await sum(tab)) - 11 * 4) < 1, "the ground carries the new weight", String(await sum(tab)));
  await tab.click("#all-recommended");
  check((await setting(tab, "gravity")).value === "10", "and all go back at once");
}

async function checkBallAndRope(tab) {
  const { length } = await bodies(tab);
  const free = await placeOf(tab, "scene", -1);
  await tab.check("#tool-ball", { force: true });
  await tab.mouse.move(free.x + 20, free.y + 60);
  await tab.mouse.down();
  await tab.mouse.move(free.x + 60, free.y + 100, { steps: 3 });
  check(await tab.isVisible("#rubber"), "a ball that is drawn out is shown");
  await tab.mouse.up();
  const ball = (await bodies(tab))[length];
  const text = await tab.evaluate(() => cairn.sceneText());
  check(ball !== undefined && /name = "ball-1"\ncircle = /.test(text), "and then is there");
  await tab.check("#tool-rope", { force: true });
  const at = await onScreen(tab, ball);
  await tab.mouse.move(at.x, at.y);
  await tab.mouse.down();
  await tab.mouse.move(at.x + 10, at.y - 60, { steps: 3 });
  check(await tab.isVisible("#rubber"), "so is a rope that is pulled");
  await tab.mouse.up();
  check(/A rope more/.test(await status(tab)), "and then is there", await status(tab));
  await tab.evaluate(() => cairn.step(120));
  const fallen = ball.y - (await bodies(tab))[length].y;
  check(fallen < 0.3, "the ball hangs from it", String(fallen));
  for (let i = 0; i < 2; ++i) await tab.click("#undo");
  check((await bodies(tab)).length === length, "undo takes out both");
}

async function checkRopeByKeys(tab) {
  const { length } = await bodies(tab);
  await tab.focus("#cairn");
  await tab.keyboard.press("ArrowRight");
  await tab.keyboard.press("t");
  await tab.keyboard.press("Enter");
  await tab.keyboard.press("ArrowUp");
  await tab.keyboard.press("ArrowUp");
  await tab.keyboard.press("Enter");
  check(/A rope more/.test(await status(tab)), "T, Enter, arrows, Enter tie two bodies", await status(tab));
  await tab.keyboard.press("z");
  await tab.keyboard.press("o");
  await tab.keyboard.press("Enter");
  check((await bodies(tab)).length === length + 1, "O, Enter put a ball", await status(tab));
}

async function checkScrub(tab) {
  const print = () => tab.evaluate(() => cairn.fingerprint());
  await tab.evaluate(() => cairn.step(40));
  const middle = await print();
  await tab.evaluate(() => cairn.step(60));
  const end = await print();
  await tab.click("#run");
  await tab.waitForFunction(() => cairn.numbers().steps > 105);
  await tab.fill("#scrub-step", "40");
  check(
    (await numbers(tab)).steps === 40 && (await print()) === middle,
    "the time line leads back to a step",
  );
  check((await tab.textContent("#run")) === "Run", "and pauses there");
  await tab.fill("#scrub-step", "100");
  check((await print()) === end, "and forwards again");
  await tab.focus("#scrub-step");
  await tab.keyboard.press("ArrowLeft");
  check((await numbers(tab)).steps === 99, "by ones with the arrow keys");
  await tab.click("#step");
  await drawn(tab);
  check(
    (await tab.getAttribute("#scrub-step", "max")) === "100",
    "a step from there forgets what came later",
  );
  await tab.fill("#scrub-row", "17");
  check((await numbers(tab)).updates === 17, "the other one leads to a row update");
  const now = await tab.evaluate(() => cairn.rows().map((row) => row.now));
  await tab.fill("#scrub-row", "0");
  for (let i = 0; i < 17; ++i) await tab.click("#row");
  const same = await tab.evaluate(() => cairn.rows().map((row) => row.now));
  check(JSON.stringify(now) === JSON.stringify(same), "the same as pressing One row as often");
  await tab.selectOption("#set-solver", "newton");
  await drawn(tab);
  check(await tab.isDisabled("#scrub-row"), "a solver without row updates has none to go through");
}

export async function checkChange(browser) {
  const scene = { hash: "#scene=stack", context: { reducedMotion: "no-preference" } };
  await inTab(browser, "live changes", scene, checkLive);
  await inTab(browser, "ball and rope", scene, checkBallAndRope);
  await inTab(browser, "rope by keys", scene, checkRopeByKeys);
  await inTab(browser, "time line", scene, checkScrub);
}
