// The flags of the verbs that step a scene, and what they ask for.
#pragma once

#include <string>

#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_list.hpp>

namespace cairn::sandbox {

/// The scene that comes with Cairn under this name, or the one in this file.
/// @throws UsageError for a name that is neither one of them nor in `others`, std::invalid_argument for a
/// file that cannot be read.
SceneEntry scene_of(const Words& words, const std::string& name, List<std::string> others = {});

/// --solver, --sweeps, --tolerance, --substeps, --contact-search, --frequency, --dt, --scalar,
/// --stabilization, --cold.
List<Flag> setting_flags();

/// --contact-search, which studies of whole runs take too.
List<Flag> search_flags();
/// What it asks for. @throws UsageError.
void set_search(const Words& words, Setting& setting);

/// Why the scene is stepped so, where nobody has said how: the reason of its default. Else nothing.
std::string why_chosen(const SceneEntry& scene, const Setting& setting);

/// The scene's recommended setting, with what the words ask for in its place.
/// @throws UsageError, std::invalid_argument for a setting that nobody can step by.
Setting setting_of(const Words& words, const SceneEntry& scene);

/// The same for a scene under several solvers, which share the words: refuse_idle_flags() is still to come.
Setting common_setting(const Words& words, const SceneEntry& scene);
/// @throws UsageError for a flag, such as --cold, that means nothing to any of the solvers.
void refuse_idle_flags(const Words& words, const List<std::string>& solvers);

/// "si" or "si:20": the setting with that solver, and with as many sweeps.
/// @throws UsageError that names --`flag`.
Setting with_solver(const Words& words, std::string_view flag, Setting setting, const std::string& text);

/// "--solver newton:16 --substeps 1": the flags with which a scene whose own setting is `usual` is stepped by
/// `setting`, as far as there are flags.
std::string flags_text(const Setting& setting, const Setting& usual);

/// --seconds, or the scene's own [s].
double seconds_of(const Words& words, const SceneEntry& scene);

/// Both lists in one.
List<Flag> joined_flags(List<Flag> first, const List<Flag>& second);

}  // namespace cairn::sandbox
