// Shards and journals, or a refusal that says what to do.
#include "lessons/sandbox/study_words.hpp"

#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/progress_line.hpp"

namespace cairn::sandbox {
Shard shard_of(const Words& words) {
  const std::optional<std::string> given = words.text("shard");
  if (!given) return {};
  words.refuse_beside("merge", "beside --shard");
  try {
    return parse_shard(*given);
  } catch (const std::invalid_argument&) {
    words.refuse("shard", "k/n with 1 <= k <= n <= 10000", *given);
  }
}

Journal open_journal(const Words& words, const std::filesystem::path& path, const Study& study,
                     const std::string& goes_on) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (words.has("again")) std::filesystem::remove(path, error);
  try {
    Journal journal(path, study);
    say_when_stopped(goes_on);
    return journal;
  } catch (const std::invalid_argument& other) {
    throw UsageError("cairn " + words.verb + ": " + other.what() +
                     "; name another folder, or delete the journal to begin anew");
  }
}

bool run_or_merge(const Words& words, const Study& study, const Shard& shard, Journal& journal,
                  const std::string& what, const std::string& goes_on) {
  for (const std::string& other : words.texts("merge")) journal.absorb(other);
  if (words.has("merge")) return true;
  ProgressLine bar(words.console, what, tasks_in(study, shard));
  const bool finished = run_study(study, shard, journal, [&](int done, int, double left) {
    bar.advance(done, left);
    return !interrupted();
  });
  bar.clear();
  if (!finished) Console(words.console).warn(goes_on);
  return finished;
}

}  // namespace cairn::sandbox
