// cairn: one program for your own scenes. The word behind its name says what to do.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>

#include "lessons/kit/fitting.hpp"
#include "lessons/kit/output.hpp"
#include "lessons/kit/words.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/math/printable.hpp>
#include "render/context.hpp"
#include "render/image.hpp"

namespace {

using namespace cairn;
using namespace cairn::sandbox;

int complain(int code, const std::string& message) {
  std::fflush(stdout);
  fmt::print(stderr, "{}", fitted(excerpt(message, longest_message) + "\n", width_of_stream(stderr)));
  return code;
}

int refuse_verb(const std::string& word) {
  List<std::string> known;
  for (const Verb& verb : verbs()) known.push_back(verb.name);
  const std::string meant = nearest(word, known);
  return complain(bad_usage, "cairn: there is no verb " + word +
                                 (meant.empty() ? "; there are: " + joined(known, ", ")
                                                : "; did you mean " + meant + "?"));
}

int act(const List<std::string>& all) {
  const std::string word = all.empty() ? "--help" : all.front();
  if (word == "-h" || word == "--help" || word == "help") {
    fmt::print("{}", fitted(help_text(), width_of_stream(stdout)));
    return all.empty() ? bad_usage : all_well;
  }
  if (word == "--version") {
    fmt::print("cairn {}\n", CAIRN_VERSION);
    return all_well;
  }
  const auto verb =
      std::find_if(verbs().begin(), verbs().end(), [&](const Verb& v) { return v.name == word; });
  if (verb == verbs().end()) return refuse_verb(word);
  const Words words = read_words(*verb, {all.begin() + 1, all.end()});
  if (words.has("help")) {
    fmt::print("{}", fitted(help_text(*verb), width_of_stream(stdout)));
    return all_well;
  }
  Console console(words.console);
  return verb->run(words, console);
}

int finished(int code) {
  if (output_is_written()) return code;
  return complain(cannot_write, "cairn: the output cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  obey_interrupts();
  try {
    return finished(act({argv + std::min(argc, 1), argv + argc}));
  } catch (const UsageError& error) {
    return complain(bad_usage, error.what());
  } catch (const Interrupted& error) {
    return complain(stopped, std::string("cairn: ") + error.what());
  } catch (const std::invalid_argument& error) {
    return complain(bad_usage, std::string("cairn: ") + error.what());
  } catch (const std::length_error& error) {
    return complain(bad_usage, std::string("cairn: ") + error.what());
  } catch (const std::bad_alloc&) {
    return complain(cannot_write, "cairn: there is not enough memory for this scene");
  } catch (const render::RenderError& error) {
    return complain(cannot_write, std::string("cairn: ") + error.what());
  } catch (const std::exception& error) {
    return complain(cannot_write, std::string("cairn: ") + error.what());
  }
}
