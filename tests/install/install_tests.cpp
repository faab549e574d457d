// What `cmake --install` gives, used as somebody else would: installs this build into a scratch folder, and
// configures, compiles and runs the programs of tests/install/user with it.
#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "installed.hpp"
#include <cairn/math/list.hpp>

namespace {

using cairn::List;
using namespace cairn::testing;

namespace fs = std::filesystem;

const std::string user_folder = std::string(CAIRN_SOURCE_DIR) + "/tests/install/user";

fs::path installed_and_moved(const fs::path& folder) { return installed_component(folder, "library"); }

/// The first file of this name below a folder; empty when there is none.
fs::path file_named(const fs::path& folder, const std::string& name) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().filename() == name) return entry.path();
  }
  return {};
}

/// Configures what is in a folder, as this build was.
std::string configure_line(const std::string& source, const fs::path& build) {
  return quoted(CAIRN_CMAKE) + " -S " + quoted(source) + " -B " + quoted(build.string()) + " -G " +
         quoted(CAIRN_GENERATOR) + " " + quoted("-DCMAKE_MAKE_PROGRAM=" + std::string(CAIRN_MAKE)) + " " +
         quoted("-DCMAKE_CXX_COMPILER=" + std::string(CAIRN_COMPILER));
}

/// The number that the user's program prints behind "newtons: "; NaN where it does not.
double printed_newtons(const fs::path& folder, const fs::path& program) {
  const CommandResult result = run_line(folder, quoted(program.string()));
  require_success(result);
  REQUIRE(result.output.rfind("newtons: ", 0) == 0);
  return std::strtod(result.output.c_str() + 9, nullptr);
}

// The weight of the user's box [N]. Its program prints six digits, of which the last is worth 1e-4 N; sweeps
// and steps leave far less, as the box stands still from the first step on.
const double weight_of_box = 2.0 * 10.0;
const double last_printed_digit = 1e-4;

/// The headers below a folder, by their paths in it, sorted.
List<std::string> headers_below(const fs::path& root, const fs::path& folder) {
  List<std::string> headers;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".hpp") headers.push_back(entry.path().lexically_relative(root).string());
  }
  std::sort(headers.begin(), headers.end());
  return headers;
}

/// Whether a path in the text begins with this folder. In other paths its name may well be, as in
/// include/cairn.
bool names_folder(const std::string& text, const std::string& folder) {
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at + 1)) {
    if (at == 0 || std::string(" \t\n\"'=;:(").find(text[at - 1]) != std::string::npos) return true;
  }
  return false;
}

List<std::string> public_headers() {
  const fs::path source = fs::path(CAIRN_SOURCE_DIR) / "src";
  List<std::string> headers = {"cairn.hpp"};
  std::istringstream rooms(CAIRN_PUBLIC_ROOMS);
  for (std::string room; std::getline(rooms, room, ',');) {
    for (const std::string& header : headers_below(source, source / room)) headers.push_back(header);
  }
  std::sort(headers.begin(), headers.end());
  return headers;
}

}  // namespace

TEST_CASE("what is installed has every public header and names no folder of the tree it came from") {
  const fs::path prefix = installed_and_moved(scratch("files"));
  const fs::path include = prefix / "include" / "cairn";
  CHECK(headers_below(include, include) == public_headers());

  int descriptions = 0;
  for (const auto& entry : fs::recursive_directory_iterator(prefix)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cmake" && extension != ".pc") continue;
    ++descriptions;
    INFO(entry.path().string());
    const std::string text = text_of(entry.path());
    CHECK_FALSE(names_folder(text, CAIRN_SOURCE_DIR));
    CHECK_FALSE(names_folder(text, CAIRN_BINARY_DIR));
    CHECK(text.find("-Wall") == std::string::npos);
    CHECK(text.find("-Werror") == std::string::npos);
  }
  CHECK(descriptions >= 5);  // the package, its version, its targets, those of one build type, and cairn.pc
}

TEST_CASE("a build without the archives installs nothing, and says what to do") {
  const fs::path folder = scratch("unbuilt");
  const fs::path build = folder / "build";
  require_success(
      run_line(folder, configure_line(CAIRN_SOURCE_DIR, build) + " -DCMAKE_CXX_FLAGS_RELEASE=-O1"));
  CHECK(text_of(build / "CMakeCache.txt").find("CMAKE_CXX_FLAGS_RELEASE:STRING=-O1\n") != std::string::npos);
  const CommandResult result = run_line(folder, quoted(CAIRN_CMAKE) + " --install " + quoted(build.string()) +
                                                    " --prefix " + quoted((folder / "prefix").string()));
  CHECK(result.code == 1);
  CHECK(result.output.find("libcairn.a is not built") != std::string::npos);
  CHECK(result.output.find("cmake --build") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "prefix"));
}

