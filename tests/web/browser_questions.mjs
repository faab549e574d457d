// What the playground asks and sets: every answer against statics or a trial of its own, challenges failed and met.
import { bodies, check, inTab, numbers, setting, status } from "./browser_tab.mjs";

const context = { reducedMotion: "no-preference" };
const text = (tab) => tab.textContent("#question-text");

/** A box of 1 kg and 1 m on one corner, 0.5 m aside: 1 / m + r^2 / I of its row [1/kg]. */
const corner = 1 + 0.5 ** 2 * 6;
const firstRow = 10 / corner; // [N] stops that corner
const secondRow = (10 - firstRow + 0.5 ** 2 * 6 * firstRow) / corner; // the other one, faster by then

/** Statics, at g = 10 m/s^2 [N]; and what a choice must be. */
const answers = {
  "The first row update": { value: firstRow, wrong: { 10: /one corner/, 30: /all three/ } },
  "One sweep goes once": { value: firstRow + secondRow, wrong: { 30: /where they end/, 10: /one box/ } },
  "the lowest box stands on two points": {
    value: 100 / 2,
    wrong: { 100: /two points share/, 10: /one box/, 47: /Close/, 25: /Half/, "-50": /other way/ },
  },
  "Warm, each step": { choice: "Warm" },
  "carries one of 100 kg": { value: 1010 / 2, wrong: { 1010: /two points share/, 5: /light box/ } },
  "For which two": { choice: "1 kg on 1 kg" },
  "Which order": { choice: "From the ground up" },
  "16 cm": { value: 100 * (0.5 - 0.16), wrong: { 66: /right point/, 50: /half of the weight/ } },
  "Each pin of a hanging": { choice: "Each pin as a block" },
  "400 rows": { choice: "Newton, one system" },
  "Only how errors": { choice: "Relaxed" },
};

const answer = async (tab, value) => {
  await tab.click("#question-try");
  await tab.fill("#answer", String(value));
  await tab.click("#question-see");
  return text(tab);
};

async function checkOne(tab, { value, choice, wrong = {} }, number) {
  const asks = await text(tab);
  const back = async () => {
    for (let i = 0; i < number; ++i) await tab.click("#question-next");
  };
  for (const [guess, judged] of Object.entries(wrong)) {
    const said = await answer(tab, guess);
    check(judged.test(said.split(" You said")[0]), `"${asks.slice(0, 40)}": ${guess} is judged`, said);
    await back();
  }
  if (choice) {
    await tab.click("#question-try");
    const names = await tab.$$eval("#question-choices button", (all) => all.map((one) => one.textContent));
    const other = names.find((name) => name !== choice);
    await tab.click(`#question-choices button:text-is("${other}")`);
    check((await text(tab)).startsWith(`No: ${choice}.`), `"${asks.slice(0, 40)}": ${other} is wrong`);
    await back();
    await tab.click("#question-try");
    await tab.click(`#question-choices button:text-is("${choice}")`);
    check((await text(tab)).startsWith("Right."), `"${asks.slice(0, 40)}": ${choice}`, await text(tab));
  } else {
    const said = await answer(tab, value);
    check(said.startsWith("You have it."), `"${asks.slice(0, 40)}": ${value} N`, said);
  }
}

async function checkAnswers(tab) {
  const count = Object.keys(answers).length;
  const met = new Set();
  for (let i = 0; i < count; ++i) {
    const asks = await text(tab);
    const found = Object.keys(answers).find((words) => asks.includes(words));
    check(found !== undefined && !met.has(found), "each question has its answer here", asks);
    met.add(found);
    await checkOne(tab, answers[found], count);
    await tab.click("#question-next");
  }
  check(met.size === count, "and each answer its question", [...met].join());
}

const begin = async (tab, number) => {
  await tab.selectOption("#challenge-list", String(number));
  await tab.click("#challenge-begin");
};
const verdict = async (tab) => {
  await tab.click("#challenge-check");
  return status(tab);
};
const set = async (tab, name, value) => {
  await tab.fill(`#set-${name}`, value);
  await tab.press(`#set-${name}`, "Enter");
};

