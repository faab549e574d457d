// The one shader program: every shape and glyph goes through it.
#pragma once

namespace cairn::render {

extern const char* const vertex_shader;
extern const char* const fragment_shader;

}  // namespace cairn::render
