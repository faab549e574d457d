// Each lesson, run once for each theme; book.lua makes the pages of what they have left.
#include "lessons/driver/book_making.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "lessons/driver/coverage.hpp"
#include "lessons/driver/exercises.hpp"
#include "lessons/driver/interruption.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/driver/small_pictures.hpp"
#include <cairn/measure/whole_file.hpp>

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

/// Where `lessons/run playground` puts it.
constexpr const char* playground_file = "out/playground/index.html";

/// Of the pictures of a page in one theme: with its text it has a tenth more.
constexpr std::uintmax_t most_bytes = 1'360'000;

fs::path lesson_out(const Program& program, const Workshop& shop, const std::string& theme) {
  return shop.work / (program.name + "_" + theme);
}

ProcessResult run_in_theme(const Program& program, const Workshop& shop, const std::string& theme,
                           const Words& pictures) {
  Words command = {program.path.string(), "--checks", "--color", "never", "--progress", "never"};
  command.insert(command.end(), pictures.begin(), pictures.end());
  command.insert(command.end(), shop.flags.begin(), shop.flags.end());
  command.insert(command.end(), {"--theme", theme, "--out", lesson_out(program, shop, theme).string()});
  const ProcessResult result = run_quietly(command);
  require_uninterrupted();
  if (result.code > 1 && result.code != skipped)
    throw ProgramFailed(program.name + " failed:\n" + result.output, result.code);
  return result;
}

/// Without what is not the lesson's but the book's: where its pictures went, and how large they were. The
/// state is put on a line of its own, so that the line is not wider than the page.
std::string console_text(const std::string& output, const fs::path& pictures) {
  const std::string written = ": " + pictures.string() + "/";
  std::istringstream lines(output);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(written) != std::string::npos) continue;
    const std::size_t out = line.rfind("Again: ", 0) == 0 ? line.find(" --out ") : std::string::npos;
    const std::size_t state = line.find("     state ");
    if (out != std::string::npos && state != std::string::npos) line.replace(out, state - out, "\n  ");
    text += line + "\n";
  }
  return text;
}

nlohmann::json read_json(const fs::path& file) {
  std::ifstream stream(file);
  return nlohmann::json::parse(stream, nullptr, false);
}

/// Those that its text shows, by their numbers.
std::set<int> frames_beside(const Program& program) {
  std::ifstream stream(lesson_folder(program) / "README.md");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::regex mark("<!-- frame: ([0-9]+) -->");
  std::set<int> frames;
  for (std::sregex_iterator at(text.begin(), text.end(), mark), end; at != end; ++at)
    frames.insert(std::stoi((*at)[1]));
  return frames;
}

/// "lesson06_0001_light.png".
std::string picture_name(const Program& program, int frame, const std::string& theme, const fs::path& file) {
  return fmt::format("lesson{}_{:04}_{}{}", two_digits(program.number), frame, theme,
                     file.extension().string());
}

/// Those of the frames that a page shows: key frames, those that show an item of the paper, and of the others
/// each that comes after so many.
nlohmann::json chosen_frames(const nlohmann::json& frames, const nlohmann::json& covers, int stride) {
  nlohmann::json chosen = nlohmann::json::array();
  int others = 0;
  for (const nlohmann::json& frame : frames) {
    const bool is_needed = frame.at("key").get<bool>() ||
                           std::any_of(covers.begin(), covers.end(), [&](const nlohmann::json& shown) {
                             return shown == frame.at("frame");
                           });
    if (is_needed || others++ % stride == 0) chosen.push_back(frame);
  }
  return chosen;
}

List<FilmPicture> film_of(const Workshop& shop, const Program& program, const nlohmann::json& frames,
                          const std::string& theme) {
  List<FilmPicture> film;
  for (const nlohmann::json& frame : frames) {
    const std::string file = frame.at("file");
    const std::string name = picture_name(program, frame.at("frame"), theme, file);
    film.push_back({.from = lesson_out(program, shop, theme) / file,
                    .to = shop.book / "frames" / name,
                    .is_key = frame.at("key")});
  }
  return film;
}

