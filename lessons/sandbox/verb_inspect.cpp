// cairn inspect: one step, row by row.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_film.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/step_view.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/scenes/default_setting.hpp>
#include <cairn/solvers/system_matrix.hpp>

namespace cairn::sandbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_columns = 8;       // of rows in the table of sweeps
constexpr int most_matrix_rows = 12;  // of A as text
constexpr int most_json_matrix_rows = 400;

/// Rounding's rest of a zero is 0.
std::string short_text(double value, int digits = 4) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return std::abs(value) < 1e-15 ? "0" : fmt::format("{:.{}g}", value, digits);
}

std::string method_text(ReferenceMethod method) {
  switch (method) {
    case ReferenceMethod::enumeration:
      return "all modes tried";
    case ReferenceMethod::lemke:
      return "Lemke's method";
    case ReferenceMethod::newton:
      return "Newton's method";
    case ReferenceMethod::none:
      break;
  }
  return "no answer was found; this is the best there was";
}

std::string uniqueness_text(Uniqueness verdict) {
  if (verdict == Uniqueness::unique) return "one";
  return verdict == Uniqueness::not_unique ? "more than one" : "perhaps one";
}

std::string row_line(const List<std::string>& cells, int name_width) {
  // Negative: right-aligned.
  const int widths[] = {-3, 14, -name_width, -name_width, -9, -9, -9, -9, -10, -10, -10};
  std::string line;
  for (int i = 0; i < cells.size(); ++i) {
    line += (i == 0 ? "" : " ") + (widths[i] < 0 ? fmt::format("{:>{}}", cells[i], -widths[i])
                                                 : fmt::format("{:<{}}", cells[i], widths[i]));
  }
  return line;
}

void print_rows(const StepView& view, int most, Console& console) {
  int name_width = 6;
  const int shown = std::min(most, view.rows.size());
  for (int i = 0; i < shown; ++i) {
    for (const std::string& name : {view.rows[i].a, view.rows[i].b})
      name_width = std::max(name_width, display_width(name));
  }
  const auto line = [&](const List<std::string>& cells) { console.result(row_line(cells, name_width)); };
  line({"row", "kind", "a", "b", "j v", "bias", "lower", "upper", "impulse", "exact", "still asks"});
  line({"", "", "", "", "m/s", "m/s", "N s", "N s", "N s", "N s", "N s"});
  for (int i = 0; i < shown; ++i) {
    const StepRow& row = view.rows[i];
    line({std::to_string(i + 1), row.kind, row.a, row.b, short_text(row.velocity, 3), short_text(row.bias, 3),
          short_text(row.lower, 3), short_text(row.upper, 3), short_text(row.impulse),
          row.exact ? short_text(*row.exact) : "-", short_text(row.correction)});
  }
  if (most < view.rows.size())
    console.result(fmt::format("    and {} more; --rows shows them", view.rows.size() - most));
}

void print_matrix(const StepView& view, Console& console) {
  if (view.given.row_count() > most_matrix_rows) {
    console.result(console.spelt(
        fmt::format("A has {0} x {0} entries: --picture FILE draws it, --json has all of it up to {1} rows",
                    view.rows.size(), most_json_matrix_rows)));
    return;
  }
  console.result(console.spelt("A = J M⁻¹ Jᵀ (1/kg; softness on the diagonal)"));
  const Matrix<double> A = system_matrices(view.given).A;
  const double rounding = 1e-13 * A.cwiseAbs().maxCoeff();
  for (Eigen::Index row = 0; row < A.rows(); ++row) {
    std::string line;
    for (Eigen::Index column = 0; column < A.cols(); ++column) {
      const double value = A(row, column);
      line += fmt::format(" {:>8}", std::abs(value) <= rounding ? "." : fmt::format("{:.4g}", value));
    }
    console.result(line);
  }
}

void print_sweeps(const StepView& view, Console& console) {
  const int columns = std::min(most_columns, view.rows.size());
  std::string heading = fmt::format("{:>6} {:>9} {:>10}", "sweep", "R_E", "r_inf m/s");
  for (int i = 0; i < columns; ++i)
    heading += fmt::format(" {:>9}", console.spelt(fmt::format("λ_{}", i + 1)));
  console.result(console.spelt("what each sweep leaves, and its impulses λ in N s"));
  console.result(heading);
  for (const int k : shown_sweeps(view.sweeps.size())) {
    const SweepRecord& sweep = view.sweeps[k];
    std::string line =
        fmt::format("{:>6} {:>9.2e} {:>10.2e}", sweep.sweep, sweep.residual_energy, sweep.residual_velocity);
    for (int i = 0; i < columns; ++i) line += fmt::format(" {:>9}", short_text(sweep.impulse[i]));
    console.result(line);
  }
  if (!view.reference) return;
  std::string line = fmt::format("{:>6} {:>9.2e} {:>10}", "exact", view.reference->report.residual, "");
  for (int i = 0; i < columns; ++i) line += fmt::format(" {:>9}", short_text(view.rows[i].exact.value_or(0)));
  console.result(line);
}

void print_reference(const StepView& view, Console& console) {
  if (!view.reference) {
    console.result(console.spelt("the reference: " + view.no_reference));
    return;
  }
  const StepReference& reference = *view.reference;
  console.result(console.spelt(fmt::format("the reference ({}): {} answer in velocities, {} in impulses",
                                           method_text(reference.report.method),
                                           uniqueness_text(reference.report.velocity.verdict),
                                           uniqueness_text(reference.report.impulse.verdict))));
  console.result(console.spelt(
      fmt::format("from it: velocities {:.3g} m/s or rad/s, impulses {:.3g} N s, {:.3g} % of the energy norm "
                  "of the change",
                  reference.velocity_gap, reference.impulse_gap, 100 * reference.energy_error)));
}

