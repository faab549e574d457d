// Pictures for documents: drawn by the lessons, named by lesson, frame and theme.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "lessons/driver/commands.hpp"
#include "lessons/driver/interruption.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/driver/work_folder.hpp"
#include "lessons/kit/film_encoding.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/measure/whole_file.hpp>

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

constexpr int cannot_write = 3;

constexpr const char* export_help =
    R"(lessons export N|all [flags]: pictures for documents, and their alt texts beside them

  -o, --out DIR             the folder (out/export)
  --frames WHICH            key (at most 12), all, film, cover, N, A:B or A:B:STEP (films film, else
                            cover); film: all of up to 64 frames, else every second or third
  --theme light|dark|both   (both)
  --scale X                 1 is 1280 x 720 px, from 0.75 to 3 (1; films 0.75)
  --format png|svg|apng|gif|webp|mp4
                            the last four: one film; gif, webp and mp4 need the program ffmpeg (png)
  --fps X                   frames a second of a film, from 0.1 to 30
  --panel NAME              only the panel that has NAME in its title
  --transparent             no background; for png and svg
  --text                    svg: text that can be searched and edited, not outlines
Other flags are the lesson's own, such as --bodies 10.
Files: 03_sequential_impulses_0007_light.png is frame 7, and 03_sequential_impulses_0007.txt says what it
shows. A film has no number in its name, its captions in it below each frame, and beside it as a file of their own:
03_sequential_impulses.vtt. Without --fps a frame stays for 1 s, and 1/4 s more for each word of its caption
that the caption before has not. A film keeps 255 colours, and of each frame what changes.
)";

/// What was asked for wrongly: one line for people.
struct ExportError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Order {
  fs::path out = "out/export";
  Words themes = {"light", "dark"};
  std::string format = "png";
  double ticks = 10;      // a second, of which frames of a film stay for a whole number
  Words flags = {};       // of the lessons
  Words complaints = {};  // of lessons whose own checks failed
};

bool is_film(const Order& order) { return order.format != "png" && order.format != "svg"; }

double number_of(const std::string& flag, double least, double most, const std::string& text) {
  const std::optional<double> number = parse_number(text);
  if (number && *number >= least && *number <= most) return *number;
  throw ExportError(
      fmt::format("export: {} must be a number from {} to {}, got {}", flag, least, most, text));
}

std::string one_of(const std::string& flag, const Words& words, const std::string& text) {
  for (const std::string& word : words)
    if (word == text) return text;
  throw ExportError("export: " + flag + " must be " + joined(words, " or ") + ", got " + text);
}

/// What a lesson that ended early said of it: all but the checks that held.
std::string complaints_in(const std::string& output) {
  std::istringstream lines(output);
  std::string complaints;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.ends_with(" ok")) continue;
    complaints += (complaints.empty() ? "" : "\n") + line;
  }
  return complaints;
}

/// Takes the words that concern the export; the others are for the lessons.
Order order_of(const Words& words) {
  Order order;
  std::optional<double> scale;
  const Words known = {"--out", "-o", "--theme", "--scale", "--format", "--fps"};
  for (int i = 0; i < words.size(); ++i) {
    const std::size_t sign = words[i].rfind("--", 0) == 0 ? words[i].find('=') : std::string::npos;
    const std::string flag = words[i].substr(0, sign);
    if (std::find(known.begin(), known.end(), flag) == known.end()) {
      order.flags.push_back(words[i]);
      continue;
    }
    if (sign == std::string::npos && i + 1 == words.size())
      throw ExportError("export: " + flag + " needs a value");
    const std::string value = sign == std::string::npos ? words[++i] : words[i].substr(sign + 1);
    if (flag == "--out" || flag == "-o") order.out = value;
    if (flag == "--theme" && one_of(flag, {"light", "dark", "both"}, value) != "both") order.themes = {value};
    if (flag == "--format") order.format = one_of(flag, {"png", "svg", "apng", "gif", "webp", "mp4"}, value);
    if (flag == "--fps") {
      order.ticks = number_of(flag, 0.1, 30, value);
      order.flags.insert(order.flags.end(), {flag, fmt::format("{:g}", order.ticks)});
    }
    if (flag == "--scale") scale = number_of(flag, 0.75, 3, value);
  }
  const double used = scale.value_or(is_film(order) ? 0.75 : 1);
  order.flags.insert(order.flags.begin(),
                     {"--frames", is_film(order) ? "film" : "cover", "--size",
                      fmt::format("{}x{}", std::lround(1280 * used), std::lround(720 * used))});
  return order;
}

/// Draws, and says what did not hold: such pictures are delivered all the same.
nlohmann::json draw(Order& order, const Program& program, const std::string& theme, const fs::path& work) {
  Words command = {program.path.string(), "-q", "--color", "never", "--progress", "never"};
  command.insert(command.end(), order.flags.begin(), order.flags.end());
  command.insert(command.end(), {"--format", is_film(order) ? "apng" : order.format, "--theme", theme,
                                 "--out", work.string()});
  const ProcessResult result = run_quietly(command);
  require_uninterrupted();
  if (result.code > 1) throw ProgramFailed(complaints_in(result.output), result.code);
  if (result.code == 1)
    order.complaints.push_back(program.name + " " + theme + ":\n" + complaints_in(result.output));
  std::ifstream stream(work / "frames.json");
  return nlohmann::json::parse(stream).at("frames");
}

