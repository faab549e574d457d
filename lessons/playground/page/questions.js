// Questions of the lessons: think first, pull the bar to where the row ends, then see.

/**
 * @typedef {object} Question about the normal row of one of the two points between two bodies
 * @property {string} scene
 * @property {string} bodies the lower one first
 * @property {boolean} [isRight] the right point; else the left one
 * @property {string} asks
 * @property {string} because what the lessons say
 */

/** The settings of each question: sweeps that are far from their end. */
export const begun = [
  ["solver", "si"],
  ["warm", "off"],
  ["sweeps", "10"],
];

/** @type {Question[]} */
export const questions = [
  {
    scene: "stack",
    bodies: "ground stack.1",
    asks: "Ten boxes of 1 kg, g = 10 m/s², and the lowest box stands on two points. Ten sweeps, begun cold, are far from done. Where will the row of the left point end?",
    because:
      "The two points share the weight of ten boxes, 100 N. A sweep hands weight on from contact to contact; cold, ten sweeps reach about a third of it (lesson 09).",
  },
  {
    scene: "stack",
    bodies: "stack.9 stack.10",
    asks: "The uppermost box of the stack weighs 10 N, and stands on two points. Where will the row of the left one end?",
    because: "It carries half of one box, 5 N. The top of a stack is right after few sweeps, its foot last.",
  },
  {
    scene: "stack-ratio",
    bodies: "ground light",
    asks: "A box of 1 kg carries one of 100 kg. Two points carry both of them. Where will the row of the left point end?",
    because:
      "Both boxes weigh 1010 N, and two points share them. With this mass ratio a sweep gets hardly nearer: look at the residual (lesson 17).",
  },
  {
    scene: "stack-offset",
    bodies: "ground stack.1",
    asks: "The boxes stand 16 cm to the left and to the right by turns. All ten weigh 100 N, and the middle of their weight is not over the middle of the lowest box. Where will the row of the left point end?",
    because:
      "The lowest box stands on the left, so the middle of the weight is nearer to its right point: 66 cm from the left one, 34 cm from the right one. Forces and moments balance at 34 N and 66 N (lesson 05).",
  },
  {
    scene: "stack-5-100",
    bodies: "ground stack.1",
    asks: "Five boxes of 1 kg carry one of 100 kg. After ten sweeps from nothing the lowest row has hardly begun. Where will it end?",
    because:
      "All of it weighs 1050 N, and the left point carries half. The weight has to find its way down through five light boxes (lesson 17).",
  },
  {
    scene: "stack",
    bodies: "stack.2 stack.3",
    isRight: true,
    asks: "Look at the third box of the stack. Where will the row of the right point under it end?",
    because:
      "Eight boxes stand on this contact, the third one among them: 80 N for two points. Each row carries what is above it.",
  },
];
