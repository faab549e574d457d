// Pictures that must stay as they are. The rule: same size, and no channel of any pixel further than 2 from
// the golden picture, with no exceptions: a missing arrow is few pixels. Drivers that round differently stay
// within 2.
#pragma once

#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <string>
#include <system_error>

#include "render/image.hpp"

namespace cairn::test {
namespace golden {

inline constexpr int tolerance = 2;  // of one channel, 0..255

enum class Mode { compare, renew };

/// Where the golden pictures lie, and where the evidence of a failure goes.
struct Place {
  std::filesystem::path goldens = {};
  std::filesystem::path failures = {};
  Mode mode = Mode::compare;
};

/// `tests/images` and, beside the test program, `golden_failures`; CAIRN_UPDATE_GOLDENS=1 renews.
inline Place default_place() {
  std::error_code error;
  std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) program = std::filesystem::temp_directory_path() / "cairn_tests";
  const char* const update = std::getenv("CAIRN_UPDATE_GOLDENS");
  return {.goldens = std::filesystem::path(CAIRN_SOURCE_DIR) / "tests" / "images",
          .failures = program.parent_path() / "golden_failures",
          .mode = update != nullptr && std::string(update) == "1" ? Mode::renew : Mode::compare};
}

/// `name` may name folders: "lessons/03_first_row".
struct Files {
  std::filesystem::path golden = {}, actual = {}, difference = {};
};

inline Files files_of(const Place& place, const std::string& name) {
  return {.golden = place.goldens / (name + ".png"),
          .actual = place.failures / (name + "_actual.png"),
          .difference = place.failures / (name + "_difference.png")};
}

inline std::string advice() {
  return "\n  Is the new picture right? Then keep it as the golden one: bash tests/run --update";
}

/// Compares with the file and leaves the actual picture and the difference on disk when they do not agree.
inline std::string objection_to_pixels(const Files& files, const std::string& name,
                                       const render::Image& actual) {
  const render::Image expected = render::read_png(files.golden);
  const render::ImageDifference found = render::compare(expected, actual);
  if (found.same_size && found.largest <= tolerance) return "";
  const auto size = [](const render::Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
  };
  render::write_png(files.actual, actual);
  render::write_png(files.difference, render::difference_image(expected, actual, tolerance));
  std::string what = "is " + size(actual) + " pixels, the golden one " + size(expected);
  if (found.same_size) {
    what = "largest difference of a channel " + std::to_string(found.largest) + ", allowed " +
           std::to_string(tolerance) + "; pixels that differ at all: " + std::to_string(found.differing);
  }
  return "picture " + name + ": " + what + "\n  golden:     " + files.golden.string() +
         "\n  actual:     " + files.actual.string() + "\n  difference: " + files.difference.string() +
         advice();
}

/// Why `actual` is not the golden picture, and what to do; empty when it is. Renewing writes it instead.
inline std::string objection(const Place& place, const std::string& name, const render::Image& actual) {
  const Files files = files_of(place, name);
  for (const std::filesystem::path& old : {files.actual, files.difference}) std::filesystem::remove(old);
  if (place.mode == Mode::renew) {
    std::filesystem::create_directories(files.golden.parent_path());
    render::write_png(files.golden, actual);
    return "";
  }
  std::filesystem::create_directories(files.actual.parent_path());
  if (std::filesystem::exists(files.golden)) return objection_to_pixels(files, name, actual);
  render::write_png(files.actual, actual);
  return "picture " + name + ": there is no golden picture yet\n  golden:     " + files.golden.string() +
         "\n  actual:     " + files.actual.string() + advice();
}

}  // namespace golden

/// Fails the running test case unless `actual` agrees with the golden picture `name`.
inline void check_golden(const golden::Place& place, const std::string& name, const render::Image& actual) {
  const std::string found = golden::objection(place, name, actual);
  if (!found.empty()) FAIL_CHECK(found);
}

/// The same for tests/images/<name>.png.
inline void check_golden(const std::string& name, const render::Image& actual) {
  check_golden(golden::default_place(), name, actual);
}

}  // namespace cairn::test
