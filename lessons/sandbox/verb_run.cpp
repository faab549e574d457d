// cairn run: a scene, its numbers, and a film of it.
#include <fmt/format.h>

#include <optional>

#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/charts.hpp"
#include "lessons/sandbox/film_files.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/reports.hpp"
#include "lessons/sandbox/run_table.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/whole_file.hpp>

namespace cairn::sandbox {
namespace {

int stopped_run(Console& console, const std::string& what) {
  console.warn(what);
  return stopped;
}

void write_series(const SceneRun& run, int every, const std::string& path, Console& console) {
  const std::string text = series_csv(run.tracks ? run.tracks->table(every) : run.series);
  if (path == "-") {
    fmt::print("{}", text);
    return;
  }
  write_whole_file(path, text);
  console.narrate(fmt::format("written: {}", path));
}

/// What --track, --every, --csv and --plot say to each other.
void check_track_words(const Words& words, const std::string& csv) {
  if (const std::optional<std::string> plot = words.text("plot")) {
    const bool has_ending = plot->ends_with(".png") || plot->ends_with(".svg");
    if (!has_ending) words.refuse("plot", "a name that ends in .png or .svg", *plot);
  }
  if (words.has("track") && csv.empty() && !words.has("plot"))
    throw UsageError("cairn run: --track needs --csv or --plot to say where its numbers go");
  if (words.has("plot") && !words.has("track")) throw UsageError("cairn run: --plot needs --track");
  if (words.has("text") && !words.text("plot").value_or("").ends_with(".svg"))
    throw UsageError("cairn run: --text needs --plot with a name that ends in .svg");
  if (words.has("every") && (!words.has("track") || csv.empty()))
    throw UsageError("cairn run: --every is of the rows of --csv, where there is --track");
}

void write_plot(const Words& words, const SceneEntry& scene, const SceneRun& run, const std::string& path,
                Console& console) {
  const TrackChart chart{.title = unmarked(scene.name + ": " + scene.title),
                         .state = setting_text(run.setting),
                         .tracks = run.tracks->tracks(),
                         .times = run.tracks->times()};
  std::optional<render::Letters> svg;
  if (path.ends_with(".svg")) svg = words.has("text") ? render::Letters::text : render::Letters::outlines;
  write_whole_file(path, draw_tracks(chart, theme_of(words), svg));
  console.narrate(fmt::format("written: {}", path));
}

int run_run(const Words& words, Console& usual_console) {
  const SceneEntry scene = scene_of(words, words.places.front());
  const Setting setting = setting_of(words, scene);
  const FilmFiles files = film_files(words);
  const FilmLook look = look_of(words, files.frames ? "medium" : "640x360");
  const std::string csv = words.text("csv").value_or("");
  check_track_words(words, csv);
  const int every = words.whole("every", 1, 1, 1'000'000'000);
  if (csv == "-" && words.has("json")) throw UsageError("cairn run: --csv - and --json both want stdout");
  ConsoleSettings settings = words.console;
  settings.narrates_on_stderr = settings.narrates_on_stderr || csv == "-";
  Console data_console(settings);
  Console& console = csv == "-" ? data_console : usual_console;
  const RunWish wish{.seconds = seconds_of(words, scene),
                     .frames_per_second = files.any() ? files.frames_per_second : 0,
                     .series = !csv.empty() && !words.has("track"),
                     .tracks = words.texts("track"),
                     .stops = interrupted};
  const List<SceneRun> runs = {run_scene(scene, setting, wish, words.console)};
  const SceneRun& run = runs.front();
  if (run.stopped) return stopped_run(console, "stopped before the run was over; nothing is written");
  if (words.has("json")) fmt::print("{}\n", run_json(scene, run).dump(1));
  if (run.result.status == TrialStatus::refused) {
    console.warn("cairn run: " + refusal_text(scene, run));
    return exit_code(run);
  }
  if (!words.has("json")) print_run(scene, run, console);
  if (!csv.empty()) write_series(run, every, csv, console);
  if (const auto plot = words.text("plot")) write_plot(words, scene, run, *plot, console);
  if (files.any()) {
    SceneFilm film(scene, runs, look);
    const FilmOutcome outcome = write_film(film, film_identity(scene, runs, look, files.frames_per_second),
                                           files, wish.stops, words.console);
    if (outcome.stopped) return stopped_run(console, stopped_text(files, outcome));
    console.narrate(film_text(outcome));
  }
  return exit_code(run);
}

}  // namespace

Verb run_verb() {
  return {
      .name = "run",
      .places = "SCENE",
      .fewest_places = 1,
      .most_places = 1,
      .summary = "steps a scene and says how well that went; a film if you ask for one",
      .idea =
          "Steps the scene by the setting that is recommended for it, or by yours, and holds what came out "
          "against what is expected: overlap, drift of joints, energy out of nothing and energy lost, "
          "whether it stands: nothing is farther from its place, aside or down, than the scene allows. "
          "Places are those after the first second, or half of a shorter run. Nothing is written unless a "
          "flag names a file. Exit code 1 when an expectation is missed, or when bodies went through each "
          "other, began below the ground or fell out of the scene or for ever, joints came apart or stayed "
          "off, or energy came from nowhere; 4 when the run diverges.",
      .flags = joined_flags(
          joined_flags(joined_flags(setting_flags(), {{"seconds", "TIME", "to simulate (the scene's own)"}}),
                       film_flags()),
          joined_flags(look_flags(),
                       {{"csv", "FILE", "a row of numbers for every step; - is stdout"},
                        {"track", "LIST",
                         "the numbers of --csv and --plot: ball.vy, rod.force, ground:box.normal, "
                         "energy; * is any name; track.md has them all",
                         true},
                        {"every", "STEPS", "a row of --csv for so many steps (1)"},
                        {"plot", "FILE", "what --track follows as a chart, .png or .svg"},
                        {"text", "", "in an .svg text that can be searched and edited, not outlines"}})),
      .examples = {"run stack", "run chain-bob --solver si:20 --substeps 4",
                   "run arch --frames out/arch --show loads --theme dark",
                   "run puck --apng puck.png --show trails --seconds 2s",
                   "run chain-bob --track chain.bob.y,chain.joint.1.force --csv - --plot bob.svg"},
      .run = run_run};
}

}  // namespace cairn::sandbox
