// From shots to numbered files.
#include "lessons/kit/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "lessons/kit/captioned_film.hpp"
#include "lessons/kit/frames.hpp"
#include "lessons/kit/picture.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/measure/whole_file.hpp>
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
    const std::string kind = fs::path(file).extension();
    const bool is_ours =
        (file.rfind(stem + "_", 0) == 0 && (kind == ".png" || kind == ".svg")) || file == stem + ".png";
    if (is_ours && file.find('/') == std::string::npos) files.push_back(file);
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

/// Numbered pictures in a folder.
class FrameFiles {
 public:
  FrameFiles(const Options& options, render::Page& page, std::string stem)
      : options_(options), maker_(options, page), stem_(std::move(stem)), pictures_(options.out, stem_) {}

  /// Draws the next frame and returns the name of the file that it will be in.
  std::string add(const std::function<void()>& draw, const std::string& alt) {
    const bool is_svg = options_.format == Options::Format::svg;
    if (!is_svg && !options_.transparent) return pictures_.add(maker_.image(draw)).filename().string();
    const std::string name = fmt::format("{}_{:04}.{}", stem_, ++count_, is_svg ? "svg" : "png");
    write_whole_file(options_.out / name, maker_.file(draw, alt));
    return name;
  }

  void finish() { pictures_.finish(); }

 private:
  const Options& options_;
  PictureMaker maker_;
  std::string stem_;
  render::FrameWriter pictures_;  // encodes plain pictures while the next is drawn
  int count_ = 0;
};

/// One film at work.
class FilmMaker {
 public:
  FilmMaker(const LessonInfo& info, const Options& options, Console& console)
      : info_(info),
        options_(options),
        console_(console),
        page_(render::ImageSize{options.width, options.height}, theme_of(options)) {}

  FilmReport make(const List<Shot>& shots, const List<int>& chosen) {
    const List<int> wanted = with_panel(shots, chosen);
    // Known before anything is written, so that an old picture is never left among the new.
    const List<std::string> earlier = earlier_frames(options_.out, stem());
    try {
      index_ = {{"lesson", info_.number}, {"title", info_.title}, {"frames_of_the_sequence", shots.size()}};
      index_["frames"] = Json::array();
      options_.format == Options::Format::apng ? write_film(shots, wanted) : write_frames(shots, wanted);
      write_whole_file(options_.out / "frames.json", index_.dump(2) + "\n");
    } catch (...) {
      remove_all_but(options_.out, {written_.begin(), written_.end()}, {});
      throw;
    }
    remove_all_but(options_.out, earlier, written_);
    report_.pictures = wanted.size();
    report_.index = index_.dump(2);
    report_.backend = page_.canvas().backend();
    return std::move(report_);
  }

 private:
  std::string stem() const { return "l" + two_digits(info_.number); }

  /// Those of the frames that have the panel that is asked for.
  List<int> with_panel(const List<Shot>& shots, const List<int>& wanted) {
    if (options_.panel.empty()) return wanted;
    const PictureMaker maker(options_, page_);
    List<int> found;
    std::set<std::string> titles;
    for (const int index : wanted) {
      draw(shots[index], index, shots.size());
      for (const render::PanelPlace& panel : page_.panels()) titles.insert('"' + panel.title + '"');
      if (maker.view()) found.push_back(index);
    }
    if (!found.empty()) return found;
    throw NoSuchFrame("--panel must be in the title of a panel of these frames, which have " +
                      (titles.empty() ? "none" : joined({titles.begin(), titles.end()}, ", ")) + "; got " +
                      options_.panel);
  }

  void write_frames(const List<Shot>& shots, const List<int>& wanted) {
    Progress progress(options_.console, "pictures", wanted.size());
    FrameFiles files(options_, page_, stem());
    for (int done = 0; done < wanted.size(); ++done) {
      const Shot& shot = shots[wanted[done]];
      const std::string file = files.add([&] { draw(shot, wanted[done], shots.size()); }, shot.alt);
      note(shot, wanted[done], file);
      progress.advance(done + 1);
      pause_after(shot, file);
    }
    files.finish();
  }

  void write_film(const List<Shot>& shots, const List<int>& wanted) {
    Progress progress(options_.console, "pictures", 2 * wanted.size());
    PictureMaker maker(options_, page_);
    List<std::string> captions;
    for (const int index : wanted) captions.push_back(shots[index].alt);
    CaptionedFilm film(options_, page_.theme(), captions);
    const auto picture = [&](int done) {
      return maker.image([&] { draw(shots[wanted[done]], wanted[done], shots.size()); });
    };
    for (int done = 0; done < wanted.size(); ++done) {
      film.look_at(picture(done));
      progress.advance(done + 1);
    }
    const std::string file = stem() + ".png";
    film.begin(options_.out / file);
    for (int done = 0; done < wanted.size(); ++done) {
      film.add(picture(done));
      note(shots[wanted[done]], wanted[done], file);
      index_["frames"].back()["seconds"] = film.seconds(done);
      progress.advance(wanted.size() + done + 1);
    }
    film.finish();
  }

  /// Enters the frame that was drawn into the index.
  void note(const Shot& shot, int index, const std::string& file) {
    find_faults(index);
    written_.insert(file);
    index_["frames"].push_back({{"file", file},
                                {"frame", index + 1},
                                {"key", shot.key},
                                {"state", shot.state},
                                {"alt", shot.alt},
                                {"words", words_drawn()}});
  }

  void draw(const Shot& shot, int index, int count) {
    page_.begin({.number = two_digits(info_.number),
                 .title = info_.title,
                 .state = shot.state,
                 .frame = index,
                 .frames = count});
    shot.draw(page_);
  }

  void find_faults(int index) {
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
