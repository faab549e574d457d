// Reads the words behind a verb with CLI11; every word of a complaint is our own.
#include <CLI/CLI.hpp>
#include <map>
#include <vector>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {
namespace {

[[noreturn]] void refuse_words(const Verb& verb, const std::string& complaint) {
  throw UsageError("cairn " + verb.name + ": " + complaint);
}

[[noreturn]] void refuse_unknown(const Verb& verb, const std::string& word) {
  List<std::string> known;
  for (const Flag& flag : verb.flags) known.push_back("--" + flag.name);
  for (const Flag& flag : shared_flags()) known.push_back("--" + flag.name);
  const std::string meant = nearest(word.substr(0, word.find('=')), known);
  refuse_words(verb, "unknown flag " + word +
                         (meant.empty() ? "; cairn " + verb.name + " --help lists the flags"
                                        : "; did you mean " + meant + "?"));
}

/// CLI11 would take --json=no for an order.
void refuse_needless_values(const Verb& verb, const List<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t end = word.find('=');
    if (end == std::string::npos) continue;
    for (const List<Flag>* flags : {&verb.flags, &shared_flags()}) {
      for (const Flag& flag : *flags) {
        const bool is_it = word.compare(0, end, "--" + flag.name) == 0;
        if (is_it && flag.takes.empty()) {
          refuse_words(verb, "--" + flag.name + " takes no value, got " + word.substr(end + 1));
        }
      }
    }
  }
}

/// The values of each flag as CLI11 leaves them.
struct Values {
  std::map<std::string, std::vector<std::string>> of = {};
  std::map<std::string, bool> given = {};
};

void declare(CLI::App& app, const List<Flag>& flags, Values& values) {
  for (const Flag& flag : flags) {
    const std::string name = flag.name == "help"    ? "-h,--help"
                             : flag.name == "quiet" ? "-q,--quiet"
                                                    : "--" + flag.name;
    if (flag.takes.empty()) {
      app.add_flag(name, values.given[flag.name]);
    } else {
      app.add_option(name, values.of[flag.name])
          ->expected(1)
          ->allow_extra_args(false)  // or it would take the words behind its value too
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }
  }
}

void take(const Verb& verb, const List<Flag>& flags, const Values& values, Words& words) {
  for (const Flag& flag : flags) {
    if (flag.takes.empty()) {
      if (values.given.at(flag.name)) words.flags[flag.name] = {};
      continue;
    }
    const List<std::string> given(values.of.at(flag.name));
    if (given.empty()) continue;
    if (given.size() > 1 && !flag.many) refuse_words(verb, "--" + flag.name + " is given twice");
    for (const std::string& value : given) {
      if (value.empty()) refuse_words(verb, "--" + flag.name + " needs a value, got nothing");
      const bool is_flag = flag.takes_paths() && value.size() > 1 && value[0] == '-';
      if (is_flag) {
        refuse_words(verb, "--" + flag.name + " needs a path, got " + value +
                               "; one that begins with a dash is written ./" + value);
      }
    }
    words.flags[flag.name] = given;
  }
}

When when_of(const Words& words, const std::string& flag) {
  const std::string when = words.word(flag, "auto", {"auto", "always", "never"});
  return when == "always" ? When::always : when == "never" ? When::never : When::automatic;
}

}  // namespace

Words read_words(const Verb& verb, const List<std::string>& all) {
  refuse_needless_values(verb, all);
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  Values values;
  declare(app, verb.flags, values);
  declare(app, shared_flags(), values);
  try {
    std::vector<std::string> reversed(all.rbegin(), all.rend());  // as CLI11 wants them
    app.parse(reversed);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string what = error.what();
    refuse_words(verb,
                 what.substr(0, what.find(':')) +
                     (what.find("required") == std::string::npos ? " takes no value" : " needs a value"));
  } catch (const CLI::ParseError& error) {
    refuse_words(verb, error.what());
  }
  Words words{.verb = verb.name, .places = List<std::string>(app.remaining()), .flags = {}, .console = {}};
  for (const std::string& word : words.places) {
    if (word.size() > 1 && word[0] == '-') refuse_unknown(verb, word);
  }
  take(verb, verb.flags, values, words);
  take(verb, shared_flags(), values, words);
  words.console = {.color = when_of(words, "color"),
                   .progress = when_of(words, "progress"),
                   .plain = words.has("plain"),
                   .quiet = words.has("quiet"),
                   .narrates_on_stderr = words.has("json")};
  if (words.has("help")) return words;
  if (words.places.size() > verb.most_places) {
    refuse_words(verb, "unexpected word \"" + words.places[verb.most_places] + "\"; it goes cairn " +
                           verb.name + " " + verb.places);
  }
  if (words.places.size() < verb.fewest_places) {
    refuse_words(verb, "a word is missing: it goes cairn " + verb.name + " " + verb.places);
  }
  return words;
}

}  // namespace cairn::sandbox
