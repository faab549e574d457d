// Floor 0. Names that were nearly right: how far two words are apart, and refusing an unknown one.
#pragma once

#include <string>
#include <string_view>

#include <cairn/math/list.hpp>

namespace cairn {

/// How many letters have to be put in, left out or replaced to make `b` of `a`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate that is nearest to `word`, if it is at most two letters off; "" if none is.
std::string nearest(std::string_view word, const List<std::string>& candidates);

/// The one of `known` that is the word, where blanks, "-" and "_" are the same: "split impulse" finds
/// "split-impulse". "" if none is.
std::string known_word(std::string_view word, const List<std::string>& known);

/// Throws std::invalid_argument unless `word` is one of `known`: names the nearest of them, or else all.
void require_known(std::string_view word, const List<std::string>& known, std::string_view place,
                   std::string_view field);

}  // namespace cairn
