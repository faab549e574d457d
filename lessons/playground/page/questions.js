// Questions of the lessons: think first, then see. Every answer is what the core finds when it is asked.

/** @typedef {import("./judge.js").Wrong} Wrong */
/** @typedef {import("./trials.js").Trial} Trial */
/** @typedef {import("./trials.js").Measure} Measure */
/**
 * @typedef {object} RowQuestion where a normal row ends, between two bodies
 * @property {string} scene
 * @property {string} bodies the lower one first
 * @property {boolean} [isRight] the right one of two points; else the left one
 * @property {string} asks
 * @property {string} because what the lessons say
 * @property {Wrong[]} wrong
 *
 * @typedef {object} CountQuestion what a trial measures
 * @property {Trial} trial
 * @property {Measure} measure
 * @property {string} what is measured, as a sentence begins
 * @property {string} asks
 * @property {string} because
 * @property {Wrong[]} wrong
 *
 * @typedef {object} ChoiceQuestion which of some trials measures least
 * @property {(Partial<Trial> & {says: string})[]} choices the last may be that none is less
 * @property {Measure} measure
 * @property {string} what is measured, as a sentence begins
 * @property {string} asks
 * @property {string} because
 *
 * @typedef {RowQuestion | CountQuestion | ChoiceQuestion} Question
 */

/** Sweeps that are far from their end. */
const cold = { solver: "si", warm: "off", sweeps: "10" };
/** Of a question about a row, after one sweep. */
export const begun = cold;

