// Chooses where the OpenGL context comes from.
#include "render/context.hpp"

#include <cstdlib>
#include <string>
#include <string_view>

#include "render/canvas.hpp"

namespace cairn::render {

#ifndef CAIRN_HAVE_OSMESA
std::unique_ptr<Context> make_osmesa_context() {
  throw RenderError("OSMesa was not there when Cairn was built: install libosmesa6-dev and build again");
}
#endif

#ifndef CAIRN_HAVE_EGL
std::unique_ptr<Context> make_egl_context() {
  throw RenderError("EGL was not there when Cairn was built: install libegl-dev and build again");
}
#endif

#ifdef CAIRN_HAVE_WEBGL
std::unique_ptr<Context> make_context() { return make_webgl_context(); }
#else
std::unique_ptr<Context> make_context() {
  const char* variable = std::getenv("CAIRN_RENDER_BACKEND");
  const std::string_view wanted = variable == nullptr ? "" : variable;
  if (wanted == "osmesa") {
    return make_osmesa_context();
  }
  if (wanted == "egl") {
    return make_egl_context();
  }
  if (!wanted.empty()) {
    throw RenderError("CAIRN_RENDER_BACKEND must be osmesa or egl, got " + std::string(wanted));
  }
  std::string why;
  try {
    return make_osmesa_context();
  } catch (const RenderError& error) {
    why = error.what();
  }
  try {
    return make_egl_context();
  } catch (const RenderError& error) {
    throw RenderError("no way to draw; OSMesa: " + why + "; EGL: " + error.what());
  }
}
#endif

}  // namespace cairn::render
