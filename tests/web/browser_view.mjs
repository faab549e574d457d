// What is seen of a scene: wheel, pull, two fingers, keys and buttons; and a list of rows that scrolls and sorts.
import { bodies, check, drawn, goTo, inTab, numbers, onScreen, placeOf, status } from "./browser_tab.mjs";

const scale = (tab) => tab.evaluate(() => cairn.scale());
/** The scene's point under a place of the screen [m]. */
const pointAt = (tab, { x, y }) =>
  tab.evaluate(
    ({ x, y }) => {
      const canvas = document.getElementById("cairn");
      const box = canvas.getBoundingClientRect();
      const by = cairn.width / box.width;
      return cairn.point((x - box.left) * by, (y - box.top) * by);
    },
    { x, y },
  );
const isNear = (a, b, off = 0.05) => Math.hypot(a.x - b.x, a.y - b.y) < off;

async function checkWheel(tab) {
  const place = await onScreen(tab, { x: 1, y: 3 });
  const before = { scale: await scale(tab), point: await pointAt(tab, place) };
  await tab.mouse.move(place.x, place.y);
  await tab.mouse.wheel(0, -300);
  await drawn(tab);
  const after = { scale: await scale(tab), point: await pointAt(tab, place) };
  check(after.scale > 1.3 * before.scale, "the wheel brings the scene nearer", `${after.scale}`);
  check(isNear(before.point, after.point), "around the place under the pointer", JSON.stringify(after));
  check((await tab.evaluate(() => scrollY)) === 0, "and the page stays where it is");
  const bar = await placeOf(tab, "row", 0);
  await tab.mouse.move(bar.x, bar.y);
  await tab.mouse.wheel(0, 200);
  await tab.waitForFunction(() => scrollY > 50);
  check((await scale(tab)) === after.scale, "over the bars it scrolls the page");
  await tab.evaluate(() => scrollTo(0, 0));
  await tab.click("#zoom-all");
  await drawn(tab);
  check((await scale(tab)) === before.scale, "All shows the whole scene again");
  for (let i = 0; i < 60; ++i) await tab.mouse.wheel(0, 0).then(() => tab.click("#zoom-out"));
  check((await scale(tab)) > before.scale / 40, "it goes no further away than there is something to see");
  await tab.selectOption("#scene", "pyramid");
  await tab.selectOption("#scene", "stack");
  await drawn(tab);
  check((await scale(tab)) === before.scale, "a scene that is opened is seen whole");
}

async function checkPull(tab) {
  const from = await placeOf(tab, "scene", -1);
  const point = await pointAt(tab, from);
  await tab.mouse.move(from.x, from.y);
  await tab.mouse.down();
  await tab.mouse.move(from.x + 90, from.y + 40, { steps: 5 });
  await tab.mouse.up();
  await drawn(tab);
  const to = { x: from.x + 90, y: from.y + 40 };
  check(isNear(point, await pointAt(tab, to)), "a pull on an empty place moves the scene with the pointer");
  const top = (await bodies(tab)).length - 1;
  const body = await onScreen(tab, (await bodies(tab))[top]);
  await tab.mouse.move(body.x, body.y);
  await tab.mouse.down();
  check(/hold/.test(await status(tab)), "there a body is taken hold of as before", await status(tab));
  await tab.mouse.up();
}

async function checkViewKeys(tab) {
  const before = await scale(tab);
  await tab.keyboard.press("+");
  await drawn(tab);
  check((await scale(tab)) > 1.2 * before, "+ brings it nearer");
  await tab.keyboard.press("-");
  await drawn(tab);
  check(Math.abs((await scale(tab)) - before) < 1e-9 * before, "- as far away again");
  const { x } = await onScreen(tab, { x: 0, y: 1 });
  for (const focus of ["#run", "#cairn"]) {
    await tab.focus(focus);
    await tab.keyboard.press("Shift+ArrowRight");
    await drawn(tab);
  }
  check(Math.abs((await onScreen(tab, { x: 0, y: 1 })).x - x + 120) < 1, "Shift and an arrow move it");
  check((await numbers(tab)).steps === 0, "and take no step");
  await tab.keyboard.press("0");
  await drawn(tab);
  check(Math.abs((await onScreen(tab, { x: 0, y: 1 })).x - x) < 1, "0 shows the whole scene");
}

async function checkFingers(tab, context) {
  const session = await context.newCDPSession(tab);
  const send = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  await tab.locator("#cairn").scrollIntoViewIfNeeded();
  const { x, y } = await onScreen(tab, { x: 0, y: 6 });
  const before = { scale: await scale(tab), scrolled: await tab.evaluate(() => scrollY) };
  await send("touchStart", [x - 20, y], [x + 20, y]);
  for (const far of [25, 35, 45]) await send("touchMove", [x - far, y + far - 20], [x + far, y + far - 20]);
  await send("touchEnd");
  await drawn(tab);
  check(Math.abs((await scale(tab)) / before.scale - 45 / 20) < 0.1, "two fingers pull the scene apart");
  check(isNear(await pointAt(tab, { x, y: y + 25 }), { x: 0, y: 6 }, 0.3), "and move it");
  check((await tab.evaluate(() => scrollY)) === before.scrolled, "while the page does not scroll");
  check((await tab.evaluate(() => visualViewport.scale)) === 1, "and keeps its size");
  const sizes = await tab.$$eval("#view button, #scrub input", (all) =>
    all.map((each) => [each.id, each.getBoundingClientRect().height]),
  );
  check(
    sizes.every(([, height]) => height >= 40),
    "what a finger presses is 40 px high",
    sizes.join(),
  );
}

