// The OpenGL side of a canvas: a framebuffer, the one program, and the buffers that a batch is drawn from.
#pragma once

#include <memory>
#include <string>

#include "render/batch.hpp"
#include "render/canvas.hpp"
#include "render/context.hpp"
#include "render/font.hpp"
#include "render/gl_api.hpp"

namespace cairn::render {

class Surface {
 public:
  /// For frames of this size [px], and glyphs of an atlas with this side [px]. @throws RenderError
  Surface(int width, int height, int atlas_side);
  ~Surface();
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  void clear(const Color& background);
  void draw(const Batch& batch, const GlyphAtlas& atlas);
  Image read();
  /// Puts the frame on what the context shows, upright.
  void show();
  std::string backend() const { return context_->backend(); }

 private:
  void check_size() const;
  void make_target();
  void make_program();
  void make_buffers();
  void make_texture(int side);
  void upload(const GlyphAtlas& atlas);
  void delete_objects();
  GLuint compile(GLenum stage, const char* source) const;

  int width_ = 0;
  int height_ = 0;
  std::unique_ptr<Context> context_;
  GlApi gl_ = {};
  GLuint framebuffer_ = 0;
  GLuint renderbuffer_ = 0;
  GLuint program_ = 0;
  GLuint vertex_array_ = 0;
  GLuint vertex_buffer_ = 0;
  GLuint index_buffer_ = 0;
  GLuint texture_ = 0;
  int uploaded_version_ = 0;
};

}  // namespace cairn::render
