// Sets up OpenGL, draws batches, reads frames back.
#include "render/surface.hpp"

#include <cstddef>
#include <string>

#include <cairn/math/list.hpp>
#include "render/shader.hpp"

namespace cairn::render {
namespace {

/// A context is current only while it is used: two canvases in one thread do not disturb each other.
class Current {
 public:
  explicit Current(Context& context) : context_(context) { context_.make_current(); }
  ~Current() { context_.release(); }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  Context& context_;
};

const void* at_offset(std::ptrdiff_t offset) {
  return reinterpret_cast<const void*>(offset);  // how OpenGL wants it since buffers were added to it
}

}  // namespace

Surface::Surface(int width, int height, int atlas_side)
    : width_(width), height_(height), context_(make_context()) {
  const Current current(*context_);
  gl_ = load_gl(*context_);
  try {
    check_size();
    make_target();
    make_program();
    make_buffers();
    make_texture(atlas_side);
  } catch (...) {
    delete_objects();
    throw;
  }
}

Surface::~Surface() {
  const Current current(*context_);
  delete_objects();
}

void Surface::delete_objects() {
  gl_.delete_textures(1, &texture_);
  gl_.delete_buffers(1, &index_buffer_);
  gl_.delete_buffers(1, &vertex_buffer_);
  gl_.delete_vertex_arrays(1, &vertex_array_);
  gl_.delete_program(program_);
  gl_.delete_renderbuffers(1, &renderbuffer_);
  gl_.delete_framebuffers(1, &framebuffer_);
}

void Surface::check_size() const {
  GLint largest = 0;
  gl_.get_integerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (width_ > largest || height_ > largest) {
    throw RenderError("Canvas: width and height must be at most " + std::to_string(largest) + " px, got " +
                      std::to_string(width_) + " x " + std::to_string(height_));
  }
}

void Surface::make_target() {
  gl_.gen_framebuffers(1, &framebuffer_);
  gl_.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.gen_renderbuffers(1, &renderbuffer_);
  gl_.bind_renderbuffer(GL_RENDERBUFFER, renderbuffer_);
  gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
  gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
  if (gl_.check_framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw RenderError("OpenGL cannot make a framebuffer of " + std::to_string(width_) + " x " +
                      std::to_string(height_) + " px");
  }
}

GLuint Surface::compile(GLenum stage, const char* source) const {
  const GLuint shader = gl_.create_shader(stage);
  const FixedList<const char*, 2> sources = {context_->shader_head(), source};
  gl_.shader_source(shader, sources.size(), sources.data(), nullptr);
  gl_.compile_shader(shader);
  GLint compiled = GL_FALSE;
  gl_.get_shaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    FixedList<char, 1024> log = {};
    gl_.get_shader_info_log(shader, log.size(), nullptr, log.data());
    gl_.delete_shader(shader);
    throw RenderError(std::string("OpenGL refuses the shader: ") + log.data());
  }
  return shader;
}

void Surface::make_program() {
  program_ = gl_.create_program();
  for (const auto& [stage, source] : {std::pair(GLenum{GL_VERTEX_SHADER}, vertex_shader),
                                      std::pair(GLenum{GL_FRAGMENT_SHADER}, fragment_shader)}) {
    const GLuint shader = compile(stage, source);
    gl_.attach_shader(program_, shader);
    gl_.delete_shader(shader);  // it lives on with the program
  }
  gl_.link_program(program_);
  GLint linked = GL_FALSE;
  gl_.get_programiv(program_, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    FixedList<char, 1024> log = {};
    gl_.get_program_info_log(program_, log.size(), nullptr, log.data());
    throw RenderError(std::string("OpenGL cannot link the shaders: ") + log.data());
  }
  gl_.use_program(program_);
  gl_.uniform_2f(gl_.get_uniform_location(program_, "pixel"), 2.0F / static_cast<float>(width_),
                 2.0F / static_cast<float>(height_));
  gl_.uniform_1i(gl_.get_uniform_location(program_, "glyphs"), 0);
}

