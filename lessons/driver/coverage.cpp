// The items of the paper, and the marks of the lessons.
#include "lessons/driver/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "lessons/driver/commands.hpp"
#include "lessons/driver/exercises.hpp"
#include "lessons/kit/words.hpp"

namespace cairn::driver {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

bool is_item(const std::string& name) {
  return std::any_of(paper_items().begin(), paper_items().end(),
                     [&name](const PaperItem& item) { return item.name == name; });
}

int whole_number(const std::string& word) {
  const bool is_number =
      !word.empty() && word.size() < 6 && word.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? std::stoi(word) : 0;
}

/// "met 7" or "shown 7", with the frame that shows it; "met", "shown" or "mentioned".
bool read_how(const std::string& text, Covered& covered) {
  const std::size_t space = text.find(' ');
  const std::string word = text.substr(0, space);
  const bool has_frame = space != std::string::npos;
  covered.frame = has_frame ? whole_number(text.substr(space + 1)) : 0;
  if (word == "met") covered.how = Coverage::met;
  if (word == "shown") covered.how = Coverage::shown;
  if (has_frame) return covered.frame > 0 && (word == "met" || word == "shown");
  return word == "met" || word == "shown" || word == "mentioned";
}

/// A check may have a | in it, as in |λ|: only the first two separate.
Covered covered_in(const std::string& line, const std::string& place) {
  const std::size_t first = line.find('|');
  const std::size_t second = first == std::string::npos ? first : line.find('|', first + 1);
  Covered covered;
  bool is_whole = second != std::string::npos;
  if (is_whole) {
    covered.item = trimmed(line.substr(0, first));
    covered.what = trimmed(line.substr(second + 1));
    is_whole =
        read_how(trimmed(line.substr(first + 1, second - first - 1)), covered) && !covered.what.empty();
  }
  if (!is_whole) {
    throw std::runtime_error(
        place + " must be \"item | met, shown or mentioned, or the first two with a frame | what\", got " +
        line);
  }
  if (!is_item(covered.item)) throw std::runtime_error(place + ": the paper has no item " + covered.item);
  return covered;
}

constexpr const char* coverage_words[] = {"met", "shown", "mentioned"};  // in the order of Coverage

/// Prints where the lessons have an item. The best way in which one of them does; none where no lesson has
/// it.
std::optional<Coverage> print_item(const Context& context, Console& console, const PaperItem& item) {
  std::optional<Coverage> best;
  console.result(
      console.colored(console.spelt(padded(item.name, 18) + " " + item.what), Console::Color::bold));
  for (const Program& program : context.programs) {
    for (const Covered& covered : covered_by(program)) {
      if (covered.item != item.name) continue;
      best = best ? std::min(*best, covered.how) : covered.how;
      const std::string frame = covered.frame > 0 ? fmt::format(", {}", covered.frame) : "";
      console.result(
          console.spelt(fmt::format("{} {} {}", padded(two_digits(program.number) + frame, 8),
                                    padded(coverage_words[static_cast<int>(covered.how)], 9), covered.what)));
    }
  }
  if (!best) console.result(padded("", 8) + " " + console.colored("in no lesson", Console::Color::bad));
  return best;
}

}  // namespace

