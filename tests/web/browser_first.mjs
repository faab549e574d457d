// The first minute, with motion as a student has it: what stands there, what moves, and what comes once it is earned.
import { check, drawn, goTo, inTab, numbers, onBar, placeOf, status } from "./browser_tab.mjs";

const withMotion = { reducedMotion: "no-preference" };
const sizes = [
  [390, 844],
  [820, 1180],
  [1280, 800],
  [1920, 1080],
];

const panels = "#side, #question, #challenge, #more, .tools";
const shown = (tab, selector) =>
  tab.$$eval(selector, (all) => all.filter((each) => each.getClientRects().length > 0).length);
const pulse = (tab) => tab.$eval("#row", (button) => getComputedStyle(button).animationName);

/** By its pixels: from where to where the first bar is orange, as a share of the picture's width. */
const orange = (tab) =>
  tab.evaluate(() => {
    cairn.draw();
    const canvas = document.getElementById("cairn");
    const copy = Object.assign(document.createElement("canvas"), {
      width: canvas.width,
      height: canvas.height,
    });
    const pen = copy.getContext("2d");
    pen.drawImage(canvas, 0, 0);
    let best = 0;
    for (let y = 0; y < canvas.height; y += 2) {
      const line = pen.getImageData(canvas.width / 2, y, canvas.width / 2, 1).data;
      let count = 0;
      for (let i = 0; i < line.length; i += 4)
        if (line[i] > 150 && line[i + 1] < 130 && line[i + 2] < 60) ++count;
      best = Math.max(best, count);
    }
    return best / (canvas.width / 2);
  });

async function checkOpening(tab) {
  await tab.waitForTimeout(1500);
  const { steps, updates, rows } = await numbers(tab);
  check(steps === 0 && updates === 0, "the page opens at rest", `${steps}, ${updates}`);
  check(rows === 6, "with three boxes and no friction", String(rows));
  check((await pulse(tab)) === "pulse", "One row pulses", await pulse(tab));
  check((await shown(tab, panels)) === 0, "and nothing else is there yet");
  check((await orange(tab)) < 0.01, "no bar has begun");
  await tab.click("#row");
  await tab.waitForTimeout(400);
  const [row] = await tab.evaluate(() => cairn.rows());
  check(Math.abs(row.now - 4) < 1e-6, "the first row gives m g / 2.5", String(row.now));
  check((await orange(tab)) > 0.08, "and its bar can be seen", String(await orange(tab)));
  check((await pulse(tab)) === "none", "then it pulses no more");
  check((await shown(tab, panels)) === 0, "a row earns nothing yet");
  await tab.click("#sweep");
  await drawn(tab);
  check((await shown(tab, panels)) === 5, "a sweep earns the other panels");
  check(!(await tab.isVisible("#set-other")), "but no second solver");
  await tab.click("#question-try");
  await tab.fill("#answer", "10");
  await tab.click("#question-see");
  check(await tab.isVisible("#set-other"), "which the first answer earns");
  check(/one corner/.test(await tab.textContent("#question-text")), "a known wrong answer is named");
}

/** An update takes 150 ms, and ends with all of it. */
async function checkMotion(tab) {
  const moments = () =>
    tab.evaluate(async () => {
      const seen = [];
      const moment = cairn.moment;
      cairn.moment = (share) => (seen.push([performance.now(), share]), moment(share));
      document.getElementById("row").click();
      await new Promise((done) => setTimeout(done, 500));
      cairn.moment = moment;
      return seen;
    });
  const seen = await moments();
  const grows = seen.every(([, share], i) => i === 0 || share >= seen[i - 1][1]);
  // It ends with the first picture after that, however late a busy machine draws it.
  const times = seen.map(([time]) => time - seen[0][0]);
  check(seen[0][1] === 0 && seen[seen.length - 1][1] === 1 && grows, "a row update grows", String(seen));
  check(times.at(-1) >= 140 && times.at(-2) < 250, "for 150 ms", String(times));
  await tab.emulateMedia({ reducedMotion: "reduce" });
  const still = await moments();
  check(
    still.every(([, share]) => share === 1),
    "but not for those who wish for less motion",
    String(still),
  );
  await tab.click("#restart");
  check((await pulse(tab)) === "none", "and for them nothing pulses", await pulse(tab));
}

/** What a lesson or a link leads to shows all of it. */
async function checkGiven(tab) {
  check((await shown(tab, panels)) === 5 && (await tab.isVisible("#set-other")), "a link shows all panels");
  check((await pulse(tab)) === "none", "and nothing pulses there");
  await goTo(tab, "#scene=stack&embed=1");
  await drawn(tab);
  const rows = await tab.evaluate(() => {
    const canvas = document.getElementById("cairn");
    const found = new Set();
    for (let y = 4; y < canvas.height; y += 6)
      for (let x = 4; x < canvas.width; x += 20)
        if (cairn.at(x, y).kind === "row") found.add(cairn.at(x, y).number);
    return [...found].sort((a, b) => a - b);
  });
  check(rows[0] === 0 && rows[1] === 1, "and a lesson has a bar for each row, friction too", rows.join());
}

