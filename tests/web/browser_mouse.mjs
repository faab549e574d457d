// The playground by mouse: every control, every tool, the text, the question.
import {
  bodies,
  check,
  drawn,
  inTab,
  numbers,
  onBar,
  onScreen,
  placeOf,
  setting,
  status,
} from "./browser_tab.mjs";

async function checkTime(tab) {
  await tab.click("#step");
  check((await numbers(tab)).steps === 1, "a click on One step takes one");
  await tab.click("#row");
  const row = await numbers(tab);
  check(
    row.updates === 1 && row.lit >= 0,
    "One row makes one row update, and lights its row",
    JSON.stringify(row),
  );
  await tab.click("#sweep");
  const sweep = await numbers(tab);
  check(sweep.updates > 1 && sweep.steps === 1, "One sweep goes to its end", JSON.stringify(sweep));
  check(/residual/.test(await status(tab)), "and the words say what it leaves", await status(tab));
  await tab.click("#back");
  check((await numbers(tab)).updates === 0, "Back goes before the step that is under way");
  await tab.click("#back");
  check((await numbers(tab)).steps === 0, "and Back once more to the step before");
  await tab.click("#back");
  check(
    /no step|nothing/i.test(await status(tab)),
    "before the start there is none, in words",
    await status(tab),
  );
  await tab.click("#run");
  check((await tab.textContent("#run")) === "Pause", "Run becomes Pause");
  await tab.waitForFunction(() => cairn.numbers().steps > 3);
  await tab.click("#run");
  const { steps } = await numbers(tab);
  await tab.waitForTimeout(200);
  check((await numbers(tab)).steps === steps, "Pause stops it");
  await tab.click("#slow");
  await tab.click("#run");
  await tab.waitForFunction((before) => cairn.numbers().steps > before || cairn.numbers().updates > 2, steps);
  check((await numbers(tab)).steps <= steps + 1, "slow motion goes row by row");
  await tab.click("#run");
  await tab.click("#slow");
  await tab.click("#restart");
  check((await numbers(tab)).steps === 0, "Restart goes to the start");
}

async function checkNumbers(tab) {
  const slider = tab.locator('.field[data-setting="sweeps"] input[type=range]');
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  await tab.mouse.click(box.x + box.width - 2, box.y + box.height / 2);
  check(Number((await setting(tab, "sweeps")).value) >= 98, "the slider of sweeps goes to its end");
  await slider.press("ArrowLeft");
  check(Number((await setting(tab, "sweeps")).value) <= 99, "and by ones with the arrow keys");
  await tab.fill("#set-sweeps", "many");
  await tab.press("#set-sweeps", "Enter");
  check(
    /sweeps.*number.*many/.test(await status(tab)),
    "a value that is no number is refused in words",
    await status(tab),
  );
  check((await tab.getAttribute("#set-sweeps", "aria-invalid")) === "true", "and its field is marked");
  await tab.click("#all-recommended");
  check(
    (await setting(tab, "sweeps")).value === (await setting(tab, "sweeps")).recommended,
    "all go back at once",
  );
}

async function checkHand(tab) {
  const top = (await bodies(tab)).length - 1;
  const before = (await bodies(tab))[top];
  const from = await onScreen(tab, before);
  await tab.mouse.move(from.x, from.y);
  await tab.mouse.down();
  check(/hold/.test(await status(tab)), "the hand takes hold of a body", await status(tab));
  await tab.mouse.move(from.x + 80, from.y - 30, { steps: 4 });
  await tab.evaluate(() => cairn.step(60));
  await tab.mouse.up();
  const after = (await bodies(tab))[top];
  check(after.x > before.x + 0.2, "and pulls it along", `${before.x} to ${after.x}`);
  check(/let go/.test(await status(tab)), "and lets go", await status(tab));
  await tab.click("#restart");
}

async function checkTools(tab) {
  const text = await tab.evaluate(() => cairn.sceneText());
  const { length } = await bodies(tab);
  await tab.check("#tool-box", { force: true });
  const free = await placeOf(tab, "scene", -1);
  await tab.mouse.move(free.x + 20, free.y + 20);
  await tab.mouse.down();
  await tab.mouse.move(free.x + 70, free.y + 60, { steps: 3 });
  check(await tab.isVisible("#rubber"), "a box that is drawn out is shown");
  await tab.mouse.up();
  check((await bodies(tab)).length === length + 1, "and then is there");
  check(await tab.isVisible("#original"), "a way back to the original is offered");
  check((await tab.inputValue("#text")) !== text, "and its text says so");
  await tab.click("#undo");
  check((await tab.evaluate(() => cairn.sceneText())) === text, "undo takes it out again");
  await tab.check("#tool-remove", { force: true });
  const top = await onScreen(tab, (await bodies(tab))[length - 1]);
  await tab.mouse.click(top.x, top.y);
  check((await tab.evaluate(() => cairn.sceneText())) !== text, "a body is removed", await status(tab));
  await tab.click("#undo");
  await tab.check("#tool-pin", { force: true });
  const again = await onScreen(tab, (await bodies(tab))[length - 1]);
  await tab.mouse.click(again.x, again.y);
  await drawn(tab);
  check(await tab.isVisible("#marker"), "a pin to be is shown");
  await tab.mouse.click(free.x, free.y);
  check(
    (await tab.evaluate(() => cairn.rows())).some(({ kind }) => kind === 0),
    "it joins the body to the ground",
  );
  await tab.click("#undo");
  check(!(await tab.evaluate(() => cairn.rows())).some(({ kind }) => kind === 0), "and undo takes it out");
  await tab.click("#undo");
  check(
    (await tab.textContent("#status.refused")).length > 0,
    "when there is nothing left to undo, words say so",
  );
}