const List<PaperItem>& paper_items() {
  static const List<PaperItem> items = {
      {"(1)", "the system velocity v"},
      {"(2)", "the system mass M⁻¹"},
      {"(3)", "a constraint c = 0"},
      {"(4)", "Baumgarte: dc/dt = −β c / Δt"},
      {"(5)", "the Jacobian: dc/dt = j v"},
      {"(6)", "the system Jacobian J"},
      {"(7)", "ζ = −β c / Δt"},
      {"(8)", "J v = ζ"},
      {"(9)", "constraint forces and torques"},
      {"(10)", "f = Jᵀ λ"},
      {"(11)", "J v₂ = ζ"},
      {"(12)", "v₂ = v₁ + M⁻¹ Jᵀ λ Δt"},
      {"(13)", "J M⁻¹ Jᵀ λ = (ζ − J v₁) / Δt"},
      {"(14)", "A λ = b"},
      {"(15)", "A = J M⁻¹ Jᵀ, b = (ζ − J v₁) / Δt"},
      {"2.2 bounds", "intervals of valid values for λ"},
      {"2.3 sparsity", "J and M⁻¹ are mostly zeros"},
      {"2.3 warm start", "last step's λ as the first guess"},
      {"2.3 order", "rows come, go and change places"},
      {"(16)", "v of two bodies"},
      {"(17)", "M⁻¹ of two bodies"},
      {"(18)", "the impulse p of a constraint"},
      {"(19)", "v₂ = v₁ + M⁻¹ p"},
      {"(20)", "0 = ζ − j v₂"},
      {"(21)", "p = jᵀ λ Δt"},
      {"(22)", "λ = (ζ − j v₁) / (j M⁻¹ jᵀ Δt)"},
      {"(23)", "p = jᵀ (ζ − j v₁) / (j M⁻¹ jᵀ)"},
      {"Algorithm 1", "sequential impulses"},
      {"3.2 clamp", "the accumulated λ is clamped, not the correction"},
      {"(24)", "η: the λ so far"},
      {"(25)", "a step changes one η"},
      {"(26)", "v = v̄ + M⁻¹ Jᵀ η Δt"},
      {"(27)", "the step of SI, with η"},
      {"(28)", "the step of Gauss-Seidel, with η"},
      {"(29)", "both are the same"},
      {"4.1", "SI and PGS are one algorithm"},
      {"4.1 time", "either takes about as long to write"},
      {"4.2 classes", "a class for each constraint keeps solver and constraints apart"},
      {"4.2 bookkeeping", "PGS by classes has to keep the numbers of rows"},
      {"4.2 A", "PGS has A, for whatever else needs it"},
      {"4.2 duplicates", "what classes compute for themselves, they write twice"},
      {"4.2 debugging", "a constraint that is an object can be looked at"},
      {"4.2 intuition", "solve one constraint, then all, again and again"},
      {"4.2 sparsity", "what PGS has to look for, SI has by itself"},
      {"4.2 once", "effective mass and ζ do not change while iterating"},
      {"4.3 bodies", "a row on more than two bodies, and no change of the solver"},
      {"4.3 blocks", "a whole constraint at once converges better"},
      {"4.3 duplicates", "a block computes once what its rows share"},
      {"4.3 updates", "a block of three rows saves two velocity updates a sweep"},
      {"4.3 inverse", "the matrix of a block is inverted once a step"},
      {"4.3 softness", "a spring is a change of one class, or of A"},
      {"4.4 two bodies", "a row changes two bodies; all velocities anew are a waste"},
      {"(30)", "the non-zeros of A"},
      {"4.4 memory", "SI stores one effective mass a row"},
      {"4.4 virtual", "virtual calls bring overhead, which is small"},
      {"4.4 split loop", "contacts have a loop of their own, without virtual calls"},
      {"4.4 contacts", "contacts outnumber joints by far"},
      {"4.4 friction", "contact and friction share their work"},
      {"4.4 locality", "large arrays and the cache"},
      {"4.4 building", "the cost of building the structures"},
      {"4.4 parallel", "Jacobi for parallel hardware"},
      {"4.4 synchronising", "what two processors have to tell each other each step"},
      {"4.5 stacking", "equally stable with contacts and stacks"},
      {"4.5 blocks", "blocks are more stable"},
      {"4.5 cone", "a friction cone instead of a pyramid"},
      {"4.5 aligned", "a pyramid along the velocity does as well"},
      {"5 maintenance", "optimized SI stays close to its algorithm, and is easier to understand"},
      {"5 flexibility", "rows on many bodies, and constraints with a behaviour of their own"},
      {"5 parallel", "PGS has the advantage on a GPU"},
      {"5 choice", "SI is the better choice in most situations"}};
  return items;
}

List<Covered> covered_by(const Program& lesson) {
  const std::filesystem::path file = lesson_folder(lesson) / "covers.txt";
  std::ifstream stream(file);
  List<Covered> all;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    all.push_back(covered_in(line, fmt::format("{}:{}", file.string(), number)));
  }
  return all;
}

int coverage(const Context& context) {
  Console console(context.settings);
  int counts[] = {0, 0, 0}, missing = 0;
  console.result("lesson, frame: met by a check named for the item alone, shown, or only mentioned");
  for (const PaperItem& item : paper_items()) {
    const std::optional<Coverage> best = print_item(context, console, item);
    ++(best ? counts[static_cast<int>(*best)] : missing);
  }
  console.result(fmt::format("{} items: {} met, {} shown, {} mentioned, {} in no lesson",
                             paper_items().size(), counts[0], counts[1], counts[2], missing));
  return missing > 0 ? 1 : 0;
}

}  // namespace cairn::driver
