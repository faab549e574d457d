// A question at work: it is asked, the student pulls the bar, types a number or chooses, then sees.
import { button, find, make, show } from "./dom.js";
import { number, numberIn, rowWords, say, sayRefusal } from "./words.js";
import { judgement, offWords } from "./judge.js";
import { begun, questions } from "./questions.js";
import { attempt, measured, measures } from "./trials.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./questions.js").Question} Question */
/** @typedef {import("./questions.js").ChoiceQuestion} ChoiceQuestion */
/** @typedef {import("./questions.js").CountQuestion} CountQuestion */
/** @typedef {import("./questions.js").RowQuestion} RowQuestion */

const text = find("question-text", HTMLElement);
const answer = find("answer", HTMLInputElement);
const choices = find("question-choices", HTMLElement);

/** The scene that a question is about. @param {Question} question */
function sceneOf(question) {
  if ("scene" in question) return question.scene;
  return "trial" in question ? question.trial.scene : (question.choices[0].scene ?? "");
}

class Quiz {
  #app;
  #at = 0;
  /** What is asked now. @type {Question | "lit" | null} */
  #asked = null;
  /** The row that is asked for; -1: none. */
  #row = -1;
  #isRevealed = false;
  /** The scene for which a question was chosen: once, so that a student can turn to others. */
  #offeredFor = "";

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
    button("question-try").addEventListener("click", () => this.#ask(questions[this.#at]));
    button("question-next").addEventListener("click", () => this.#turn());
    button("question-lit").addEventListener("click", () => this.#askLit());
    find("question-form", HTMLFormElement).addEventListener("submit", (event) => {
      event.preventDefault();
      this.#see();
    });
    answer.addEventListener("change", () => this.#typed());
  }

  /** Keeps up with the world; a question of the scene that was opened comes first. */
  update() {
    const { predicted, prediction, lit, diverged } = this.#app.core.numbers();
    const isGone = this.#row >= 0 ? predicted !== this.#row : this.#app.scene !== this.#offeredFor;
    const isPast = this.#isRevealed && this.#app.player.isRunning;
    if (this.#asked && (isGone || isPast)) this.#end();
    const isAsked = this.#asked !== null;
    if (!isAsked) this.#offer();
    else if (this.#row >= 0 && !this.#isRevealed && document.activeElement !== answer)
      answer.value = number(prediction);
    const isOpen = isAsked && !this.#isRevealed;
    const isChoice = isOpen && this.#asked !== "lit" && this.#asked !== null && "choices" in this.#asked;
    this.#makeRoom(isAsked);
    show(find("question-form", HTMLElement), isOpen && !isChoice);
    show(find("question-pull", HTMLElement), this.#row >= 0);
    show(choices, isChoice);
    show(button("question-try"), !isAsked);
    show(button("question-next"), !isAsked || this.#isRevealed);
    show(button("question-lit"), !isAsked && lit >= 0 && diverged === 0);
  }

  /** While it is asked the question stands under the picture, and both are on the screen. @param {boolean} isAsked */
  #makeRoom(isAsked) {
    if (document.body.classList.contains("asking") === isAsked) return;
    document.body.classList.toggle("asking", isAsked);
    window.dispatchEvent(new Event("resize"));
  }

  #offer() {
    if (this.#offeredFor !== this.#app.scene && sceneOf(questions[this.#at]) !== this.#app.scene) {
      const found = questions.findIndex((question) => sceneOf(question) === this.#app.scene);
      if (found >= 0) this.#at = found;
    }
    this.#offeredFor = this.#app.scene;
    this.#write(questions[this.#at].asks);
  }

  /** @param {string} words */
  #write(words) {
    if (text.textContent !== words) text.textContent = words;
  }

  #turn() {
    this.#at = (this.#at + 1) % questions.length;
    this.#end();
    say("Another question.");
    this.#app.changed();
  }

  #end() {
    this.#asked = null;
    this.#row = -1;
    this.#isRevealed = false;
  }

  /** @param {Question} question */
  #ask(question) {
    this.#app.player.pause();
    if ("scene" in question) return this.#askRow(question);
    const scene = sceneOf(question);
    const set = "trial" in question ? question.trial.set : undefined;
    if (!attempt(this.#app, { scene, set })) return this.#refused();
    this.#open(question, question.asks);
    if ("trial" in question) return this.#focus("");
    choices.replaceChildren(
      ...question.choices.map(({ says }, i) => {
        const one = make("button", { type: "button", textContent: says });
        one.addEventListener("click", () => this.#choose(question, i));
        return one;
      }),
    );
    say("Choose one: then all are tried.");
    this.#app.changed();
    this.#bringIntoView();
  }

  #refused(words = "") {
    sayRefusal(words || this.#app.core.refusal());
    this.#app.changed();
  }

  /** @param {RowQuestion} question */
  #askRow(question) {
    const isSet = attempt(this.#app, { scene: question.scene, set: begun, sweeps: 1 });
    const row = isSet ? this.#find(question) : -1;
    if (row < 0) return this.#refused(this.#app.core.refusal() || "The scene has no such row now.");
    this.#askAbout(row, question, question.asks);
  }

  #askLit() {
    const row = this.#app.core.numbers().lit;
    this.#app.player.pause();
    this.#askAbout(row, "lit", `Where will ${rowWords(this.#app.core, row)}, end if the sweeps go on?`);
  }

  /** @param {number} row @param {Question | "lit"} question @param {string} asks */
  #askAbout(row, question, asks) {
    const { core } = this.#app;
    core.lightRow(row);
    if (!core.predict(row, core.rows()[row].now)) return sayRefusal(core.refusal());
    this.#row = row;
    this.#open(question, asks);
    this.#focus(number(core.rows()[row].now));
    say(`Pull the bar of row ${row + 1} to where you think it ends, or type the number. Then press See.`);
  }

  /** @param {Question | "lit"} question @param {string} asks */
  #open(question, asks) {
    this.#offeredFor = this.#app.scene;
    this.#asked = question;
    this.#isRevealed = false;
    this.#write(asks);
    const unit = question !== "lit" && "trial" in question ? measures[question.measure].unit : "N";
    find("question-unit", HTMLElement).textContent = unit;
  }

  /** @param {string} value of the field as it begins */
  #focus(value) {
    say("Type the number. Then press See.");
    answer.value = value;
    this.#app.changed();
    this.#bringIntoView();
    // On a phone the field would bring up a keyboard over the picture.
    if (window.matchMedia("(pointer: fine)").matches) answer.focus({ preventScroll: true });
    answer.select();
  }

  #bringIntoView() {
    find("frame", HTMLElement).scrollIntoView({ block: "start" });
  }