async function checkBars(tab) {
  await drawn(tab);
  const bar = await placeOf(tab, "row", 2);
  await tab.mouse.click(bar.x, bar.y);
  check((await numbers(tab)).lit === 2, "a click on a bar lights its row");
  check(/row 3/.test(await status(tab)), "and says which", await status(tab));
  await tab.mouse.click(bar.x, bar.y);
  check((await numbers(tab)).lit === -1, "a second click puts it out");
}

async function checkText(tab) {
  await tab.click("#scene-file summary");
  const text = await tab.inputValue("#text");
  const print = await tab.evaluate(() => cairn.fingerprint());
  await tab.fill("#text", text + "\n[[body]]\ndensty = 2\n");
  await tab.click("#run-text");
  const words = await tab.textContent("#text-refusal");
  check(/:\d+:\d+: .*densty.*density\?/.test(words), "a bad text is refused with its line and rule", words);
  const marked = await tab.evaluate(() => window.getSelection().toString());
  check(/densty|\[\[body\]\]/.test(marked), "and its line is marked", marked);
  check((await tab.evaluate(() => cairn.fingerprint())) === print, "the world is as it was");
  await tab.fill("#text", text.replace(/^n = \d+/m, "n = 4"));
  await tab.press("#text", "Control+Enter");
  check(
    (await bodies(tab)).length === 5 && !(await tab.isVisible("#text-refusal")),
    "Ctrl+Enter runs a good one",
  );
  await tab.click("#original");
  check((await tab.inputValue("#text")) === text, "the original comes back");
  await tab.click("#scene-file summary");
  await tab.click("#plan-part summary");
  await tab.waitForFunction(() => document.getElementById("plan").textContent.length > 10);
  check(true, "the plan is there when it is unfolded");
}

async function checkQuestion(tab) {
  await tab.click("#question-try");
  const { predicted, steps } = await numbers(tab);
  check(predicted >= 0 && steps === 0, "a question is about a row");
  check((await setting(tab, "warm")).value === "off", "under its settings");
  await drawn(tab);
  const [from, to] = [await onBar(tab, predicted, 0), await onBar(tab, predicted, 40)];
  await tab.mouse.move(from.x, from.y);
  await tab.mouse.down();
  await tab.mouse.move(to.x, to.y, { steps: 5 });
  await tab.mouse.up();
  check(
    Math.abs((await numbers(tab)).prediction - 40) < 2,
    "the bar is pulled to where one thinks",
    (await numbers(tab)).prediction,
  );
  check(Math.abs(Number(await tab.inputValue("#answer")) - 40) < 2, "and the field follows");
  await tab.fill("#answer", "about");
  await tab.click("#question-see");
  check(
    /number/.test(await status(tab)) && (await numbers(tab)).revealed === 0,
    "what is no number is refused",
  );
  await tab.fill("#answer", "45");
  await tab.click("#question-see");
  const said = await tab.textContent("#question-text");
  check(
    /^Close\. You said 45 N\. The row ends at .* N off, \d+ %/.test(said),
    "a sentence says how far off it was",
    said,
  );
  const { end } = (await tab.evaluate(() => cairn.rows()))[predicted];
  check(said.includes(`ends at ${Number(end.toPrecision(4))} N`), "and where the row does end", said);
  await tab.click("#question-next");
  check((await tab.textContent("#question-text")) !== said, "there is another question");
  await tab.keyboard.press("k");
  await tab.click("#question-lit");
  check((await numbers(tab)).predicted >= 0, "a lit row can be asked about, too");
}

export async function checkMouse(browser) {
  const scene = { hash: "#scene=stack" };
  await inTab(browser, "time", scene, checkTime);
  await inTab(browser, "numbers", scene, checkNumbers);
  await inTab(browser, "hand", scene, checkHand);
  await inTab(browser, "tools", scene, checkTools);
  await inTab(browser, "bars", scene, checkBars);
  await inTab(browser, "text", scene, checkText);
  await inTab(browser, "question", scene, checkQuestion);
}
