// Floor 9. Scenes, settings and runs of the map, and what they say.
#include <cairn/study/tuning/map_study.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/measure/failure.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/jitter.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/study/tuning/recommend_scenes.hpp>
#include <cairn/study/tuning/tuner.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

constexpr double longest_run = 2;      // [s]
constexpr double box_may_move = 0.05;  // [m] of boxes of 1 m

void add_member(List<MapScene>& scenes, const std::string& family, double value, std::function<Scene()> make,
                double stands) {
  scenes.push_back({.family = family,
                    .value = value,
                    .scene = {.name = fmt::format("{} {:g}", family, value),
                              .make = std::move(make),
                              .seconds = longest_run,
                              .stand_distance = stands}});
}

void add_families(List<MapScene>& scenes) {
  for (const double top : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 1e4})
    add_member(
        scenes, "heavy-top", top, [top] { return tower_of_boxes(5, top); }, box_may_move);
  for (const int boxes : {2, 3, 5, 10, 20, 30, 50})
    add_member(
        scenes, "height", boxes, [boxes] { return tower_of_boxes(boxes); }, box_may_move);
  for (const int rows : {2, 3, 5, 8, 12})
    add_member(
        scenes, "pyramid", rows, [rows] { return pyramid_of_boxes(rows); }, box_may_move);
  for (const double bob : {1.0, 10.0, 100.0, 1e3, 1e4})
    add_member(
        scenes, "heavy-bob", bob, [bob] { return chain_with_bob(5, bob, ChainStart::level); }, 0);
  for (const int links : {1, 2, 5, 10, 20, 50})
    add_member(
        scenes, "length", links, [links] { return chain_with_bob(links, 1, ChainStart::level); }, 0);
}

double error_of(const TrialResult& run) { return std::max(run.worst_penetration, run.worst_drift); }

/// How a run of the map goes: what it must not do, and the formula where there is one.
struct MapWatch {
  std::unique_ptr<MotionError> formula = {};
  bool driven = false;
  bool slow = false;

  bool gains(const TrialResult& run) const { return !driven && run.energy_gain > largest_map_gain; }
  double error(const TrialResult& run) const { return formula ? formula->value() : error_of(run); }

  bool is_over(const TrialResult& so_far, const Setting& setting, double seconds) {
    const double work = counted_work(setting.solver, static_cast<double>(so_far.row_updates),
                                     static_cast<double>(so_far.rows));
    slow = so_far.seconds > seconds / 10 && work > most_map_work * so_far.seconds;
    const bool off = !formula && error_of(so_far) > largest_map_error;
    return slow || off || so_far.fell_at || gains(so_far);
  }

  std::string status(const TrialResult& run) const {
    if (run.status != TrialStatus::ok) return status_text(run.status);
    if (run.fell_at) return "fell";
    if (!run.failures.empty()) return "fails";
    if (gains(run)) return "gained";
    if (slow) return "timeout";
    return error(run) <= largest_map_error ? "ok" : "off";
  }
};

/// With four digits, as many as a table of so many rows has room for.
CsvCell short_cell(double value) { return fmt::format("{:.4g}", value); }

List<CsvCell> map_row(const MapScene& entry, const Setting& setting) {
  const TrajectoryScene& scene = entry.scene;
  const Scene as_made = scene.make();
  MapWatch watch{.formula = scene.watch ? scene.watch() : nullptr, .driven = is_driven(as_made)};
  TrialOptions options = trial_options(scene, setting);
  const bool is_whole = watch.formula || !scene.wish.places.empty();
  if (!is_whole) options.seconds = std::min(scene.seconds, longest_run);
  if (watch.formula) options.observer = [&watch](const Snapshot& now) { watch.formula->see(now); };
  options.gives_up = [&](const TrialResult& so_far) {
    return watch.is_over(so_far, setting, options.seconds);
  };
  const TrialResult run = run_trial(nth_start(as_made, scene.stand_distance > 0 ? 1 : 0), setting, options);
  const double seconds = run.seconds > 0 ? run.seconds : 1;
  return {scene.name,
          entry.family,
          short_cell(entry.value),
          setting.solver,
          static_cast<long long>(std::lround(1 / setting.dt)),
          static_cast<long long>(setting.substeps),
          static_cast<long long>(setting.sweeps.iterations),
          stabilization_text(setting.stabilization),
          word_of(setting.scalar),
          watch.status(run),
          short_cell(static_cast<double>(run.rows) / seconds),
          short_cell(static_cast<double>(run.row_updates) / seconds),
          short_cell(watch.error(run))};
}

}  // namespace

const List<MapFamily>& map_families() {
  static const List<MapFamily> families = {
      {"heavy-top", "Five boxes, the top one heavier", "mass of the top box over that of the others"},
      {"height", "A stack of boxes", "boxes"},
      {"pyramid", "A pyramid of boxes", "layers"},
      {"heavy-bob", "A swinging chain of five links, and a bob", "mass of the bob over that of a link"},
      {"length", "A swinging chain", "links"}};
  return families;
}

List<MapScene> map_scenes() {
  List<MapScene> scenes;
  add_families(scenes);
  for (const std::string& name : trajectory_names()) scenes.push_back({.scene = trajectory_scene(name)});
  return scenes;
}

