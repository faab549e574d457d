// cairn_price_film THEME FILE SCENES: six scenes at a tenth of the default's work, at the default's and at
// ten times it, side by side as a short animated PNG. SCENES: the folder of those that do not come with
// Cairn.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_film.hpp"
#include "render/draw.hpp"
#include "render/lint.hpp"
#include "render/sequence.hpp"
#include <cairn/scenes/scene_list.hpp>

namespace {

using namespace cairn;
using namespace cairn::sandbox;
using render::Rect;

constexpr int width = 1280, height = 700, frames = 10;
constexpr double seconds = 3, frames_per_second = frames / seconds;
constexpr double title_height = 24, caption_height = 36, block_gap = 12, cell_gap = 6, caption_type = 12;

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
  SceneEntry scene = {};
  List<SceneRun> runs = {};
};

PricedRuns runs_of(const PricedScene& priced, const std::filesystem::path& folder) {
  const std::string name = priced.name;
  PricedRuns all{.kind = priced.kind,
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
  Film(const std::string& theme, const std::filesystem::path& folder)
      : page_(width, height, theme == "dark" ? render::dark_theme() : render::light_theme()) {
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
    page_.canvas().text({page_.sizes().margin, height - 11.0},
                        "×: counted work beside the default's. x20 in 4 steps: at most so many sweeps or "
                        "systems in each of so "
                        "many substeps. The worst of 3 s, 0 below 0.01 mm; bold: the scene expects less.",
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
    for (int i = 0; i < all.runs.size(); ++i) draw_run(all, all.runs[i], frame, cells[i]);
  }

  void draw_run(const PricedRuns& all, const SceneRun& run, int frame, const Rect& rect) {
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
    page_.canvas().text({rect.x, base + 14},
                        fmt::format("×{:.{}g} {} x{} in {} step{}", work, work < 1 ? 1 : 2,
                                    run.setting.solver, run.setting.sweeps.iterations, run.setting.substeps,
                                    run.setting.substeps == 1 ? "" : "s"),
                        caption(false));
    page_.canvas().text({rect.x, base + 30}, errors_of(all, run),
                        caption(!run.judgement.meets()));
  }

  render::Page page_;
  List<PricedRuns> scenes_;
};

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fprintf(stderr, "cairn_price_film THEME FILE SCENES\n");
    return 2;
  }
  try {
    Film(words[1], words[3]).write(words[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cairn_price_film: %s\n", error.what());
    return 3;
  }
}
