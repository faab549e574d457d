// The entry points of OpenGL 3.3 core that Cairn calls, loaded from the context itself: linking a libGL
// next to OSMesa would send the calls to the wrong library.
#pragma once

#include <GL/glcorearb.h>

namespace cairn::render {

class Context;

struct GlApi {
  PFNGLACTIVETEXTUREPROC active_texture = nullptr;
  PFNGLATTACHSHADERPROC attach_shader = nullptr;
  PFNGLBINDBUFFERPROC bind_buffer = nullptr;
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = nullptr;
  PFNGLBINDRENDERBUFFERPROC bind_renderbuffer = nullptr;
  PFNGLBINDTEXTUREPROC bind_texture = nullptr;
  PFNGLBINDVERTEXARRAYPROC bind_vertex_array = nullptr;
  PFNGLBLENDFUNCPROC blend_func = nullptr;
  PFNGLBLITFRAMEBUFFERPROC blit_framebuffer = nullptr;
  PFNGLBUFFERDATAPROC buffer_data = nullptr;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC check_framebuffer_status = nullptr;
  PFNGLCLEARPROC clear = nullptr;
  PFNGLCLEARCOLORPROC clear_color = nullptr;
  PFNGLCOMPILESHADERPROC compile_shader = nullptr;
  PFNGLCREATEPROGRAMPROC create_program = nullptr;
  PFNGLCREATESHADERPROC create_shader = nullptr;
  PFNGLDELETEBUFFERSPROC delete_buffers = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers = nullptr;
  PFNGLDELETEPROGRAMPROC delete_program = nullptr;
  PFNGLDELETERENDERBUFFERSPROC delete_renderbuffers = nullptr;
  PFNGLDELETESHADERPROC delete_shader = nullptr;
  PFNGLDELETETEXTURESPROC delete_textures = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC delete_vertex_arrays = nullptr;
  PFNGLDISABLEPROC disable = nullptr;
  PFNGLDRAWELEMENTSPROC draw_elements = nullptr;
  PFNGLENABLEPROC enable = nullptr;
  PFNGLENABLEVERTEXATTRIBARRAYPROC enable_vertex_attrib_array = nullptr;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC framebuffer_renderbuffer = nullptr;
  PFNGLGENBUFFERSPROC gen_buffers = nullptr;
  PFNGLGENFRAMEBUFFERSPROC gen_framebuffers = nullptr;
  PFNGLGENRENDERBUFFERSPROC gen_renderbuffers = nullptr;
  PFNGLGENTEXTURESPROC gen_textures = nullptr;
  PFNGLGENVERTEXARRAYSPROC gen_vertex_arrays = nullptr;
  PFNGLGETERRORPROC get_error = nullptr;
  PFNGLGETINTEGERVPROC get_integerv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC get_program_info_log = nullptr;
  PFNGLGETPROGRAMIVPROC get_programiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC get_shader_info_log = nullptr;
  PFNGLGETSHADERIVPROC get_shaderiv = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC get_uniform_location = nullptr;
  PFNGLLINKPROGRAMPROC link_program = nullptr;
  PFNGLPIXELSTOREIPROC pixel_storei = nullptr;
  PFNGLREADPIXELSPROC read_pixels = nullptr;
  PFNGLRENDERBUFFERSTORAGEPROC renderbuffer_storage = nullptr;
  PFNGLSCISSORPROC scissor = nullptr;
  PFNGLSHADERSOURCEPROC shader_source = nullptr;
  PFNGLTEXIMAGE2DPROC tex_image_2d = nullptr;
  PFNGLTEXPARAMETERIPROC tex_parameteri = nullptr;
  PFNGLTEXSUBIMAGE2DPROC tex_sub_image_2d = nullptr;
  PFNGLUNIFORM1IPROC uniform_1i = nullptr;
  PFNGLUNIFORM2FPROC uniform_2f = nullptr;
  PFNGLUSEPROGRAMPROC use_program = nullptr;
  PFNGLVERTEXATTRIBPOINTERPROC vertex_attrib_pointer = nullptr;
  PFNGLVIEWPORTPROC viewport = nullptr;
};

/// The table of a context, which must be current.
/// @throws RenderError
GlApi load_gl(const Context& context);

}  // namespace cairn::render
