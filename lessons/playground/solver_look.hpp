// How a solver looks wherever it stands: as `lessons legend` has it.
#pragma once

#include <string>

#include "render/theme.hpp"

namespace cairn::playground {

/// The style of a solver by its name; those of a family share it: "pgs-sparse" looks like "pgs". A solver of
/// whole systems looks like the exact answer.
const render::SeriesStyle& look_of(const render::Theme& theme, const std::string& solver);

}  // namespace cairn::playground
