// Floor 9. Frozen problems from JSON text that may hold anything.
#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include <cairn/math/check.hpp>
#include <cairn/study/frozen/frozen_problem.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using FrozenJson = nlohmann::json;

const std::size_t largest_frozen = std::size_t{32} << 20;  // [bytes]
const std::size_t longest_frozen_text = 2000;              // [bytes]
const std::size_t longest_complaint = 200;  // [bytes] of the parser, which repeats what it read

/// No longer than that, and cut between two letters of UTF-8.
std::string beginning(const std::string& complaint) {
  if (complaint.size() <= longest_complaint) return complaint;
  std::size_t end = longest_complaint;
  while (end > 0 && (static_cast<unsigned char>(complaint[end]) & 0xC0U) == 0x80U) --end;
  return complaint.substr(0, end) + "...";
}

/// What a message shows of a value: one line of plain letters, whatever there is.
std::string frozen_shown(const FrozenJson& value) {
  if (value.is_structured()) return fmt::format("{} of {}", value.type_name(), value.size());
  const std::string text = value.dump(-1, ' ', true, FrozenJson::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 40) + "...";
}

/// A value with its path in the file. Copies no text until something is wrong.
class FrozenField {
 public:
  FrozenField(const FrozenJson& value, const std::string& file, std::string path)
      : value_(&value), file_(&file), path_(std::move(path)) {}

  [[noreturn]] void refuse(std::string_view rule) const {
    require(false, *file_, path_, rule, frozen_shown(*value_));
    throw std::logic_error("unreachable");
  }
  FrozenField at(std::size_t i) const { return {(*value_)[i], *file_, fmt::format("{}[{}]", path_, i)}; }
  FrozenField member(const char* field) const {
    const auto found = value_->find(field);
    if (found == value_->end()) require(false, *file_, field, "given", "nothing");
    return {*found, *file_, field};
  }
  /// The number of elements; a list of anything else than `least` to `most` of them is refused.
  std::size_t list(std::size_t least, std::size_t most) const {
    const bool fits = value_->is_array() && value_->size() >= least && value_->size() <= most;
    if (fits) return value_->size();
    refuse(least == most ? fmt::format("a list of {}", least)
                         : fmt::format("a list of {} to {}", least, most));
  }
  std::size_t list() const {
    if (!value_->is_array()) refuse("a list");
    return value_->size();
  }
  const std::string& text() const {
    if (!value_->is_string()) refuse("a text");
    return value_->get_ref<const std::string&>();
  }
  double number() const {
    if (!value_->is_number()) refuse("a number");
    return value_->get<double>();
  }
  /// A number, or an infinity as a text.
  double bound() const {
    if (*value_ == "inf") return std::numeric_limits<double>::infinity();
    if (*value_ == "-inf") return -std::numeric_limits<double>::infinity();
    if (!value_->is_number()) refuse("a number, \"inf\" or \"-inf\"");
    return value_->get<double>();
  }
  int whole() const {
    const bool is_beyond = value_->is_number_unsigned() && value_->get<std::uint64_t>() >> 31 != 0;
    const bool is_whole = value_->is_number_integer() && !is_beyond;
    const std::int64_t value = is_whole ? value_->get<std::int64_t>() : 0;
    if (!is_whole || value < std::numeric_limits<int>::min()) refuse("a whole number of 32 bits");
    return static_cast<int>(value);
  }
  std::uint64_t hexadecimal() const {
    const std::string& digits = text();
    const char* const end = digits.data() + digits.size();
    std::uint64_t result = 0;
    const auto [stop, error] = std::from_chars(digits.data(), end, result, 16);
    if (error != std::errc() || stop != end) refuse("1 to 16 hexadecimal digits");
    return result;
  }
  Vec3<double> vector(std::size_t first) const {
    return {at(first).number(), at(first + 1).number(), at(first + 2).number()};
  }

 private:
  const FrozenJson* value_;
  const std::string* file_;
  std::string path_;
};

Bounds<double> read_bounds(const FrozenField& field) {
  const std::size_t count = field.list();
  if (count != 2 && count != 6) field.refuse("a list of 2 or 6");
  Bounds<double> bounds{.lower = field.at(0).bound(), .upper = field.at(1).bound()};
  if (count == 2) return bounds;
  bounds.friction = field.at(2).number();
  bounds.disc = field.at(3).number();
  bounds.normal_row = field.at(4).whole();
  bounds.second_normal_row = field.at(5).whole();
  return bounds;
}

void read_row(const FrozenField& field, VelocityProblem<double>& problem) {
  const std::size_t count = field.list(9, 11);
  if (count == 10) field.refuse("a list of 9 or 11");
  ConstraintRow<double> row;
  row.a = {field.at(0).whole()};
  row.b = {field.at(1).whole()};
  const FrozenField jacobian_a = field.at(2), jacobian_b = field.at(3), key = field.at(7);
  jacobian_a.list(3, 3);
  jacobian_b.list(3, 3);
  key.list(2, 2);
  row.jacobian_a = jacobian_a.vector(0);
  row.jacobian_b = jacobian_b.vector(0);
  row.bias = field.at(4).number();
  row.softness = field.at(5).number();
  row.bounds = read_bounds(field.at(6));
  row.key = {key.at(0).hexadecimal(), key.at(1).hexadecimal()};
  problem.impulse.push_back(field.at(8).number());
  if (count == 11) row.first_extra = field.at(9).whole();
  if (count == 11) row.extra_count = field.at(10).whole();
  problem.rows.push_back(row);
}

