// Something to bring about, which the core then checks; and two solvers in a race.
import { button, find, make } from "./dom.js";
import { number, say, sayRefusal } from "./words.js";
import { attempt } from "./trials.js";

/** @typedef {import("./app.js").App} App */
/**
 * @typedef {object} Challenge
 * @property {string} title
 * @property {string} asks
 * @property {import("./trials.js").Trial} start
 * @property {(app: App) => {isDone: boolean, words: string}} check
 */

/** In millimetres, to two digits and a hundredth. @param {number} metres */
function mm(metres) {
  if (!Number.isFinite(metres)) return "more than any number";
  return `${number(Number((Math.round(1e5 * metres) / 100).toPrecision(2)))} mm`;
}

/** Of the settings that may not differ from what the scene recommends. @param {App} app @param {string[]} free */
const changed = ({ core }, free) =>
  core.settings().filter(({ name, value, recommended }) => value !== recommended && !free.includes(name));

/** @param {App} app @param {string} name */
const valueOf = ({ core }, name) => core.settings().find((one) => one.name === name)?.value ?? "";

/** From the start so many steps on: how far the top came down [m]. @param {App} app @param {number} steps */
function fallAfter({ core }, steps) {
  const isDone = core.restart() && core.step(steps);
  return isDone && core.numbers().diverged === 0 ? core.fall(0) : Infinity;
}

/** @param {App} app @param {number} times the mass that the scene has */
function holdsWith(app, times) {
  return app.core.set("mass-ratio", String(times)) && fallAfter(app, 180) < 0.5;
}

/** The mass under which it just holds, over that of the scene. @param {App} app */
function largestThatHolds(app) {
  let [low, high] = [0.01, 10];
  if (holdsWith(app, high)) return high;
  for (let i = 0; i < 9; ++i) {
    const middle = Math.sqrt(low * high);
    if (holdsWith(app, middle)) low = middle;
    else high = middle;
  }
  return low;
}

/** Bodies that no joint leads to from the beam; the ground and the hand are none. @param {App} app */
function loose({ core }) {
  const bodies = core.bodies();
  const held = bodies.map(({ isThere, canMove }, i) => i > 0 && isThere && !canMove);
  const joints = core.rows().filter(({ kind }) => kind === 0);
  for (let hasGrown = true; hasGrown;) {
    hasGrown = false;
    for (const { a, b } of joints) {
      if (a === 0 || held[a] === held[b]) continue;
      held[a] = held[b] = hasGrown = true;
    }
  }
  return bodies.filter(({ canMove }, i) => canMove && !held[i]).length;
}

/** Whether the chain has been in pieces since it was opened. */
let wasTorn = false;

/** @type {Challenge[]} */
const challenges = [
  {
    title: "Stand with ten sweeps",
    asks: "Cold, the tower of ten sinks. Make it stand: in two seconds its top may sink 20 mm, with ten sweeps a step or fewer, four substeps or fewer, and a solver that sweeps.",
    start: { scene: "stack", set: { solver: "si", sweeps: "10", warm: "off" } },
    check: (app) => {
      const other = changed(app, ["solver", "other", "sweeps", "warm", "policy", "beta", "rate", "substeps"]);
      if (other.length > 0 || app.core.sceneText() !== app.file.text)
        return { isDone: false, words: "Leave boxes, friction and numbers as they were." };
      if (Number(valueOf(app, "sweeps")) > 10) return { isDone: false, words: "Ten sweeps at most." };
      if (Number(valueOf(app, "substeps")) > 4) return { isDone: false, words: "Four substeps at most." };
      if (["newton", "reference"].includes(valueOf(app, "solver")))
        return { isDone: false, words: "That solver solves systems: take one that sweeps." };
      const steps = Math.round(2 * Number(valueOf(app, "rate")));
      const fall = fallAfter(app, steps);
      return { isDone: fall <= 0.02, words: `After ${steps} steps the top has sunk by ${mm(fall)}.` };
    },
  },
  {
    title: "The largest weight on five boxes",
    asks: "Five boxes of 1 kg, ten sweeps. Which weight on them can they just carry? Set the mass of the uppermost body (× 100 kg), and nothing else: in three seconds it may not sink by half a metre. Within a tenth of the most is enough.",
    start: { scene: "stack-5-100", set: { "mass-ratio": "0.01" } },
    check: (app) => {
      if (changed(app, ["mass-ratio", "other"]).length > 0 || app.core.sceneText() !== app.file.text)
        return { isDone: false, words: "Change nothing but the mass of the uppermost body." };
      const mine = Number(valueOf(app, "mass-ratio"));
      const most = largestThatHolds(app);
      const holds = holdsWith(app, mine);
      const kg = `${number(100 * mine)} kg`;
      if (!holds) return { isDone: false, words: `${kg} sinks by ${mm(app.core.fall(0))}: too heavy.` };
      if (mine < 0.9 * most) return { isDone: false, words: `${kg} holds. More is possible.` };
      return {
        isDone: true,
        words: `${kg} holds, and ${number(Number((110 * most).toPrecision(2)))} kg would not.`,
      };
    },
  },
  {
    title: "An arch that SI drops and the exact solver holds",
    asks: "This arch stands under both. Change its stones in the scene file, or settings, until sequential impulses let its keystone fall by half a metre in two seconds, while Newton under the same settings lets it sink less than 20 mm.",
    start: { scene: "arch" },
    check: (app) => {
      const mine = valueOf(app, "solver");
      const [si, exact] = ["si", "newton"].map((solver) =>
        app.core.set("solver", solver) ? fallAfter(app, 120) : NaN,
      );
      app.core.set("solver", mine);
      app.core.restart();
      return {
        isDone: si >= 0.5 && exact <= 0.02,
        words: `Under SI the keystone comes down by ${mm(si)}, under Newton by ${mm(exact)}.`,
      };
    },
  },
  {
    title: "Tear a chain, then mend it",
    asks: "Run it, and pull at the chain until a pin breaks. Then choose Pin, and join what came apart, until every link hangs from the beam again.",
    start: { scene: "torn-chain" },
    check: (app) => {
      const links = loose(app);
      if (links > 0)
        return { isDone: false, words: `Torn: ${links} of its links hang from nothing. Mend it.` };
      return {
        isDone: wasTorn,
        words: wasTorn ? "All links hang from the beam again." : "It has not been torn yet.",
      };
    },
  },
];

