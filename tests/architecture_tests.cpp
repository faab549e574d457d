// Holds the sources against the floors: who may include whom, how long a file may be, how it begins.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include <cairn/math/list.hpp>

namespace {

using cairn::List;

// The rooms of src and their floors. A room may include itself and every room on a lower floor; collision may
// also name the bodies of dynamics, which stands beside it. The core, which is installed, ends with measure.
const std::map<std::string, int> floor_of_room = {
    {"math", 0},    {"geometry", 1},  {"dynamics", 2},   {"collision", 2}, {"constraints", 3},
    {"solvers", 4}, {"world", 5},     {"measure", 6},    {"reference", 7}, {"device", 7},
    {"samples", 7}, {"scenes", 8},    {"validation", 8}, {"study", 9},
};
const int last_floor_of_the_core = 6;

struct SourceLine {
  int number = 0;
  std::string text = {};
};

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

std::string first_folder(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::string without_first_folder(const std::string& path) { return path.substr(path.find('/') + 1); }

// "src/constraints/row.hpp" -> "constraints"; "src/cairn.hpp" -> "".
std::string room_of(const std::string& file) { return first_folder(without_first_folder(file)); }

// Folders of solvers: what all of them share lies in none, and the exact methods may begin with a sweep.
std::string including_within_solvers(const std::string& file, const std::string& target) {
  const std::string from = first_folder(without_first_folder(without_first_folder(file)));
  const std::string to = first_folder(without_first_folder(target));
  if (to.empty() || to == from) return "";
  return from == "exact" && to == "iterative" ? ""
                                              : "what solvers share must not know those in solvers/" + to;
}

// Folders of the study: frozen problems know nothing of runs, and runs nothing of those who compare them.
std::string including_within_study(const std::string& file, const std::string& target) {
  const std::map<std::string, int> order = {{"frozen", 0}, {"", 1}, {"tuning", 2}, {"extremes", 3}};
  const std::string from = first_folder(without_first_folder(without_first_folder(file)));
  const std::string to = first_folder(without_first_folder(target));
  return order.at(to) <= order.at(from) ? "" : "study/" + from + " must not look up at study/" + to;
}

std::string including_from_a_room(const std::string& file, const std::string& target) {
  const std::string room = room_of(file), other = first_folder(target);
  const auto from = floor_of_room.find(room), to = floor_of_room.find(other);
  if (from == floor_of_room.end()) return room + " is no room of src";
  if (to == floor_of_room.end()) return "there is no room " + other + " on the floors of src";
  if (room == other && room == "study") return including_within_study(file, target);
  if (room == other) return room == "solvers" ? including_within_solvers(file, target) : "";
  const std::set<std::string> of_a_step = {"constraints/row.hpp", "constraints/row_rule.hpp",
                                           "constraints/converted.hpp", "constraints/contact.hpp",
                                           "constraints/contact_rows.hpp"};
  if (room == "solvers" && other == "constraints" && !of_a_step.contains(target)) {
    return "solvers see rows and contacts only: constraints/row.hpp, row_rule.hpp, contact.hpp, "
           "contact_rows.hpp";
  }
  if (room == "collision" && other == "dynamics") return "";
  return to->second < from->second ? "" : room + " must not look up or sideways at " + other;
}

// `render` draws values: vectors, shapes, snapshots and tables.
std::string including_from_render(const std::string& target) {
  const std::string other = first_folder(target);
  const bool is_of_src = floor_of_room.count(other) != 0 || target == "cairn.hpp";
  const bool is_seen = other == "math" || other == "geometry" || target == "world/snapshot.hpp" ||
                       target == "measure/csv.hpp" || target == "measure/whole_file.hpp";
  if (is_of_src && !is_seen) {
    return "render sees math, geometry, world/snapshot.hpp, measure/csv.hpp and measure/whole_file.hpp only";
  }
  if (other == "lessons" || other == "tests") return "render must not look up at " + other;
  return "";
}

// Why `file` (relative to the project) must not include the project's header `target`; empty when it may.
std::string objection(const std::string& file, const std::string& target) {
  if (begins_with(file, "render/")) return including_from_render(target);
  if (!begins_with(file, "src/")) return "";
  if (begins_with(target, ".")) return "paths in src begin with the room";
  if (file != "src/cairn.hpp") return including_from_a_room(file, target);
  const auto floor = floor_of_room.find(first_folder(target));
  return floor != floor_of_room.end() && floor->second <= last_floor_of_the_core
             ? ""
             : "the core ends with measure";
}

// The same for the header of a library: Box2D has one place, and one where it is a peer; physics never knows
// that pictures exist.
std::string objection_to_library(const std::string& file, const std::string& target) {
  if (begins_with(target, "box2d/")) {
    const bool has_place = begins_with(file, "src/reference/") || begins_with(file, "tests/bench/peers/");
    return has_place ? "" : "Box2D is included in src/reference and tests/bench/peers only";
  }
  const std::string library = first_folder(target);
  if (library == "toml++") {
    return begins_with(file, "src/scenes/") ? "" : "toml++ is included in src/scenes only";
  }
  const auto floor = floor_of_room.find(room_of(file));
  const bool is_a_study = floor != floor_of_room.end() && floor->second == floor_of_room.at("study");
  if (library == "nlohmann" && is_a_study) return "";
  if (room_of(file) == "device" && library == "CL") return "";
  const bool is_of_the_core = library.empty() || library == "Eigen" || library == "fmt";
  return is_of_the_core || !begins_with(file, "src/") ? "" : "the core needs Eigen and fmt, not " + library;
}

List<SourceLine> lines_of(const std::filesystem::path& path) {
  List<SourceLine> lines;
  std::ifstream stream(path);
  for (std::string text; std::getline(stream, text);) {
    lines.push_back({.number = lines.size() + 1, .text = text});
  }
  return lines;
}

// Objections to the includes in the lines of `file`, each with its place.
List<std::string> objections_to(const std::string& file, const List<SourceLine>& lines) {
  List<std::string> found;
  for (const SourceLine& line : lines) {
    const std::string directive = "#include ";
    if (!begins_with(line.text, directive) || line.text.size() < directive.size() + 2) continue;
    const char opening = line.text[directive.size()];
    const std::size_t begin = directive.size() + 1;
    const std::size_t end = line.text.find(opening == '<' ? '>' : '"', begin);
    const std::string target = line.text.substr(begin, end - begin);
    const std::string of_src = begins_with(target, "cairn/") ? target.substr(6) : target;
    const bool is_library = opening == '<' && of_src == target;
    const std::string reason = is_library ? objection_to_library(file, target) : objection(file, of_src);
    if (reason.empty()) continue;
    found.push_back(file + ":" + std::to_string(line.number) + " includes " + of_src + ": " + reason);
  }
  return found;
}

// Why the first line of a file of src is not the head comment it should be; empty when it is.
std::string objection_to_head(const std::string& file, const std::string& first_line) {
  if (file == "src/cairn.hpp") return begins_with(first_line, "// ") ? "" : "should begin with a comment";
  const auto floor = floor_of_room.find(room_of(file));
  if (floor == floor_of_room.end()) return "is in no room of src";
  const std::string head = "// Floor " + std::to_string(floor->second) + ". ";
  const bool is_head = begins_with(first_line, head) && first_line.size() > head.size();
  return is_head ? "" : "should begin with \"" + head + "\" and what the file is for";
}

List<std::string> source_files(const List<std::string>& folders) {
  const std::filesystem::path root = CAIRN_SOURCE_DIR;
  List<std::string> files;
  for (const std::string& folder : folders) {
    if (!std::filesystem::exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".hpp" && extension != ".cpp") continue;
      files.push_back(std::filesystem::relative(entry.path(), root).generic_string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

List<SourceLine> lines_of_source(const std::string& file) {
  return lines_of(std::filesystem::path(CAIRN_SOURCE_DIR) / file);
}

const int longest_file = 300;

std::string objection_to_length(const std::string& file, int lines) {
  return lines <= longest_file ? "" : file + " has " + std::to_string(lines) + " lines: one idea per file";
}

}  // namespace

TEST_CASE("every file of the project includes only what its floor may see") {
  const List<std::string> files = source_files({"src", "render", "lessons", "tests"});
  int includes = 0;
  for (const std::string& file : files) {
    const List<SourceLine> lines = lines_of_source(file);
    for (const SourceLine& line : lines) includes += line.text.find("#include <cairn/") == 0 ? 1 : 0;
    for (const std::string& found : objections_to(file, lines)) FAIL_CHECK(found);
  }
  CHECK(includes > files.size());  // the sources were found and read: a file includes more than one other
}

TEST_CASE("an include that breaks the floors is found, with its file and line") {
  const auto found =
      objections_to("src/constraints/made_up.hpp", {{.number = 1, .text = "#pragma once"},
                                                    {.number = 2, .text = "#include <vector>"},
                                                    {.number = 3, .text = "#include <fmt/format.h>"},
                                                    {.number = 4, .text = "#include <cairn/math/math.hpp>"},
                                                    {.number = 7, .text = "#include <cairn/world/plan.hpp>"}});
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "src/constraints/made_up.hpp:7 includes world/plan.hpp: constraints must not look up or sideways at "
        "world");
  const SourceLine box2d = {.number = 5, .text = "#include <box2d/box2d.h>"};
  CHECK(objections_to("src/world/made_up.cpp", {box2d}).size() == 1);
  CHECK(objections_to("tests/reference/made_up.cpp", {box2d}).size() == 1);
  CHECK(objections_to("src/reference/made_up.cpp", {box2d}).empty());
  CHECK(objections_to("src/world/made_up.cpp", {{.number = 1, .text = "#include <GL/osmesa.h>"}}).size() ==
        1);
  const SourceLine toml = {.number = 1, .text = "#include <toml++/toml.h>"};
  CHECK(objections_to("src/scenes/made_up.cpp", {toml}).empty());
  CHECK(objections_to("src/study/made_up.cpp", {toml}).size() == 1);
  CHECK(objections_to("src/world/made_up.cpp", {toml}).size() == 1);
  CHECK(objections_to("lessons/sandbox/made_up.cpp", {toml}).size() == 1);
}

TEST_CASE("each rule of the floors allows what it should and refuses what it should") {
  CHECK(objection("src/math/a.hpp", "math/check.hpp").empty());
  CHECK_FALSE(objection("src/math/a.hpp", "geometry/shape.hpp").empty());
  CHECK(objection("src/collision/a.hpp", "dynamics/body.hpp").empty());
  CHECK_FALSE(objection("src/dynamics/a.hpp", "collision/manifold.hpp").empty());
  CHECK(objection("src/solvers/a.hpp", "constraints/row.hpp").empty());
  CHECK(objection("src/solvers/a.hpp", "constraints/contact.hpp").empty());
  CHECK_FALSE(objection("src/solvers/a.hpp", "constraints/constraint.hpp").empty());
  CHECK_FALSE(objection("src/world/a.hpp", "measure/csv.hpp").empty());
  CHECK(objection("src/measure/a.hpp", "world/snapshot.hpp").empty());
  CHECK_FALSE(objection("src/measure/a.hpp", "reference/box2d_world.hpp").empty());
  CHECK_FALSE(objection("src/measure/a.hpp", "render/canvas.hpp").empty());
  CHECK_FALSE(objection("src/measure/a.hpp", "../world/world.hpp").empty());
  CHECK_FALSE(objection("src/attic/a.hpp", "math/math.hpp").empty());
  CHECK(objection("src/reference/a.hpp", "world/scene.hpp").empty());
  CHECK(objection("src/solvers/exact/a.hpp", "solvers/iterative/b.hpp").empty());
  CHECK(objection("src/solvers/exact/a.hpp", "solvers/solver.hpp").empty());
  CHECK_FALSE(objection("src/solvers/iterative/a.hpp", "solvers/exact/b.hpp").empty());
  CHECK_FALSE(objection("src/solvers/a.hpp", "solvers/iterative/b.hpp").empty());
  CHECK(objection("src/study/a.hpp", "scenes/scene_file.hpp").empty());
  CHECK(objection("src/study/tuning/a.hpp", "study/trial.hpp").empty());
  CHECK_FALSE(objection("src/study/a.hpp", "study/extremes/extreme.hpp").empty());
  CHECK_FALSE(objection("src/scenes/a.hpp", "study/trial.hpp").empty());
  CHECK_FALSE(objection("src/measure/a.hpp", "reference/box2d_world.hpp").empty());
  CHECK_FALSE(objection("src/cairn.hpp", "reference/box2d_world.hpp").empty());
  for (const char* seen : {"math/math.hpp", "geometry/shape.hpp", "world/snapshot.hpp", "measure/csv.hpp",
                           "measure/whole_file.hpp"}) {
    CHECK(objection("render/a.hpp", seen).empty());
  }
  for (const char* unseen : {"world/world.hpp", "measure/energy.hpp", "solvers/solver.hpp", "cairn.hpp"}) {
    CHECK_FALSE(objection("render/a.hpp", unseen).empty());
  }
  CHECK(objection("render/a.hpp", "canvas.hpp").empty());
  CHECK(objection("lessons/00_one_body/lesson.cpp", "cairn.hpp").empty());
}

TEST_CASE("no file has more than 300 lines") {
  const List<std::string> files = source_files({"src", "render", "lessons", "tests"});
  CHECK(std::count(files.begin(), files.end(), "tests/architecture_tests.cpp") == 1);
  for (const std::string& file : files) CHECK(objection_to_length(file, lines_of_source(file).size()) == "");
  CHECK(objection_to_length("made_up.cpp", longest_file).empty());
  CHECK_FALSE(objection_to_length("made_up.cpp", longest_file + 1).empty());
}

TEST_CASE("every file of the core says on its first line on which floor it is, and what it is for") {
  const List<std::string> files = source_files({"src"});
  CHECK(std::count(files.begin(), files.end(), "src/cairn.hpp") == 1);
  for (const std::string& file : files) {
    const List<SourceLine> lines = lines_of_source(file);
    const std::string found = lines.empty() ? "is empty" : objection_to_head(file, lines.front().text);
    CHECK_MESSAGE(found.empty(), file, " ", found);
  }
  CHECK(objection_to_head("src/solvers/a.hpp", "// Floor 4. Rows, solved.").empty());
  CHECK_FALSE(objection_to_head("src/solvers/a.hpp", "// Floor 3. Rows, solved.").empty());
  CHECK_FALSE(objection_to_head("src/solvers/a.hpp", "// Floor 4. ").empty());
  CHECK_FALSE(objection_to_head("src/reference/a.hpp", "// Beside floor 6. Box2D.").empty());
  CHECK_FALSE(objection_to_head("src/cairn.hpp", "#pragma once").empty());
}
