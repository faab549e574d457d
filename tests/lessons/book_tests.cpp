// The lesson book: pages that are whole, links that lead somewhere, pictures that the lessons drew.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "book_pages.hpp"
#include "child_lesson.hpp"
#include "html.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

/// "lesson03_sequential_impulses" of every lesson that was built.
List<std::string> built_lessons() {
  List<std::string> names;
  for (const auto& entry : fs::directory_iterator(CAIRN_BIN_DIR)) {
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, std::regex("lesson[0-9][0-9]_[a-z0-9_]+"))) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("the lesson book has a page for every lesson, under 20 MB in all") {
  const WholeBook& book = whole_book();
  if (book_is_missing(book.ran)) return;
  CAPTURE(book.ran.err);
  REQUIRE(book.ran.code == 0);
  CHECK_FALSE(fs::exists(book.folder / "unfinished"));
  for (const std::string& name : built_lessons()) {
    CAPTURE(name);
    const std::string page = name.substr(0, 8) + ".html";
    REQUIRE(book.pages.count(page) == 1);
    CHECK(book.pages.at("index.html").find("href=\"" + page + "\"") != std::string::npos);
  }
  for (const char* page :
       {"index", "conclusion", "glossary", "equations", "notation", "prerequisites", "search", "teachers"}) {
    CAPTURE(page);
    CHECK(book.pages.count(page + std::string(".html")) == 1);
  }
  std::uintmax_t size = 0;
  for (const auto& entry : fs::recursive_directory_iterator(book.folder)) {
    if (entry.is_regular_file()) size += entry.file_size();
  }
  // 400 pictures of 1280 x 720 px and 256 colours, 30 kB each, and half as much for all else.
  CHECK(size < 20'000'000);
}

TEST_CASE("every page of the lesson book is well formed, and every picture has its words") {
  for (const auto& entry : whole_book().pages) {
    const std::string& name = entry.first;
    const std::string& page = entry.second;
    CAPTURE(name);
    CHECK(nesting_error(page) == "");
    const List<std::string> ids = all_matches(page, std::regex(" id=\"([^\"]*)\""));
    CHECK(std::set<std::string>(ids.begin(), ids.end()).size() == ids.size());
    const auto pictures = all_matches(page, std::regex("<(img) "));
    const auto described =
        all_matches(page, std::regex("<img src=\"[^\"]+\" width=\"[0-9]+\" height=\"[0-9]+\" "
                                     "alt=\"([^\"]+)\"(?: loading=\"lazy\")?>"));
    CHECK(pictures.size() == described.size());
    CHECK(page.find("<!-- ") == std::string::npos);  // every comment of the texts was followed
    CHECK(all_matches(page, std::regex("<(h1)")).size() == 1);
  }
}

TEST_CASE("every link and picture of the lesson book is in the book") {
  const WholeBook& book = whole_book();
  for (const auto& entry : book.pages) {
    const std::string& name = entry.first;
    const std::string& page = entry.second;
    for (const std::string& target : all_matches(page, std::regex(" (?:href|src|srcset)=\"([^\"]*)\""))) {
      if (target.rfind("https://", 0) == 0 || target.rfind("data:", 0) == 0) continue;
      CAPTURE(name);
      CAPTURE(target);
      const std::size_t hash = target.find('#');
      const std::string file = hash == 0 ? name : target.substr(0, hash);
      CHECK(fs::is_regular_file(book.folder / file));
      if (hash == std::string::npos) continue;
      CHECK(bytes_of(book.folder / file).find(" id=\"" + target.substr(hash + 1) + "\"") !=
            std::string::npos);
    }
  }
}

