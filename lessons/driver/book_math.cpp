// Reads a formula as it is typed. A blank parts two factors; a / between blanks has the whole product before
// it as its numerator, a / without blanks only what it touches.
#include "lessons/driver/book_math.hpp"

#include <stdexcept>

#include "lessons/driver/book_glyphs.hpp"
#include "lessons/driver/book_text.hpp"
#include "math/list.hpp"

namespace cairn::driver {
namespace {

struct NoFormula : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string element(const std::string& name, const std::string& inside) {
  return "<" + name + ">" + inside + "</" + name + ">";
}
std::string row_of(const std::string& inside) { return element("mrow", inside); }

/// A piece of MathML, and what the piece is to its neighbours.
struct Piece {
  enum class Kind { operand, function, group, number, unit } kind = Kind::operand;
  std::string html = {};
  std::string inside = {};  // of a group, without its brackets
};

class Reader {
 public:
  Reader(std::string_view formula, const SymbolPages& symbols)
      : glyphs_(glyphs_of(formula)), symbols_(symbols) {}

  std::string whole() {
    const std::string html = expression("");
    if (!done()) throw NoFormula("there is something behind the formula");
    return html;
  }

 private:
  bool done() const { return at_ >= glyphs_.size(); }
  std::string now() const { return done() ? "" : glyphs_[at_]; }
  std::string then() const { return at_ + 1 < glyphs_.size() ? glyphs_[at_ + 1] : ""; }
  std::string take() { return done() ? "" : glyphs_[at_++]; }
  void skip_blanks() {
    while (now() == " ") ++at_;
  }

  /// Up to the bracket that closes; `factors` are those that a / between blanks would divide.
  std::string expression(const std::string& close) {
    std::string html;
    List<Piece> factors;
    const auto flush = [&html, &factors] {
      for (const Piece& factor : factors) html += factor.html;
      factors.clear();
    };
    for (skip_blanks(); !done() && now() != close; skip_blanks()) {
      if (now() == "/") {
        ++at_;
        factors = {divided(factors, denominator())};
      } else if (operators.count(now()) > 0) {
        flush();
        html += element("mo", escaped(take()));
      } else if (now() == "Σ") {
        flush();
        html += sum();
      } else {
        const bool is_unit = is_unit_behind(factors);
        if (!factors.empty()) factors.back().html += "<mspace width=\"0.2em\"></mspace>";
        factors.push_back(is_unit ? unit() : chunk());
      }
    }
    flush();
    return html;
  }

  std::string letters_here() const {
    std::string letters;
    for (int i = at_; i < glyphs_.size() && is_latin(glyphs_[i]); ++i) letters += glyphs_[i];
    return letters;
  }

  /// The N of "10 N", but not that of "N + 1".
  bool is_unit_behind(const List<Piece>& factors) const {
    if (factors.empty() || units.count(letters_here()) == 0) return false;
    return factors.back().kind == Piece::Kind::number || factors.back().kind == Piece::Kind::unit;
  }

  Piece unit() {
    const std::string letters = letters_here();
    at_ += static_cast<int>(letters.size());
    const std::string html = "<mi mathvariant=\"normal\">" + letters + "</mi>";
    return {.kind = Piece::Kind::unit, .html = html};
  }

  std::string denominator() {
    skip_blanks();
    std::string sign;
    if (now() == "−") sign = element("mo", take());
    Piece below = chunk();
    if (below.kind == Piece::Kind::function) {
      skip_blanks();
      below = {.html = below.html + chunk().html};
    }
    return sign + (below.kind == Piece::Kind::group ? below.inside : below.html);
  }

  static Piece divided(const List<Piece>& above, const std::string& below) {
    if (above.empty()) throw NoFormula("nothing is divided");
    std::string top;
    for (const Piece& piece : above) top += piece.html;
    if (above.size() == 1 && above[0].kind == Piece::Kind::group) top = above[0].inside;
    return {.html = element("mfrac", row_of(top) + row_of(below))};
  }

  /// What stands together without a blank: "2n", "j·v", "v²/2μg", "cos²(π/2n)".
  Piece chunk() {
    Piece run = product();
    while (now() == "/" && then() != " ") {
      ++at_;
      Piece below = product();
      run = divided({run}, below.kind == Piece::Kind::group ? below.inside : below.html);
    }
    return run;
  }

  bool run_goes_on() const {
    const std::string glyph = now();
    return !glyph.empty() && glyph != " " && glyph != "/" && glyph != ")" && glyph != "]" && glyph != "}" &&
           glyph != "|" && (operators.count(glyph) == 0 || glyph == "·");
  }

  Piece product() {
    Piece run = primary();
    while (run_goes_on()) {
      if (now() == "·") {
        run = {.html = run.html + element("mo", take())};
        continue;
      }
      run = {.kind = Piece::Kind::operand, .html = run.html + primary().html};
    }
    return run;
  }

