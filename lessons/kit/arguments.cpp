// Reads the command line with CLI11, the only file that knows it; every word of a complaint is our own.
#include "lessons/kit/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "lessons/kit/words.hpp"
#include <cairn/math/check.hpp>

namespace cairn {
namespace {

/// The flags of all lessons: to tell "not here" from "nowhere".
const List<std::string> shared_vocabulary = {
    "dt",    "gravity",   "bodies", "mass-ratio", "mu",      "beta", "slop",  "steps",     "sweeps",
    "angle", "tolerance", "solver", "clamp",      "no-warm", "warm", "order", "precision", "seed"};

/// The texts behind the flags, before they are understood.
struct Texts {
  std::map<std::string, std::string> scene = {};
  std::string answer = {}, out = {}, frames = {}, size = {}, theme = {}, palette = {}, format = {},
              panel = {}, fps = {};
  std::string csv = {}, json = {};
  std::string expect = {}, color = {}, progress = {}, hint = {};
  bool help = false, version = false, about = false, list_params = false, dry_run = false;
};

void add_texts(CLI::App& app, Texts& texts) {
  app.add_option("--answer", texts.answer);
  app.add_option("-o,--out", texts.out);
  app.add_option("--frames", texts.frames);
  app.add_option("--size", texts.size);
  app.add_option("--theme", texts.theme);
  app.add_option("--palette", texts.palette);
  app.add_option("--format", texts.format);
  app.add_option("--panel", texts.panel);
  app.add_option("--fps", texts.fps);
  app.add_option("--csv", texts.csv);
  app.add_option("--json", texts.json);
  app.add_option("--expect", texts.expect);
  app.add_option("--color", texts.color);
  app.add_option("--progress", texts.progress);
  app.add_option("--hint", texts.hint)->expected(0, 1);
}

void add_flags(CLI::App& app, Texts& texts, Options& options) {
  app.add_flag("-h,--help", texts.help);
  app.add_flag("--version", texts.version);
  app.add_flag("--about", texts.about);
  app.add_flag("--list-params", texts.list_params);
  app.add_flag("--dry-run", texts.dry_run);
  app.add_flag("--transparent", options.transparent);
  app.add_flag("--text", options.text);
  app.add_flag("--predict", options.predict);
  app.add_flag("--check", options.check);
  app.add_flag("--checks", options.checks);
  app.add_flag("--step", options.step);
  app.add_flag("-q,--quiet", options.console.quiet);
  app.add_flag("-v,--verbose", options.console.verbose);
  app.add_flag("--plain", options.console.plain);
}

List<std::string> scene_flags(const LessonInfo& info) {
  List<std::string> flags;
  for (const Parameter& parameter : info.parameters) flags.push_back(parameter.flag);
  for (const Choice& choice : info.choices) flags.push_back(choice.flag);
  return flags;
}

[[noreturn]] void refuse(const LessonInfo& info, const std::string& complaint) {
  throw UsageError(short_name(info) + ": " + complaint);
}

[[noreturn]] void refuse_unknown(const LessonInfo& info, const std::string& word) {
  const std::string help = "; " + program_name(info) + " --help lists the flags";
  if (word.size() < 2 || word[0] != '-') refuse(info, "unexpected word \"" + word + "\"" + help);
  const std::string flag = word.substr(0, word.find('='));
  const std::string name = flag.substr(
      flag.find_first_not_of('-') == std::string::npos ? flag.size() : flag.find_first_not_of('-'));
  const List<std::string> own = scene_flags(info);
  const bool is_known =
      std::find(shared_vocabulary.begin(), shared_vocabulary.end(), name) != shared_vocabulary.end();
  if (is_known) {
    const std::string uses = own.empty() ? "it has no scene flags" : "it uses: --" + joined(own, ", --");
    throw UsageError(short_name(info) + " does not use --" + name + "; " + uses);
  }
  List<std::string> all = own;
  all.insert(all.end(), common_flags().begin(), common_flags().end());
  const std::string meant = nearest(name, all);
  refuse(info, "unknown flag " + flag + (meant.empty() ? help : "; did you mean --" + meant + "?"));
}

void parse(const LessonInfo& info, CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string what = error.what();
    const std::string flag = what.substr(0, what.find(':'));
    refuse(info, flag + (what.find("required") == std::string::npos ? " takes no value" : " needs a value"));
  } catch (const CLI::ParseError& error) {
    refuse(info, std::string(error.what()));
  }
  if (app.remaining_size() > 0) refuse_unknown(info, app.remaining().front());
}

std::string with_unit(const Parameter& parameter) {
  return parameter.unit.empty() ? "" : " " + parameter.unit;
}

double read_parameter(const LessonInfo& info, const Parameter& parameter, const std::string& text) {
  const std::optional<double> value = parse_number(text);
  const bool is_whole = parameter.kind == Parameter::Kind::whole;
  const bool fits = value && *value >= parameter.min && *value <= parameter.max &&
                    (!is_whole || std::trunc(*value) == *value);
  if (fits) return *value;
  refuse(info, "--" + parameter.flag + " (" + parameter.what + ") must be a " + (is_whole ? "whole " : "") +
                   "number from " + shortest(parameter.min) + " to " + shortest(parameter.max) +
                   with_unit(parameter) + ", got " + text);
}

/// The place of `text` among the words, or a refusal that lists them.
int read_word(const LessonInfo& info, const std::string& flag, const List<std::string>& words,
              const std::string& text) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found != words.end()) return static_cast<int>(found - words.begin());
  refuse(info, "--" + flag + " must be " + joined(words, " or ") + ", got " + text);
}

