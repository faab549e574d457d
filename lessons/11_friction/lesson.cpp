// Lesson 11. Friction: a row whose bounds lean on the row beside it.
#include "lessons/lesson.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pictures.hpp"
#include "study.hpp"

namespace {

using namespace cairn;
using namespace cairn::friction;
using render::fixed;
using render::significant;

LessonInfo info() {
  LessonInfo info;
  info.number = 11;
  info.name = "friction";
  info.title = "Friction";
  info.idea =
      "Friction is a row like any other, but its bounds lean on its neighbour: what the normal row gives.";
  info.paper = "paper 2.2, \"interval of valid values\"; 4.4, contact and friction";
  info.equations = {"j_n v ≥ 0,  λ_n ≥ 0            normal row: the contact may push, never pull",
                    "j_t v = 0,  |λ_t| ≤ μ λ_n      tangent row: Coulomb's law as bounds",
                    "holds while tan θ ≤ μ; else slides with a = g (sin θ − μ cos θ)"};
  info.needs = {"lesson 06"};
  info.reads = {"src/constraints/contact.cpp", "src/constraints/row.hpp",
                "src/solvers/sequential_impulse.cpp"};
  info.question = "The rough block just holds. Double its mass: does it start to slide?";
  info.hints = {"What pulls the block down the slope, and what does that depend on?",
                "Write down the limit of friction, and look for the mass in it.",
                "Needed: m g sin θ. Limit: μ m g cos θ. Divide one by the other."};
  using Kind = Parameter::Kind;
  info.parameters = {
      {.flag = "angle", .standard = 30, .min = 5, .max = 35, .unit = "°", .what = "angle of the slope"},
      {.flag = "mu",
       .standard = 0.5,
       .min = 0.05,
       .max = 0.8,
       .unit = "",
       .what = "friction of the slippery block"},
      {.flag = "mu-rough",
       .standard = 0.6,
       .min = 0.05,
       .max = 0.8,
       .unit = "",
       .what = "friction of the rough one"},
      {.flag = "mass",
       .standard = 2,
       .min = 0.001,
       .max = 1000,
       .unit = "kg",
       .what = "mass of the rough one's twin"},
      {.flag = "gravity", .standard = 10, .min = 1, .max = 20, .unit = "m/s²", .what = "gravity"},
      {.flag = "dt", .standard = 0.02, .min = 0.001, .max = 0.05, .unit = "s", .what = "time step"},
      {.flag = "sweeps",
       .standard = 50,
       .min = 1,
       .max = 1000,
       .unit = "",
       .what = "sweeps per step",
       .kind = Kind::whole},
      {.flag = "steps",
       .standard = 100,
       .min = 40,
       .max = 400,
       .unit = "",
       .what = "steps",
       .kind = Kind::whole}};
  info.cover = 4;
  info.next = "lesson12_blocks   (rows that belong together, solved together)";
  return info;
}

StudySettings settings_of(const Lesson& lesson) {
  StudySettings settings;
  settings.slope.angle = lesson.real("angle") * pi / 180;
  settings.slope.gravity = lesson.real("gravity");
  settings.slope.dt = lesson.real("dt");
  settings.slope.sweeps = lesson.whole("sweeps");
  settings.slope.steps = lesson.whole("steps");
  settings.slippery = std::min(lesson.real("mu"), lesson.real("mu-rough"));
  settings.rough = std::max(lesson.real("mu"), lesson.real("mu-rough"));
  settings.mass = lesson.real("mass");
  return settings;
}

std::string verdict(const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  if (law.acceleration == 0) return "holds";
  return "slides with " + fixed(law.acceleration, 3) + " m/s²";
}

void tell_law(Lesson& lesson, const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  lesson.print(fmt::format("  μ = {}, {} kg: λ_n = {} N, needed {} N, limit {} N: {}",
                           fixed(slide.block.friction, 2), significant(slide.block.mass, 3),
                           fixed(law.load, 3), fixed(law.needed, 3), fixed(law.limit, 3), verdict(slide)));
}

void tell_scene(Lesson& lesson, const Study& study) {
  const Slope& slope = study.settings.slope;
  lesson.print(
      fmt::format("Scene: unit boxes on a slope of {}°, gravity {} m/s², Δt {} s, {} sweeps, {} steps",
                  significant(slope.angle * 180 / pi), significant(slope.gravity), significant(slope.dt),
                  slope.sweeps, slope.steps));
  tell_law(lesson, study.slippery);
  tell_law(lesson, study.rough);
}

/// The first step of the slippery block: how the bounds of the tangent rows move with the normal rows.
void tell_sweeps(Lesson& lesson, const Study& study) {
  lesson.print(fmt::format("First step, μ = {}, cold start; forces in N", fixed(study.settings.slippery, 2)));
  lesson.print("sweep    upper: λ_n    ± μ λ_n      λ_t    lower: λ_n    ± μ λ_n      λ_t");
  const double mu = study.settings.slippery;
  const double dt = study.settings.slope.dt;
  for (const SweepRecord& record : study.slippery.first_step) {
    std::string line = fmt::format("{:5}", record.sweep);
    for (std::size_t point = 0; 2 * point + 1 < record.impulse.size(); ++point) {
      const double load = record.impulse[2 * point] / dt;
      line += fmt::format("    {:>10} {:>10} {:>8}", fixed(load, 3), fixed(mu * load, 3),
                          fixed(record.impulse[2 * point + 1] / dt, 3));
    }
    const int sweep = record.sweep;
    const bool shown = sweep == 0 || sweep == 1 || sweep == 2 || sweep == 5 || sweep == 10;
    if (shown || sweep == study.settings.slope.sweeps) {
      lesson.print(line);
    } else {
      lesson.detail(line);
    }
  }
}

void tell_run(Lesson& lesson, const Study& study) {
  const Slide& slide = study.slippery;
  lesson.print(fmt::format("Speed down the slope (m/s)   t (s)     exact     Cairn{}",
                           slide.box2d_speed.empty() ? "" : "     Box2D"));
  const double acceleration = coulomb(slide.slope, slide.block).acceleration;
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const auto k = static_cast<std::size_t>(slide.slope.steps * quarter / 4);
    std::string line = fmt::format("                         {:>9} {:>9} {:>9}", fixed(slide.time[k], 2),
                                   fixed(acceleration * slide.time[k], 4), fixed(slide.speed[k], 4));
    if (!slide.box2d_speed.empty()) line += fmt::format(" {:>9}", fixed(slide.box2d_speed[k], 4));
    lesson.print(line);
  }
  if (slide.box2d_speed.empty())
    lesson.print("This build has no Box2D: Cairn is shown alone, and nothing is compared.");
  for (const Threshold& threshold : study.thresholds) {
    std::string line =
        fmt::format("Slides above: μ = {}: atan μ = {}°, Cairn {}°", fixed(threshold.friction, 2),
                    fixed(threshold.formula, 3), fixed(threshold.cairn, 3));
    if (has_box2d()) line += fmt::format(", Box2D {}°", fixed(threshold.box2d, 3));
    lesson.print(line);
  }
}