  Piece primary() {
    Piece base = bare();
    std::string below;
    std::string above;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      if (now() == "_") below += (++at_, script()), goes_on = true;
      if (now() == "^") above += (++at_, script()), goes_on = true;
      while (lowered.count(now()) > 0) below += scripted(lowered.at(take())), goes_on = true;
      while (raised.count(now()) > 0) above += scripted(raised.at(take())), goes_on = true;
    }
    if (below.empty() && above.empty()) return base;
    const std::string low = below.empty() ? "" : row_of(below);
    const std::string high = above.empty() ? "" : row_of(above);
    const std::string name = below.empty() ? "msup" : above.empty() ? "msub" : "msubsup";
    const bool is_function = base.kind == Piece::Kind::function;
    return {.kind = is_function ? base.kind : Piece::Kind::operand,
            .html = element(name, row_of(base.html) + low + high)};
  }

  std::string scripted(const std::string& glyph) const {
    if (is_digit(glyph)) return element("mn", glyph);
    return element(is_latin(glyph) ? "mi" : "mo", glyph);
  }

  /// Behind _ or ^: {...}, (...), or letters and digits.
  std::string script() {
    if (now() == "{" || now() == "(") {
      const std::string close = take() == "{" ? "}" : ")";
      const std::string inside = expression(close);
      if (take() != close) throw NoFormula("a bracket is open");
      return inside;
    }
    std::string word;
    while (is_latin(now()) || is_digit(now()) || is_greek(now())) word += take();
    if (word.empty()) throw NoFormula("there is no script");
    return is_digit(word.substr(0, 1)) ? element("mn", word) : element("mi", word);
  }

  Piece bare() {
    if (now() == "[") return matrix();
    if (now() == "(" || now() == "|") return group();
    if (now() == "√") return ++at_, Piece{.html = element("msqrt", group().inside)};
    if (is_digit(now())) return number();
    if (is_greek(now()) && now() != "Δ") return {.html = symbol(take())};
    if (now() == "Δ") {
      std::string name = take();
      if (!is_latin(now()) && !is_greek(now())) throw NoFormula("Δ of nothing");
      return {.html = symbol(name + take())};
    }
    if (is_latin(now())) return word();
    throw NoFormula("unknown character " + now());
  }

  Piece number() {
    std::string digits;
    while (is_digit(now()) || (now() == "." && is_digit(then()))) digits += take();
    return {.kind = Piece::Kind::number, .html = element("mn", digits)};
  }

  Piece word() {
    const std::string letters = letters_here();
    const int count = static_cast<int>(letters.size());
    if (functions.count(letters) > 0) {
      at_ += count;
      return {.kind = Piece::Kind::function, .html = element("mi", letters)};
    }
    if (long_names.count(letters) > 0) return at_ += count, Piece{.html = element("mi", letters)};
    if (count > 2 || small_words.count(letters) > 0) throw NoFormula("the word " + letters);
    const std::string letter = take();
    if (now() != "\u0304") return {.html = symbol(letter)};
    ++at_;
    return {.html = element("mover", symbol(letter) + element("mo", "¯"))};
  }

  std::string symbol(const std::string& name) const {
    const auto page = symbols_.find(name);
    if (page == symbols_.end()) return element("mi", name);
    return element("mi", "<a href=\"" + page->second + "\" tabindex=\"-1\">" + name + "</a>");
  }

  Piece group() {
    const std::string open = take();
    const std::string close = open == "(" ? ")" : "|";
    const std::string inside = expression(close);
    if (take() != close) throw NoFormula("a bracket is open");
    return {.kind = open == "(" ? Piece::Kind::group : Piece::Kind::operand,
            .html = row_of(element("mo", open) + inside + element("mo", close)),
            .inside = inside};
  }

  /// "[1 −1; −1 2]": blanks part the numbers of a row.
  Piece matrix() {
    ++at_;
    std::string rows;
    std::string cells;
    std::string cell;
    const auto end_cell = [&] {
      if (!cell.empty()) cells += element("mtd", Reader(cell, symbols_).whole());
      cell.clear();
    };
    const auto end_row = [&] {
      end_cell();
      rows += element("mtr", cells);
      cells.clear();
    };
    for (; !done() && now() != "]"; ++at_) {
      if (now() == " ") end_cell();
      if (now() == ";") end_row();
      if (now() != " " && now() != ";") cell += now();
    }
    if (take() != "]") throw NoFormula("a bracket is open");
    end_row();
    return {.html = row_of(element("mo", "[") + element("mtable", rows) + element("mo", "]"))};
  }

  std::string sum() {
    const std::string sign = element("mo", take());
    if (now() != "_") return sign;
    ++at_;
    return element("munder", sign + row_of(script()));
  }

  Glyphs glyphs_ = {};
  const SymbolPages& symbols_;
  int at_ = 0;
};

}  // namespace

std::optional<std::string> math_of(std::string_view formula, const SymbolPages& symbols) {
  try {
    return "<math displaystyle=\"true\">" + Reader(formula, symbols).whole() + "</math>";
  } catch (const NoFormula&) {
    return {};
  }
}

}  // namespace cairn::driver
