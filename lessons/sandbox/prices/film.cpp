// cairn_price_film THEME FILE SCENES TIMES: six scenes at a tenth of the default's work, at the default's and
// at ten times it, side by side as a short animated PNG.
// cairn_price_film times TIMES SCENES: measures the times that are written into it, anew.
// SCENES: the folder of those that do not come with Cairn. TIMES: a file, so that the film is the same
// wherever it is made.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_film.hpp"
#include "render/draw.hpp"
#include "render/lint.hpp"
#include "render/sequence.hpp"
#include <cairn/measure/whole_file.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/build_info.hpp>

namespace {

using namespace cairn;
using namespace cairn::sandbox;
using render::Rect;

constexpr int width = 1280, height = 764, frames = 10;
constexpr double seconds = 3, frames_per_second = frames / seconds;
constexpr int turns = 5;  // of times, whose median counts
constexpr double title_height = 24, caption_height = 52, block_gap = 12, cell_gap = 6, caption_type = 12;

/// A setting that costs about the price that it is shown for.
struct PricedSetting {
  const char* solver = "";
  int sweeps = 0;
  int substeps = 1;
};

struct PricedScene {
  const char* kind = "";
  const char* name = "";  // of a scene that comes with Cairn, or of a file in SCENES
  PricedSetting tenth = {};
  PricedSetting tenfold = {};
};

/// A tenth buys the setting with the smallest error of sweeps and systems in 1, 2 and 4 substeps.
const PricedScene priced_scenes[] = {
    {"100 kg on five boxes of 1 kg", "stack-5-100", {"si", 1, 1}, {"newton", 20, 40}},
    {"a bridge of 12 planks", "bridge", {"newton", 4, 1}, {"newton", 20, 40}},
    {"150 stones, poured", "heap.toml", {"accelerated", 8, 1}, {"wide", 50, 16}},
    {"a bob of a hundred links", "chain-bob", {"block", 2, 4}, {"newton", 20, 42}},
    {"a ball strikes a wall", "wrecking-ball", {"accelerated", 8, 4}, {"newton", 20, 80}},
    {"a figure falls onto steps", "ragdoll", {"accelerated", 24, 2}, {"newton", 20, 96}}};

/// A scene, and its runs from the cheapest to the dearest; the default's is the second.
struct PricedRuns {
  std::string kind = {};
  std::string name = {};
  SceneEntry scene = {};
  List<SceneRun> runs = {};
};

PricedRuns runs_of(const PricedScene& priced, const std::filesystem::path& folder) {
  const std::string name = priced.name;
  PricedRuns all{.kind = priced.kind,
                 .name = name,
                 .scene = scene_entry(names_scene_file(name) ? (folder / name).string() : name)};
  List<Setting> settings(3, all.scene.setting);
  const PricedSetting* const given[] = {&priced.tenth, nullptr, &priced.tenfold};
  for (int i = 0; i < 3; ++i) {
    if (given[i] == nullptr) continue;
    settings[i].solver = given[i]->solver;
    settings[i].sweeps.iterations = given[i]->sweeps;
    settings[i].substeps = given[i]->substeps;
  }
  const RunWish wish{.seconds = seconds, .frames_per_second = frames_per_second};
  for (const Setting& setting : settings)
    all.runs.push_back(run_scene(all.scene, setting, wish, {.quiet = true}));
  return all;
}

/// [ms a frame of 1/60 s] of each run, the median of some turns, and where they were measured.
nlohmann::ordered_json measured_times(const std::filesystem::path& folder) {
  nlohmann::ordered_json times;
  for (const auto& [name, value] : build_entries()) {
    if (name == "cpu") times["cpu"] = value;
  }
  for (const PricedScene& priced : priced_scenes) {
    std::array<List<double>, 3> all;
    for (int turn = 0; turn < turns; ++turn) {
      const PricedRuns priced_runs = runs_of(priced, folder);
      for (int i = 0; i < 3; ++i) all[i].push_back(1e3 * priced_runs.runs[i].result.frame());
    }
    for (List<double>& one : all) {
      std::sort(one.begin(), one.end());
      times["ms"][priced.name].push_back(std::stod(fmt::format("{:.2g}", one[turns / 2])));
    }
  }
  return times;
}

/// "18", "0.067"; 0 below a hundredth.
std::string millimetres(double metres) {
  const double value = 1e3 * metres;
  return value < 0.01 ? "0" : fmt::format("{:.{}g}", value, value < 100 ? 2 : 4);
}

/// "overlap 3.2, joints 12 mm": what the scene limits, the worst of the run.
std::string errors_of(const PricedRuns& all, const SceneRun& run) {
  List<std::string> errors;
  if (all.scene.expectations.penetration)
    errors.push_back("overlap " + millimetres(run.result.worst_penetration));
  if (all.scene.expectations.drift) errors.push_back("joints " + millimetres(run.result.worst_drift));
  return joined(errors, ", ") + " mm";
}

class Film {
 public:
  /// `times` as measured_times() gives them.
  Film(const std::string& theme, const std::filesystem::path& folder, const nlohmann::ordered_json& times)
      : page_(width, height, theme == "dark" ? render::dark_theme() : render::light_theme()), times_(times) {
    for (const PricedScene& priced : priced_scenes) scenes_.push_back(runs_of(priced, folder));
  }

