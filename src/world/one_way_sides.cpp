// Floor 5. Who is held off by what is one-way.
#include <cairn/world/one_way_sides.hpp>

#include <algorithm>
#include <tuple>

namespace cairn {

void OneWaySides::end() {
  const auto key = [](const Sight& sight) { return std::tuple(sight.shape, sight.other); };
  std::sort(sights_.begin(), sights_.end(),
            [key](const Sight& one, const Sight& other) { return key(one) < key(other); });
  List<Held> held;
  for (int i = 0; i < sights_.size();) {
    Sight all = sights_[i];
    for (; i < sights_.size() && key(sights_[i]) == key(all); ++i) {
      all.outside &= sights_[i].outside;
      all.overlaps |= sights_[i].overlaps;
    }
    if (all.outside || (all.overlaps && holds(all.shape, all.other))) held.push_back({all.shape, all.other});
  }
  held_ = std::move(held);
}

bool OneWaySides::holds(int shape, BodyId other) const {
  return std::binary_search(held_.begin(), held_.end(), Held{shape, other});
}

/// Shapes keep their order.
void OneWaySides::carry_over(const OneWaySides& before, Span<const int> numbers) {
  held_.clear();
  for (const Held& held : before.held_) {
    if (numbers[held.shape] >= 0) held_.push_back({numbers[held.shape], held.other});
  }
}

}  // namespace cairn
