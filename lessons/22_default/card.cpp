// Lesson 22: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson22(
    {.number = 22,
     .name = "default",
     .title = "What you get if you ask for nothing",
     .idea =
         "Sweeps carry a pull from joint to joint, and all rows at once carry it through. A small scene that "
         "names no setting gets all rows at once: see what they are good for.",
     .paper = "paper 5, and beyond",
     .equations = {"work of a step = substeps × solves × systems or sweeps × rows × the price of one"},
     .needs = {"lesson 18", "lesson 19", "lesson 21"},
     .reads = {"src/scenes/default_setting.cpp", "lessons/sandbox/CHOOSING.md"},
     .question =
         "Twelve planks of 1\u00a0m on pins are as long as the gap between two banks, and carry three loads. "
         "With all rows at once the middle load sinks by 2\u00a0mm. With 20 sweeps instead, no joint ever "
         "opens by more than 12\u00a0mm, and all 13 together by 7\u00a0cm. By how many centimetres does the "
         "load sink then?",
     .spoilers = {"59 cm", "Pythagoras"},
     .unasked = {"tower"},
     .wrong = {{{0}, {3}, "The gaps of thirteen joints add up, and the planks need not stay level."},
               {{3.1}, {20}, "That is along the bridge. A rope that is a little longer hangs a lot lower."},
               {{20.1},
                {47},
                "Lower still. A triangle of 6\u00a0m, with a long side of 6.035\u00a0m: how high is it?"},
               {{71.5}, {140}, "Either half of the bridge is a triangle of its own, with half of the gaps."}},
     .hints = {"What becomes of a level chain that is a little too long?",
               "Each half is the long side of a triangle. How high is that triangle?",
               "√((6 + x)² − 6²), where x is half of all gaps, 3.5 cm."},
     .parameters = {{"planks", 12, 4, 24, "", "of the bridge", Parameter::Kind::whole},
                    {"density", 20, 1, 200, "kg/m^2", "of its loads, of 0.64 m^2 each"},
                    {"tower", 110, 101, 130, "", "boxes of the tower beyond the border",
                     Parameter::Kind::whole}},
     .cover = 1,
     .next = ""});

}  // namespace cairn