List<Setting> map_settings() {
  SettingGrid grid{.solvers = {"si", "accelerated", "block", "jacobi-split"},
                   .frequencies = {30, 60, 120, 240},
                   .substeps = {1, 4},
                   .sweeps = {1, 3, 10, 30, 100},
                   .policies = {Policy::relaxed, Policy::soft, Policy::split_impulse, Policy::baumgarte},
                   .scalars = {Precision::double_precision, Precision::single_precision}};
  List<Setting> settings = settings_of(grid);
  grid.solvers = {"newton"};
  grid.sweeps = {1, 3, 10};
  const List<Setting> of_newton = settings_of(grid);
  settings.insert(settings.end(), of_newton.begin(), of_newton.end());
  return settings;
}

double counted_work(const std::string& solver, double updates, double rows, std::optional<double> price) {
  const SolverEntry& entry = solver_entry(solver);
  const double weight = price.value_or(entry.work_of_a_sweep) / entry.updates_a_row;
  return weight * updates + work_of_a_step * rows;
}

const List<std::string>& map_header() {
  static const List<std::string> header = {"scene",    "family",    "value",  "solver", "Hz",
                                           "substeps", "sweeps",    "policy", "scalar", "status",
                                           "rows/s",   "updates/s", "error"};
  return header;
}

Study map_study(const List<MapScene>& scenes, const List<Setting>& settings) {
  Study study{.name = "cairn map of settings:", .header = map_header(), .tasks = {}};
  const auto kept = std::make_shared<const List<MapScene>>(scenes);
  for (const MapScene& entry : *kept) {
    study.name += fmt::format(" {} {:x}", entry.scene.name, entry.scene.fingerprint);
    for (const Setting& setting : settings) {
      study.tasks.push_back({.name = entry.scene.name + ", " + setting_text(setting),
                             .run = [kept, &entry, setting] { return map_row(entry, setting); }});
    }
  }
  study.name += fmt::format("; {} settings", settings.size());
  return study;
}

namespace {

/// A number, or infinity where there is none.
double map_number(const CsvTable& table, int row, const char* column) {
  const double number = number_in(table, row, column);
  return std::isnan(number) ? std::numeric_limits<double>::infinity() : number;
}

int map_count(const CsvTable& table, int row, const char* column) {
  const double number = number_in(table, row, column);
  require(number >= 0 && number <= 1e9, "map of settings", column, "a whole number", number);
  return static_cast<int>(number);
}

MapRow map_row_of(const CsvTable& table, int i) {
  MapRow row{.scene = text_in(table, i, "scene"),
             .family = text_in(table, i, "family"),
             .value = map_number(table, i, "value"),
             .solver = text_in(table, i, "solver"),
             .frequency = map_count(table, i, "Hz"),
             .substeps = map_count(table, i, "substeps"),
             .sweeps = map_count(table, i, "sweeps"),
             .policy = text_in(table, i, "policy"),
             .scalar = text_in(table, i, "scalar"),
             .status = text_in(table, i, "status"),
             .rows = map_number(table, i, "rows/s"),
             .updates = map_number(table, i, "updates/s"),
             .error = map_number(table, i, "error")};
  row.work = counted_work(row.solver, row.updates, row.rows);
  return row;
}

}  // namespace

std::string MapRow::setting() const {
  const std::string substepped = substeps > 1 ? fmt::format(" x{}", substeps) : "";
  return fmt::format("{} x{}, {} Hz{}, {}, {}", solver, sweeps, frequency, substepped, policy, scalar);
}

MapTable read_map(const CsvTable& table, const std::string& name) {
  require_columns(table, map_header(), name, "those of the map of settings");
  MapTable map;
  for (int i = 0; i < table.rows.size(); ++i) {
    MapRow row = map_row_of(table, i);
    if (map.scenes.empty() || map.scenes.back().front().scene != row.scene) map.scenes.emplace_back();
    map.scenes.back().push_back(std::move(row));
  }
  for (const List<MapRow>& runs : map.scenes)
    require(runs.size() == map.settings(), name, "settings of " + runs.front().scene,
            fmt::format("{}, as of the first scene", map.settings()), runs.size());
  return map;
}

MapTable priced(MapTable table, const std::string& solver, double price) {
  for (List<MapRow>& runs : table.scenes) {
    for (MapRow& run : runs) {
      if (run.solver == solver) run.work = counted_work(solver, run.updates, run.rows, price);
    }
  }
  return table;
}

const MapRow* cheapest(const List<MapRow>& runs, double goal,
                       const std::function<bool(const MapRow&)>& among) {
  const MapRow* best = nullptr;
  for (const MapRow& run : runs) {
    if (!run.meets(goal) || (among && !among(run))) continue;
    if (best == nullptr || run.work < best->work) best = &run;
  }
  return best;
}

MapChoice best_for_all(const MapTable& table, const List<int>& scenes, double goal,
                       const std::string& solver) {
  List<double> least;
  for (const int scene : scenes) {
    const MapRow* best = cheapest(table.scenes[scene], goal);
    least.push_back(best != nullptr ? best->work : 0);
  }
  MapChoice choice;
  for (int setting = 0; setting < table.settings(); ++setting) {
    if (table.scenes.front()[setting].solver != solver) continue;
    int met = 0;
    double logs = 0;
    for (int i = 0; i < scenes.size(); ++i) {
      const MapRow& run = table.scenes[scenes[i]][setting];
      if (!run.meets(goal)) continue;
      ++met;
      if (least[i] > 0) logs += std::log(run.work / least[i]);
    }
    const double multiple = met > 0 ? std::exp(logs / met) : 1;
    const bool is_better = met > choice.met || (met == choice.met && multiple < choice.multiple);
    if (choice.setting < 0 || is_better) choice = {setting, met, multiple};
  }
  return choice;
}

}  // namespace cairn