/** @type {Question[]} */
export const questions = [
  {
    trial: { scene: "three-boxes", rows: 1 },
    measure: "first",
    what: "It gives",
    asks: "Three boxes of 1 kg, g = 10 m/s², and nothing pushes yet. The first row update stops the lower left corner. Which force does it give?",
    because:
      "A push at a corner also turns the box, and so the corner gives way more easily than the whole box would: 1 + 1.5 times (lesson 02).",
    wrong: [
      { is: 10, says: "That would stop the whole box. This row stops one corner." },
      { is: 5, says: "That is half of the box, as if the other corner held the rest: it has no force yet." },
      { is: 30, says: "That is the weight of all three. The row knows only of its own two bodies." },
      { is: 15, says: "That is where the sweeps end. It is the first of many updates." },
    ],
  },
  {
    trial: { scene: "three-boxes", sweeps: 1 },
    measure: "lowest",
    what: "They give",
    asks: "One sweep goes once through all six rows, from the ground up. What do the two rows under the lowest box give together after it? In the end they carry 30 N.",
    because:
      "When the lowest rows had their turn, the boxes above had not pushed yet: they stopped one box, and that not well. The rest comes down with the next sweeps (lesson 03).",
    wrong: [
      { is: 30, says: "That is where they end. One sweep leaves most of it." },
      { is: 10, says: "That would hold one box. The second row has undone some of what the first did." },
      {
        is: 8,
        says: "Twice what the first row gives: the second one finds the box turning, and has more to do.",
      },
    ],
  },
  {
    scene: "stack",
    bodies: "ground stack.1",
    asks: "Ten boxes of 1 kg, g = 10 m/s², and the lowest box stands on two points. Where will the row of the left point end?",
    because:
      "The two points share the weight of ten boxes, 100 N. A sweep hands weight on from contact to contact; cold, ten sweeps reach about a third of it (lesson 08).",
    wrong: [
      { is: 100, says: "Twice it: that is the whole weight, and two points share it." },
      { is: 10, says: "That is one box. Nine more stand on it." },
      { is: 5, says: "That is half of one box. Nine more stand on it." },
      { is: 90, says: "That leaves the box itself out." },
    ],
  },
  {
    choices: [
      { says: "Warm", scene: "stack", set: { ...cold, warm: "on" }, steps: 60 },
      { says: "Cold", scene: "stack", set: cold, steps: 60 },
      { says: "Both alike" },
    ],
    measure: "fall",
    what: "After one second the top has sunk by",
    asks: "Ten boxes, ten sweeps a step. Warm, each step begins from the forces of the last one; cold, from nothing. Which tower sinks less in a second?",
    because: "Warm, sixty steps work on one answer; cold, each begins with none of it (lesson 08).",
  },
  {
    scene: "stack-ratio",
    bodies: "ground light",
    asks: "A box of 1 kg carries one of 100 kg. Two points carry both of them. Where will the row of the left point end?",
    because:
      "Both boxes weigh 1010 N, and two points share them. With this mass ratio a sweep gets hardly nearer: look at the residual (lesson 19).",
    wrong: [
      { is: 1010, says: "Twice it: that is the whole weight, and two points share it." },
      { is: 5, says: "That is the light box alone." },
      { is: 10.1, says: "That is a hundredth of it: weight is mass times 10 m/s²." },
    ],
  },
  {
    choices: [
      { says: "100 kg on 1 kg", scene: "stack-ratio", set: cold },
      { says: "1 kg on 1 kg", scene: "stack-ratio", set: { ...cold, "mass-ratio": "0.01" } },
      { says: "Both alike" },
    ],
    measure: "left",
    what: "Ten sweeps leave a residual of",
    asks: "Two boxes, one on the other, ten sweeps from nothing. For which two do they leave less to do?",
    because:
      "A light box under a heavy one is thrown from contact to contact: each sweep moves a hundredth of the weight. Heavy on light is slow (lesson 19).",
  },
  {
    choices: [
      { says: "From the ground up", scene: "three-boxes", sweeps: 1 },
      {
        says: "From the top down",
        scene: "three-boxes",
        edit: ['solver = "si"', 'solver = "si"\nrow_order = "reverse"'],
        sweeps: 1,
      },
      { says: "Both alike" },
    ],
    measure: "left",
    what: "One sweep leaves a residual of",
    asks: "Three boxes fall alike, one on the other. Which order of the rows leaves less to do after one sweep?",
    because:
      "Between boxes that fall alike there is nothing to push yet. From the top down, four of six rows find nothing to do; from the ground up, each push finds the next one waiting.",
  },
  {
    scene: "stack-offset",
    bodies: "ground stack.1",
    asks: "The boxes stand 16 cm to the left and to the right by turns. All ten weigh 100 N, and the middle of their weight is not over the middle of the lowest box. Where will the row of the left point end?",
    because:
      "The lowest box stands on the left, so the middle of the weight is nearer to its right point: 66 cm from the left one, 34 cm from the right one. Forces and moments balance at 34 N and 66 N (lesson 06).",
    wrong: [
      { is: 50, says: "That is half of the weight: the middle of it is not over the middle of the box." },
      { is: 66, says: "That is the right point: the weight is nearer to it." },
      { is: 100, says: "That is the whole weight, and two points share it." },
    ],
  },
  {
    choices: [
      { says: "Row by row", scene: "chain-bob", set: cold },
      { says: "Each pin as a block", scene: "chain-bob", set: { ...cold, solver: "block" } },
      { says: "Both alike" },
    ],
    measure: "left",
    what: "Ten sweeps leave a residual of",
    asks: "Each pin of a hanging chain has two rows, left-right and up-down, that disturb each other. A block solves both at once. Which leaves less to do?",
    because:
      "What one row of a pin does, its other row need not undo. Between pins all stays as it was (lesson 12).",
  },
  {
    choices: [
      { says: "10 sweeps", scene: "pyramid", set: cold },
      { says: "100 sweeps", scene: "pyramid", set: { ...cold, sweeps: "100" } },
      { says: "Newton, one system", scene: "pyramid", set: { ...cold, solver: "newton", sweeps: "1" } },
    ],
    measure: "left",
    what: "What is left is a residual of",
    asks: "A pyramid with 400 rows, begun from nothing. Newton solves one system of linear equations for all of them. Which leaves the least?",
    because:
      "Here all points press, so one system has the whole answer; where points open or slip, Newton asks which, and solves a few more. A system costs far more than a sweep (lesson 22).",
  },
  {
    choices: [
      {
        says: "Baumgarte",
        scene: "rope",
        set: { solver: "newton", policy: "baumgarte", substeps: "1" },
        steps: 180,
      },
      {
        says: "Relaxed",
        scene: "rope",
        set: { solver: "newton", policy: "relaxed", substeps: "1" },
        steps: 180,
      },
      { says: "Both alike" },
    ],
    measure: "far",
    what: "After three seconds the bob is away from its pin by",
    asks: "Four links hold a bob of a hundred times their mass, at 2.5 m or less from the pin, and every step is solved exactly. Only how errors are removed differs. With which does the bob stay nearer?",
    because:
      "What a link carries turns with it within a step, as if a spring held it: geometric stiffness. Relaxed asks where the step ends, and takes that spring into the masses; without it light links whip.",
  },
];
