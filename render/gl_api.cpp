// Loads the OpenGL entry points by name.
#include "render/gl_api.hpp"

#include <string>

#include "render/canvas.hpp"
#include "render/context.hpp"

namespace cairn::render {
namespace {

template <typename Function>
void load(const Context& context, const char* name, Function& function) {
  function = reinterpret_cast<Function>(context.proc(name));
  if (function == nullptr) {
    throw RenderError(std::string("OpenGL 3.3 core is incomplete: ") + name + " is missing from " +
                      context.backend());
  }
}

void load_first_half(const Context& context, GlApi& gl) {
  load(context, "glActiveTexture", gl.active_texture);
  load(context, "glAttachShader", gl.attach_shader);
  load(context, "glBindBuffer", gl.bind_buffer);
  load(context, "glBindFramebuffer", gl.bind_framebuffer);
  load(context, "glBindRenderbuffer", gl.bind_renderbuffer);
  load(context, "glBindTexture", gl.bind_texture);
  load(context, "glBindVertexArray", gl.bind_vertex_array);
  load(context, "glBlendFunc", gl.blend_func);
  load(context, "glBlitFramebuffer", gl.blit_framebuffer);
  load(context, "glBufferData", gl.buffer_data);
  load(context, "glCheckFramebufferStatus", gl.check_framebuffer_status);
  load(context, "glClear", gl.clear);
  load(context, "glClearColor", gl.clear_color);
  load(context, "glCompileShader", gl.compile_shader);
  load(context, "glCreateProgram", gl.create_program);
  load(context, "glCreateShader", gl.create_shader);
  load(context, "glDeleteBuffers", gl.delete_buffers);
  load(context, "glDeleteFramebuffers", gl.delete_framebuffers);
  load(context, "glDeleteProgram", gl.delete_program);
  load(context, "glDeleteRenderbuffers", gl.delete_renderbuffers);
  load(context, "glDeleteShader", gl.delete_shader);
  load(context, "glDeleteTextures", gl.delete_textures);
  load(context, "glDeleteVertexArrays", gl.delete_vertex_arrays);
  load(context, "glDisable", gl.disable);
  load(context, "glDrawElements", gl.draw_elements);
  load(context, "glEnable", gl.enable);
  load(context, "glEnableVertexAttribArray", gl.enable_vertex_attrib_array);
  load(context, "glFramebufferRenderbuffer", gl.framebuffer_renderbuffer);
}

void load_second_half(const Context& context, GlApi& gl) {
  load(context, "glGenBuffers", gl.gen_buffers);
  load(context, "glGenFramebuffers", gl.gen_framebuffers);
  load(context, "glGenRenderbuffers", gl.gen_renderbuffers);
  load(context, "glGenTextures", gl.gen_textures);
  load(context, "glGenVertexArrays", gl.gen_vertex_arrays);
  load(context, "glGetError", gl.get_error);
  load(context, "glGetIntegerv", gl.get_integerv);
  load(context, "glGetProgramInfoLog", gl.get_program_info_log);
  load(context, "glGetProgramiv", gl.get_programiv);
  load(context, "glGetShaderInfoLog", gl.get_shader_info_log);
  load(context, "glGetShaderiv", gl.get_shaderiv);
  load(context, "glGetUniformLocation", gl.get_uniform_location);
  load(context, "glLinkProgram", gl.link_program);
  load(context, "glPixelStorei", gl.pixel_storei);
  load(context, "glReadPixels", gl.read_pixels);
  load(context, "glRenderbufferStorage", gl.renderbuffer_storage);
  load(context, "glScissor", gl.scissor);
  load(context, "glShaderSource", gl.shader_source);
  load(context, "glTexImage2D", gl.tex_image_2d);
  load(context, "glTexParameteri", gl.tex_parameteri);
  load(context, "glTexSubImage2D", gl.tex_sub_image_2d);
  load(context, "glUniform1i", gl.uniform_1i);
  load(context, "glUniform2f", gl.uniform_2f);
  load(context, "glUseProgram", gl.use_program);
  load(context, "glVertexAttribPointer", gl.vertex_attrib_pointer);
  load(context, "glViewport", gl.viewport);
}

}  // namespace

GlApi load_gl(const Context& context) {
  GlApi gl = {};
  load_first_half(context, gl);
  load_second_half(context, gl);
  return gl;
}

}  // namespace cairn::render
