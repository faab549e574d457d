// The seam to what provides OpenGL: where a context comes from, and nothing of OpenGL itself.
#pragma once

#include <memory>
#include <string>

namespace cairn::render {

/// One OpenGL 3.3 core context without a window; in a browser, WebGL2 on the canvas of the page. It is
/// current only between make_current and release, so that several contexts, also of different makers, live
/// side by side in one process.
class Context {
 public:
  using Proc = void (*)();

  Context() = default;
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// @throws RenderError
  virtual void make_current() = 0;
  virtual void release() = 0;

  /// The entry point of that name, null if there is none. The context must be current.
  virtual Proc proc(const char* name) const = 0;
  /// "osmesa", "egl" or "webgl".
  virtual std::string backend() const = 0;
  /// What every shader begins with: the version of its language.
  virtual const char* shader_head() const { return "#version 330 core\n"; }
};

/// The context that CAIRN_RENDER_BACKEND asks for; OSMesa, or else EGL, when the variable is unset. In a
/// browser, its own.
/// @throws RenderError
std::unique_ptr<Context> make_context();

/// @throws RenderError
std::unique_ptr<Context> make_osmesa_context();
std::unique_ptr<Context> make_egl_context();
std::unique_ptr<Context> make_webgl_context();

}  // namespace cairn::render
