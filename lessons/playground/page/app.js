// What all parts of the page share: the core, its time, and what follows an act.
import { isRefusal, say, sayRefusal } from "./words.js";
import { Player } from "./player.js";
import { ownFile } from "./own.js";

/** @typedef {import("./core.js").Core} Core */
/** @typedef {{name: string, title: string, look: string, order: number, text: string}} SceneFile */

export class App {
  core;
  player;
  /** @type {SceneFile[]} in their order */
  scenes;
  /** The name of the scene that is open. */
  scene = "";
  /** How often one was opened. */
  opened = 0;
  /** What is plotted: a body, or two and the force between them. @type {number[]} */
  chosen = [];
  /** @type {(() => void)[]} */
  #followers = [];
  /** @type {(() => void)[]} */
  #drawnFollowers = [];

  /**
   * @param {Core} core
   * @param {SceneFile[]} scenes
   */
  constructor(core, scenes) {
    this.core = core;
    this.scenes = scenes;
    this.player = new Player(
      core,
      () => this.#drawnFollowers.forEach((follow) => follow()),
      (refusal) => {
        if (refusal) sayRefusal(refusal);
        else if (!isRefusal()) say(core.words());
        this.changed();
      },
    );
  }

  /**
   * Calls it after each act.
   * @param {() => void} follow
   */
  follow(follow) {
    this.#followers.push(follow);
  }

  /**
   * Calls it after each picture.
   * @param {() => void} follow
   */
  followPictures(follow) {
    this.#drawnFollowers.push(follow);
  }

  /**
   * Does what a student asks for, and says what came of it.
   * @param {() => boolean} task which returns false where the core has refused
   * @param {string} [words] to be said instead of the core's
   */
  act(task, words) {
    const isDone = task();
    if (isDone) say(words ?? this.core.words());
    else sayRefusal(this.core.refusal());
    this.changed();
    return isDone;
  }

  /**
   * The same for what needs a world at rest.
   * @param {() => boolean} task
   */
  actPaused(task) {
    this.player.pause();
    return this.act(task);
  }

  /** Plots a body, or what is between two; without any, nothing. @param {number[]} bodies */
  choose(...bodies) {
    this.chosen = bodies;
    this.player.wake();
  }

  /** Something may look different now. */
  changed() {
    const rate = this.core.settings().find((setting) => setting.name === "rate");
    if (rate) this.player.rate = Number(rate.value);
    this.#followers.forEach((follow) => follow());
    this.player.wake();
  }

  toggleRunning() {
    if (this.player.isRunning) {
      this.player.pause();
      say(this.core.words() || "Paused.");
    } else {
      this.player.run();
      say(this.player.isSlow ? "Runs in slow motion, row by row." : "Runs.");
    }
    this.changed();
  }

  toggleSlow() {
    this.player.isSlow = !this.player.isSlow;
    say(this.player.isSlow ? "Slow motion: a few row updates a frame." : "Slow motion is off.");
    this.changed();
  }

  /**
   * Opens a scene of the list, or another text under its name.
   * @param {string} name
   * @param {string} [text]
   */
  open(name, text) {
    if (this.player.target > 0) this.player.pause();
    const file = this.scenes.find((scene) => scene.name === name) ?? this.scenes[0];
    const isOpened = this.core.open(text ?? file.text, file.name);
    if (isOpened) [this.scene, this.chosen, this.opened] = [file.name, [], this.opened + 1];
    return isOpened;
  }

  /** To the start once more, to stand still there. */
  restart() {
    this.player.pause();
    return this.core.restart();
  }

  /** What is open: the file of the list, or what a text of one's own calls itself. */
  get own() {
    return ownFile(this.file, this.core.sceneText());
  }

  /** The file of the scene that is open, as it is in the list. */
  get file() {
    return this.scenes.find((scene) => scene.name === this.scene) ?? this.scenes[0];
  }
}