TEST_CASE("the book shows what the lesson drew and printed, its text and its exercise") {
  const WholeBook& book = whole_book();
  if (book_is_missing(book.ran)) return;
  const std::string& page = book.pages.at("lesson03.html");
  const ScratchFolder out;
  const Ran ran = run_program("lesson03_sequential_impulses", {"--checks", "-o", out.path()});
  REQUIRE(ran.code == 0);
  const auto film = nlohmann::json::parse(out.text("frames.json"));
  for (const auto& frame : film["frames"]) {
    const int number = frame["frame"];
    CAPTURE(number);
    CHECK(page.find("<li id=\"frame-" + std::to_string(number) + "\" class=\"key\">") != std::string::npos);
    CHECK(page.find(frame["state"].get<std::string>()) != std::string::npos);
    CHECK(page.find("alt=\"" + frame["alt"].get<std::string>() + "\"") != std::string::npos);
  }
  CHECK(all_matches(page, std::regex("<li (id=\"frame-)")).size() == film["frames"].size());
  for (const std::string& line : all_matches(ran.out, std::regex("(CHECK .*)"))) {
    CAPTURE(line);
    CHECK(page.find(line) != std::string::npos);
  }
  CHECK(page.find("Your code begins here: some fifteen lines") != std::string::npos);      // exercise.cpp
  CHECK(page.find("its own two boxes stop approaching each other") != std::string::npos);  // README.md
  CHECK(page.find("<mfrac><mrow>") != std::string::npos);                             // (22) as a fraction
  const std::string plain = std::regex_replace(page, std::regex("<[^>]*>"), "");      // without colours
  CHECK(plain.find("double jv = row_velocity(problem, row);") != std::string::npos);  // what it quotes
}

TEST_CASE("formulas of every page are MathML, whose symbols lead to the notation, and no TeX is left") {
  for (const auto& entry : whole_book().pages) {
    CAPTURE(entry.first);
    const std::string text = without_blocks_of_code(entry.second);
    CHECK(text.find('$') == std::string::npos);
    CHECK(text.find('\\') == std::string::npos);
  }
  if (book_is_missing(whole_book().ran)) return;
  const std::string& page = whole_book().pages.at("lesson02.html");
  CHECK(page.find("<span class=\"tag\" id=\"eq-22\">(22)</span><span><math") != std::string::npos);
  CHECK(page.find("<span>what an impulse does</span>") != std::string::npos);
  CHECK(std::regex_search(page, std::regex("<mi data-symbol=\"notation.html#symbol-[0-9]+\">λ</mi>")));
  CHECK(std::regex_search(page, std::regex("<mi data-symbol=\"notation.html#symbol-[0-9]+\">Δt</mi>")));
  CHECK(whole_book().pages.at("lesson12.html").find("<mtable>") != std::string::npos);  // a matrix
}

TEST_CASE("subscripts of prose are set as such, and nothing within a formula takes the focus") {
  const std::regex raw("(^|[^A-Za-z])([A-Za-z]|[\xCC-\xCF][\x80-\xBF])_[{A-Za-z0-9]");
  for (const auto& [name, page] : whole_book().pages) {
    CAPTURE(name);
    const std::string main = page.substr(page.find("<main"));
    const std::string prose =
        std::regex_replace(without_blocks_of_code(main), std::regex("<code[^>]*>[^<]*</code>"), "");
    const std::string words = std::regex_replace(prose, std::regex("<[^>]*>"), "");
    std::smatch found;
    CHECK_MESSAGE(!std::regex_search(words, found, raw), found.str());
    for (const std::string& formula : all_matches(page, std::regex("<math[^>]*>(.*)</math>")))
      CHECK(formula.find("tabindex") == std::string::npos);
  }
  if (book_is_missing(whole_book().ran)) return;
  CHECK(whole_book().pages.at("notation.html").find("<sub>") != std::string::npos);
}

TEST_CASE("keywords, comments and numbers of code have colours of their own, and so have commands") {
  if (book_is_missing(whole_book().ran)) return;
  const std::string& page = whole_book().pages.at("lesson03.html");
  for (const std::string piece :
       {"<span class=\"dt\">double</span>", "<span class=\"cf\">for</span>",
        "<span class=\"co\">// how fast its two boxes part</span>", "<span class=\"dv\">0</span>",
        "<span class=\"fu\">bash</span>", "<span class=\"at\">--predict</span>"}) {
    CAPTURE(piece);
    CHECK(page.find(piece) != std::string::npos);
  }
}