void read_scene(const LessonInfo& info, const CLI::App& app, const Texts& texts, Options& options) {
  for (const Parameter& parameter : info.parameters) {
    const bool is_given = app.count("--" + parameter.flag) > 0;
    options.numbers[parameter.flag] =
        is_given ? read_parameter(info, parameter, texts.scene.at(parameter.flag)) : parameter.standard;
  }
  for (const Choice& choice : info.choices) {
    const bool is_given = app.count("--" + choice.flag) > 0;
    const std::string text = is_given ? texts.scene.at(choice.flag) : choice.values.at(0);
    options.choices[choice.flag] = choice.values[read_word(info, choice.flag, choice.values, text)];
  }
}

void read_size(const LessonInfo& info, const std::string& text, Options& options) {
  const List<std::pair<std::string, std::pair<int, int>>> names = {
      {"small", {960, 540}}, {"medium", {1280, 720}}, {"large", {1920, 1080}}};
  for (const auto& [name, size] : names) {
    if (text != name) continue;
    options.width = size.first;
    options.height = size.second;
    return;
  }
  const std::size_t cross = text.find('x');
  const std::optional<double> width = parse_number(text.substr(0, cross));
  const std::optional<double> height =
      cross == std::string::npos ? std::optional<double>{} : parse_number(text.substr(cross + 1));
  const bool fits = width && height && *width >= 960 && *width <= 3840 && *height >= 540 && *height <= 2160 &&
                    std::trunc(*width) == *width && std::trunc(*height) == *height;
  if (!fits) {
    refuse(info,
           "--size must be small, medium, large or WIDTHxHEIGHT from 960x540 to 3840x2160 px, got " + text);
  }
  options.width = static_cast<int>(*width);
  options.height = static_cast<int>(*height);
}

/// A path that begins with a dash was meant as a flag; "-" alone is for the caller.
std::string read_path(const LessonInfo& info, const std::string& flag, const std::string& rule,
                      const std::string& text) {
  if (text.empty()) refuse(info, "--" + flag + " must " + rule + ", got nothing");
  if (text.size() < 2 || text[0] != '-') return text;
  refuse(info, "--" + flag + " must " + rule + ", got " + text +
                   "; a path that begins with a dash is written ./" + text);
}

void read_format(const LessonInfo& info, const CLI::App& app, const Texts& texts, Options& options) {
  const Options::Format formats[] = {Options::Format::png, Options::Format::svg, Options::Format::apng};
  if (app.count("--format") > 0)
    options.format = formats[read_word(info, "format", {"png", "svg", "apng"}, texts.format)];
  if (options.transparent && options.format == Options::Format::apng)
    refuse(info, "--transparent must come with --format png or svg, got apng");
  if (app.count("--fps") > 0) {
    options.fps = parse_number(texts.fps);
    if (!options.fps || *options.fps < 0.1 || *options.fps > 30)
      refuse(info, "--fps must be a number from 0.1 to 30, got " + texts.fps);
  }
  if (app.count("--panel") > 0 && texts.panel.empty()) refuse(info, "--panel must name a panel, got nothing");
  options.panel = texts.panel;
  if (options.text && options.format != Options::Format::svg)
    refuse(info, "--text must come with --format svg");
  if (options.transparent) options.picture_flags.push_back("--transparent");
  if (options.text) options.picture_flags.push_back("--text");
}

