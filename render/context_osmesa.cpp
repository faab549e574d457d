// A context from OSMesa, which draws in software into plain memory.
#ifdef CAIRN_HAVE_OSMESA

#include <GL/osmesa.h>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"
#include "render/context.hpp"

namespace cairn::render {
namespace {

class OsmesaContext final : public Context {
 public:
  OsmesaContext() : context_(OSMesaCreateContextAttribs(attributes.data(), nullptr)) {
    if (context_ == nullptr) {
      throw RenderError("OSMesa cannot make an OpenGL 3.3 core context: install libosmesa6");
    }
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  void make_current() override {
    if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, side, side) == GL_FALSE) {
      throw RenderError("OSMesa cannot make its context current");
    }
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  Proc proc(const char* name) const override { return OSMesaGetProcAddress(name); }
  std::string backend() const override { return "osmesa"; }

 private:
  static constexpr int side = 8;
  static constexpr FixedList<int, 11> attributes = {OSMESA_FORMAT,
                                                    OSMESA_RGBA,
                                                    OSMESA_PROFILE,
                                                    OSMESA_CORE_PROFILE,
                                                    OSMESA_CONTEXT_MAJOR_VERSION,
                                                    3,
                                                    OSMESA_CONTEXT_MINOR_VERSION,
                                                    3,
                                                    OSMESA_DEPTH_BITS,
                                                    0,
                                                    0};

  OSMesaContext context_ = nullptr;
  // OSMesa insists on a buffer of its own; pictures are drawn into a framebuffer object.
  FixedList<unsigned char, 4 * side* side> buffer_ = {};
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace cairn::render

#endif
