// Floor 8. Reads a sum by recursive descent, and computes it on the way.
#include <cairn/scenes/scene_formula.hpp>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <cairn/math/math.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using FormulaFunction = double (*)(double);

const std::map<std::string, FormulaFunction>& formula_functions() {
  static const std::map<std::string, FormulaFunction> functions = {
      {"sqrt", [](double x) { return std::sqrt(x); }},
      {"abs", [](double x) { return std::abs(x); }},
      {"sin", sine},
      {"cos", cosine},
      {"tan", tangent},
      {"asin", arc_sine},
      {"acos", arc_cosine},
      {"atan", [](double x) { return arc_tangent(x, 1); }}};
  return functions;
}

class FormulaReader {
 public:
  FormulaReader(const std::string& text, const std::map<std::string, double>& numbers)
      : text_(text), numbers_(numbers) {}

  FormulaResult read() {
    const double value = sum();
    if (problem_.empty() && at() != '\0') complain(unexpected());
    if (problem_.empty() && !std::isfinite(value)) complain("its value is not finite");
    return {.value = value, .problem = problem_};
  }

 private:
  char at() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    return place_ < text_.size() ? text_[place_] : '\0';
  }
  bool take(char sign) {
    if (at() != sign) return false;
    ++place_;
    return true;
  }
  std::string unexpected() const { return "unexpected \"" + excerpt(text_.substr(place_), 12) + '"'; }
  double complain(const std::string& problem) {
    if (problem_.empty()) problem_ = problem;
    place_ = text_.size();
    return 0;
  }

  double sum() {
    double value = product();
    while (at() == '+' || at() == '-') {
      if (take('+')) {
        value += product();
      } else {
        take('-');
        value -= product();
      }
    }
    return value;
  }

  double product() {
    double value = factor();
    while (at() == '*' || at() == '/') {
      if (take('*')) {
        value *= factor();
      } else {
        take('/');
        value /= factor();
      }
    }
    return value;
  }

  double factor() {
    const int deepest = 50;  // brackets and signs in each other: the stack has an end
    if (depth_ >= deepest) return complain("more than 50 brackets in each other");
    ++depth_;
    double value = 0;
    if (take('-')) {
      value = -factor();
    } else if (take('(')) {
      value = bracket();
    } else if (std::isalpha(static_cast<unsigned char>(at()))) {
      value = named();
    } else {
      value = literal();
    }
    --depth_;
    return value;
  }

  double bracket() {
    const double value = sum();
    return take(')') ? value : complain("a bracket that is not closed");
  }

  std::string word() {
    at();
    const std::size_t begin = place_;
    const auto belongs = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    while (place_ < text_.size() && belongs(text_[place_])) ++place_;
    return text_.substr(begin, place_ - begin);
  }

  double named() {
    const std::string name = word();
    const auto number = numbers_.find(name);
    if (number != numbers_.end()) return number->second;
    if (name == "pi") return pi;
    const auto function = formula_functions().find(name);
    if (function != formula_functions().end()) {
      if (!take('(')) return complain(name + " without a bracket behind it");
      return function->second(bracket());
    }
    return complain("unknown word " + excerpt(name) + hint(name));
  }

  std::string hint(const std::string& name) const {
    List<std::string> known = {"pi", "deg"};
    for (const auto& entry : numbers_) known.push_back(entry.first);
    for (const auto& entry : formula_functions()) known.push_back(entry.first);
    const std::string near = nearest(name, known);
    return near.empty() ? "" : " (" + near + "?)";
  }

  double literal() {
    if (at() == '\0') return complain("a number is missing at its end");
    double value = 0;
    const char* begin = text_.data() + place_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) {
      const bool is_large = std::strtod(begin, nullptr) > 1;
      return complain(is_large ? "a number too large" : "a number too small");
    }
    if (error != std::errc()) return complain(unexpected());
    place_ += static_cast<std::size_t>(end - begin);
    if (!std::isalpha(static_cast<unsigned char>(at()))) return value;
    const std::string unit = word();
    if (unit == "deg") return value * pi / 180;
    if (unit == "rad") return value;
    return complain("unknown unit " + excerpt(unit) + ", only deg and rad can stand behind a number");
  }

  const std::string& text_;
  const std::map<std::string, double>& numbers_;
  std::string problem_ = {};
  std::size_t place_ = 0;
  int depth_ = 0;
};

}  // namespace

FormulaResult evaluate_formula(const std::string& text, const std::map<std::string, double>& numbers) {
  return FormulaReader(text, numbers).read();
}

}  // namespace cairn
