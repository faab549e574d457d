// What a page says before its fold asks, and what it says behind it answers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "child_lesson.hpp"
#include "lessons/kit/card.hpp"
#include <cairn/math/list.hpp>

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;
using Words = List<std::string>;

constexpr const char* fold = "\n<!-- fold -->\n";

/// "03_sequential_impulses".
std::string folder_of(const LessonInfo& card) {
  return (card.number < 10 ? "0" : "") + std::to_string(card.number) + "_" + card.name;
}

std::string readme_of(const LessonInfo& card) {
  std::ifstream in(fs::path(CAIRN_SOURCE_DIR) / "lessons" / folder_of(card) / "README.md", std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// In small letters, with one blank wherever there are blanks, ends of lines or nothing but markup; lowered
/// digits as TeX has them.
std::string evened(std::string text) {
  for (const char digit : {'1', '2', '3'}) {
    const std::string lowered = std::string("\xE2\x82") + static_cast<char>('\x80' + (digit - '0'));
    for (std::size_t at = 0; (at = text.find(lowered, at)) != std::string::npos;)
      text.replace(at, 3, {'_', digit});
  }
  std::string result = " ";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '*' || c == '`' || c == '{' || c == '}' || c == '$' || c == '\\') continue;
    if (std::isspace(byte) == 0) {
      result += static_cast<char>(std::tolower(byte));
    } else if (result.back() != ' ') {
      result += ' ';
    }
  }
  return result + " ";
}

/// "30" stands in "of 30 N." but not in "130" or "30.5".
bool stands_in(const std::string& word, const std::string& text) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  std::string wanted = evened(word);
  wanted = wanted.substr(1, wanted.size() - 2);
  const std::string whole = evened(text);
  for (std::size_t at = whole.find(wanted); at != std::string::npos; at = whole.find(wanted, at + 1)) {
    const char before = whole[at - 1];
    const std::size_t end = at + wanted.size();
    const bool goes_on = is_part(whole[end]) || (whole[end] == '.' && is_part(whole[end + 1]));
    if (!is_part(before) && before != '.' && !goes_on) return true;
  }
  return false;
}

std::string all_of(const nlohmann::json& words) {
  std::string text;
  for (const nlohmann::json& word : words) text += word.get<std::string>() + " ";
  return text;
}

/// What somebody sees of a lesson before its fold, by place.
std::map<std::string, std::string> before_fold(const LessonInfo& card, const std::string& text) {
  const ScratchFolder folder;
  REQUIRE(run_program("lesson" + folder_of(card), {"-q", "--frames", "cover", "-o", folder.path()}).code ==
          0);
  const auto cover = nlohmann::json::parse(folder.text("frames.json"))["frames"][0];
  return {{"the page before its fold", text.substr(0, text.find(fold))},
          {"the card's idea", card.idea},
          {"the card's question", card.question},
          {"the cover's alt text", cover.at("alt")},
          {"the cover's words", cover.at("state").get<std::string>() + " " + all_of(cover.at("words"))}};
}

Words headings_of(const std::string& text) {
  static const std::regex heading("\n## ([^\n]*)");
  Words headings;
  for (std::sregex_iterator found(text.begin(), text.end(), heading), end; found != end; ++found)
    headings.push_back((*found)[1].str());
  return headings;
}

void check_order(const std::string& text) {
  const Words headings = headings_of(text);
  std::size_t last = 0;
  for (const char* name :
       {"The question", "The answer", "What to look at", "Run it", "Your turn", "Read on"}) {
    CAPTURE(name);
    const auto found = std::find(headings.begin(), headings.end(), name);
    REQUIRE(found != headings.end());
    const auto at = static_cast<std::size_t>(found - headings.begin());
    CHECK(at >= last);
    last = at;
  }
  CHECK(headings[0] == "The question");
  CHECK(headings[1] == "The answer");
  CHECK((text.find("\n## What it checks\n") != std::string::npos ||
         text.find("\n<details><summary>What it checks</summary>\n") != std::string::npos));
}

}  // namespace

