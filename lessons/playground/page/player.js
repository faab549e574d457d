// Time: how many steps a frame, and when to draw. A page that nobody sees computes nothing.

const longestFrame = 0.1; // [s] what a slow frame owes at most
const mostSteps = 8; // a frame
const budget = 12; // [ms] of computing a frame: the rest is dropped, and the world runs slower
const slice = 30; // [ms] of computing a frame on the way to a step
const slowStep = 240; // frames that a step takes at least in slow motion

/** @typedef {import("./core.js").Core} Core */

export class Player {
  isRunning = false;
  isSlow = false;
  /** Steps a second of the world. */
  rate = 60;
  /** Whether the picture can be seen, as far as the page has scrolled. */
  isInView = true;
  /** The step that it goes to as fast as it can, to pause there; 0: none. */
  target = 0;

  #core;
  #drawn;
  #stopped;
  #frame = 0;
  #last = 0;
  #owed = 0;
  #isStale = true;

  /**
   * @param {Core} core
   * @param {() => void} drawn after each picture
   * @param {(refusal: string) => void} stopped once a step or a picture was refused, or it is where it goes to; then ""
   */
  constructor(core, drawn, stopped) {
    this.#core = core;
    this.#drawn = drawn;
    this.#stopped = stopped;
    document.addEventListener("visibilitychange", () => this.#request());
  }

  run() {
    this.isRunning = true;
    this.#core.move(true);
    this.#last = 0;
    this.#owed = 0;
    this.#request();
  }

  pause() {
    this.isRunning = false;
    this.target = 0;
    this.#core.move(false);
    this.wake();
  }

  /**
   * Goes to that step in slices, with pictures in between; the first slice now. Once there it stands still.
   * @param {number} step
   */
  goTo(step) {
    this.target = step;
    this.run();
    this.#goOn();
  }

  #goOn() {
    const begun = this.#core.numbers().steps;
    if (!this.#did(this.#core.stepFor(this.target - begun, slice))) return;
    const { steps, diverged } = this.#core.numbers();
    if (steps >= this.target || diverged === 1) this.#stop("");
  }

  /** The picture is no longer what it should be: draws it with the next frame. */
  wake() {
    this.#isStale = true;
    this.#request();
  }

  /** @param {boolean} isInView */
  setInView(isInView) {
    this.isInView = isInView;
    this.#request();
  }

  get #isSeen() {
    return !document.hidden && this.isInView;
  }

  #request() {
    if (!this.#isSeen) {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
      this.#last = 0;
    } else if (this.#frame === 0 && (this.isRunning || this.#isStale)) {
      this.#frame = requestAnimationFrame((now) => this.#tick(now));
    }
  }

  /** @param {number} now [ms] */
  #tick(now) {
    this.#frame = 0;
    if (!this.#isSeen) return;
    if (this.isRunning) this.#advance(now);
    this.#last = now;
    if (this.#isStale) {
      this.#isStale = false;
      if (this.#core.draw()) {
        this.#drawn();
      } else {
        this.#stop(this.#core.refusal());
        this.#isStale = false; // another try would be refused, too
      }
    }
    this.#request();
  }

  /** @param {number} now [ms] */
  #advance(now) {
    if (this.target > 0) return this.#goOn();
    const elapsed = this.#last === 0 ? 1 / 60 : Math.min((now - this.#last) / 1000, longestFrame);
    if (this.isSlow) {
      this.#did(this.#core.row(this.#updatesAFrame()));
      return;
    }
    this.#owed += elapsed * this.rate;
    const due = Math.floor(this.#owed + 1e-3);
    if (due === 0) return;
    const begun = this.#core.numbers().steps;
    if (!this.#did(this.#core.stepFor(Math.min(due, mostSteps), budget))) return;
    const done = this.#core.numbers().steps - begun;
    this.#owed = done < due ? 0 : this.#owed - due;
  }

  #updatesAFrame() {
    return Math.max(1, Math.round(this.#core.numbers().allUpdates / slowStep));
  }

  /** @param {boolean} isDone */
  #did(isDone) {
    this.#isStale = true;
    if (!isDone) this.#stop(this.#core.refusal());
    return isDone;
  }

  /** @param {string} refusal */
  #stop(refusal) {
    this.pause();
    this.#stopped(refusal);
  }
}
