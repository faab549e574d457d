// Holds the documents against the tree: links lead somewhere, and quoted code is code of the project.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <cairn/math/list.hpp>

namespace {

namespace fs = std::filesystem;
using cairn::List;

const fs::path document_root = CAIRN_SOURCE_DIR;

List<std::string> document_lines(const fs::path& file) {
  std::ifstream in(file);
  REQUIRE_MESSAGE(in.good(), file.string());
  List<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The documents of the project: what ends in .md, without what is built or downloaded.
List<fs::path> documents() {
  List<fs::path> files = {document_root / "README.md"};
  for (const char* folder : {"src", "lessons", "tests", "render"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(document_root / folder)) {
      if (entry.path().extension() == ".md") files.push_back(entry.path());
    }
  }
  return files;
}

}  // namespace

TEST_CASE("every link of every document leads to a file of the project") {
  const std::regex link(R"(\]\(([^)#:]+)\)|src(?:set)?="([^":]+)\")");
  int links = 0;
  for (const fs::path& file : documents()) {
    CAPTURE(file.string());
    bool is_code = false;
    for (const std::string& line : document_lines(file)) {
      if (line.rfind("```", 0) == 0) is_code = !is_code;
      if (is_code) continue;
      for (std::sregex_iterator found(line.begin(), line.end(), link), end; found != end; ++found) {
        const std::string target = (*found)[1].matched ? (*found)[1].str() : (*found)[2].str();
        CAPTURE(target);
        CHECK(fs::exists(file.parent_path() / target));
        ++links;
      }
    }
  }
  CHECK(links > 50);
}

TEST_CASE("the page on extending fits on two screens, and shows code of compiled files alone") {
  const List<std::string> page = document_lines(document_root / "src/EXTENDING.md");
  CHECK(page.size() <= 100);
  int listings = 0;
  for (int i = 1; i < page.size(); ++i) {
    if (page[i].rfind("```cpp", 0) != 0) continue;
    CAPTURE(page[i + 1]);
    CHECK(page[i - 1].rfind("<!-- source: ", 0) == 0);  // which is held against the file
    ++listings;
  }
  CHECK(listings == 2);
}

TEST_CASE("the step that README has one read is ten files of less than 1600 lines together") {
  const std::regex linked(R"(\]\((src/[^)]+)\))");
  std::set<std::string> files;
  bool is_list = false;
  for (const std::string& line : document_lines(document_root / "README.md")) {
    if (line.rfind("1. [", 0) == 0) is_list = true;
    if (line.empty() && !files.empty()) is_list = false;
    if (!is_list) continue;
    for (std::sregex_iterator found(line.begin(), line.end(), linked), end; found != end; ++found)
      files.insert((*found)[1].str());
  }
  CHECK(files.size() == 10);
  int lines = 0;
  for (const std::string& file : files) lines += document_lines(document_root / file).size();
  CHECK(lines < 1600);
}
