// The playground by keyboard alone and by touch.
import { bodies, check, drawn, inTab, numbers, onScreen, status } from "./browser_tab.mjs";

const focused = (tab) =>
  tab.evaluate(() => {
    const at = document.activeElement;
    const marked = at.matches("input[type=radio]") ? at.nextElementSibling : at;
    return { id: at.id || at.className || at.tagName, outline: getComputedStyle(marked).outlineStyle };
  });

async function checkFocus(tab) {
  const reached = new Set();
  let unmarked = "";
  for (let i = 0; i < 60; ++i) {
    await tab.keyboard.press("Tab");
    const { id, outline } = await focused(tab);
    if (id === "BODY") break;
    if (outline === "none") unmarked = id;
    reached.add(id);
  }
  const wanted =
    "skip link picture save-scene keys theme scene cairn run row sweep step back restart slow tool-hand undo";
  for (const id of [...wanted.split(" "), "set-solver", "set-sweeps", "question-try"]) {
    check(reached.has(id), `the keyboard reaches ${id}`);
  }
  check(unmarked === "", "what has the focus is marked", unmarked);
}

async function focusCanvas(tab) {
  await tab.evaluate(() => document.activeElement.blur());
  await tab.focus("#restart");
  for (let i = 0; i < 20 && (await focused(tab)).id !== "cairn"; ++i) await tab.keyboard.press("Shift+Tab");
  check((await focused(tab)).id === "cairn", "Tab goes to the picture");
}

async function checkCursor(tab) {
  await focusCanvas(tab);
  await tab.keyboard.press("ArrowRight");
  const first = await status(tab);
  await tab.keyboard.press("ArrowUp");
  const second = await status(tab);
  check(
    first !== second && /stack/.test(first) && /stack/.test(second),
    "arrows choose a body",
    `${first}, ${second}`,
  );
  await drawn(tab);
  check(await tab.isVisible("#marker"), "with a ring around it");
  await tab.keyboard.press("Enter");
  check(/hold/.test(await status(tab)), "Enter takes hold of it", await status(tab));
  const before = await bodies(tab);
  for (let i = 0; i < 8; ++i) await tab.keyboard.press("ArrowRight");
  await tab.evaluate(() => cairn.step(30));
  const after = await bodies(tab);
  const moved = Math.max(...after.map((body, i) => body.x - before[i].x));
  check(moved > 0.05, "arrows then pull it", String(moved));
  await tab.keyboard.press("Escape");
  check(/let go/.test(await status(tab)), "Escape lets go", await status(tab));
  await checkToolsByKeys(tab);
}

/** With a body chosen. */
async function checkToolsByKeys(tab) {
  const before = await bodies(tab);
  await tab.keyboard.press("b");
  await tab.keyboard.press("Enter");
  check(
    (await bodies(tab)).length === before.length + 1,
    "Enter puts a box, with that tool",
    await status(tab),
  );
  await tab.keyboard.press("Control+z");
  check((await bodies(tab)).length === before.length, "Ctrl+Z takes it back");
  await tab.keyboard.press("p");
  await tab.keyboard.press("Enter");
  await tab.keyboard.press("g");
  check(
    (await tab.evaluate(() => cairn.rows())).some(({ kind }) => kind === 0),
    "P, Enter, G pin a body to the ground",
  );
  await tab.keyboard.press("z");
  const text = await tab.evaluate(() => cairn.sceneText());
  await tab.keyboard.press("Delete");
  check((await tab.evaluate(() => cairn.sceneText())) !== text, "Delete removes the body");
}

const withShelf = `[ground]
half_width = 5
[[body]]
name = "shelf"
type = "static"
box = [1, 0.2]
position = [2, 3]
[[body]]
name = "lamp"
box = [1, 1]
position = [2, 1]
`;

