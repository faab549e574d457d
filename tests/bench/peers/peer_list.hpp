// Who is compared: every engine with its settings.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine.hpp"
#include <cairn/math/list.hpp>

namespace cairn::bench {

/// An engine under one setting.
struct Contestant {
  std::string name = {};
  std::function<std::unique_ptr<Engine>(const Scene&)> make = {};
};

/// One way of one engine, under settings of rising cost.
using Method = List<Contestant>;

/// With the settings that each engine comes with. The first is the one that times are compared with: Box2D 3,
/// or Box2D 2.4.1 where that is not there.
const List<Contestant>& usual_contestants();
/// How each engine may be made to work harder.
const List<Method>& methods();
/// The engines that are here, and those that were missing when this was built: one line each.
List<std::string> engine_lines();

}  // namespace cairn::bench
