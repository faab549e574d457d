// Shards and journals, or a refusal that says what to do.
#include "lessons/sandbox/study_words.hpp"

#include "lessons/sandbox/interrupt.hpp"

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

Journal open_journal(const Words& words, const std::filesystem::path& path, const Study& study) {
  try {
    Journal journal(path, study);
    say_when_stopped(journal_goes_on);
    return journal;
  } catch (const std::invalid_argument& error) {
    throw UsageError("cairn " + words.verb + ": " + error.what() +
                     "; name another folder, or delete the journal to begin anew");
  }
}

}  // namespace cairn::sandbox
