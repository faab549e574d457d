// A context from EGL without a surface, always on the software device: a graphics card would give
// other pixels.
#ifdef CAIRN_HAVE_EGL

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string_view>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"
#include "render/context.hpp"

namespace cairn::render {
namespace {

bool lists(const char* extensions, std::string_view name) {
  return extensions != nullptr && std::string_view(extensions).find(name) != std::string_view::npos;
}

template <typename Function>
Function egl_proc(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

EGLDisplay display_of(EGLenum platform, void* native) {
  const auto get = egl_proc<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get == nullptr ? EGL_NO_DISPLAY : get(platform, native, nullptr);
}

/// The display of the first device that draws in software; the surfaceless platform where devices are not
/// listed.
EGLDisplay software_display() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto devices = egl_proc<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto describe = egl_proc<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (lists(client, "EGL_EXT_platform_device") && devices != nullptr && describe != nullptr) {
    FixedList<EGLDeviceEXT, 16> found = {};
    EGLint count = 0;
    devices(found.size(), found.data(), &count);
    for (int i = 0; i < count; ++i) {
      if (lists(describe(found[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) {
        return display_of(EGL_PLATFORM_DEVICE_EXT, found[i]);
      }
    }
  }
  if (lists(client, "EGL_MESA_platform_surfaceless")) {
    return display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  }
  return EGL_NO_DISPLAY;
}

class EglContext final : public Context {
 public:
  EglContext() : display_(software_display()) {
    // The display is shared by all contexts of the process and stays open: closing it would end them all.
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      throw RenderError("EGL has no display that draws in software: install libegl-mesa0");
    }
    if (!lists(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
      throw RenderError("EGL cannot draw without a surface: EGL_KHR_surfaceless_context is missing");
    }
    eglBindAPI(EGL_OPENGL_API);
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display_, config_attributes.data(), &config, 1, &count);
    if (count > 0) {
      context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, context_attributes.data());
    }
    if (context_ == EGL_NO_CONTEXT) {
      throw RenderError("EGL cannot make an OpenGL 3.3 core context: install libgl1-mesa-dri");
    }
  }
  ~EglContext() override { eglDestroyContext(display_, context_); }

  void make_current() override {
    eglBindAPI(EGL_OPENGL_API);
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      throw RenderError("EGL cannot make its context current");
    }
  }
  void release() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  Proc proc(const char* name) const override { return eglGetProcAddress(name); }
  std::string backend() const override { return "egl"; }

 private:
  static constexpr FixedList<EGLint, 5> config_attributes = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                                             EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
  static constexpr FixedList<EGLint, 7> context_attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                              3,
                                                              EGL_CONTEXT_MINOR_VERSION,
                                                              3,
                                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                              EGL_NONE};

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace cairn::render

#endif
