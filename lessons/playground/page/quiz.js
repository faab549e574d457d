// A question at work: it is asked, the student pulls the bar or types a number, then sees.
import { button, find, show } from "./dom.js";
import { number, numberIn, offWords, rowWords, say, sayRefusal } from "./words.js";
import { begun, questions } from "./questions.js";

/** @typedef {import("./app.js").App} App */
/** @typedef {import("./questions.js").Question} Question */

const text = find("question-text", HTMLElement);
const answer = find("answer", HTMLInputElement);

class Quiz {
  #app;
  #at = 0;
  /** The row that is asked for; -1: none. */
  #row = -1;
  /** What is said once the end is shown. */
  #because = "";
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
    if (this.#row >= 0 && predicted !== this.#row) this.#end();
    const asked = this.#row >= 0;
    if (!asked) this.#offer();
    else if (!this.#isRevealed && document.activeElement !== answer) answer.value = number(prediction);
    document.body.classList.toggle("asking", asked);
    show(find("question-form", HTMLElement), asked && !this.#isRevealed);
    show(button("question-try"), !asked);
    show(button("question-next"), !asked || this.#isRevealed);
    show(button("question-lit"), !asked && lit >= 0 && diverged === 0);
  }

  #offer() {
    if (this.#offeredFor !== this.#app.scene && questions[this.#at].scene !== this.#app.scene) {
      const found = questions.findIndex(({ scene }) => scene === this.#app.scene);
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
    this.#row = -1;
    this.#isRevealed = false;
  }

  /** @param {Question} question */
  #ask(question) {
    const { core, player } = this.#app;
    player.pause();
    const isSet =
      this.#app.open(question.scene) && begun.every(([name, value]) => core.set(name, value)) && core.sweep();
    const row = isSet ? this.#find(question) : -1;
    if (row < 0) {
      sayRefusal(core.refusal() || "The scene has no such row now.");
      this.#app.changed();
      return;
    }
    this.#begin(row, question.asks, question.because);
  }

  #askLit() {
    const row = this.#app.core.numbers().lit;
    this.#app.player.pause();
    const words = rowWords(this.#app.core, row);
    this.#begin(row, `Where will ${words}, end if the sweeps go on?`, "");
  }

  /** @param {number} row @param {string} asks @param {string} because */
  #begin(row, asks, because) {
    const { core } = this.#app;
    core.lightRow(row);
    if (!core.predict(row, core.rows()[row].now)) return sayRefusal(core.refusal());
    this.#offeredFor = this.#app.scene;
    this.#row = row;
    this.#because = because;
    this.#isRevealed = false;
    this.#write(asks);
    say(`Pull the bar of row ${row + 1} to where you think it ends, or type the number. Then press See.`);
    this.#app.changed();
    find("question", HTMLElement).scrollIntoView({ block: "nearest" });
    // On a phone the field would bring up a keyboard over the picture.
    if (window.matchMedia("(pointer: fine)").matches) answer.focus({ preventScroll: true });
    answer.select();
  }

  /** @param {Question} question */
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
    return this.#app.act(() => this.#app.core.predict(this.#row, value), `You say ${number(value)} N.`);
  }

  #see() {
    if (!this.#typed()) return;
    const { core } = this.#app;
    const { prediction } = core.numbers();
    core.reveal();
    this.#isRevealed = true;
    const off = offWords(prediction, core.rows()[this.#row].end);
    this.#write(`${off} ${this.#because}`.trim());
    say("");
    this.#app.changed();
    button("question-next").focus();
  }
}

/** @param {App} app */
export function setUpQuiz(app) {
  const quiz = new Quiz(app);
  app.follow(() => quiz.update());
}