TEST_CASE("the first use of a term on a page is a link to the glossary") {
  for (const auto& entry : whole_book().pages) {
    CAPTURE(entry.first);
    const std::regex link("<a class=\"term\" href=\"glossary.html#([^\"]*)\"");
    const List<std::string> terms = all_matches(entry.second, link);
    CHECK(std::set<std::string>(terms.begin(), terms.end()).size() == terms.size());
  }
  if (book_is_missing(whole_book().ran)) return;
  const std::string first =
      "One visit to every contact is a <em><a class=\"term\" href=\"glossary.html#sweep\" title=\"";
  CHECK(whole_book().pages.at("lesson03.html").find(first) != std::string::npos);
}

TEST_CASE("two makings of the lesson book give the same bytes, and only its own files are replaced") {
  const ScratchFolder scratch;
  const std::string driver = driver_apart(
      scratch, "tree", {"lesson02_effective_mass", "lesson03_sequential_impulses", "lesson11_friction"});
  const std::string one = scratch.path() + "/one";
  const std::string two = scratch.path() + "/elsewhere/two";
  const Ran first = make_book(scratch, driver, {one, "--frames", "cover"});
  if (book_is_missing(first)) return;
  REQUIRE(first.code == 0);
  REQUIRE(make_book(scratch, driver, {two, "--frames", "1:3"}).code == 0);
  scratch.write("elsewhere/two/mine.txt", "mine");
  scratch.write("elsewhere/two/frames/lesson_plan.png", "mine");
  for (const char* name : {"unfinished", "unfinished_mine"}) {
    fs::create_directories(two + "/" + name);
    scratch.write("elsewhere/two/" + std::string(name) + "/mine.txt", "mine");
  }
  REQUIRE(make_book(scratch, driver, {two, "--frames", "cover"}).code == 0);
  for (const char* name : {"", "/unfinished", "/unfinished_mine"})
    CHECK(scratch.text("elsewhere/two" + std::string(name) + "/mine.txt") == "mine");
  CHECK(scratch.text("elsewhere/two/frames/lesson_plan.png") == "mine");
  for (const char* name : {"/mine.txt", "/unfinished", "/unfinished_mine", "/frames/lesson_plan.png"})
    fs::remove_all(two + name);
  int files = 0;
  for (const std::string below : {"", "/frames"}) {
    CHECK(scratch.names("one" + below) == scratch.names("elsewhere/two" + below));
    for (const auto& entry : fs::directory_iterator(one + below)) {
      if (!entry.is_regular_file()) continue;
      CAPTURE(entry.path().string());
      CHECK(bytes_of(entry.path()) == bytes_of(two + below + "/" + entry.path().filename().string()));
      ++files;
    }
  }
  CHECK(files == 3 + 3 + 9 + 3 + 3 * 2);  // lessons, their notes, references, style and scripts, covers
}

TEST_CASE("a book that cannot be made says so, and is not half made") {
  const ScratchFolder scratch;
  const std::string driver = driver_apart(scratch, "tree", {"lesson03_sequential_impulses"});
  const Ran wrong = run_program(driver, {"book", scratch.path() + "/book", "--sise", "small"});
  if (book_is_missing(wrong)) return;
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("--sise") != std::string::npos);
  CHECK_FALSE(fs::exists(scratch.path() + "/book/index.html"));
  scratch.write("file", "no folder");
  const Ran blocked = run_program(driver, {"book", scratch.path() + "/file/book"});
  CHECK(blocked.code == 3);
  CHECK(blocked.err.find("/file/book") != std::string::npos);
}

TEST_CASE("a book of a lesson whose claims do not hold is made, and says so") {
  const ScratchFolder scratch;
  const std::string driver = driver_apart(scratch, "tree", {"lesson11_friction"});
  // Two sweeps leave the first step unfinished, which the lesson's text names as a run that fails.
  const Ran ran =
      run_program(driver, {"book", scratch.path() + "/book", "--frames", "cover", "--sweeps", "2"});
  if (book_is_missing(ran)) return;
  CHECK(ran.code == 1);
  CHECK(ran.err.find("check failed") != std::string::npos);
  CHECK(scratch.text("book/lesson11.html").find("FAILED") != std::string::npos);
}

}  // namespace cairn::testing
