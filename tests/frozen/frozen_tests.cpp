// Frozen problems: kept to the last bit, and refused where they are not what they should be.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "../geometry/random_shapes.hpp"
#include <cairn/study/frozen/frozen_set.hpp>
#include <cairn/math/list.hpp>
#include "scratch_folder.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Every kind of bounds, terms of further bodies, numbers that decimals do not hold, and the extremes.
FrozenProblem all_kinds() {
  FrozenProblem frozen{
      .name = "all_kinds", .description = "\"Quotes\", \\ and \xC3\xA9.", .tags = {"a", "b"}};
  VelocityProblem<double>& problem = frozen.problem;
  problem.dt = 1.0 / 60;
  problem.inverse_mass = {{0, 0, 0}, {1.0 / 3, 1.0 / 3, 0.1}, {5e-324, 1e300, 0}};
  problem.velocity = {
      {0, -0.0, 0}, {1.0 / 7, -1e-310, 12345678901234567890.0}, {-1.0 / 3, 9007199254740992.0, 0}};
  const Bounds<double> bounds[] = {Bounds<double>::equality(),
                                   Bounds<double>::unilateral(),
                                   Bounds<double>::at_most(0.1),
                                   {.lower = -0.25, .upper = 1.0 / 3},
                                   {.upper = 2},
                                   {.lower = -0.0, .upper = 0.0},
                                   Bounds<double>::coulomb(0.7, 1),
                                   Bounds<double>::coulomb(-0.0, 1, 0),
                                   Bounds<double>::rest_of_disc(0.3, 2)};
  std::uint64_t source = std::numeric_limits<std::uint64_t>::max();
  for (const Bounds<double>& each : bounds) {
    ConstraintRow<double> row;
    row.a = {1};
    row.b = {problem.row_count() % 3};
    row.jacobian_a = {0.1, -0.0, 1e22};
    row.jacobian_b = {-std::sqrt(2.0), 0.2, 0.1 + 0.2};
    row.bias = problem.row_count() / 3.0;
    row.softness = problem.row_count() * 0.01;
    row.bounds = each;
    row.key = {source--, std::uint64_t{1} << 53 | 1};
    problem.rows.push_back(row);
    problem.impulse.push_back(-1.0 / (3 + problem.row_count()));
  }
  problem.rows[4].first_extra = 1;
  problem.rows[4].extra_count = 2;
  problem.extra_terms = {{{2}, {1, 2, 3}}, {{0}, {0.1, -0.0, 0.3}}, {{1}, {-1e-300, 0, 0}}};
  problem.blocks = {{0, 2}, {2, 0}, {2, 7}};
  return frozen;
}

std::string frozen_text(const FrozenProblem& frozen) {
  std::ostringstream out;
  write_frozen(out, frozen);
  return out.str();
}

FrozenProblem thawed(const std::string& text) {
  std::istringstream in(text);
  return read_frozen(in, "file.json");
}