/// The acceleration in the second half of a run, when the cold start is forgotten.
double late_acceleration(const Slide& slide) {
  const std::size_t last = slide.speed.size() - 1;
  return (slide.speed[last] - slide.speed[last / 2]) / (slide.time[last] - slide.time[last / 2]);
}

void check_motion(Lesson& lesson, const Study& study) {
  const Slope& slope = study.settings.slope;
  for (const Slide* slide : {&study.slippery, &study.rough}) {
    const double formula = coulomb(slope, slide->block).acceleration;
    const double late = slide->time.back() / 2;
    // v_k = v_(k-1) + dt a: two speeds, each with the rounding of all steps, over half of the time.
    const double tolerance = 2 * rounding(slope, std::abs(slide->speed.back())) / late;
    lesson.check_equal(
        fmt::format("μ = {}: a = max(0, g (sin θ − μ cos θ)) (m/s²)", fixed(slide->block.friction, 2)),
        late_acceleration(*slide), formula, tolerance);
  }
  if (coulomb(slope, study.rough.block).acceleration > 0) return;
  // Only the sweeps that the first steps leave undone can move a block that holds; each step repairs the
  // last.
  const double crept = 4 * slope.dt * unfinished(slope) + rounding(slope, 0) * study.rough.time.back();
  lesson.check_small("the block that holds does not creep (m)", study.rough.way.back(), crept);
}