  void write(const std::filesystem::path& file) {
    render::ApngWriter film(file, frames, frames_per_second);
    // The end comes first: a viewer without animation shows it.
    for (int i = 0; i < frames; ++i) film.add(draw((i + frames - 1) % frames));
    film.finish();
    for (const std::string& finding : render::lint(page_))
      std::fprintf(stderr, "cairn_price_film: %s\n", finding.c_str());
  }

 private:
  render::Image draw(int frame) {
    page_.begin({.title = "Six scenes at a tenth of the default's work, at the default's, at ten times it",
                 .state = fmt::format("t = {:.2f} s", (frame + 1) / frames_per_second)});
    const List<Rect> bands = render::rows(page_.area(), {1, 1, 1}, block_gap);
    for (int i = 0; i < scenes_.size(); ++i)
      draw_scene(scenes_[i], frame, render::columns(bands[i / 2], {1, 1}, page_.sizes().gap)[i % 2]);
    const std::string cpu = times_.at("cpu");
    const double margin = page_.sizes().margin;
    page_.canvas().text({margin, height - 27.0},
                        "×: counted work beside the default's. x20 in 4 steps: at most so many sweeps or "
                        "systems in each of so many substeps. Processor time of a frame of 1/60 s,",
                        caption(false));
    page_.canvas().text({margin, height - 11.0},
                        "measured once (" + cpu +
                            "). Errors: the worst of 3 s, 0 below 0.01 mm; bold: the scene expects less.",
                        caption(false));
    return page_.canvas().read();
  }

  render::TextStyle caption(bool is_bold) const {
    return {.size = caption_type,
            .color = is_bold ? page_.theme().text : page_.theme().secondary_text,
            .bold = is_bold};
  }

  void draw_scene(const PricedRuns& all, int frame, const Rect& rect) {
    render::TextStyle title = page_.label();
    title.bold = true;
    page_.canvas().text({rect.x, rect.y + 16}, all.kind, title);
    const Rect below = {rect.x, rect.y + title_height, rect.width, rect.height - title_height};
    const List<Rect> cells = render::columns(below, {1, 1, 1}, cell_gap);
    for (int i = 0; i < all.runs.size(); ++i) draw_run(all, i, frame, cells[i]);
  }

  void draw_run(const PricedRuns& all, int number, int frame, const Rect& rect) {
    const SceneRun& run = all.runs[number];
    const Rect world = {rect.x, rect.y, rect.width, rect.height - caption_height};
    page_.canvas().rect(
        {world.x + 0.5, world.y + 0.5, world.width - 1, world.height - 1},
        {.fill = page_.theme().panel, .outline = page_.theme().frame_line, .outline_width = 1});
    const Rect inside = render::inset(world, 1);
    Snapshot snapshot = run.frames[std::min(frame + 1, run.frames.size() - 1)];
    snapshot.joints.clear();  // their marks would hide the bodies, which are small
    render::draw_world(page_, render::fit(inside, view_of(all.scene, all.runs).box), snapshot,
                       {.numbers = false, .contacts = false, .penetration = false});
    const double work =
        static_cast<double>(run.result.row_updates) / static_cast<double>(all.runs[1].result.row_updates);
    const double base = world.y + world.height;
    const double time = times_.at("ms").at(all.name).at(number);
    const std::string price =
        fmt::format("work ×{:.{}g}, {:.2g} ms a frame", work, work < 1 ? 1 : 2, time);
    page_.canvas().text({rect.x, base + 14}, price, caption(false));
    const int steps = run.setting.substeps;
    const std::string how = fmt::format("{} x{} in {} step{}", run.setting.solver,
                                        run.setting.sweeps.iterations, steps, steps == 1 ? "" : "s");
    page_.canvas().text({rect.x, base + 30}, how, caption(false));
    page_.canvas().text({rect.x, base + 46}, errors_of(all, run), caption(!run.judgement.meets()));
  }

  render::Page page_;
  nlohmann::ordered_json times_;
  List<PricedRuns> scenes_;
};

nlohmann::ordered_json read_times(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return nlohmann::ordered_json::parse(in);
}

}  // namespace

int main(int count, char** words) {
  const bool measures = count == 4 && words[1] == std::string("times");
  if (!measures && count != 5) {
    std::fprintf(stderr, "cairn_price_film THEME FILE SCENES TIMES\ncairn_price_film times TIMES SCENES\n");
    return 2;
  }
  try {
    if (measures)
      write_whole_file(words[2], measured_times(words[3]).dump(1) + "\n");
    else
      Film(words[1], words[3], read_times(words[4])).write(words[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cairn_price_film: %s\n", error.what());
    return 3;
  }
}
