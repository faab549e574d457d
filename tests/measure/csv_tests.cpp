// CSV that reads back as it was written.
#include <cstdlib>
#include <sstream>

#include "geometry/random_shapes.hpp"
#include "testing.hpp"

using namespace cairn;

namespace {

std::string text_of_table(const CsvTable& table) {
  std::ostringstream out;
  write_csv(out, table);
  return out.str();
}

/// The cells of CSV text, line by line: quotes taken off, doubled quotes single.
List<List<std::string>> parsed(const std::string& text) {
  List<List<std::string>> lines(1, List<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      lines.back().back() += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      lines.back().emplace_back();
    } else if (!quoted && c == '\n') {
      lines.emplace_back(1);
    } else {
      lines.back().back() += c;
    }
  }
  lines.pop_back();  // after the last line break
  return lines;
}

}  // namespace

TEST_CASE("a table is a header line and its rows, each ended by a line feed") {
  CHECK(text_of_table({.header = {"sweep", "energy [J]"}, .rows = {{1LL, 0.5}, {2LL, -2.0}}}) ==
        "sweep,energy [J]\n1,0.5\n2,-2\n");
  CHECK(text_of_table({.header = {"empty"}}) == "empty\n");
}

TEST_CASE("numbers read back bit-equal") {
  test::Random random(6);
  CsvTable table{.header = {"number"}};
  for (int i = 0; i < 200; ++i) {
    table.rows.push_back({std::ldexp(random.uniform(-1, 1), random.below(2000) - 1000)});
  }
  for (const double special : {0.1, -0.0, std::numeric_limits<double>::denorm_min(),
                               std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()}) {
    table.rows.push_back({special});
  }
  const List<List<std::string>> lines = parsed(text_of_table(table));
  REQUIRE(lines.size() == table.rows.size() + 1);
  for (int i = 0; i < table.rows.size(); ++i) {
    const double written = std::get<double>(table.rows[i][0]);
    const double read = std::strtod(lines[i + 1][0].c_str(), nullptr);
    CHECK(read == written);
    CHECK(std::signbit(read) == std::signbit(written));
  }
}

TEST_CASE("text with commas, quotes and line breaks reads back as it was") {
  const List<std::string> texts = {"plain", "a, b", "say \"so\"", "two\nlines", ""};
  CsvTable table{.header = texts};
  table.rows.push_back({texts.begin(), texts.end()});
  const List<List<std::string>> lines = parsed(text_of_table(table));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == texts);
  CHECK(lines[1] == texts);
}

TEST_CASE("a row that is not as long as the header is refused") {
  CHECK_THROWS_WITH_AS(text_of_table({.header = {"a", "b"}, .rows = {{1LL}}}),
                       "write_csv: row must be as long as the header, got 1", std::invalid_argument);
}

TEST_CASE("what was written reads back: numbers bit for bit, text with commas, quotes and line breaks") {
  const double infinity = std::numeric_limits<double>::infinity();
  CsvTable table = {.header = {"text", "a, \"b\"", "number"}, .rows = {}};
  for (const double number : {0.1, -1e-310, 1 / 3.0, 6.02e23, infinity, -infinity}) {
    table.rows.push_back({std::string("two\nlines, \"quoted\""), -7LL, number});
  }
  std::istringstream in(text_of_table(table));
  const CsvTable read = read_csv(in, "table");
  CHECK(read.header == table.header);
  CHECK(read.rows == table.rows);
}

TEST_CASE("CSV that is cut off, or has rows of another length, is refused by its line") {
  const auto refused = [](const std::string& text, const char* message) {
    std::istringstream in(text);
    CHECK_THROWS_WITH_AS(read_csv(in, "table.csv"), doctest::Contains(message), std::invalid_argument);
  };
  refused("a,b\n1,2\n3\n", "table.csv: line 3");
  refused("a,b\n1,\"2\n", "a quote with a quote");
  refused("a,b\n1,2", "table.csv: line 2");
}
