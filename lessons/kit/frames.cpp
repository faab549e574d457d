// Frame numbers: from 1 at the front, from -1 at the back.
#include "lessons/kit/frames.hpp"

#include <algorithm>
#include <charconv>

namespace cairn {
namespace {

constexpr int most_key_frames = 12;
constexpr int most_film_frames = 64;  // without the key frames between them

std::optional<int> parse_frame_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value == 0) return {};
  return value;
}

std::optional<FrameChoice> parse_range(std::string_view text) {
  FrameChoice choice = {.kind = FrameChoice::Kind::range};
  const std::size_t colon = text.find(':');
  const std::size_t second = colon == std::string_view::npos ? colon : text.find(':', colon + 1);
  const std::optional<int> first = parse_frame_number(text.substr(0, colon));
  if (!first) return {};
  choice.first = choice.last = *first;
  if (colon == std::string_view::npos) return choice;
  const std::optional<int> last = parse_frame_number(text.substr(colon + 1, second - colon - 1));
  if (!last) return {};
  choice.last = *last;
  if (second == std::string_view::npos) return choice;
  const std::optional<int> step = parse_frame_number(text.substr(second + 1));
  if (!step || *step < 1) return {};
  choice.step = *step;
  return choice;
}

/// From 0; below 0 or beyond the end when there is no such frame.
long long index_of(int number, int count) {
  return number > 0 ? number - 1LL : static_cast<long long>(count) + number;
}

List<int> frames_in_range(const FrameChoice& choice, int count) {
  const long long first = std::max(0LL, index_of(choice.first, count));
  const long long last = std::min(static_cast<long long>(count) - 1, index_of(choice.last, count));
  List<int> chosen;
  for (long long i = first; i <= last; i += choice.step) chosen.push_back(static_cast<int>(i));
  if (chosen.empty()) {
    const std::string asked = choice.first == choice.last ? "frame " + std::to_string(choice.first)
                                                          : "frames " + std::to_string(choice.first) + ":" +
                                                                std::to_string(choice.last);
    throw NoSuchFrame("--frames: there is no " + asked + "; the sequence has frames 1 to " +
                      std::to_string(count));
  }
  return chosen;
}

List<int> key_frames(const FrameSupply& supply) {
  List<int> chosen;
  for (int i = 0; i < supply.key.size(); ++i) {
    if (supply.key[i]) chosen.push_back(i);
  }
  if (chosen.size() > most_key_frames) {
    throw std::logic_error("a lesson has at most 12 key frames, this one has " +
                           std::to_string(chosen.size()));
  }
  return chosen;
}

List<int> film_frames(const FrameSupply& supply) {
  const int count = supply.key.size(), step = (count + most_film_frames - 1) / most_film_frames;
  List<int> chosen;
  for (int i = 0; i < count; ++i)
    if (i % step == 0 || supply.key[i] || i + 1 == count) chosen.push_back(i);
  return chosen;
}

List<int> cover_frame(const FrameSupply& supply) {
  const long long index = index_of(supply.cover, supply.key.size());
  if (supply.cover == 0 || index < 0 || index >= supply.key.size()) {
    throw std::logic_error("the cover is frame " + std::to_string(supply.cover) + " of " +
                           std::to_string(supply.key.size()));
  }
  return {static_cast<int>(index)};
}

}  // namespace

std::optional<FrameChoice> parse_frames(std::string_view text) {
  if (text == "key") return FrameChoice{.kind = FrameChoice::Kind::key};
  if (text == "all") return FrameChoice{.kind = FrameChoice::Kind::all};
  if (text == "film") return FrameChoice{.kind = FrameChoice::Kind::film};
  if (text == "none") return FrameChoice{.kind = FrameChoice::Kind::none};
  if (text == "cover") return FrameChoice{.kind = FrameChoice::Kind::cover};
  return parse_range(text);
}

List<int> chosen_frames(const FrameChoice& choice, const FrameSupply& supply) {
  switch (choice.kind) {
    case FrameChoice::Kind::none:
      return {};
    case FrameChoice::Kind::key:
      return key_frames(supply);
    case FrameChoice::Kind::film:
      return film_frames(supply);
    case FrameChoice::Kind::cover:
      return cover_frame(supply);
    case FrameChoice::Kind::all:
      return supply.key.empty() ? List<int>{} : frames_in_range(FrameChoice{}, supply.key.size());
    case FrameChoice::Kind::range:
      return frames_in_range(choice, supply.key.size());
  }
  return {};
}

}  // namespace cairn
