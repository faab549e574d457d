// Floor 8. Box2D 2.4.1 as an engine that cases can ask.
#pragma once

#include <cairn/validation/case.hpp>

namespace cairn {

/// Box2D, in float, with as many velocity iterations as a case asks of Cairn, and its usual three position
/// iterations. Empty where Cairn was built without Box2D.
/// The engines throw std::invalid_argument for scenes that Box2D 2.4.1 does not have.
EngineMaker box2d_engine();

}  // namespace cairn
