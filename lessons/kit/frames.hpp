// Which frames of a sequence are wanted: --frames key|all|film|none|cover|A:B[:S]|N.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <cairn/math/list.hpp>

namespace cairn {

struct FrameChoice {
  enum class Kind { key, all, film, none, cover, range } kind = Kind::key;
  int first = 1;  // from 1; negative: from the end, -1 is the last
  int last = -1;  // included
  int step = 1;
};

/// Nothing when the text is none of key, all, film, none, cover, N, A:B or A:B:S with numbers other than 0.
std::optional<FrameChoice> parse_frames(std::string_view text);

/// What is chosen from.
struct FrameSupply {
  List<bool> key = {};  // one for each frame of the sequence
  int cover = -1;       // as FrameChoice::first
};

/// The sequence has no such frame.
struct NoSuchFrame : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The chosen frames, from 0, in order. A film has all of up to 64, else every second, third ..., and of
/// those between what is key.
/// @throws NoSuchFrame when a range holds none, std::logic_error for more than 12 key frames or a cover that
/// is none of the frames.
List<int> chosen_frames(const FrameChoice& choice, const FrameSupply& supply);

}  // namespace cairn
