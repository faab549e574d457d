// From shots to numbered files.
#include "lessons/film.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "lessons/frames.hpp"
#include "measure/whole_file.hpp"
#include "render/lint.hpp"
#include "render/sequence.hpp"

namespace cairn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

render::Theme theme_of(const Options& options) {
  const render::Theme theme =
      options.theme == Options::Theme::dark ? render::dark_theme() : render::light_theme();
  return options.palette == Options::Palette::gray ? render::without_hues(theme) : theme;
}

List<int> wanted_frames(const LessonInfo& info, const Options& options, const List<Shot>& shots) {
  FrameSupply supply = {.cover = info.cover};
  for (int i = 0; i < shots.size(); ++i) {
    const std::string place = short_name(info) + ", frame " + std::to_string(i + 1) + ": ";
    if (shots[i].alt.empty()) throw std::logic_error(place + "there is no alt text");
    if (!shots[i].draw) throw std::logic_error(place + "there is nothing that draws");
    supply.key.push_back(shots[i].key);
  }
  return chosen_frames(options.frames, supply);
}

/// The files that the folder's frames.json names: only such as this lesson could have written.
/// @throws WriteError where that file is of nobody's lesson
List<std::string> earlier_frames(const fs::path& folder, const std::string& stem) {
  const fs::path path = folder / "frames.json";
  if (!fs::exists(path)) return {};
  std::ifstream stream(path);
  const Json old = Json::parse(stream, nullptr, false);
  List<std::string> files;
  if (!old.is_object() || !old.contains("lesson") || !old.contains("frames") || !old["frames"].is_array()) {
    throw WriteError("cannot write " + path.string() + ": there is one that no lesson wrote");
  }
  for (const Json& frame : old["frames"]) {
    if (!frame.is_object() || !frame.contains("file") || !frame["file"].is_string()) continue;
    const std::string file = frame["file"];
    const bool is_ours = file.rfind(stem + "_", 0) == 0 && file.find('/') == std::string::npos &&
                         fs::path(file).extension() == ".png";
    if (is_ours) files.push_back(file);
  }
  return files;
}

void remove_all_but(const fs::path& folder, const List<std::string>& files,
                    const std::set<std::string>& kept) {
  std::error_code ignored;
  for (const std::string& file : files) {
    if (kept.count(file) == 0) fs::remove(folder / file, ignored);
  }
}

/// One film at work.
class FilmMaker {
 public:
  FilmMaker(const LessonInfo& info, const Options& options, Console& console)
      : info_(info),
        options_(options),
        console_(console),
        page_(options.width, options.height, theme_of(options)) {}

  FilmReport make(const List<Shot>& shots, const List<int>& wanted) {
    // Known before anything is written, so that an old picture is never left among the new.
    const List<std::string> earlier = earlier_frames(options_.out, stem());
    try {
      write_frames(shots, wanted);
      write_whole_file(options_.out / "frames.json", index_.dump(2) + "\n");
    } catch (...) {
      remove_all_but(options_.out, {written_.begin(), written_.end()}, {});
      throw;
    }
    remove_all_but(options_.out, earlier, written_);
    report_.pictures = wanted.size();
    report_.backend = page_.canvas().backend();
    return std::move(report_);
  }

 private:
  std::string stem() const { return "l" + two_digits(info_.number); }

  void write_frames(const List<Shot>& shots, const List<int>& wanted) {
    index_ = {{"lesson", info_.number}, {"title", info_.title}, {"frames_of_the_sequence", shots.size()}};
    index_["frames"] = Json::array();
    Progress progress(options_.console, "pictures", wanted.size());
    render::FrameWriter writer(options_.out, stem());
    for (int done = 0; done < wanted.size(); ++done) {
      const Shot& shot = shots[wanted[done]];
      draw(shot, wanted[done], shots.size());
      const std::string file = writer.add(page_.canvas().read()).filename().string();
      written_.insert(file);
      index_["frames"].push_back({{"file", file},
                                  {"frame", wanted[done] + 1},
                                  {"state", shot.state},
                                  {"alt", shot.alt},
                                  {"words", words_drawn()}});
      progress.advance(done + 1);
      pause_after(shot, file);
    }
    writer.finish();
  }

  void draw(const Shot& shot, int index, int count) {
    page_.begin({.number = two_digits(info_.number),
                 .title = info_.title,
                 .state = shot.state,
                 .frame = index,
                 .frames = count});
    shot.draw(page_);
    for (const std::string& finding : render::lint(page_)) {
      report_.findings.push_back("frame " + std::to_string(index + 1) + ": " + finding);
    }
  }

  /// The texts of the page with their markup, in the order in which they were drawn.
  Json words_drawn() const {
    Json words = Json::array();
    for (const render::TextBox& box : page_.canvas().text_boxes()) {
      if (box.text.find_first_not_of(' ') != std::string::npos) words.push_back(box.text);
    }
    return words;
  }

  void pause_after(const Shot& shot, const std::string& file) {
    if (!options_.step) return;
    console_.narrate(file + "  " + shot.state + ": " + shot.alt);
    console_.wait();
  }

  const LessonInfo& info_;
  const Options& options_;
  Console& console_;
  render::Page page_;
  Json index_ = {};
  std::set<std::string> written_ = {};
  FilmReport report_ = {};
};

}  // namespace

FilmReport draw_film(const LessonInfo& info, const Options& options, const List<Shot>& shots,
                     Console& console) {
  const List<int> wanted = wanted_frames(info, options, shots);
  if (wanted.empty()) return {};
  return FilmMaker(info, options, console).make(shots, wanted);
}

}  // namespace cairn