void read_pictures(const LessonInfo& info, const CLI::App& app, const Texts& texts, Options& options) {
  options.out = std::filesystem::path("out") / short_name(info);
  if (app.count("--out") > 0) options.out = read_path(info, "out", "name a folder", texts.out);
  if (app.count("--frames") > 0) {
    const std::optional<FrameChoice> choice = parse_frames(texts.frames);
    if (!choice) {
      refuse(info,
             "--frames must be key, all, film, none, cover, N, A:B or A:B:STEP "
             "(from 1; -1 is the last), got " +
                 texts.frames);
    }
    options.frames = *choice;
  }
  if (app.count("--size") > 0) read_size(info, texts.size, options);
  if (app.count("--theme") > 0 && read_word(info, "theme", {"light", "dark"}, texts.theme) == 1)
    options.theme = Options::Theme::dark;
  if (app.count("--palette") > 0 && read_word(info, "palette", {"color", "gray"}, texts.palette) == 1)
    options.palette = Options::Palette::gray;
  read_format(info, app, texts, options);
  const List<std::pair<std::string, std::string>> given = {
      {"--out", texts.out},     {"--frames", texts.frames},   {"--size", texts.size},
      {"--theme", texts.theme}, {"--palette", texts.palette}, {"--format", texts.format},
      {"--panel", texts.panel}, {"--fps", texts.fps}};
  for (const auto& [flag, text] : given) {
    if (app.count(flag) == 0) continue;
    options.picture_flags.push_back(flag);
    options.picture_flags.push_back(shell_quoted(text));
  }
  options.dry_run = texts.dry_run;
  if (options.dry_run || options.check) options.frames = {.kind = FrameChoice::Kind::none};
}

void read_data(const LessonInfo& info, const CLI::App& app, const Texts& texts, Options& options) {
  if (app.count("--csv") > 0) options.csv = read_path(info, "csv", "name a file or be -", texts.csv);
  if (app.count("--json") > 0) options.json = read_path(info, "json", "name a file or be -", texts.json);
  if (texts.csv == "-" && texts.json == "-") refuse(info, "--csv - and --json - cannot share stdout");
  options.console.narrates_on_stderr = texts.csv == "-" || texts.json == "-";
  const bool is_hash =
      texts.expect.size() == 16 && texts.expect.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (app.count("--expect") > 0 && !is_hash) {
    refuse(info, "--expect must be the state that an earlier run printed, 16 hexadecimal digits, got " +
                     texts.expect);
  }
  options.expect = texts.expect;
}

void read_teaching(const LessonInfo& info, const CLI::App& app, const Texts& texts, Options& options) {
  if (app.count("--answer") > 0) {
    options.answer = parse_numbers(texts.answer);
    if (!options.answer)
      refuse(info, "--answer must be numbers between commas, without units, got " + texts.answer);
  }
  if (app.count("--hint") == 0) return;
  const int most = info.hints.size();
  const std::optional<double> hint = texts.hint.empty() ? 1.0 : parse_number(texts.hint);
  if (most == 0) refuse(info, "--hint: this lesson has none");
  if (!hint || *hint < 1 || *hint > most || std::trunc(*hint) != *hint) {
    refuse(info, "--hint must be a whole number from 1 to " + std::to_string(most) + ", got " + texts.hint);
  }
  options.hint = static_cast<int>(*hint);
  options.request = Options::Request::hint;
}

void read_console(const LessonInfo& info, const CLI::App& app, const Texts& texts, Options& options) {
  const List<std::string> words = {"auto", "always", "never"};
  const When whens[] = {When::automatic, When::always, When::never};
  if (app.count("--color") > 0) options.console.color = whens[read_word(info, "color", words, texts.color)];
  if (app.count("--progress") > 0) {
    options.console.progress = whens[read_word(info, "progress", words, texts.progress)];
  }
}

Options::Request request_of(const Texts& texts, Options::Request otherwise) {
  if (texts.help) return Options::Request::help;
  if (texts.version) return Options::Request::version;
  if (texts.about) return Options::Request::about;
  return texts.list_params ? Options::Request::list_params : otherwise;
}

}  // namespace

Options read_arguments(const LessonInfo& info, int argc, const char* const* argv) {
  Options options;
  Texts texts;
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  try {
    add_texts(app, texts);
    add_flags(app, texts, options);
    for (const std::string& flag : scene_flags(info)) app.add_option("--" + flag, texts.scene[flag]);
  } catch (const CLI::ConstructionError& error) {
    throw std::logic_error(short_name(info) + ": two flags of one name: " + error.what());
  }
  parse(info, app, argc, argv);
  read_scene(info, app, texts, options);
  read_pictures(info, app, texts, options);
  read_data(info, app, texts, options);
  read_teaching(info, app, texts, options);
  read_console(info, app, texts, options);
  options.request = request_of(texts, options.request);
  return options;
}

}  // namespace cairn