/** Beside a tower that stands the ticks stand, too. */
async function checkSums(tab) {
  await tab.selectOption("#scene", "stack");
  const spread = await tab.evaluate(() => {
    const single = [];
    const sums = [];
    for (let i = 0; i < 220; ++i) {
      cairn.step(1);
      const rows = cairn.rows().filter(({ kind, a, b }) => kind === 1 && a === 0 && b === 1);
      if (i < 100) continue;
      single.push(rows[0].end);
      sums.push(rows.reduce((sum, { end }) => sum + end, 0));
    }
    const of = (all) => Math.max(...all) - Math.min(...all);
    return { single: of(single), sums: of(sums) };
  });
  check(spread.single > 20, "the ends of single rows wander", JSON.stringify(spread));
  check(spread.sums < 10, "but not their sum", JSON.stringify(spread));
  await tab.click("#step");
  await drawn(tab);
  const first = await placeOf(tab, "row", 0);
  const second = await placeOf(tab, "row", 2);
  check(first !== null && second === null, "between steps a contact has one bar, of its two points");
  await tab.click("#row");
  await drawn(tab);
  check((await placeOf(tab, "row", 2)) !== null, "within a step each point has its own");
  check((await placeOf(tab, "row", 3)) === null, "and friction is folded");
  await tab.check("#all-rows");
  await drawn(tab);
  check((await placeOf(tab, "row", 3)) !== null, "until it is asked for");
}

/** Question and bar are on the screen together, and the bar reaches the answer. */
async function checkQuestion(tab, width) {
  for (const scene of ["stack-ratio", "stack", "stack-offset"]) {
    await goTo(tab, "#scene=" + scene);
    await tab.click("#question-try");
    await tab.waitForTimeout(400);
    const { predicted } = await numbers(tab);
    const where = `${scene}, ${width} px`;
    const { end } = (await tab.evaluate(() => cairn.rows()))[predicted];
    const top = await tab.$eval("#frame", (frame) => frame.getBoundingClientRect().top);
    check(top >= -1, `${where}: the picture is on the screen`, String(top));
    const see = await tab.$eval("#question-see", (button) => button.getBoundingClientRect().bottom);
    const high = await tab.evaluate(() => window.innerHeight);
    check(see <= high, `${where}: and so is the question`, `${see} of ${high}`);
    const to = await onBar(tab, predicted, end);
    const from = await onBar(tab, predicted, 0);
    check(
      to.y > 0 && to.y < high && to.off < 0.02 * end,
      `${where}: the bar reaches the answer`,
      `${to.off}`,
    );
    await tab.mouse.move(from.x, from.y);
    await tab.mouse.down();
    await tab.mouse.move(to.x, from.y, { steps: 4 });
    await tab.mouse.up();
    const { prediction } = await numbers(tab);
    check(Math.abs(prediction - end) < 0.03 * end, `${where}: it is pulled there`, `${prediction}, ${end}`);
    await tab.click("#question-see");
    check(/You have it|Close/.test(await tab.textContent("#question-text")), `${where}: and judged so`);
  }
}

/** The page says what its colours mean. */
async function checkLegend(tab) {
  check(!(await tab.isVisible("#legend dd")), "the legend is folded");
  await tab.click("#legend summary");
  const words = await tab.textContent("#legend");
  for (const meaning of ["normal force", "friction", "velocity", "PGS", "SI", "Jacobi", "exact"])
    check(words.includes(meaning), `the legend says ${meaning}`);
  const colours = await tab.$$eval("#legend i", (all) =>
    all.map((each) => getComputedStyle(each, "::before").borderTopColor),
  );
  check(new Set(colours).size >= 8, "in its colours", colours.join(" "));
  check((await status(tab)).length > 0, "and the page says what to press");
}

export async function checkFirst(browser) {
  const context = withMotion;
  await inTab(browser, "opening", { context }, checkOpening);
  await inTab(browser, "motion", { context }, checkMotion);
  await inTab(browser, "given", { hash: "#scene=stack", context }, checkGiven);
  await inTab(browser, "sums", { context }, checkSums);
  await inTab(browser, "legend", { context }, checkLegend);
  for (const [width, height] of sizes) {
    const at = { context: { ...withMotion, viewport: { width, height } } };
    await inTab(browser, `question at ${width}`, at, (tab) => checkQuestion(tab, width));
  }
}