TEST_CASE("a word of the answer is found as a word, whatever is around it") {
  CHECK(stands_in("30 N", "about *30\nN*."));
  CHECK(stands_in("0.75", "leaves 0.75."));
  CHECK(stands_in("three feet", "on Three Feet"));
  CHECK_FALSE(stands_in("30", "130"));
  CHECK_FALSE(stands_in("30", "30.5"));
  CHECK_FALSE(stands_in("75", "0.75"));
  CHECK_FALSE(stands_in("fall", "falls"));
}

TEST_CASE("nothing before a page's fold gives its answer away") {
  for (const LessonInfo& card : cards()) {
    CAPTURE(card.name);
    CHECK_FALSE(card.spoilers.empty());
    for (const auto& [place, text] : before_fold(card, readme_of(card))) {
      CAPTURE(place);
      for (const std::string& word : card.spoilers) {
        CAPTURE(word);
        CHECK_FALSE(stands_in(word, text));
      }
    }
  }
}

TEST_CASE("an answer behind a page's fold has the words that the card calls its spoilers") {
  for (const LessonInfo& card : cards()) {
    CAPTURE(card.name);
    const std::string text = readme_of(card);
    const std::string answer = text.substr(text.find(fold));
    for (const std::string& word : card.spoilers) {
      CAPTURE(word);
      CHECK(stands_in(word, answer));
    }
  }
}

TEST_CASE("a page asks, folds, answers, and then explains") {
  for (const LessonInfo& card : cards()) {
    CAPTURE(card.name);
    const std::string text = readme_of(card);
    const std::size_t at = text.find(fold);
    REQUIRE(at != std::string::npos);
    CHECK(text.find(fold, at + 1) == std::string::npos);
    CHECK(text.substr(at + std::string(fold).size()).rfind("\n## The answer\n", 0) == 0);
    CHECK(text.find("<picture>") < text.find("\n## The question\n"));
    const std::string asked = text.substr(0, at);
    const std::string command = "bash lessons/run " + std::to_string(card.number) + " --";
    CHECK((asked.find(command + "answer ") != std::string::npos ||
           asked.find(command + "predict") != std::string::npos));
    check_order(text);
  }
}

TEST_CASE("a page has six headings") {
  for (const LessonInfo& card : cards()) {
    CAPTURE(card.name);
    CHECK(headings_of(readme_of(card)).size() == 6);
  }
}

TEST_CASE("a page closes every fold that it opens, and no more") {
  static const std::regex opens("<details"), closes("</details>");
  for (const LessonInfo& card : cards()) {
    CAPTURE(card.name);
    const std::string text = readme_of(card);
    const auto count = [&text](const std::regex& what) {
      return std::distance(std::sregex_iterator(text.begin(), text.end(), what), std::sregex_iterator());
    };
    CHECK(count(opens) == count(closes));
  }
}

TEST_CASE("things to find out hide their answers, all in one form") {
  static const std::regex item(
      "\n[0-9]+\\. [^\n]*(\n   ? ?[^\n]+)*\n\n"
      "   <details><summary>Answer</summary>\n\n"
      "(   [^\n]*\n|\n)+?   </details>\n");
  static const std::regex number("\n[0-9]+\\. ");
  for (const LessonInfo& card : cards()) {
    CAPTURE(card.name);
    const std::string text = readme_of(card);
    const std::size_t begin = text.find("hings to find out");
    REQUIRE(begin != std::string::npos);
    const std::string things = text.substr(begin, text.find("\n## ", begin) - begin);
    const auto count = [&things](const std::regex& what) {
      return std::distance(std::sregex_iterator(things.begin(), things.end(), what), std::sregex_iterator());
    };
    CHECK(count(number) >= 2);
    CHECK(count(item) == count(number));
  }
}

}  // namespace cairn::testing
