// A context from the browser: WebGL2 on the canvas of the page whose id is "cairn".
#ifdef CAIRN_HAVE_WEBGL

#include <GLES3/gl3.h>
#include <emscripten/html5.h>
#include <emscripten/html5_webgl.h>

#include <map>
#include <string>
#include <string_view>

#include "render/canvas.hpp"
#include "render/context.hpp"

namespace cairn::render {
namespace {

#define CAIRN_ENTRY(name) \
  { #name, reinterpret_cast < Context::Proc>(name) }

/// Asked for an address by name, emscripten has none: but it links what is named here.
const std::map<std::string_view, Context::Proc> entries = {
    CAIRN_ENTRY(glActiveTexture),
    CAIRN_ENTRY(glAttachShader),
    CAIRN_ENTRY(glBindBuffer),
    CAIRN_ENTRY(glBindFramebuffer),
    CAIRN_ENTRY(glBindRenderbuffer),
    CAIRN_ENTRY(glBindTexture),
    CAIRN_ENTRY(glBindVertexArray),
    CAIRN_ENTRY(glBlendFunc),
    CAIRN_ENTRY(glBlitFramebuffer),
    CAIRN_ENTRY(glBufferData),
    CAIRN_ENTRY(glCheckFramebufferStatus),
    CAIRN_ENTRY(glClear),
    CAIRN_ENTRY(glClearColor),
    CAIRN_ENTRY(glCompileShader),
    CAIRN_ENTRY(glCreateProgram),
    CAIRN_ENTRY(glCreateShader),
    CAIRN_ENTRY(glDeleteBuffers),
    CAIRN_ENTRY(glDeleteFramebuffers),
    CAIRN_ENTRY(glDeleteProgram),
    CAIRN_ENTRY(glDeleteRenderbuffers),
    CAIRN_ENTRY(glDeleteShader),
    CAIRN_ENTRY(glDeleteTextures),
    CAIRN_ENTRY(glDeleteVertexArrays),
    CAIRN_ENTRY(glDisable),
    CAIRN_ENTRY(glDrawElements),
    CAIRN_ENTRY(glEnable),
    CAIRN_ENTRY(glEnableVertexAttribArray),
    CAIRN_ENTRY(glFramebufferRenderbuffer),
    CAIRN_ENTRY(glGenBuffers),
    CAIRN_ENTRY(glGenFramebuffers),
    CAIRN_ENTRY(glGenRenderbuffers),
    CAIRN_ENTRY(glGenTextures),
    CAIRN_ENTRY(glGenVertexArrays),
    CAIRN_ENTRY(glGetError),
    CAIRN_ENTRY(glGetIntegerv),
    CAIRN_ENTRY(glGetProgramInfoLog),
    CAIRN_ENTRY(glGetProgramiv),
    CAIRN_ENTRY(glGetShaderInfoLog),
    CAIRN_ENTRY(glGetShaderiv),
    CAIRN_ENTRY(glGetUniformLocation),
    CAIRN_ENTRY(glLinkProgram),
    CAIRN_ENTRY(glPixelStorei),
    CAIRN_ENTRY(glReadPixels),
    CAIRN_ENTRY(glRenderbufferStorage),
    CAIRN_ENTRY(glScissor),
    CAIRN_ENTRY(glShaderSource),
    CAIRN_ENTRY(glTexImage2D),
    CAIRN_ENTRY(glTexParameteri),
    CAIRN_ENTRY(glTexSubImage2D),
    CAIRN_ENTRY(glUniform1i),
    CAIRN_ENTRY(glUniform2f),
    CAIRN_ENTRY(glUseProgram),
    CAIRN_ENTRY(glVertexAttribPointer),
    CAIRN_ENTRY(glViewport),
};

#undef CAIRN_ENTRY

class WebglContext final : public Context {
 public:
  WebglContext() {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = attributes.depth = attributes.stencil = attributes.antialias = EM_FALSE;
    attributes.preserveDrawingBuffer = EM_TRUE;
    context_ = emscripten_webgl_create_context("#cairn", &attributes);
    if (context_ <= 0)
      throw RenderError("the browser cannot make a WebGL2 context: switch hardware acceleration on");
  }
  ~WebglContext() override { emscripten_webgl_destroy_context(context_); }

  void make_current() override {
    if (emscripten_webgl_make_context_current(context_) != EMSCRIPTEN_RESULT_SUCCESS) {
      throw RenderError("WebGL2 cannot make its context current");
    }
  }
  void release() override { emscripten_webgl_make_context_current(0); }
  Proc proc(const char* name) const override {
    const auto found = entries.find(name);
    return found == entries.end() ? nullptr : found->second;
  }
  std::string backend() const override { return "webgl"; }
  const char* shader_head() const override {
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
  }

 private:
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context_ = 0;
};

}  // namespace

std::unique_ptr<Context> make_webgl_context() { return std::make_unique<WebglContext>(); }

}  // namespace cairn::render

#endif
