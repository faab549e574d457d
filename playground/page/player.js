// Time: how many steps a frame, and when to draw. A page that nobody sees computes nothing.

const longestFrame = 0.1; // [s] what a slow frame owes at most
const mostSteps = 8; // a frame
const budget = 12; // [ms] of computing a frame: the rest is dropped, and the world runs slower
const slowStep = 240; // frames that a step takes at least in slow motion

/** @typedef {import("./core.js").Core} Core */

export class Player {
  isRunning = false;
  isSlow = false;
  /** Steps a second of the world. */
  rate = 60;
  /** Whether the picture can be seen, as far as the page has scrolled. */
  isInView = true;

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
   * @param {() => void} stopped once a step was refused
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
    this.#core.move(false);
    this.wake();
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
      this.#core.draw();
      this.#drawn();
    }
    this.#request();
  }

  /** @param {number} now [ms] */
  #advance(now) {
    const elapsed = this.#last === 0 ? 1 / 60 : Math.min((now - this.#last) / 1000, longestFrame);
    if (this.isSlow) {
      this.#did(this.#core.row(this.#updatesAFrame()));
      return;
    }
    this.#owed += elapsed * this.rate;
    const begun = performance.now();
    for (let steps = 0; this.#owed >= 1 - 1e-3; ++steps) {
      if (steps === mostSteps || performance.now() - begun > budget) {
        this.#owed = 0;
        return;
      }
      this.#owed -= 1;
      if (!this.#did(this.#core.step(1))) return;
    }
  }

  #updatesAFrame() {
    return Math.max(1, Math.round(this.#core.numbers().allUpdates / slowStep));
  }

  /** @param {boolean} isDone */
  #did(isDone) {
    this.#isStale = true;
    if (!isDone) {
      this.pause();
      this.#stopped();
    }
    return isDone;
  }
}