/** The second end of a pin may be a body that stands still; and nothing may be pinned to one that was removed. */
async function checkPin(tab) {
  await tab.click("#scene-file summary");
  await tab.fill("#text", withShelf);
  await tab.click("#run-text");
  await focusCanvas(tab);
  await tab.keyboard.press("ArrowUp");
  check((await status(tab)) === "lamp", "arrows choose what can move first", await status(tab));
  await tab.keyboard.press("p");
  await tab.keyboard.press("Enter");
  await tab.keyboard.press("ArrowUp");
  check((await status(tab)) === "shelf", "and for a pin also what stands still", await status(tab));
  await tab.keyboard.press("Enter");
  const text = await tab.evaluate(() => cairn.sceneText());
  check(/a = "shelf"\nb = "lamp"/.test(text), "to which Enter pins it", await status(tab));
  await tab.keyboard.press("Escape");
  await tab.keyboard.press("ArrowUp");
  check((await status(tab)) === "lamp", "and no hand takes hold of", await status(tab));
}

/** What is read aloud: names, the picture in words, and no more than somebody can listen to. */
async function checkAloud(tab, context) {
  await tab.click("#settings-rest summary");
  const session = await context.newCDPSession(tab);
  const { nodes } = await session.send("Accessibility.getFullAXTree");
  const is = (node, name) => node.properties?.some((one) => one.name === name && one.value.value === true);
  const nameless = nodes.filter((node) => is(node, "focusable") && !node.name?.value);
  check(
    nameless.every(({ role }) => role.value === "RootWebArea"),
    "what can have the focus has a name",
    nameless.map(({ role }) => role.value).join(),
  );
  const picture = nodes.find(({ role }) => role?.value === "application");
  const description = picture?.description?.value ?? "";
  check(/impulse/.test(picture?.name?.value), "the picture has a name");
  check(/ten boxes: 11 bodies.* 40 rows.*Arrow keys/.test(description), "and a description", description);
  const slider = await tab.getAttribute('[data-setting="rate"] input[type=range]', "aria-valuetext");
  check(slider === "60 Hz", "a slider says its value, not its place", slider);
  const changes = await tab.evaluate(async () => {
    let count = 0;
    const observer = new MutationObserver((all) => (count += all.length));
    const options = { childList: true, characterData: true, subtree: true };
    document.querySelectorAll("[aria-live], [role=alert]").forEach((each) => observer.observe(each, options));
    document.getElementById("run").click();
    await new Promise((done) => setTimeout(done, 1000));
    return count;
  });
  check(changes <= 2, "while it runs nothing is read aloud again and again", String(changes));
}

async function checkKeys(tab) {
  await tab.keyboard.press("ArrowRight");
  check((await numbers(tab)).steps === 1, "the right arrow takes a step");
  await tab.keyboard.press("r");
  check((await numbers(tab)).updates === 1, "R makes a row update");
  await tab.keyboard.press("s");
  check((await numbers(tab)).updates > 1, "S goes to the end of the sweep");
  await tab.keyboard.press("ArrowLeft");
  await tab.keyboard.press("ArrowLeft");
  check((await numbers(tab)).steps === 0, "the left arrow goes back");
  await tab.keyboard.press("j");
  await tab.keyboard.press("j");
  check((await numbers(tab)).lit === 1, "J lights the next row", String((await numbers(tab)).lit));
  await tab.keyboard.press("Space");
  await tab.waitForFunction(() => cairn.numbers().steps > 2);
  await tab.keyboard.press("Space");
  const { steps } = await numbers(tab);
  await tab.waitForTimeout(150);
  check((await numbers(tab)).steps === steps, "Space runs, and pauses");
  await tab.focus("#run");
  await tab.keyboard.press("Space");
  check((await tab.textContent("#run")) === "Pause", "on a button Space presses that button, once");
  await tab.keyboard.press("Space");
  await tab.keyboard.press("Home");
  check((await numbers(tab)).steps === 0, "Home restarts");
  await tab.keyboard.press("?");
  check(await tab.isVisible("#keys-dialog"), "a dialog names the keys");
  await tab.uncheck("#letters");
  await tab.keyboard.press("Escape");
  check(!(await tab.isVisible("#keys-dialog")), "Escape closes it");
  await tab.evaluate(() => document.activeElement.blur());
  await tab.keyboard.press("r");
  check((await numbers(tab)).updates === 0, "letters can be switched off");
  await tab.focus("#set-solver");
  await tab.keyboard.press("ArrowDown");
  check((await numbers(tab)).steps === 0, "arrows in a list are for the list");
}

