// What a verb of `cairn` is: its flags as data, and what it does with their values.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lessons/kit/console.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {

/// How the program ends.
enum ExitCode {
  all_well = 0,
  check_failed = 1,
  bad_usage = 2,
  cannot_write = 3,
  diverged = 4,
  stopped = 130,  // as shells say it of SIGINT
};

/// The command line cannot be understood: one line for people.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Flag {
  std::string name = {};   // without the dashes
  std::string takes = {};  // "MM"; empty: it takes no value
  std::string help = {};   // with its standard value in brackets
  bool many = false;       // may be given more than once, or with commas

  /// Whether its values are places on disk.
  bool takes_paths() const { return takes == "DIR" || takes.rfind("FILE", 0) == 0; }
};

/// The words of a command line behind its verb, as far as flags and their values are told apart.
struct Words {
  std::string verb = {};
  List<std::string> places = {};  // what is no flag
  std::map<std::string, List<std::string>, std::less<>> flags = {};
  ConsoleSettings console = {};

  bool has(std::string_view flag) const { return flags.count(flag) != 0; }
  /// The value given last.
  std::optional<std::string> text(std::string_view flag) const;
  /// Every value given; those between commas are values of their own.
  List<std::string> texts(std::string_view flag) const;
  /// @throws UsageError unless it is a number from `least` to `most`.
  double number(std::string_view flag, double standard, double least, double most) const;
  int whole(std::string_view flag, int standard, int least, int most) const;
  /// The one of the words that it is, by known_word(). @throws UsageError where it is none.
  std::string word(std::string_view flag, const std::string& standard, const List<std::string>& words) const;
  /// A quantity in its SI unit, written with or without one: see read_quantity().
  /// @throws UsageError unless it is above 0 and at most `most`.
  double quantity(std::string_view flag, std::string_view unit, double standard,
                  double most = std::numeric_limits<double>::max()) const;
  /// Every value given, as `known` has it, once each. @throws UsageError unless each is one of `known`.
  List<std::string> known_texts(std::string_view flag, const List<std::string>& known) const;
  /// `list`: the command that shows them, where there are too many for a message.
  /// @throws UsageError "cairn VERB: what must be ..." unless `value` is one of `known`.
  void require_known(std::string_view what, const std::string& value, const List<std::string>& known,
                     const std::string& list = {}) const;
  /// @throws UsageError where the flag is given, but means nothing there.
  void refuse_beside(std::string_view flag, const std::string& what) const;
  /// @throws UsageError "cairn VERB: --flag must be rule, got value".
  [[noreturn]] void refuse(std::string_view flag, const std::string& rule, const std::string& value) const;
};

struct Verb {
  std::string name = {};
  std::string places = {};  // "SCENE [FILE]"
  int fewest_places = 0;
  int most_places = 0;
  std::string summary = {};  // for the list of verbs
  std::string idea = {};     // for its own help: what it answers, and what the answer means
  List<Flag> flags = {};
  List<std::string> examples = {};  // command lines behind "cairn "
  std::function<int(const Words&, Console&)> run = {};
};

/// All verbs, in the order in which help lists them.
const List<Verb>& verbs();
/// Flags that every verb has.
const List<Flag>& shared_flags();

/// "2mm", "0.02 m", "5 cm", "3 %", "10s", "250 ms": in m, 1 or s, as `unit` asks ("m", "%", "s"). A number
/// alone is in `unit`, where "%" stands for hundredths.
std::optional<double> read_quantity(std::string_view text, std::string_view unit);

/// @throws UsageError.
Words read_words(const Verb& verb, const List<std::string>& words);

/// The text of `cairn --help`, and of `cairn VERB --help`.
std::string help_text();
std::string help_text(const Verb& verb);

}  // namespace cairn::sandbox