async function checkTower(tab) {
  await begin(tab, 0);
  check(/^Not yet.* sunk by \d+ mm/.test(await verdict(tab)), "cold, the tower sinks", await status(tab));
  await tab.selectOption("#set-solver", "newton");
  check(/^Not yet.*sweeps/.test(await verdict(tab)), "the exact solver is no answer", await status(tab));
  await tab.selectOption("#set-solver", "si");
  await set(tab, "sweeps", "80");
  check(/^Not yet. Ten sweeps/.test(await verdict(tab)), "nor are more sweeps", await status(tab));
  await set(tab, "sweeps", "10");
  await tab.check("#set-warm");
  check(/^Done\./.test(await verdict(tab)), "warm, it stands", await status(tab));
}

async function checkWeight(tab) {
  await begin(tab, 1);
  check(/^Not yet. 1 kg holds/.test(await verdict(tab)), "five boxes carry more than one", await status(tab));
  await set(tab, "mass-ratio", "1");
  check(/^Not yet. 100 kg sinks/.test(await verdict(tab)), "but not 100 kg", await status(tab));
  const most = await tab.evaluate(() => {
    const holds = (ratio) =>
      cairn.set("mass-ratio", String(ratio)) && cairn.restart() && cairn.step(180) && cairn.fall(0) < 0.5;
    let ratio = 0.01;
    while (holds(ratio + 0.01)) ratio += 0.01;
    return ratio;
  });
  await set(tab, "mass-ratio", most.toFixed(2));
  check(
    /^Done\./.test(await verdict(tab)),
    "the most in whole kilograms is enough",
    `${most} ${await status(tab)}`,
  );
  await set(tab, "mass-ratio", (0.8 * most).toFixed(3));
  check(/^Not yet.*More/.test(await verdict(tab)), "four fifths of it are not", await status(tab));
  check((await setting(tab, "mass-ratio")).value === (0.8 * most).toFixed(3), "and it stays as it was set");
}

async function checkArch(tab) {
  await begin(tab, 2);
  check(/^Not yet/.test(await verdict(tab)), "both hold the arch as it is", await status(tab));
  await tab.uncheck("#set-warm");
  check(/^Done\./.test(await verdict(tab)), "cold, SI drops it", await status(tab));
}

async function checkChain(tab) {
  await begin(tab, 3);
  check(/not been torn/.test(await verdict(tab)), "a whole chain has not been torn", await status(tab));
  await tab.evaluate(() => {
    const { x, y } = cairn.bodies()[7];
    cairn.grab(x, y);
    for (let i = 0; i < 90; ++i) {
      cairn.drag(x + 0.02 * i, y);
      cairn.step(1);
    }
    cairn.letGo();
  });
  await tab.click("#step");
  check(/^Not yet. Torn: 3 of/.test(await verdict(tab)), "a hand tears it", await status(tab));
  const { x, y } = (await bodies(tab))[5];
  await tab.evaluate(({ x, y }) => cairn.pin(4, 5, x, y), { x, y });
  await tab.click("#step");
  check(/^Done\./.test(await verdict(tab)), "and a pin mends it", await status(tab));
}

async function checkRace(tab) {
  await tab.click("#everything");
  await tab.click("#race");
  await tab.waitForFunction(
    () => /came|come down/.test(document.getElementById("status").textContent),
    null,
    {
      timeout: 30000,
    },
  );
  const [, si, jacobi] = /si ([\d.]+) mm, jacobi-split ([\d.]+) mm/.exec(await status(tab)) ?? [];
  check(Number(jacobi) > 10 * Number(si), "the race says who let it sink", await status(tab));
  check((await numbers(tab)).steps >= 180, "after three seconds");
}

export async function checkQuestions(browser) {
  await inTab(browser, "answers", { hash: "#scene=three-boxes", context }, checkAnswers);
  for (const [name, checks] of Object.entries({ checkTower, checkWeight, checkArch, checkChain }))
    await inTab(browser, name, { hash: "#scene=stack", context }, checks);
  await inTab(browser, "race", { context }, checkRace);
}