/** A finger that goes from one place to another. */
async function swipe(tab, from, to) {
  const session = await tab.context().newCDPSession(tab);
  const touch = (type, point) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: point ? [{ x: point.x, y: point.y }] : [],
    });
  await touch("touchStart", from);
  for (let i = 1; i <= 5; ++i) {
    await touch("touchMove", {
      x: from.x + ((to.x - from.x) * i) / 5,
      y: from.y + ((to.y - from.y) * i) / 5,
    });
    await tab.evaluate(() => cairn.step(8));
  }
  await touch("touchEnd", null);
  await session.detach();
}

/** Targets that a finger may miss. */
const smallTargets = () => {
  document.querySelectorAll("details").forEach((each) => (each.open = true));
  const targets = [...document.querySelectorAll("button, select, summary, input, .tools label")];
  return targets
    .filter((each) => each.getClientRects().length > 0 && !each.matches("[type=checkbox]"))
    .map((each) => ({ id: each.id || each.className || each.tagName, box: each.getBoundingClientRect() }))
    .filter(({ box }) => box.height < 40 || box.width < 40)
    .map(({ id, box }) => `${id} ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`)
    .join(", ");
};

async function checkTouch(tab) {
  await tab.tap("#step");
  check((await numbers(tab)).steps === 1, "a tap on One step takes one");
  const top = (await bodies(tab)).length - 1;
  const before = (await bodies(tab))[top];
  await tab.evaluate(() => document.getElementById("cairn").scrollIntoView({ block: "center" }));
  await tab.waitForTimeout(100);
  const from = await onScreen(tab, before);
  const scrolled = await tab.evaluate(() => window.scrollY);
  await swipe(tab, from, { x: from.x + 60, y: from.y - 60 });
  const after = (await bodies(tab))[top];
  check(after.x > before.x + 0.1, "a finger pulls a body", `${before.x} to ${after.x}`);
  check(
    Math.abs((await tab.evaluate(() => window.scrollY)) - scrolled) < 2,
    "and the page stays where it is",
  );
  const canvas = await tab.locator("#cairn").boundingBox();
  const corner = { x: canvas.x + 6, y: canvas.y + 14 };
  await swipe(tab, corner, { x: corner.x, y: corner.y - 150 });
  await tab.waitForTimeout(200);
  check((await tab.evaluate(() => window.scrollY)) > scrolled + 40, "beside the bodies it scrolls the page");
  await tab.tap("label:has(#tool-remove)");
  const text = await tab.evaluate(() => cairn.sceneText());
  const last = await onScreen(tab, (await bodies(tab))[1]);
  await tab.touchscreen.tap(last.x, last.y);
  check(
    (await tab.evaluate(() => cairn.sceneText())) !== text,
    "a tap removes a body, with that tool",
    await status(tab),
  );
  const small = await tab.evaluate(smallTargets);
  check(small === "", "every target has at least 40 px", small);
}

export async function checkWays(browser) {
  const scene = { hash: "#scene=stack" };
  await inTab(browser, "focus", scene, checkFocus);
  await inTab(browser, "picture by keyboard", scene, checkCursor);
  await inTab(browser, "pin by keyboard", scene, checkPin);
  await inTab(browser, "aloud", scene, checkAloud);
  await inTab(browser, "keys", scene, checkKeys);
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  await inTab(browser, "touch", { ...scene, context: phone }, checkTouch);
}