/// So many of the frames that the page is not too heavy, small, in both themes: and below each the frame that
/// it lies upon, or itself.
/// `bytes` becomes what one theme of them has.
nlohmann::json small_frames(const Workshop& shop, const Program& program, const nlohmann::json& all,
                            const nlohmann::json& covers, std::uintmax_t& bytes) {
  nlohmann::json frames;
  SmallFilm made{.bytes = most_bytes + 1};
  for (int stride = 1; made.bytes > most_bytes && stride <= static_cast<int>(all.size());) {
    for (const FilmPicture& picture : film_of(shop, program, frames, "light")) fs::remove(picture.to);
    frames = chosen_frames(all, covers, stride);
    made = make_small(film_of(shop, program, frames, "light"));
    stride += std::max(1, static_cast<int>(made.bytes / most_bytes));
    require_uninterrupted();
  }
  make_small(film_of(shop, program, frames, "dark"), made.bases);
  bytes = made.bytes;
  for (int i = 0; i < made.bases.size(); ++i) {
    nlohmann::json& frame = frames[static_cast<std::size_t>(i)];
    frame["base"] = frames[static_cast<std::size_t>(made.bases[i])].at("frame");
    for (const char* theme : {"light", "dark"})
      frame[theme] = picture_name(program, frame.at("frame"), theme, frame.at("file").get<std::string>());
  }
  return frames;
}

/// Frames beside the text once more, as many pixels as a dense screen has there, where the page does not
/// become too heavy by all of them. They are key frames. Flags may ask for other sizes or frames: none then.
void add_sharp_frames(const Workshop& shop, const Program& program, nlohmann::json& frames,
                      std::uintmax_t bytes) {
  const std::set<int> beside = frames_beside(program);
  if (beside.empty() || !shop.flags.empty()) return;
  for (const std::string theme : {"light", "dark"}) {
    run_in_theme(program, shop, theme, {"--frames", "key", "--size", "large"});
    List<FilmPicture> film;
    const auto index = read_json(lesson_out(program, shop, theme) / "frames.json");
    for (const nlohmann::json& frame : index.at("frames")) {
      if (!beside.contains(frame.at("frame"))) continue;
      const std::string file = frame.at("file");
      film.push_back({.from = lesson_out(program, shop, theme) / file,
                      .to = shop.book / "frames" /
                            picture_name(program, frame.at("frame"), "sharp_" + theme, file)});
    }
    if (theme == "light" && bytes + make_small(film).bytes > most_bytes) {
      for (const FilmPicture& picture : film) fs::remove(picture.to);
      return;
    }
    if (theme == "dark") make_small(film);
  }
  for (nlohmann::json& frame : frames) frame["is_sharp"] = beside.contains(frame.at("frame"));
}

/// As they are, in one theme.
nlohmann::json printed_frames(const Workshop& shop, const Program& program, nlohmann::json frames) {
  for (const FilmPicture& picture : film_of(shop, program, frames, "light"))
    fs::rename(picture.from, picture.to);
  for (nlohmann::json& frame : frames) {
    frame["base"] = frame.at("frame");
    frame["light"] = picture_name(program, frame.at("frame"), "light", frame.at("file").get<std::string>());
  }
  return frames;
}

void take_frames(const Workshop& shop, const Program& program, nlohmann::json& lesson) {
  const fs::path out = lesson_out(program, shop, "light");
  const auto index = read_json(out / "frames.json");
  const auto record = read_json(out / "run.json");
  if (!index.is_object() || !record.is_object()) return;  // it draws nothing here
  lesson["frames_in_all"] = index.at("frames_of_the_sequence");
  lesson["width"] = record.at("width");
  lesson["height"] = record.at("height");
  lesson["answer"] = record.at("answer").dump();
  if (shop.is_for_print) {
    lesson["frames"] = printed_frames(shop, program, index.at("frames"));
    return;
  }
  std::uintmax_t bytes = 0;
  lesson["frames"] = small_frames(shop, program, index.at("frames"), lesson.at("covers"), bytes);
  add_sharp_frames(shop, program, lesson["frames"], bytes);
}

