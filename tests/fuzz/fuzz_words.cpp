// Command lines: read by the program's own reader, and run where a run can be kept short.
#include "fuzz/fuzz_words.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include "render/image.hpp"

namespace cairn::fuzz {

namespace {

using sandbox::Flag;
using sandbox::Verb;
using sandbox::Words;

/// Those that can be kept to some hundredths of a second.
const std::set<std::string> quick_verbs = {"list",    "explain", "completion", "run",
                                           "compare", "inspect", "freeze"};
/// Pictures and films are slow, and so is the whole frozen set.
const std::set<std::string> quick_flags = {
    "solver",        "solvers", "sweeps",  "substeps", "frequency", "dt",       "scalar",
    "stabilization", "cold",    "seconds", "csv",      "json",      "quiet",    "plain",
    "color",         "step",    "rows",    "out",      "list",      "progress", "tolerance"};

List<std::string> divided(const std::string& bytes) {
  List<std::string> words(1);
  for (const char letter : bytes) {
    if (letter == ' ' || letter == '\n') {
      words.emplace_back();
    } else if (letter != '\0') {  // no operating system hands one over
      words.back() += letter;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Numbers above `most` become `most`; what is no number stays what it is.
void limit_number(Words& words, const char* flag, double most, const std::string& in_place) {
  const auto found = words.flags.find(flag);
  if (found == words.flags.end()) return;
  for (std::string& value : found->second) {
    const std::optional<double> number = parse_number(value);
    if (number && *number > most) value = in_place;
  }
}

/// A file is written where the program is, and not over a device.
std::string kept_here(const std::string& path) {
  const bool leaves = path.find('/') != std::string::npos || path.find("..") != std::string::npos;
  return leaves ? "fuzz.out" : path;
}

void limit_times(Words& words) {
  const auto limit_time = [&](const char* flag, auto is_slow, const std::string& in_place) {
    const std::optional<std::string> value = words.text(flag);
    if (!value) return;
    const std::optional<double> fraction = parse_number(*value);
    const std::optional<double> time = fraction ? fraction : sandbox::read_quantity(*value, "s");
    if (time && is_slow(*time)) words.flags[flag] = {in_place};
  };
  limit_time(
      "seconds", [](double time) { return time > 0.05; }, "0.05");
  limit_time(
      "dt", [](double time) { return time > 0 && time < 0.005; }, "0.005");
  if (!words.has("seconds")) words.flags["seconds"] = {"0.05"};
}

void limit_solvers(Words& words, const char* flag) {
  const auto found = words.flags.find(flag);
  if (found == words.flags.end()) return;
  for (std::string& value : found->second) {
    const std::size_t colon = value.find(':');
    if (value.find("reference") != std::string::npos) value = "si";  // takes minutes for large scenes
    const bool has_many =
        colon != std::string::npos && parse_number(value.substr(colon + 1)).value_or(0) > 20;
    if (has_many) value = value.substr(0, value.find(':'));
  }
}

/// The same words, so that running them takes little time and leaves the folder alone.
Words tamed(Words words, const Verb& verb) {
  for (auto flag = words.flags.begin(); flag != words.flags.end();) {
    flag = quick_flags.count(flag->first) != 0 ? std::next(flag) : words.flags.erase(flag);
  }
  for (const char* flag : {"csv", "out"}) {
    const auto found = words.flags.find(flag);
    if (found == words.flags.end()) continue;
    for (std::string& value : found->second) value = kept_here(value);
  }
  for (std::string& place : words.places) {
    if (place.find('/') != std::string::npos) place = "fuzz.toml";  // which is not there
  }
  limit_number(words, "sweeps", 20, "20");
  limit_number(words, "substeps", 3, "3");
  limit_number(words, "frequency", 200, "200");
  limit_number(words, "step", 4, "4");
  limit_solvers(words, "solver");
  limit_solvers(words, "solvers");
  limit_times(words);
  const bool has_step =
      std::any_of(verb.flags.begin(), verb.flags.end(), [](const Flag& flag) { return flag.name == "step"; });
  if (has_step && !words.has("step") && !words.has("list")) words.flags["step"] = {"4"};
  return words;
}

Outcome refused_words(const std::string& message) {
  if (message.empty()) throw Finding("a refusal says nothing");
  if (message.size() > 2000) throw Finding("a refusal is too long: " + message.substr(0, 200) + "...");
  return {.accepted = false, .message = message};
}

Outcome run_words(const std::string& bytes) {
  const List<std::string> all = divided(bytes);
  const auto verb = std::find_if(sandbox::verbs().begin(), sandbox::verbs().end(),
                                 [&](const Verb& v) { return !all.empty() && v.name == all.front(); });
  if (verb == sandbox::verbs().end()) return refused_words("no verb");
  const Words words = read_words(*verb, {all.begin() + 1, all.end()});
  if (words.has("help") && help_text(*verb).empty()) throw Finding("no help");
  if (words.has("help") || quick_verbs.count(verb->name) == 0) return {.accepted = true};
  Console console(words.console);
  const int code = verb->run(tamed(words, *verb), console);
  if (code < sandbox::all_well || code > sandbox::diverged) {
    throw Finding("an exit code of " + std::to_string(code));
  }
  return {.accepted = true};
}

}  // namespace

Outcome feed_words(const std::string& bytes) {
  try {
    return run_words(bytes);
  } catch (const Finding&) {
    throw;
  } catch (const sandbox::UsageError& error) {
    return refused_words(error.what());
  } catch (const std::invalid_argument& error) {
    return refused_words(error.what());
  } catch (const std::length_error& error) {
    return refused_words(error.what());
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    if (message.find("cannot ") == std::string::npos) throw Finding("a failure of no file: " + message);
    return refused_words(message);
  } catch (const std::exception& error) {
    throw Finding(std::string("an exception of another kind: ") + error.what());
  }
}

List<std::string> word_seeds() {
  List<std::string> seeds;
  for (const Verb& verb : sandbox::verbs()) {
    seeds.insert(seeds.end(), verb.examples.begin(), verb.examples.end());
    List<Flag> flags = verb.flags;
    flags.insert(flags.end(), sandbox::shared_flags().begin(), sandbox::shared_flags().end());
    for (const Flag& flag : flags) {
      seeds.push_back(verb.name + " stack --" + flag.name + (flag.takes.empty() ? "" : " 1"));
    }
  }
  return seeds;
}

}  // namespace cairn::fuzz
