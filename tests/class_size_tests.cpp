// Holds every class of the core against the most that a reader can keep in mind: public functions and
// members.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <cairn/math/list.hpp>

namespace {

using cairn::List;

const int most_functions = 12;
const int most_members = 15;

struct ClassSize {
  std::string name = {};
  bool is_struct = false;
  List<std::string> functions = {};       // public ones, those of one name each; overrides are the base's
  int members = 0;                        // with those of a struct within it that it has one of
  std::map<std::string, int> parts = {};  // the members of each struct within it
};

/// A line without its comment, and without what lies inside <>, () and {} but for the first (.
std::string outline_of(std::string text) {
  text = text.substr(0, text.find("//"));
  std::string kept;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_arrow = c == '>' && i > 0 && text[i - 1] == '-';
    if ((c == '>' || c == ')' || c == '}') && !is_arrow) depth = std::max(depth - 1, 0);
    if (depth == 0) kept += c;
    if (c == '<' || c == '(' || c == '{') ++depth;
  }
  return kept;
}

/// Takes in one declaration of a class.
void take_declaration(const std::string& text, bool is_public, ClassSize& size) {
  static const std::regex no_member("(using|friend|static|enum|class|struct|typedef|explicit)\\b.*|[~#}@].*");
  const std::string line = outline_of(text);
  if (line.empty() || line.find("operator") != std::string::npos || std::regex_match(line, no_member)) return;
  const std::size_t paren = line.find('('), end = std::min(line.find('='), line.find('{'));
  const bool is_function = paren != std::string::npos && paren < end && text.find("(*") == std::string::npos;
  if (!is_function) {
    const auto part = size.parts.find(line.substr(0, line.find(' ')));
    const int each = part == size.parts.end() ? 1 : part->second;
    size.members += each * (1 + static_cast<int>(std::count(line.begin(), line.end(), ',')));
    return;
  }
  std::smatch name;
  const std::string before = line.substr(0, paren);
  if (!is_public || text.find("override") != std::string::npos ||
      before.find("operator") != std::string::npos)
    return;
  if (std::regex_search(before, name, std::regex("(\\w+)$")) && name[1] != size.name)
    size.functions.push_back(name[1]);
}

std::set<std::string> names_of(const ClassSize& size) {
  return {size.functions.begin(), size.functions.end()};
}

/// Containers of several kinds of things, which add, change and remove each: their overloads count once, as
/// they do the same to different things (C++ Core Guidelines, C.162).
bool is_container(const std::string& name) {
  return name == "Scene"            // of bodies, joints, events and rules
         || name == "SceneJoints";  // of joints and what holds them, read as a range
}

/// The classes of a header, which is laid out as clang-format does: members stand two columns in.
List<ClassSize> classes_of(const std::filesystem::path& file) {
  struct Open {
    ClassSize size;
    std::size_t indent = 0;
    bool is_public = false;
    std::string text = {};  // of a declaration that goes on
  };
  static const std::regex begins("( *)(class|struct) (?:alignas\\(\\d+\\) )?(\\w+)[^;]*\\{(?: *//.*)?");
  static const std::regex access(" *(public|private|protected):.*");
  List<ClassSize> classes;
  List<Open> open;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos || line.compare(indent, 2, "//") == 0) continue;
    while (!open.empty() && indent <= open.back().indent && line[indent] == '}') {
      classes.push_back(open.back().size);
      open.pop_back();
      if (!open.empty()) open.back().size.parts[classes.back().name] = classes.back().members;
    }
    if (std::regex_match(line, match, begins)) {
      const bool is_struct = match[2] == "struct";
      open.push_back({{match[3], is_struct}, indent, is_struct});
    } else if (!open.empty() && std::regex_match(line, match, access)) {
      open.back().is_public = match[1] == "public";
    } else if (!open.empty() && indent >= open.back().indent + 2) {
      Open& at = open.back();
      if (indent == at.indent + 2 && line.compare(indent, 8, "template") == 0) continue;
      if (indent > at.indent + 2 && at.text.empty()) continue;  // inside the body of a function
      at.text += (at.text.empty() ? "" : " ") + line.substr(indent).substr(0, line.substr(indent).find("//"));
      const char last = at.text[at.text.find_last_not_of(' ')];
      if (last != ';' && last != '{' && last != '}') continue;
      take_declaration(at.text, at.is_public, at.size);
      at.text.clear();
    }
  }
  return classes;
}

}  // namespace

TEST_CASE("no class of the core has more public functions or members than a reader keeps in mind") {
  for (const char* const room : {"world", "solvers", "collision", "constraints", "scenes"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(CAIRN_SOURCE_DIR "/src/") + room)) {
      if (entry.path().extension() != ".hpp") continue;
      for (const ClassSize& size : classes_of(entry.path())) {
        CAPTURE(size.name);
        const auto functions = is_container(size.name) ? names_of(size).size() : size.functions.size();
        CHECK(static_cast<int>(functions) <= most_functions);
        CHECK(size.members <= most_members);
      }
    }
  }
}

TEST_CASE("functions and members of a class are counted as they are read") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "cairn_class_size.hpp";
  std::ofstream(file)
      << "template <typename T>\nclass Two : public One {\n public:\n  explicit Two(int size);\n"
         "  /// Says.\n  int say() const;\n  int say(int many,\n          int times) const {\n"
         "    int none = 0;\n    return none;\n  }\n  void heard() override;\n"
         "  std::map<int, int> all(int a) const { return {}; }\n\n private:\n"
         "  struct Part {\n    int one = 1, two = 2;\n  };\n\n  void hide();\n"
         "  std::function<void(int)> first_;  // of (two)\n  int second_ = 0, third_ = 1;\n  Part part_;\n"
         "  static int none_;\n};\n";
  const List<ClassSize> classes = classes_of(file);
  std::filesystem::remove(file);
  REQUIRE(classes.size() == 2);
  CHECK(classes[0].name == "Part");
  CHECK(classes[0].members == 2);
  CHECK(classes[1].functions == List<std::string>{"say", "say", "all"});
  CHECK(names_of(classes[1]) == std::set<std::string>{"all", "say"});
  CHECK(classes[1].members == 5);
}
