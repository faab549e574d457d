// Words that the verbs with a journal share.
#pragma once

#include <filesystem>

#include "lessons/sandbox/verb.hpp"
#include "study/journal.hpp"

namespace cairn::sandbox {

/// --shard; the whole without it. @throws UsageError, also beside --merge.
Shard shard_of(const Words& words);

/// What a verb with a journal says when it is stopped.
inline constexpr const char* journal_goes_on = "stopped; the same command goes on where it was";

/// Begins a journal or takes one up; from then on the program says so wherever it is stopped. @throws
/// UsageError for one of another study, or of another build.
Journal open_journal(const Words& words, const std::filesystem::path& path, const Study& study);

}  // namespace cairn::sandbox