TEST_CASE("a program outside of the tree finds the installed library with CMake and computes with it") {
  const fs::path folder = scratch("with_cmake");
  const fs::path prefix = installed_and_moved(folder);
  const fs::path build = folder / "build";
  std::string configure =
      configure_line(user_folder, build) + " " + quoted("-DCMAKE_PREFIX_PATH=" + prefix.string());
#ifdef CAIRN_HAVE_BOX2D
  configure += " -DBOX2D=ON";
#endif
  require_success(run_line(folder, configure));
  require_success(run_line(folder, quoted(CAIRN_CMAKE) + " --build " + quoted(build.string()) + " -j 2"));
  CHECK(std::abs(printed_newtons(folder, build / "resting_box") - weight_of_box) < last_printed_digit);
#ifdef CAIRN_HAVE_BOX2D
  // Box2D computes in float: impulses of 1/3 N s in 1/60 s, to some roundings of 2^-24.
  CHECK(std::abs(printed_newtons(folder, build / "second_opinion") - weight_of_box) < 1e-3);
#endif
}

TEST_CASE(
    "Cairn is a part of another project: its library alone, and nothing that the project has not chosen") {
  const fs::path folder = scratch("as_a_part"), build = folder / "build";
  require_success(run_line(folder, configure_line(user_folder, build) + " " +
                                       quoted("-DCAIRN_SOURCE=" + std::string(CAIRN_SOURCE_DIR)) +
                                       " -DCMAKE_CXX_FLAGS=-Werror=old-style-cast"));
  const std::string cache = text_of(build / "CMakeCache.txt");
  CHECK(cache.find("CMAKE_BUILD_TYPE:STRING=\n") != std::string::npos);
  CHECK(cache.find("CMAKE_CXX_FLAGS_DEBUG:STRING=-g\n") != std::string::npos);
  CHECK(cache.find("BUILD_TESTING") == std::string::npos);
  const std::string make = quoted(CAIRN_CMAKE) + " --build " + quoted(build.string());
  const CommandResult targets = run_line(folder, make + " --target help");
  require_success(targets);
  CHECK(targets.output.find("cairn_world") != std::string::npos);
  for (const char* other : {"cairn_render", "cairn_scenes", "lesson", "tests", "images"})
    CHECK(targets.output.find(other) == std::string::npos);
  // The library is compiled in minutes; what uses it shows whether its headers are found and its flags are
  // let be.
  require_success(run_line(folder, make + " --target CMakeFiles/resting_box.dir/resting_box.cpp.o"));
  const CommandResult commands = run_line(folder, make +
                                                      " --target CMakeFiles/resting_box.dir/resting_box.cpp.o"
                                                      " --clean-first --verbose");
  require_success(commands);
  CHECK(commands.output.find("-ffp-contract=off") != std::string::npos);
  CHECK(commands.output.find("-Wconversion") == std::string::npos);
}

TEST_CASE("pkg-config says what compiles the same program, without a warning, and links it") {
  const fs::path folder = scratch("with_pkg_config");
  if (run_line(folder, "pkg-config --version").code != 0) {
    MESSAGE("left out: there is no pkg-config here");
    return;
  }
  const fs::path prefix = installed_and_moved(folder);
  const fs::path description = file_named(prefix, "cairn.pc");
  REQUIRE_FALSE(description.empty());
  const std::string program = (folder / "resting_box").string();
  const std::string flags = "$(PKG_CONFIG_PATH=" + quoted(description.parent_path().string()) +
                            " pkg-config --cflags --libs cairn)";
  require_success(run_line(folder, quoted(CAIRN_COMPILER) + " -Wall -Wextra -Werror -o " + quoted(program) +
                                       " " + quoted(user_folder + "/resting_box.cpp") + " " + flags));
  CHECK(std::abs(printed_newtons(folder, program) - weight_of_box) < last_printed_digit);
}

TEST_CASE("the reference documents every public name, and Doxygen reads all of it without a warning") {
#ifdef CAIRN_DOXYGEN
  const fs::path folder = scratch("reference");
  const CommandResult result = run_line(
      folder, quoted(CAIRN_DOXYGEN) + " " + quoted((fs::path(CAIRN_BINARY_DIR) / "Doxyfile").string()));
  INFO(result.output);
  CHECK(result.code == 0);
  CHECK(result.output.empty());
#else
  MESSAGE("left out: there is no Doxygen here");
#endif
}
