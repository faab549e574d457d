// The shader source. A pixel's coverage is taken from the signed distance to the shape's edge, so that
// edges, outlines and hairlines are smooth without supersampling.
#include "render/shader.hpp"

namespace cairn::render {

// y = 0 is the bottom row to OpenGL and the first row in memory: read back, the picture's top row comes
// first.
const char* const vertex_shader = R"(layout(location = 0) in vec2 position;
layout(location = 1) in vec4 local_in;
layout(location = 2) in vec4 first_in;
layout(location = 3) in vec4 second_in;
layout(location = 4) in vec4 shape_in;
layout(location = 5) in vec4 fill_in;
layout(location = 6) in vec4 outline_in;
uniform vec2 pixel;
out vec4 local;
flat out vec4 first;
flat out vec4 second;
flat out vec4 shape;
flat out vec4 fill;
flat out vec4 outline;
void main() {
  gl_Position = vec4(position * pixel - 1.0, 0.0, 1.0);
  local = local_in;
  first = first_in;
  second = second_in;
  shape = shape_in;
  fill = fill_in;
  outline = outline_in;
}
)";

const char* const fragment_shader = R"(in vec4 local;
flat in vec4 first;   // w: kind
flat in vec4 second;  // w: half the outline width
flat in vec4 shape;
flat in vec4 fill;
flat in vec4 outline;
uniform sampler2D glyphs;
out vec4 color;

// Branches would be computed for every pixel anyway, so all shapes share one way: four distances to edges, and
// what to keep of the pixel besides.

// The part of a pixel behind straight edges at signed distances d, positive outside.
vec3 behind(vec3 d) { return clamp(0.5 - d, 0.0, 1.0); }
float behind(float d) { return clamp(0.5 - d, 0.0, 1.0); }

// The part behind two edges that leave u and v of the pixel and meet at an interior angle [pi]: nothing is
// shared at 0, they are independent at 1/2, and one edge at 1.
vec3 corner(vec3 u, vec3 v, float angle) {
  float apart = max(1.0 - 2.0 * angle, 0.0);
  float together = max(2.0 * angle - 1.0, 0.0);
  return apart * max(u + v - 1.0, 0.0) + together * min(u, v) + (1.0 - apart - together) * (u * v);
}

// Distance to a box, and to its far side, as those of two opposite edges.
vec4 box() {
  vec2 q = abs(local.xy) - shape.xy;
  float d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - shape.z;
  return vec4(d, -1e3, -d - 2.0 * (min(shape.x, shape.y) + shape.z), -1e3);
}

float between_cuts() {
  vec3 here = vec3(gl_FragCoord.xy, 1.0);
  return max(behind(-dot(first.xyz, here)) + behind(dot(second.xyz, here)) - 1.0, 0.0);
}

float hatch() {
  float s = mod(gl_FragCoord.x + gl_FragCoord.y - second.z, second.x);
  float d = min(s, second.x - s) * 0.70710678;
  return max(behind(d - second.y) + behind(-d - second.y) - 1.0, 0.0);
}

// Coverage of the shape itself, and of the shape within and up to the outline's two edges.
vec3 coverage(vec4 d, float diagonal, vec4 angles) {
  vec3 grow = vec3(0.0, -second.w, second.w);
  vec2 near = d.y > d.w ? angles.xy : angles.wz;
  vec3 u = corner(behind(d.x - grow), behind(d.z - grow), diagonal);
  vec3 v = max(behind(d.y - grow) + behind(d.w - grow) - 1.0, 0.0);
  return corner(u, v, d.x > d.z ? near.x : near.y);
}

// Fill reaches up to the edge, the outline lies on both sides of it and hides what it covers.
void main() {
  float kind = first.w;
  vec4 d = kind < 0.5 ? vec4(-1e3) : kind < 1.5 ? box() : local;
  float keep = kind < 0.5   ? texelFetch(glyphs, ivec2(local.xy), 0).r
               : kind < 1.5 ? between_cuts()
               : kind < 2.5 ? 1.0
                            : hatch();
  bool straight = kind > 1.5;
  vec3 part = keep * coverage(d, straight ? first.x : 0.0, straight ? shape : vec4(0.0));
  float in_fill = (part.y + (part.x - part.y) * (1.0 - outline.a)) * fill.a;
  float in_outline = (part.z - part.y) * outline.a;
  color = vec4(fill.rgb * in_fill + outline.rgb * in_outline, in_fill + in_outline);
}
)";

}  // namespace cairn::render
