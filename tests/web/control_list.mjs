// Every control of the playground, and how a test sees that it works.

const divergent = `title = "gone"
gravity = [0, 0]
[[body]]
circle = 0.5
velocity = [1.7e308, 0]
`;

/** Brings an act of the core, which no control has done, to the page. */
export const tell = (tab) => tab.dblclick("#slow");
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
export const controls = {
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
  walls: { holds: () => document.getElementById("walls").ariaPressed === "true" },
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
