// The command line of a lesson, read and checked.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lessons/kit/console.hpp"
#include "lessons/kit/frames.hpp"
#include "lessons/kit/lesson.hpp"
#include <cairn/math/list.hpp>

namespace cairn {

/// What the reader asked a lesson to do. Everything has been checked.
struct Options {
  enum class Request { run, help, version, about, list_params, hint };
  enum class Theme { light, dark };
  enum class Palette { color, gray };
  enum class Format { png, svg, apng };

  Request request = Request::run;
  std::map<std::string, double, std::less<>> numbers = {};       // by flag, the standard ones among them
  std::map<std::string, std::string, std::less<>> choices = {};  // by flag

  int hint = 1;
  bool predict = false;
  bool check = false;   // claims only: no frames, no files
  bool checks = false;  // every claim, in place of their number
  bool step = false;
  std::optional<List<double>> answer = {};

  std::filesystem::path out = {};
  FrameChoice frames = {};
  bool dry_run = false;
  int width = 1280;  // [px]
  int height = 720;  // [px]
  Theme theme = Theme::light;
  Palette palette = Palette::color;
  Format format = Format::png;
  std::optional<double> fps = {};  // of a film; nothing: each frame stays until its caption is read
  std::string panel = {};          // of each frame only the panel with this in its title; "": all
  bool transparent = false;        // no background
  bool text = false;               // letters of an SVG that can be searched, in place of their outlines

  std::string csv = {};     // a path; "-": stdout; "": nowhere
  std::string json = {};    // likewise
  std::string expect = {};  // 16 hexadecimal digits

  ConsoleSettings console = {};
  List<std::string> picture_flags = {};  // those that were given, to be repeated in "Again:"
};

/// The command line cannot be understood: one line for people.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// @throws UsageError, and std::logic_error when two flags of the lesson have one name.
Options read_arguments(const LessonInfo& info, int argc, const char* const* argv);

/// The card of a run: without its question where that is about other values. card() loses it, too.
LessonInfo card_for(const LessonInfo& info, const Options& options);

/// "lesson03".
std::string short_name(const LessonInfo& info);
/// "lesson03_sequential_impulses".
std::string program_name(const LessonInfo& info);
/// What a reader types: "bash lessons/run 3".
std::string typed_command(const LessonInfo& info);
/// "01" to "99".
std::string two_digits(int number);

/// The flags that every lesson has, without the dashes.
const List<std::string>& common_flags();

}  // namespace cairn