/// What reading the text is refused with; empty if it is not.
std::string refusal(const std::string& text) {
  try {
    thawed(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The text with its first `from` replaced.
std::string with(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  REQUIRE(place != std::string::npos);
  return text.substr(0, place) + to + text.substr(place + from.size());
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Vec3<double>& a, const Vec3<double>& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

void check_same_row(const ConstraintRow<double>& a, const ConstraintRow<double>& b) {
  CHECK(a.a == b.a);
  CHECK(a.b == b.b);
  CHECK(same_bits(a.jacobian_a, b.jacobian_a));
  CHECK(same_bits(a.jacobian_b, b.jacobian_b));
  CHECK(same_bits(a.bias, b.bias));
  CHECK(same_bits(a.softness, b.softness));
  CHECK(same_bits(a.bounds.lower, b.bounds.lower));
  CHECK(same_bits(a.bounds.upper, b.bounds.upper));
  CHECK(same_bits(a.bounds.friction, b.bounds.friction));
  CHECK(same_bits(a.bounds.disc, b.bounds.disc));
  CHECK(a.bounds.normal_row == b.bounds.normal_row);
  CHECK(a.bounds.second_normal_row == b.bounds.second_normal_row);
  CHECK(a.key == b.key);
  CHECK(a.first_extra == b.first_extra);
  CHECK(a.extra_count == b.extra_count);
}

void check_same(const VelocityProblem<double>& a, const VelocityProblem<double>& b) {
  CHECK(same_bits(a.dt, b.dt));
  REQUIRE(a.rows.size() == b.rows.size());
  REQUIRE(a.velocity.size() == b.velocity.size());
  REQUIRE(a.blocks.size() == b.blocks.size());
  REQUIRE(a.extra_terms.size() == b.extra_terms.size());
  for (int i = 0; i < a.rows.size(); ++i) {
    check_same_row(a.rows[i], b.rows[i]);
    CHECK(same_bits(a.impulse[i], b.impulse[i]));
  }
  for (const BodyId body : a.velocity.indices()) {
    CHECK(same_bits(a.velocity[body], b.velocity[body]));
    CHECK(same_bits(a.inverse_mass[body], b.inverse_mass[body]));
  }
  for (int i = 0; i < a.blocks.size(); ++i) {
    CHECK(a.blocks[i].first == b.blocks[i].first);
    CHECK(a.blocks[i].count == b.blocks[i].count);
  }
  for (int i = 0; i < a.extra_terms.size(); ++i) {
    CHECK(a.extra_terms[i].body == b.extra_terms[i].body);
    CHECK(same_bits(a.extra_terms[i].jacobian, b.extra_terms[i].jacobian));
  }
}

}  // namespace

TEST_CASE("a frozen problem reads back bit-equal, with every kind of bounds and keys of 64 bits") {
  const FrozenProblem before = all_kinds();
  const FrozenProblem after = thawed(frozen_text(before));
  CHECK(after.name == before.name);
  CHECK(after.description == before.description);
  CHECK(after.tags == before.tags);
  check_same(after.problem, before.problem);
  CHECK(frozen_text(after) == frozen_text(before));
}

TEST_CASE("a world without rows, and one without moving bodies, can be frozen") {
  const FrozenProblem nothing = freeze(World<double>(Scene()), "nothing", "");
  CHECK(nothing.tags == List<std::string>{"cold", "0 rows", "start"});
  check_same(thawed(frozen_text(nothing)).problem, nothing.problem);
}

TEST_CASE("what is malformed is refused in one message of file, field, rule and value") {
  struct Malformed {
    const char* from;
    const char* to;
    const char* message;
  };
  // A row of the text below: [1,2,[..],[..],1.666,0.05,[bounds],["source","part"],impulse,first,count]
  const std::string text = frozen_text(all_kinds());
  const std::string first_row = "[1,0,[0.10000000000000001,-0.0,1e+22]";
  const std::string coulomb = "[\"-inf\",\"inf\",0.69999999999999996,0,1,-1]";
  const List<Malformed> all = {
      {"problem 1", "problem 2", "file.json: schema must be \"cairn frozen problem 1\", got"},
      {"\"dt\": 0.016666666666666666", "\"dt\": 0", "file.json: dt must be a finite number > 0 s, got 0"},
      {"\"dt\": 0.016666666666666666", "\"dt\": \"inf\"", "file.json: dt must be a number, got \"inf\""},
      {"\"dt\": 0.016666666666666666", "\"dt\": NaN", "file.json: text must be JSON, got"},
      {"\"dt\": 0.016666666666666666", "\"dt\": 1e999", "file.json: text must be JSON, got number overflow"},
      {" \"dt\": 0.016666666666666666,\n", "", "file.json: dt must be given, got nothing"},
      {"\"dt\"", "\"dT\"", "file.json: \"dT\" must be a field that problems have"},
      {"\"dt\"", "\"tags\": [], \"dt\"", "file.json: \"tags\" must be given once, got it twice"},
      {"\"all_kinds\"", "\"../x\"", "file.json: name must be 1 to 64 letters, digits, - and _, got \"../x\""},
      {"\"all_kinds\"", "[1,2]", "file.json: name must be a text, got array of 2"},
      {"[\"a\",\"b\"]", "[\"a\",3]", "file.json: tags[1] must be a text, got 3"},
      {"[0,0,0,0,-0.0,0]", "[0,0,0,0,-0.0]", "file.json: bodies[0] must be a list of 6, got array of 5"},
      {"[0,0,0,0,-0.0,0]", "[0,0,1,0,-0.0,0]", "file.json: bodies[0].inverse_mass must be 0 1/kg"},
      {"[0.33333333333333331,", "[-1,", "file.json: bodies[1].inverse_mass must be numbers >= 0"},
      {"0.33333333333333331,0.10", "null,0.10", "file.json: bodies[1][1] must be a number, got null"},
      {"[2,1,2,3]", "[3,1,2,3]", "file.json: extra_terms[0].body must be the place of a body, got 3"},
      {"[1,0,[", "[1,3,[", "file.json: rows[0].b must be the place of a body, got 3"},
      {"[1,0,[", "[-1,0,[", "file.json: rows[0].a must be the place of a body, got -1"},
      {"[1,0,[", "[1.5,0,[", "file.json: rows[0][0] must be a whole number of 32 bits, got 1.5"},
      {"[1,0,[", "[18446744073709551615,0,[", "file.json: rows[0][0] must be a whole number of 32 bits"},
      {"[1,0,[", "[-2147483649,0,[", "file.json: rows[0][0] must be a whole number of 32 bits"},
      {",1e+22]", "]", "file.json: rows[0][2] must be a list of 3, got array of 2"},
      {"[\"-inf\",\"inf\"]", "[\"inf\",\"inf\"]", "file.json: rows[0].bounds.lower must be a number below"},
      {"[\"-inf\",\"inf\"]", "[2,1]", "file.json: rows[0].bounds.upper must be a number >= lower N s, got 1"},
      {"[\"-inf\",\"inf\"]", "[\"nan\",0]", "file.json: rows[0][6][0] must be a number, \"inf\" or \"-inf\""},
      {"[\"-inf\",\"inf\"]", "[0]", "file.json: rows[0][6] must be a list of 2 or 6, got array of 1"},
      {coulomb.c_str(), "[0,0,0.7,0,9,-1]", "file.json: rows[6].bounds.normal_row must be -1 or the place"},
      {coulomb.c_str(), "[0,0,0.7,0,6,-1]", "file.json: rows[6].bounds.normal_row must be a row that names"},
      {coulomb.c_str(), "[0,0,0.7,0,-1,1]", "file.json: rows[6].bounds.second_normal_row must be -1"},
      {coulomb.c_str(), "[0,0,0.7,0,1,1]", "file.json: rows[6].bounds.second_normal_row must be another"},
      {coulomb.c_str(), "[0,0,-0.7,0,1,-1]",
       "file.json: rows[6].bounds.friction must be a finite number >= 0"},
      {coulomb.c_str(), "[0,0,0.7,-3,1,-1]", "file.json: rows[6].bounds.disc must be a finite number >= 0"},
      {"\"ffffffffffffffff\"", "\"1ffffffffffffffff\"", "file.json: rows[0][7][0] must be 1 to 16 hexa"},
      {"\"ffffffffffffffff\"", "\"-1\"", "file.json: rows[0][7][0] must be 1 to 16 hexadecimal digits"},
      {"\"ffffffffffffffff\"", "\"\"", "file.json: rows[0][7][0] must be 1 to 16 hexadecimal digits"},
      {"\"ffffffffffffffff\"", "7", "file.json: rows[0][7][0] must be a text, got 7"},
      {",1,2]", ",2,2]", "file.json: rows[4].first_extra must be so that its terms lie inside extra_terms"},
      {",1,2]", ",2147483647,2]", "file.json: rows[4].first_extra must be so that its terms lie inside"},
      {",1,2]", ",0,2147483647]", "file.json: rows[4].extra_count must be from 0 to the number of extra"},
      {",1,2]", ",1]", "file.json: rows[4] must be a list of 9 or 11, got array of 10"},
      {"[2,7]", "[2,6]", "file.json: blocks must be so many as to cover all rows, got 8"},
      {"[2,7]", "[3,6]", "file.json: blocks[2].first must be where the block before ends, got 3"},
      {"[2,7]", "[2,2147483647]", "file.json: blocks[2].count must be a number of rows that are left"},
      {"[2,0]", "[2,-1]", "file.json: blocks[1].count must be a number of rows that are left, got -1"},
      {"\"rows\": [", "\"rows\": [],\n \"blocks\": [", "file.json: \"blocks\" must be given once"},
      {"\n}\n", "\n}\nmore", "file.json: text must be JSON, got parse error at line"},
      {"{\n", "[{\n", "file.json: text must be JSON, got parse error at line"},
  };
  REQUIRE(text.find(first_row) != std::string::npos);
  for (const Malformed& each : all) {
    const std::string message = refusal(with(text, each.from, each.to));
    CAPTURE(message);
    CHECK(message.find(each.message) == 0);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.size() <= 200);
  }
}

TEST_CASE("no beginning of a frozen problem is one, and neither is any other text") {
  const std::string text = frozen_text(all_kinds());
  for (std::size_t size = 0; size + 2 < text.size(); size += 3) CHECK(!refusal(text.substr(0, size)).empty());
  for (const char* other : {"null", "[]", "{}", "7", "\"inf\"", "\xFF\xFE", "{\"schema\": \"\xC3\"}"}) {
    CHECK(refusal(other).find("file.json: ") == 0);
  }
  CHECK(refusal(std::string(1000000, '[')).find("file.json: text must be JSON") == 0);
  CHECK(refusal(std::string((32u << 20) + 1, ' ')) == "file.json: size must be at most 32 MiB, got 33554433");
}

TEST_CASE("a frozen problem with a wrong character is refused, or is another problem that holds together") {
  const std::string text = frozen_text(all_kinds());
  const std::string characters = "0123456789-+.eE\"[]{},: infaN\n\x01\xFF";
  test::Random random(7);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string other = text;
    const auto place = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
    other[place] = characters[static_cast<std::size_t>(random.below(static_cast<int>(characters.size())))];
    const std::string message = refusal(other);
    refused += message.empty() ? 0 : 1;
    if (message.empty()) CHECK(frozen_text(thawed(frozen_text(thawed(other)))) == frozen_text(thawed(other)));
  }
  CHECK(refused > 300);
}

TEST_CASE("what could not be read is not written") {
  FrozenProblem frozen = all_kinds();
  frozen.problem.velocity[{1}].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(frozen_text(frozen),
                       "write_frozen: bodies[1].velocity[0] must be a finite number, got nan",
                       std::invalid_argument);
  frozen = all_kinds();
  frozen.problem.rows[3].bounds.lower = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(frozen_text(frozen), std::invalid_argument);
  frozen = all_kinds();
  frozen.problem.impulse.pop_back();
  CHECK_THROWS_AS(frozen_text(frozen), std::invalid_argument);
  frozen = all_kinds();
  frozen.description = "\xFF";
  CHECK_THROWS_WITH_AS(frozen_text(frozen),
                       "write_frozen: description must be a text in UTF-8, got other bytes",
                       std::invalid_argument);
}

TEST_CASE("a frozen file is whole or not there, and a missing one is named") {
  const ScratchFolder folder;
  write_frozen_file(folder / "one.json", all_kinds());
  write_frozen_file(folder / "one.json", all_kinds());
  check_same(read_frozen_file(folder / "one.json").problem, all_kinds().problem);
  CHECK(folder.names().size() == 1);
  FrozenProblem broken = all_kinds();
  broken.problem.dt = 0;
  CHECK_THROWS_AS(write_frozen_file(folder / "two.json", broken), std::invalid_argument);
  CHECK_FALSE(std::filesystem::exists(folder / "two.json"));
  CHECK_THROWS_AS(write_frozen_file(folder / "one.json/two.json", all_kinds()), std::runtime_error);
  CHECK_THROWS_AS(read_frozen_file(folder / "three.json"), std::runtime_error);
  CHECK_THROWS_AS(read_frozen_file(folder.path()), std::runtime_error);
  REQUIRE(mkfifo((folder / "fifo.json").c_str(), 0600) == 0);  // nobody writes: to open it would block
  CHECK_THROWS_AS(read_frozen_file(folder / "fifo.json"), std::runtime_error);
}