void Surface::make_buffers() {
  gl_.gen_vertex_arrays(1, &vertex_array_);
  gl_.bind_vertex_array(vertex_array_);
  gl_.gen_buffers(1, &vertex_buffer_);
  gl_.bind_buffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl_.gen_buffers(1, &index_buffer_);
  gl_.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  constexpr GLsizei stride = sizeof(Vertex);
  const auto floats = [&](GLuint location, GLint count, std::ptrdiff_t offset) {
    gl_.enable_vertex_attrib_array(location);
    gl_.vertex_attrib_pointer(location, count, GL_FLOAT, GL_FALSE, stride, at_offset(offset));
  };
  const auto color = [&](GLuint location, std::ptrdiff_t offset) {
    gl_.enable_vertex_attrib_array(location);
    gl_.vertex_attrib_pointer(location, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, at_offset(offset));
  };
  floats(0, 2, offsetof(Vertex, position));
  floats(1, 4, offsetof(Vertex, local));
  floats(2, 4, offsetof(Vertex, first_and_kind));
  floats(3, 4, offsetof(Vertex, second_and_half_outline));
  floats(4, 4, offsetof(Vertex, shape));
  color(5, offsetof(Vertex, fill));
  color(6, offsetof(Vertex, outline));
}

void Surface::make_texture(int side) {
  gl_.gen_textures(1, &texture_);
  gl_.active_texture(GL_TEXTURE0);
  gl_.bind_texture(GL_TEXTURE_2D, texture_);
  gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.tex_image_2d(GL_TEXTURE_2D, 0, GL_R8, side, side, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  gl_.viewport(0, 0, width_, height_);
  gl_.enable(GL_BLEND);
  gl_.blend_func(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.pixel_storei(GL_PACK_ALIGNMENT, 1);
  gl_.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
}

void Surface::upload(const GlyphAtlas& atlas) {
  if (atlas.version() == uploaded_version_) {
    return;
  }
  gl_.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, atlas.side(), atlas.side(), GL_RED, GL_UNSIGNED_BYTE,
                       atlas.texels().data());
  uploaded_version_ = atlas.version();
}

void Surface::clear(const Color& background) {
  const Current current(*context_);
  gl_.disable(GL_SCISSOR_TEST);
  gl_.clear_color(background.r, background.g, background.b, 1);
  gl_.clear(GL_COLOR_BUFFER_BIT);
}

void Surface::draw(const Batch& batch, const GlyphAtlas& atlas) {
  if (batch.draws().empty()) {
    return;
  }
  const Current current(*context_);
  upload(atlas);
  gl_.buffer_data(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(batch.vertices().bytes()), batch.vertices().data(),
                  GL_STREAM_DRAW);
  gl_.buffer_data(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(batch.indices().bytes()),
                  batch.indices().data(), GL_STREAM_DRAW);
  constexpr std::ptrdiff_t index_size = sizeof(std::uint32_t);  // [bytes]
  gl_.enable(GL_SCISSOR_TEST);
  for (const Draw& part : batch.draws()) {
    const PixelRect& clip = part.clip;
    gl_.scissor(clip.left, clip.top, clip.right - clip.left, clip.bottom - clip.top);
    gl_.draw_elements(GL_TRIANGLES, part.count, GL_UNSIGNED_INT, at_offset(part.first * index_size));
  }
}

Image Surface::read() {
  const Current current(*context_);
  const std::ptrdiff_t count = std::ptrdiff_t{width_} * height_;
  List<std::uint8_t> pixels(4 * count);
  gl_.read_pixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  if (const GLenum error = gl_.get_error(); error != GL_NO_ERROR) {
    throw RenderError("OpenGL reports error " + std::to_string(error) + " after a frame");
  }
  Image image = {.width = width_, .height = height_};
  image.pixels.resize(3 * count);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    image.pixels[3 * i] = pixels[4 * i];
    image.pixels[3 * i + 1] = pixels[4 * i + 1];
    image.pixels[3 * i + 2] = pixels[4 * i + 2];
  }
  return image;
}

void Surface::show() {
  const Current current(*context_);
  gl_.disable(GL_SCISSOR_TEST);
  gl_.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.blit_framebuffer(0, 0, width_, height_, 0, height_, width_, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
}

}  // namespace cairn::render