void check_bounds(Lesson& lesson, const Study& study) {
  const Slope& slope = study.settings.slope;
  const double ulp = std::numeric_limits<double>::epsilon();
  const double cone = std::max({study.slippery.worst_cone, study.rough.worst_cone, study.heavy.worst_cone});
  const double limit =
      std::max(1.0, study.settings.mass) * slope.gravity;  // [N] the weight bounds every force
  lesson.check_small("|λ_t| − μ λ_n of every row in every step is never above 0 (N)", std::max(0.0, cone),
                     4 * ulp * limit);
  const double power =
      std::max({study.slippery.largest_power, study.rough.largest_power, study.heavy.largest_power});
  lesson.check_small("friction never drives: its largest power is not above 0 (W)", std::max(0.0, power),
                     limit * (unfinished(slope) + rounding(slope, 0)));
}

void check_mass(Lesson& lesson, const Study& study) {
  double difference = 0;
  for (std::size_t k = 0; k < study.rough.speed.size(); ++k) {
    difference = std::max(difference, std::abs(study.rough.speed[k] - study.heavy.speed[k]));
  }
  lesson.check_small(fmt::format("{} kg move like 1 kg: largest difference of speed (m/s)",
                                 significant(study.settings.mass)),
                     difference, 2 * rounding(study.settings.slope, std::abs(study.rough.speed.back())));
}

void check_thresholds(Lesson& lesson, const Study& study) {
  for (const Threshold& threshold : study.thresholds) {
    const double blind = blind_angle(study.settings.slope, threshold.friction);
    const std::string mu = fixed(threshold.friction, 2);
    lesson.check_equal(fmt::format("Cairn slides above atan {} (degrees)", mu), threshold.cairn,
                       threshold.formula, blind);
    // Box2D first lifts the block out of the skins and computes in float: half a degree is generous to both.
    if (has_box2d()) {
      lesson.check_equal(fmt::format("Box2D slides above atan {} (degrees)", mu), threshold.box2d,
                         threshold.formula, std::max(0.5, blind));
    }
  }
}

CsvTable table_of(const Study& study) {
  CsvTable table = {.header = {"mu", "mass", "step", "t", "speed", "way", "speed_exact", "speed_box2d"}};
  for (const Slide* slide : {&study.slippery, &study.rough, &study.heavy}) {
    const double acceleration = coulomb(slide->slope, slide->block).acceleration;
    for (std::size_t k = 0; k < slide->time.size(); ++k) {
      std::vector<CsvCell> row;
      row.emplace_back(slide->block.friction);
      row.emplace_back(slide->block.mass);
      row.emplace_back(static_cast<long long>(k));
      for (const double number :
           {slide->time[k], slide->speed[k], slide->way[k], acceleration * slide->time[k]}) {
        row.emplace_back(number);
      }
      if (slide->box2d_speed.empty()) {
        row.emplace_back(std::string());
      } else {
        row.emplace_back(slide->box2d_speed[k]);
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

void run(Lesson& lesson) {
  const Study study = make_study(settings_of(lesson));
  tell_scene(lesson, study);
  lesson.predict();
  tell_sweeps(lesson, study);
  tell_run(lesson, study);
  tell_law(lesson, study.heavy);
  // The answer as a number: 1 for "it slides", 0 for "it holds".
  const double slides = coulomb(study.heavy.slope, study.heavy.block).acceleration > 0 ? 1 : 0;
  lesson.answer({slides}, 0,
                "0 = it holds, 1 = it slides. Needed and limit both grow with the mass; tan θ ≤ μ has none.");
  check_motion(lesson, study);
  check_bounds(lesson, study);
  check_mass(lesson, study);
  check_thresholds(lesson, study);
  lesson.data(table_of(study));
  lesson.fingerprint(study.slippery.frames.back());
  lesson.film(pictures(study, info().question));
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