Words encoding_of(const std::string& format) {
  if (format == "mp4") return mp4_encoding();
  if (format == "webp") return {"-c:v", "libwebp_anim", "-lossless", "1", "-loop", "0"};
  return gif_encoding();
}

std::string needs(const std::string& format) {
  return "--format " + format + " needs the program ffmpeg (apt-get install ffmpeg); apng needs none";
}

/// The film in another format. What ffmpeg says of a failure is the reason.
void encode(const Order& order, const fs::path& drawn, const fs::path& target) {
  const fs::path made = drawn.parent_path() / ("film." + order.format);
  Words command = {"ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "apng", "-i", drawn.string()};
  const Words encoding = encoding_of(order.format);
  command.insert(command.end(), encoding.begin(), encoding.end());
  command.insert(command.end(), {"-r", fmt::format("{:g}", order.ticks), made.string()});
  const ProcessResult result = run_quietly(command);
  require_uninterrupted();
  if (result.code != 0) throw WriteError("cannot write " + target.string() + ": ffmpeg: " + result.output);
  move_to(made, target);
}

/// "00:01:05.250"
std::string film_time(double seconds) {
  const auto thousandths = std::lround(1000 * seconds);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", thousandths / 3600000, thousandths / 60000 % 60,
                     thousandths / 1000 % 60, thousandths % 1000);
}

/// What each frame shows, for as long as it is seen (WebVTT).
std::string captions(const nlohmann::json& frames) {
  std::string text = "WEBVTT\n";
  double begin = 0;
  for (const auto& frame : frames) {
    const double end = begin + frame.at("seconds").get<double>();
    text += fmt::format("\n{} --> {}\n{}\n", film_time(begin), film_time(end),
                        frame.at("alt").get<std::string>());
    begin = end;
  }
  return text;
}

/// The pictures of one lesson in one theme. Returns how many files there are.
int export_one(Order& order, const Program& program, const std::string& theme) {
  const std::string name = program.name.substr(std::string("lesson").size());
  const WorkFolder folder(order.out);
  const fs::path work = folder.path / "runs";
  const nlohmann::json frames = draw(order, program, theme, work);
  std::string alt;
  for (const auto& frame : frames) {
    const std::string file = frame.at("file"), text = frame.at("alt");
    if (is_film(order)) {
      alt += fmt::format("{}. {}\n", frame.at("frame").get<int>(), text);
      continue;
    }
    const std::string numbered = fmt::format("{}_{:04}", name, frame.at("frame").get<int>());
    move_to(work / file, order.out / (numbered + "_" + theme + fs::path(file).extension().string()));
    write_whole_file(order.out / (numbered + ".txt"), text + "\n");
  }
  if (!is_film(order)) return static_cast<int>(frames.size());
  const fs::path drawn = work / frames.front().at("file").get<std::string>();
  if (order.format == "apng") {
    move_to(drawn, order.out / (name + "_" + theme + ".png"));
  } else {
    encode(order, drawn, order.out / (name + "_" + theme + "." + order.format));
  }
  write_whole_file(order.out / (name + ".txt"), alt);
  write_whole_file(order.out / (name + ".vtt"), captions(frames));
  return 1;
}

List<Program> wanted_programs(const Context& context, const Words& words) {
  if (words.empty()) throw ExportError("export needs the number of a lesson, or all");
  if (words.front() == "all") return built(context.programs);
  const Program* program = find(context.programs, words.front());
  if (program == nullptr) throw ExportError("export: there is no lesson " + words.front());
  require_built(*program);
  return {*program};
}

int export_all(const Context& context, const Words& words) {
  const List<Program> programs = wanted_programs(context, words);
  Order order = order_of({words.begin() + 1, words.end()});
  const bool has_encoder =
      !is_film(order) || order.format == "apng" || run_quietly({"ffmpeg", "-version"}).code == 0;
  if (!has_encoder) throw WriteError(needs(order.format));
  Progress progress(context.settings, "lessons", programs.size());
  int files = 0;
  for (int i = 0; i < programs.size(); ++i) {
    progress.advance(i);
    for (const std::string& theme : order.themes) {
      try {
        files += export_one(order, programs[i], theme);
      } catch (const ProgramFailed& ended) {
        if (ended.code != skipped || programs.size() == 1) throw;
      }
    }
  }
  progress.clear();
  Console console(context.settings);
  console.narrate(fmt::format("{} {}{} with what {} show{}: {}", files, is_film(order) ? "film" : "picture",
                              files == 1 ? "" : "s", files == 1 ? "it" : "they", files == 1 ? "s" : "",
                              order.out.string()));
  for (const std::string& complaint : order.complaints) console.warn(complaint);
  return order.complaints.empty() ? 0 : 1;
}

}  // namespace

int export_pictures(const Context& context, const Words& words) {
  Console console(context.settings);
  for (const std::string& word : words) {
    if (word != "-h" && word != "--help") continue;
    console.result(export_help);
    return 0;
  }
  note_interrupts();
  try {
    return export_all(context, words);
  } catch (const ExportError& error) {
    console.warn(std::string("lessons: ") + error.what());
    return bad_usage;
  } catch (const ProgramFailed& ended) {
    console.warn(ended.what());
    return ended.code;
  } catch (const Interrupted&) {
    console.warn("lessons: interrupted; the pictures that were exported before are whole");
    return stopped;
  } catch (const WriteError& error) {
    console.warn(std::string("lessons: ") + error.what());
    return cannot_write;
  }
}

}  // namespace cairn::driver
