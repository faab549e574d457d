// Floor 10. Ratios to the best.
#include "study/profile.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace cairn {

double PerformanceProfile::share(double tau) const {
  if (ratios.empty()) return 0;
  const auto beyond = std::upper_bound(ratios.begin(), ratios.end(), tau);
  // An infinite tau does not make a failure a success.
  const auto failed = std::lower_bound(ratios.begin(), ratios.end(), std::numeric_limits<double>::infinity());
  return static_cast<double>(std::min(beyond, failed) - ratios.begin()) / static_cast<double>(ratios.size());
}

List<PerformanceProfile> performance_profiles(const List<WorkToError>& work, int which) {
  const double never = std::numeric_limits<double>::infinity();
  std::map<std::string, double> least;  // by problem
  for (const WorkToError& entry : work) {
    const auto found = least.try_emplace(entry.scene, never).first;
    found->second = std::min(found->second, entry.row_updates.at(which));
  }
  List<PerformanceProfile> profiles;
  for (const WorkToError& entry : work) {
    auto own = std::find_if(profiles.begin(), profiles.end(),
                            [&](const PerformanceProfile& p) { return p.solver == entry.solver; });
    if (own == profiles.end()) own = profiles.insert(own, {.solver = entry.solver, .ratios = {}});
    const double updates = entry.row_updates.at(which), best = least.at(entry.scene);
    if (updates < never) own->ratios.push_back(updates == best ? 1 : updates / best);
  }
  for (PerformanceProfile& profile : profiles) {
    profile.ratios.resize(std::ssize(least), never);
    std::sort(profile.ratios.begin(), profile.ratios.end());
  }
  return profiles;
}

}  // namespace cairn
