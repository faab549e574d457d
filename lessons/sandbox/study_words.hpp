// Words that the verbs with a journal share.
#pragma once

#include <filesystem>

#include "lessons/sandbox/verb.hpp"
#include <cairn/study/journal.hpp>

namespace cairn::sandbox {

/// --shard; the whole without it. @throws UsageError, also beside --merge.
Shard shard_of(const Words& words);

/// What a verb with a journal says when it is stopped.
inline const std::string journal_goes_on = "stopped; the same command goes on where it was";

/// Begins a journal or takes one up, with --again without what was found before. From then on the program
/// says `goes_on` wherever it is stopped. @throws UsageError for one of another study, or of another build.
Journal open_journal(const Words& words, const std::filesystem::path& path, const Study& study,
                     const std::string& goes_on = journal_goes_on);

/// Does what is left of the shard, with a bar that counts `what`; puts the parts of --merge together instead.
/// False when it was stopped, which it says.
bool run_or_merge(const Words& words, const Study& study, const Shard& shard, Journal& journal,
                  const std::string& what, const std::string& goes_on = journal_goes_on);

}  // namespace cairn::sandbox
