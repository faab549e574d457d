// Lesson 11. What is printed, and what is checked.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

std::string verdict(const Slide& slide) {
  const Coulomb law = coulomb(slide.slope, slide.block);
  if (law.acceleration == 0) return "holds";
  return "slides with " + fixed(law.acceleration, 3) + " m/s²";
}

/// The acceleration in the second half of a run, when the cold start is forgotten.
double late_acceleration(const Slide& slide) {
  const int last = slide.speed.size() - 1;
  return (slide.speed[last] - slide.speed[last / 2]) / (slide.time[last] - slide.time[last / 2]);
}

/// The loop of lesson.cpp against the library's solver. Both do the same in the same order.
void check_by_hand(Lesson& lesson, const Study& study) {
  const double dt = study.settings.slope.dt;
  double gap = 0;
  for (int sweep = 0; sweep < study.by_hand.size(); ++sweep) {
    const PerRow<double>& impulse = study.slippery.first_step[sweep].impulse;
    for (int i = 0; i < impulse.size(); ++i)
      gap = std::max(gap, std::abs(impulse[i] - study.by_hand[sweep][i]) / dt);
  }
  // Four rows a sweep, each rounded a few times, of forces below the weight of 1 kg.
  const double updates = 4.0 * study.by_hand.size();
  lesson.check_small("the first step, row by row by hand: the λ of the library's solver (N)", gap,
                     4 * epsilon * updates * study.settings.slope.gravity);
}

void check_motion(Lesson& lesson, const Study& study) {
  const Slope& slope = study.settings.slope;
  for (const Slide* slide : {&study.slippery, &study.rough}) {
    const double formula = coulomb(slope, slide->block).acceleration;
    const double late = slide->time.back() / 2;
    // v_k = v_(k-1) + dt a: two speeds, each with the rounding of all steps, over half of the time.
    const double tolerance = 2 * rounding(slope, std::abs(slide->speed.back())) / late;
    lesson.check_equal(
        fmt::format("μ = {}: a = max(0, g (sin α − μ cos α)) (m/s²)", fixed(slide->block.friction, 2)),
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
  const double cone = std::max({study.slippery.worst_cone, study.rough.worst_cone, study.heavy.worst_cone});
  const double limit =
      std::max(1.0, study.settings.mass) * slope.gravity;  // [N] the weight bounds every force
  lesson.check_small("|λ_t| − μ λ_n of every row in every step is never above 0 (N)", std::max(0.0, cone),
                     4 * epsilon * limit);
  const double power =
      std::max({study.slippery.largest_power, study.rough.largest_power, study.heavy.largest_power});
  lesson.check_small("friction never drives: its largest power is not above 0 (W)", std::max(0.0, power),
                     limit * (unfinished(slope) + rounding(slope, 0)));
}

/// Friction acts half a side below the centre, as far as each corner is beside it: the moments of the three
/// forces balance.
void check_corners(Lesson& lesson, const Study& study) {
  const Slope& slope = study.settings.slope;
  const Coulomb law = coulomb(slope, study.slippery.block);
  // A velocity that the sweeps have left, as a force on the block of 1 kg.
  const double left = 2 * (unfinished(slope) + rounding(slope, 0)) / slope.dt;
  lesson.check_equal("the lower corner: λ_n = (load + friction)/2 (N)", first_force(study, lower_normal),
                     (law.load + law.given()) / 2, left);
  if (law.acceleration == 0) return;
  lesson.check_equal("and λ_t = μ λ_n, uphill (N)", -first_force(study, lower_tangent),
                     study.settings.slippery * (law.load + law.limit) / 2, left);
}

void check_mass(Lesson& lesson, const Study& study) {
  double difference = 0;
  for (int k = 0; k < study.rough.speed.size(); ++k) {
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

}  // namespace

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

void tell_sweeps(Lesson& lesson, const Study& study) {
  const Slope& slope = study.settings.slope;
  const double mu = study.settings.slippery;
  lesson.print(fmt::format("First step, μ = {}, cold start; forces in N", fixed(mu, 2)));
  lesson.print("sweep    upper: λ_n    ± μ λ_n      λ_t    lower: λ_n    ± μ λ_n      λ_t");
  for (int sweep = 0; sweep < study.by_hand.size(); ++sweep) {
    const PerRow<double>& impulse = study.by_hand[sweep];
    std::string line = fmt::format("{:5}", sweep);
    for (int point = 0; 2 * point + 1 < impulse.size(); ++point) {
      const double load = impulse[2 * point] / slope.dt;
      line += fmt::format("    {:>10} {:>10} {:>8}", fixed(load, 3), fixed(mu * load, 3),
                          fixed(impulse[2 * point + 1] / slope.dt, 3));
    }
    const bool shown = sweep <= 5 || sweep == 10 || sweep == slope.sweeps;
    lesson.print_if(shown, line);
  }
}

void tell_run(Lesson& lesson, const Study& study) {
  const Slide& slide = study.slippery;
  lesson.print(fmt::format("Speed down the slope (m/s)   t (s)     exact     Cairn{}",
                           slide.box2d_speed.empty() ? "" : "     Box2D"));
  const double acceleration = coulomb(slide.slope, slide.block).acceleration;
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const int k = slide.slope.steps * quarter / 4;
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

void check_study(Lesson& lesson, const Study& study) {
  check_by_hand(lesson, study);
  check_motion(lesson, study);
  check_bounds(lesson, study);
  check_corners(lesson, study);
  check_mass(lesson, study);
  check_thresholds(lesson, study);
}

CsvTable table_of(const Study& study) {
  CsvTable table = {.header = {"mu", "mass", "step", "t", "speed", "way", "speed_exact", "speed_box2d"}};
  for (const Slide* slide : {&study.slippery, &study.rough, &study.heavy}) {
    const double acceleration = coulomb(slide->slope, slide->block).acceleration;
    for (int k = 0; k < slide->time.size(); ++k) {
      const CsvCell box2d = slide->box2d_speed.empty() ? CsvCell("") : slide->box2d_speed[k];
      table.rows.push_back({slide->block.friction, slide->block.mass, k, slide->time[k], slide->speed[k],
                            slide->way[k], acceleration * slide->time[k], box2d});
    }
  }
  return table;
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

}  // namespace cairn::friction
