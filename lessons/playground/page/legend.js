// What colours, dashes and marks of the picture mean, as `lessons legend` says it.
import { find, make } from "./dom.js";

/** Each look, as CSS draws it, and its meaning. */
const meanings = [
  [
    "arrow",
    "orange arrow or bar: a normal force, on the body that receives it; hatched: what this row update gives or takes back",
  ],
  ["arrow friction", "purple arrow: friction"],
  ["arrow velocity", "blue arrow, open head: velocity"],
  ["arrow external", "grey, dashed: the hand, a force from outside"],
  ["bar", "grey bar: what a row has given so far"],
  ["tick", "tick across a bar: where the sweeps end, which is the exact answer of this step"],
  ["box a", "blue body: body a of the row that is being solved"],
  ["box b", "ochre body: body b of that row"],
  ["box ground", "grey with hatch: it cannot move"],
  ["dot", "dot: the contact of the row that is being solved, where its force is too small for an arrow"],
  ["line pgs", "blue, solid, circle: PGS and its kin"],
  ["line si", "ochre, dashed, square: SI, row by row or in blocks"],
  ["line jacobi", "plum, dotted, diamond: Jacobi"],
  ["line exact", "thin, text colour, tick: exact: Newton and the reference"],
];

export function setUpLegend() {
  const lines = meanings.flatMap(([look, words]) => [
    make("dt", {}, make("i", { className: look, ariaHidden: "true" })),
    make("dd", { textContent: words }),
  ]);
  find("legend", HTMLElement).append(make("dl", {}, ...lines));
}