const raceSeconds = 3;

class Race {
  #app;
  /** The step at which it ends; 0: there is none. */
  #end = 0;

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
  }

  /** On the scene that is open; where that is the first one, which is cold, on an arch. */
  begin() {
    const { core, player } = this.#app;
    player.pause();
    document.body.classList.remove("one-solver");
    const isFirst = this.#app.scene === this.#app.scenes[0].name;
    if (isFirst && !attempt(this.#app, { scene: "arch" })) return sayRefusal(core.refusal());
    const rival = valueOf(this.#app, "solver") === "jacobi-split" ? "si" : "jacobi-split";
    if (!(valueOf(this.#app, "other") === "none" ? core.set("other", rival) : core.restart()))
      return sayRefusal(core.refusal());
    this.#end = Math.round(raceSeconds * player.rate);
    say(`${this.#names().join(" against ")}, with equally many sweeps: pull at a body, and both feel it.`);
    player.run();
    this.#app.changed();
  }

  #names() {
    return ["solver", "other"].map((name) => valueOf(this.#app, name));
  }

  /** Says who is ahead, once. */
  follow() {
    const { steps, time } = this.#app.core.numbers();
    if (this.#end === 0 || steps < this.#end) return;
    this.#end = 0;
    const falls = [0, 1].map((world) => `${this.#names()[world]} ${mm(this.#app.core.fall(world))}`);
    say(`After ${time.toFixed(2)} s the top has come down: ${falls.join(", ")}.`);
  }
}

/** @param {App} app */
export function setUpChallenges(app) {
  const list = find("challenge-list", HTMLSelectElement);
  const text = find("challenge-text", HTMLElement);
  list.append(...challenges.map(({ title }, i) => make("option", { value: String(i), textContent: title })));
  const chosen = () => challenges[Number(list.value)];
  const write = () => (text.textContent = chosen().asks);
  list.addEventListener("change", write);
  button("challenge-begin").addEventListener("click", () => {
    app.player.pause();
    wasTorn = false;
    document.body.classList.remove("one-solver");
    app.act(() => attempt(app, chosen().start), "Your turn. When you think that it is done, press Check it.");
    find("frame", HTMLElement).scrollIntoView({ block: "nearest" });
  });
  button("challenge-check").addEventListener("click", () => {
    app.player.pause();
    if (app.scene !== chosen().start.scene)
      return sayRefusal("Press Begin first: it has a scene of its own.");
    const { isDone, words } = chosen().check(app);
    say(`${isDone ? "Done." : "Not yet."} ${words}`);
    text.textContent = `${isDone ? "Done." : "Not yet."} ${words} ${chosen().asks}`;
    app.changed();
  });
  const race = new Race(app);
  button("race").addEventListener("click", () => race.begin());
  app.followPictures(() => {
    if (app.scene === "torn-chain" && !wasTorn) wasTorn = loose(app) > 0;
    race.follow();
  });
  write();
}