VelocityProblem<double> read_problem(const FrozenField& root) {
  VelocityProblem<double> problem;
  problem.dt = root.member("dt").number();
  const FrozenField bodies = root.member("bodies"), terms = root.member("extra_terms"),
                    rows = root.member("rows");
  const FrozenField blocks = root.member("blocks");
  for (std::size_t i = 0; i < bodies.list(); ++i) {
    const FrozenField body = bodies.at(i);
    body.list(6, 6);
    problem.inverse_mass.push_back(body.vector(0));
    problem.velocity.push_back(body.vector(3));
  }
  for (std::size_t i = 0; i < terms.list(); ++i) {
    const FrozenField term = terms.at(i);
    term.list(4, 4);
    problem.extra_terms.push_back({{term.at(0).whole()}, term.vector(1)});
  }
  for (std::size_t i = 0; i < rows.list(); ++i) read_row(rows.at(i), problem);
  for (std::size_t i = 0; i < blocks.list(); ++i) {
    const FrozenField block = blocks.at(i);
    block.list(2, 2);
    problem.blocks.push_back({block.at(0).whole(), block.at(1).whole()});
  }
  return problem;
}

/// The whole stream, but never more than the largest file.
std::string read_all(std::istream& in, const std::string& name) {
  std::string text;
  FixedList<char, 65536> piece = {};
  while (in.read(piece.data(), piece.size()) || in.gcount() > 0) {
    text.append(piece.data(), piece.data() + in.gcount());
    require(text.size() <= largest_frozen, name, "size", "at most 32 MiB", static_cast<double>(text.size()));
  }
  return text;
}

/// Refuses what is no JSON, and fields that are given twice.
FrozenJson parse_frozen(const std::string& text, const std::string& name) {
  List<std::set<std::string>> fields;  // of the objects that are open
  const auto watch = [&](int, FrozenJson::parse_event_t event, FrozenJson& parsed) {
    if (event == FrozenJson::parse_event_t::object_start) fields.emplace_back();
    if (event == FrozenJson::parse_event_t::object_end) fields.pop_back();
    if (event == FrozenJson::parse_event_t::key) {
      const std::string& key = parsed.get_ref<const std::string&>();
      const bool is_new = fields.back().insert(key).second;
      if (!is_new) require(false, name, frozen_shown(parsed), "given once", "it twice");
    }
    return true;
  };
  try {
    return FrozenJson::parse(text, watch);
  } catch (const FrozenJson::exception& error) {
    const std::string what = error.what();  // "[json.exception...] parse error at line 3, column 1: ..."
    require(false, name, "text", "JSON", beginning(what.substr(what.find("] ") + 2)));
    throw;
  }
}

void require_known_fields(const FrozenJson& root, const std::string& name) {
  require(root.is_object(), name, "text", "an object", root.type_name());
  const std::set<std::string> known = {"schema", "name", "description", "tags",  "dt",
                                       "bodies", "rows", "extra_terms", "blocks"};
  for (const auto& entry : root.items()) {
    if (known.count(entry.key()) == 0) {
      require(false, name, frozen_shown(entry.key()), "a field that problems have", "an unknown one");
    }
  }
}

bool is_utf8(const std::string& text) {
  try {
    return !FrozenJson(text).dump().empty();
  } catch (const FrozenJson::type_error&) {
    return false;
  }
}

}  // namespace

FrozenProblem read_frozen(std::istream& in, const std::string& name) {
  const FrozenJson json = parse_frozen(read_all(in, name), name);
  require_known_fields(json, name);
  const FrozenField root(json, name, "");
  if (root.member("schema").text() != frozen_schema) root.member("schema").refuse('"' + frozen_schema + '"');
  FrozenProblem frozen{.name = root.member("name").text(), .description = root.member("description").text()};
  const FrozenField tags = root.member("tags");
  for (std::size_t i = 0; i < tags.list(); ++i) frozen.tags.push_back(tags.at(i).text());
  frozen.problem = read_problem(root);
  check(frozen, name);
  return frozen;
}

FrozenProblem read_frozen_file(const std::filesystem::path& path) {
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(path, error);  // to open a FIFO would wait for ever
  std::ifstream file(is_file ? path : "", std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string() + ": there is no such file");
  return read_frozen(file, path.filename().string());
}

void check(const FrozenProblem& frozen, const std::string& place) {
  const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  const bool is_name = !frozen.name.empty() && frozen.name.size() <= 64 &&
                       frozen.name.find_first_not_of(letters) == std::string::npos;
  require(is_name, place, "name", "1 to 64 letters, digits, - and _", frozen_shown(frozen.name));
  const auto require_text = [&](const std::string& text, const char* field) {
    require(text.size() <= longest_frozen_text, place, field, "a text of at most 2000 bytes",
            static_cast<double>(text.size()));
    require(is_utf8(text), place, field, "a text in UTF-8", "other bytes");
  };
  require_text(frozen.description, "description");
  require(frozen.tags.size() <= 100, place, "tags", "at most 100", static_cast<double>(frozen.tags.size()));
  for (const std::string& tag : frozen.tags) require_text(tag, "tags");
  check(frozen.problem, place);
}

}  // namespace cairn