/// By item, the first frame that shows it; 0 where the text does.
nlohmann::json covers_of(const Program& program) {
  nlohmann::json covers = nlohmann::json::object();
  for (const Covered& covered : covered_by(program)) covers.emplace(covered.item, covered.frame);
  return covers;
}

/// What book.lua has to know of a lesson beside its texts.
nlohmann::json facts_of(const Workshop& shop, const Program& program, BookSize& size) {
  const Words pictures =
      shop.is_for_print ? Words{"--frames", "key", "--format", "svg", "--text"} : Words{"--frames", "all"};
  const ProcessResult result = run_in_theme(program, shop, "light", pictures);
  if (!shop.is_for_print) run_in_theme(program, shop, "dark", pictures);
  size.all_held = size.all_held && result.code != 1;
  const LessonInfo& card = program.card;
  const fs::path folder = lesson_folder(program);
  nlohmann::json lesson = {{"number", program.number},
                           {"folder", folder.filename().string()},
                           {"title", card.title},
                           {"idea", card.idea},
                           {"paper", card.paper},
                           {"cover", card.cover},
                           {"covers", covers_of(program)},
                           {"console", console_text(result.output, lesson_out(program, shop, "light"))},
                           {"frames", nlohmann::json::array()},
                           {"has_stage", fs::exists(folder.parent_path() / "your_solver/stages" /
                                                    (two_digits(program.number) + ".txt"))}};
  take_frames(shop, program, lesson);
  size.pictures += (shop.is_for_print ? 1 : 2) * static_cast<int>(lesson["frames"].size());
  return lesson;
}

/// A table of Lua, whose strings and numbers are written as those of JSON are.
std::string lua_of(const nlohmann::json& value) {
  if (!value.is_structured()) return value.dump();
  std::string items;
  for (const auto& item : value.items()) {
    if (value.is_object()) items += "[" + nlohmann::json(item.key()).dump() + "] = ";
    items += lua_of(item.value()) + ",\n";
  }
  return "{" + items + "}";
}

nlohmann::json items_of_the_paper() {
  nlohmann::json items = nlohmann::json::array();
  for (const PaperItem& item : paper_items()) items.push_back({{"name", item.name}, {"what", item.what}});
  return items;
}

}  // namespace

BookSize make_pages(const Context& context, const Workshop& shop) {
  fs::create_directories(shop.book / "frames");
  BookSize size;
  nlohmann::json lessons = nlohmann::json::array();
  const List<Program> programs = built(context.programs);
  Progress progress(context.settings, "lessons", programs.size());
  for (const Program& program : programs) {
    progress.advance(size.lessons++);
    lessons.push_back(facts_of(shop, program, size));
  }
  const bool has_playground = fs::exists(playground_file);
  if (has_playground) fs::copy_file(playground_file, shop.book / "playground.html");
  fs::create_directories(shop.work);
  const fs::path facts = shop.work / "facts.lua";
  write_whole_file(facts, "return " + lua_of({{"lessons", lessons},
                                              {"items", items_of_the_paper()},
                                              {"version", CAIRN_VERSION},
                                              {"folder", shop.book.string()},
                                              {"lessons_folder", lessons_folder().string()},
                                              {"has_playground", has_playground},
                                              {"is_for_print", shop.is_for_print}}));
  const ProcessResult made = run_quietly({"pandoc", "--from", "gfm", "--to", "plain", "--lua-filter",
                                          (lessons_folder() / "driver/book.lua").string(), "--metadata",
                                          "facts=" + facts.string(), "--output", "/dev/null", "/dev/null"});
  require_uninterrupted();
  if (made.code != 0 || !made.output.empty())
    throw ProgramFailed("pandoc cannot make the pages:\n" + made.output, cannot_make);
  return size;
}

}  // namespace cairn::driver