  /** @param {RowQuestion} question */
  #find({ bodies, isRight }) {
    const { core } = this.#app;
    const isMeant = (/** @type {import("./core.js").Row} */ { kind, a, b }) =>
      kind === 1 && bodies === `${core.bodyName(a)} ${core.bodyName(b)}`;
    const both = core.rows().flatMap((row, i) => (isMeant(row) ? [i] : []));
    return both[isRight ? 1 : 0] ?? -1;
  }

  #typed() {
    const value = numberIn(answer.value);
    if (Number.isNaN(value)) {
      sayRefusal("A number, please: how many newtons?");
      return false;
    }
    if (this.#row < 0) return true;
    return this.#app.act(() => this.#app.core.predict(this.#row, value), `You say ${number(value)} N.`);
  }

  #see() {
    if (!this.#typed() || !this.#asked) return;
    const { core } = this.#app;
    const asked = this.#asked;
    const known = asked === "lit" || !("wrong" in asked) ? { wrong: [], because: "" } : asked;
    if (asked !== "lit" && "trial" in asked) {
      const said = numberIn(answer.value);
      const end = measured(this.#app, asked.trial, asked.measure);
      if (Number.isNaN(end)) return this.#refused();
      const off = offWords(said, end, measures[asked.measure].unit, asked.what);
      return this.#reveal(`${judgement(said, end, NaN, known.wrong)} ${off} ${known.because}`);
    }
    const { prediction } = core.numbers();
    core.reveal();
    const { now, end } = core.rows()[this.#row];
    this.#reveal(
      `${judgement(prediction, end, now, known.wrong)} ${offWords(prediction, end, "N")} ${known.because}`,
    );
  }

  /** All are tried; then the world is that of the best. @param {ChoiceQuestion} question @param {number} chosen */
  #choose({ choices: all, measure, what, because }, chosen) {
    const found = all.map((one) => (one.scene ? measured(this.#app, one, measure) : Infinity));
    if (found.some(Number.isNaN)) return this.#refused();
    const least = found.indexOf(Math.min(...found));
    const [first, second] = [...found].sort((a, b) => a - b);
    const right = second - first <= 0.02 * second ? all.length - 1 : least;
    attempt(this.#app, all[least]);
    this.#offeredFor = this.#app.scene;
    const { unit } = measures[measure];
    const numbers = all.flatMap(({ says }, i) =>
      found[i] < Infinity ? [`${number(Number(found[i].toPrecision(2)))} ${unit}`.trim() + ` (${says})`] : [],
    );
    const judged = chosen === right ? "Right." : `No: ${all[right].says}.`;
    this.#reveal(`${judged} ${what} ${numbers.join(", ")}. ${because}`);
  }

  /** @param {string} words */
  #reveal(words) {
    this.#isRevealed = true;
    document.body.classList.remove("one-solver");
    this.#write(words.trim());
    say("");
    this.#app.changed();
    this.#bringIntoView();
    button("question-next").focus({ preventScroll: true });
  }
}

/** @param {App} app */
export function setUpQuiz(app) {
  const quiz = new Quiz(app);
  app.follow(() => quiz.update());
}