const column = (tab, i) =>
  tab.$$eval("#rows tbody tr", (all, k) => all.map((line) => line.cells[k].textContent), i);

async function checkRows(tab) {
  await goTo(tab, "#scene=pyramid");
  await tab.click("#rows-title");
  const { rows } = await numbers(tab);
  await tab.waitForSelector("#rows tbody tr");
  check((await column(tab, 0)).length === rows && rows > 200, "the list has every row", String(rows));
  const box = tab.locator("#rows-list");
  await box.hover();
  await tab.mouse.wheel(0, 400);
  await tab.waitForFunction(() => document.getElementById("rows-list").scrollTop > 100);
  check(true, "and scrolls");
  await tab.click('#rows th button:has-text("Now")');
  const sizes = (await tab.evaluate(() => cairn.rows().map(({ now }) => Math.abs(now)))).sort(
    (a, b) => b - a,
  );
  const shown = (await column(tab, 3)).map((text) => Math.abs(Number(text.replace("\u2212", "-"))));
  check(
    shown.every((value, i) => Math.abs(value - sizes[i]) <= 5e-3 * sizes[i] + 5e-4),
    "a press on a column sorts it, the largest first",
    shown.slice(0, 5).join(),
  );
  await tab.locator("#rows tbody button").first().click();
  const { lit } = await numbers(tab);
  check(String(lit + 1) === (await column(tab, 0))[0], "a press on a row lights it", String(lit));
}

async function checkRowsOfBody(tab) {
  const top = (await bodies(tab)).length - 1;
  const place = await onScreen(tab, (await bodies(tab))[top]);
  await tab.mouse.click(place.x, place.y);
  await drawn(tab);
  const name = await tab.evaluate((body) => cairn.bodyName(body), top);
  const wanted = await tab.evaluate((t) => cairn.rows().filter(({ a, b }) => a === t || b === t).length, top);
  check(
    /Rows of stack\.10: 4/.test(await tab.textContent("#rows-title")) && wanted === 4,
    "a press on a body",
  );
  const names = await column(tab, 2);
  check(
    names.length === wanted && names.every((each) => each.includes(name)),
    "lists its rows",
    names.join(),
  );
  await tab.click("#rows-all");
  check((await column(tab, 0)).length === (await numbers(tab)).rows, "and a button lists all of them again");
}

/** Pulls the uppermost box out of the tower, and throws it aside. */
const throwBox = (tab) =>
  tab.evaluate(() => {
    cairn.grab(0, 9.5);
    cairn.drag(30, 14);
    cairn.step(120);
    cairn.letGo();
    cairn.step(900);
  });

/** Without walls it lands on the floor under the ground. */
async function checkFloor(tab) {
  await throwBox(tab);
  const all = await bodies(tab);
  const lowest = Math.min(...all.map(({ y }) => y));
  check(Math.max(...all.map(({ x }) => x)) > 8.5, "a box leaves the ground");
  check(lowest > -3.2, "and does not fall for ever", String(lowest));
}

/** Where there are walls it stays in the picture, and so it does where a link, an undo or a step back leads. */
async function checkWalls(tab) {
  const isPressed = () => tab.getAttribute("#walls", "aria-pressed");
  const text = await tab.evaluate(() => cairn.sceneText());
  await tab.click("#walls");
  check(/Walls around what is seen/.test(await status(tab)), "Walls puts walls", await status(tab));
  check((await isPressed()) === "true", "and is pressed then");
  await tab.click("#link");
  await throwBox(tab);
  const outside = await tab.evaluate(() =>
    cairn.bodies().filter(({ x, y, canMove }) => {
      const place = cairn.place(x, y);
      return canMove && cairn.at(place.x, place.y).kind !== "scene";
    }),
  );
  check(outside.length === 0, "a box that is thrown stays in the picture", JSON.stringify(outside));
  const beside = Math.max(...(await bodies(tab)).map(({ x }) => x));
  check(beside > 3, "though it left the tower", String(beside));
  await tab.click("#back");
  check((await isPressed()) === "true", "a step back keeps the walls");
  await tab.click("#undo");
  check((await isPressed()) === "false", "Undo takes them out");
  check((await tab.evaluate(() => cairn.sceneText())) === text, "also of the text");
  await goTo(tab, new URL(await tab.evaluate(() => navigator.clipboard.readText())).hash);
  check((await isPressed()) === "true", "a link holds them");
  await tab.keyboard.press("w");
  check((await isPressed()) === "false", "W takes them out");
  await tab.click("#zoom-out");
  await drawn(tab);
  await tab.keyboard.press("w");
  const { y } = (await bodies(tab)).at(-1);
  check((await isPressed()) === "true" && Number.isFinite(y), "and puts them around what is seen now");
}

export async function checkView(browser) {
  const moving = { reducedMotion: "no-preference" };
  const scene = { hash: "#scene=stack", context: moving };
  await inTab(browser, "wheel", scene, checkWheel);
  await inTab(browser, "pull", scene, checkPull);
  await inTab(browser, "keys of the view", scene, checkViewKeys);
  const phone = { ...moving, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  await inTab(browser, "two fingers", { hash: "#scene=stack", context: phone }, checkFingers);
  await inTab(browser, "list of rows", scene, checkRows);
  await inTab(browser, "rows of a body", scene, checkRowsOfBody);
  await inTab(browser, "floor", scene, checkFloor);
  await inTab(browser, "walls", scene, checkWalls);
}