Json rows_json(const StepView& view) {
  Json rows = Json::array();
  for (const StepRow& row : view.rows) {
    rows.push_back({{"kind", row.kind},
                    {"a", row.a},
                    {"b", row.b},
                    {"jv", row.velocity},
                    {"bias", row.bias},
                    {"lower_Ns", row.lower},
                    {"upper_Ns", row.upper},
                    {"impulse_Ns", row.impulse},
                    {"exact_Ns", row.exact ? Json(*row.exact) : Json(nullptr)},
                    {"still_asks_Ns", row.correction}});
  }
  return rows;
}

Json step_json(const SceneEntry& scene, const StepView& view) {
  Json sweeps = Json::array();
  for (const SweepRecord& sweep : view.sweeps) {
    sweeps.push_back({{"sweep", sweep.sweep},
                      {"R_E", sweep.residual_energy},
                      {"r_inf", sweep.residual_velocity},
                      {"impulse_Ns", sweep.impulse}});
  }
  Json reference = nullptr;
  if (view.reference) {
    reference = {{"method", method_text(view.reference->report.method)},
                 {"residual", view.reference->report.residual},
                 {"velocities", uniqueness_text(view.reference->report.velocity.verdict)},
                 {"impulses", uniqueness_text(view.reference->report.impulse.verdict)},
                 {"velocity_gap", view.reference->velocity_gap},
                 {"impulse_gap_Ns", view.reference->impulse_gap},
                 {"energy_error", view.reference->energy_error}};
  }
  Json A = nullptr;
  if (view.given.row_count() <= most_json_matrix_rows) {
    A = Json::array();
    const Matrix<double> matrix = system_matrices(view.given).A;
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      const Vector<double> line = matrix.row(row).transpose();
      A.push_back(List<double>(line.data(), line.data() + line.size()));
    }
  }
  return {{"scene", scene.name},     {"step", view.step},
          {"time_s", view.time},     {"setting", setting_text(view.setting)},
          {"rows", rows_json(view)}, {"A", A},
          {"sweeps", sweeps},        {"reference", reference}};
}

Setting inspected_setting(const Words& words, const SceneEntry& scene) {
  Setting setting = setting_of(words, scene);
  if (!words.has("solver") && setting.solver == default_setting(scene.make()).setting.solver) {
    setting.solver = "si";  // sweeps are to be seen
    if (!words.has("sweeps")) setting.sweeps.iterations = 10;
    if (!words.has("substeps")) setting.substeps = 1;
  }
  if (setting.solver == "box2d")
    words.refuse("solver", "one of Cairn's own: the rows of Box2D cannot be seen", "box2d");
  if (words.has("scalar") && setting.scalar != Precision::double_precision)
    words.refuse("scalar", "double", *words.text("scalar"));
  return setting;
}

int run_inspect(const Words& words, Console& console) {
  const SceneEntry scene = scene_of(words, words.places.front());
  const Setting setting = inspected_setting(words, scene);
  const int step = words.whole("step", 30, 1, 10000000);
  const int most = words.whole("rows", 24, 0, 1000000);
  const FilmLook look = look_of(words, "medium");
  const StepView view = view_step(scene, setting, step);
  if (words.has("json")) {
    fmt::print("{}\n", step_json(scene, view).dump(1));
  } else {
    console.result(
        console.spelt(fmt::format("{}, step {}, t = {:.4g} s: {} bodies, {} rows", scene.name, step,
                                  view.time, view.given.body_count(), view.given.row_count())));
    console.result(
        console.spelt("  " + setting_text(setting) + (setting.substeps > 1 ? "; the last substep" : "")));
    print_rows(view, most, console);
    if (!view.rows.empty()) {
      print_matrix(view, console);
      print_sweeps(view, console);
      print_reference(view, console);
    }
  }
  if (const std::optional<std::string> path = words.text("picture")) {
    const render::Theme theme = look.dark ? render::dark_theme() : render::light_theme();
    render::write_png(*path, draw_step(view, scene.title, theme, look.width, look.height));
    console.narrate("written: " + *path);
  }
  return all_well;
}

List<Flag> inspect_flags() {
  List<Flag> flags = {{"step", "N", "which step, from 1 (30)"},
                      {"rows", "N", "so many of them in the table (24)"},
                      {"picture", "FILE", "A as a heat map, beside the residual of every sweep"}};
  for (const Flag& flag : joined_flags(setting_flags(), look_flags())) {
    if (flag.name != "show") flags.push_back(flag);
  }
  return flags;
}

}  // namespace

Verb inspect_verb() {
  return {
      .name = "inspect",
      .places = "SCENE",
      .fewest_places = 1,
      .most_places = 1,
      .summary = "one step: its rows, A, impulses sweep by sweep, and the exact answer",
      .idea =
          "Steps the scene in double as `cairn run` does, and takes step N apart: each row with its bodies, "
          "the velocity that it had, the velocity that it wants, its bounds and its impulse; A = J M^-1 "
          "J^T; what each sweep left (R_E is 1 where nothing was done and 0 at the solution); and how far "
          "the answer is from that of the reference solver.",
      .flags = inspect_flags(),
      .examples = {"inspect stack --step 1 --sweeps 10", "inspect pulley",
                   "inspect arch --picture arch-A.png"},
      .run = run_inspect};
}

}  // namespace cairn::sandbox
