// The palettes, light and dark, and the sizes of text and lines.
#include "render/theme.hpp"

#include <algorithm>
#include <cmath>

namespace cairn::render {

namespace {

List<double> si_dash() { return {10, 6}; }
List<double> box2d_dash() { return {12, 5, 2, 5}; }
List<double> jacobi_dash() { return {2, 5}; }

double linear_of(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double srgb_of(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// The grey of the same relative luminance (WCAG 2), at the same opacity.
Color gray_of(Color color) {
  const double luminance =
      0.2126 * linear_of(color.r) + 0.7152 * linear_of(color.g) + 0.0722 * linear_of(color.b);
  const float level = static_cast<float>(std::clamp(srgb_of(luminance), 0.0, 1.0));
  return {level, level, level, color.a};
}

}  // namespace

Color rgb(std::uint32_t hex) {
  const auto channel = [hex](unsigned shift) { return static_cast<float>(hex >> shift & 0xFFU) / 255.0F; };
  return {channel(16), channel(8), channel(0), 1};
}

Color faded(Color color, double opacity) {
  color.a *= static_cast<float>(opacity);
  return color;
}

Theme light_theme() {
  Theme theme;
  theme.background = rgb(0xFBFBF9);
  theme.panel = rgb(0xFFFFFF);
  theme.frame_line = rgb(0xC4CAD2);
  theme.grid = rgb(0xE3E6EA);
  theme.text = rgb(0x1B1F24);
  theme.secondary_text = rgb(0x59626D);
  theme.outline = rgb(0x1B1F24);
  theme.body = rgb(0xDDE6EE);
  theme.active_a = rgb(0xCFE3F2);
  theme.active_b = rgb(0xFBE3B5);
  theme.static_body = rgb(0xC9CED6);
  theme.static_hatch = rgb(0x8F98A3);
  theme.sleeping = rgb(0xEDEFF1);
  theme.normal = rgb(0xD55E00);
  theme.friction = rgb(0x640B88);
  theme.joint = rgb(0x1B1F24);
  theme.velocity = rgb(0x1697D6);
  theme.external = rgb(0x7A7B7B);
  theme.penetration = rgb(0xF0E442);
  theme.water = rgb(0xD9EAF5);
  theme.inactive = rgb(0x9AA3AE);
  theme.positive = rgb(0xB2182B);
  theme.negative = rgb(0x3F3D9A);
  theme.pgs = {.color = rgb(0x0072B2), .dash = {}, .marker = Marker::circle};
  theme.si = {.color = rgb(0xC2770C), .dash = si_dash(), .marker = Marker::square};
  theme.box2d = {.color = rgb(0x0C5B3B), .dash = box2d_dash(), .marker = Marker::triangle};
  theme.jacobi = {.color = rgb(0x900E64), .dash = jacobi_dash(), .marker = Marker::diamond};
  theme.exact = {.color = rgb(0x1B1F24), .dash = {}, .marker = Marker::tick};
  return theme;
}

Theme dark_theme() {
  Theme theme;
  theme.background = rgb(0x14171C);
  theme.panel = rgb(0x1B2027);
  theme.frame_line = rgb(0x4A535E);
  theme.grid = rgb(0x2A3038);
  theme.text = rgb(0xF2F4F7);
  theme.secondary_text = rgb(0xAEB6C1);
  theme.outline = rgb(0xF2F4F7);
  theme.body = rgb(0x323B46);
  theme.active_a = rgb(0x1F4E6E);
  theme.active_b = rgb(0x6B4A12);
  theme.static_body = rgb(0x3A424C);
  theme.static_hatch = rgb(0x6B7480);
  theme.sleeping = rgb(0x20252C);
  theme.normal = rgb(0xFF7A2E);
  theme.friction = rgb(0xB656DB);
  theme.joint = rgb(0xF2F4F7);
  theme.velocity = rgb(0xA6C4EE);
  theme.external = rgb(0xA3A3A3);
  theme.penetration = rgb(0xF0E442);
  theme.water = rgb(0x17303F);
  theme.inactive = rgb(0x7C8794);
  theme.positive = rgb(0xE05555);
  theme.negative = rgb(0x6A6AE0);
  theme.pgs = {.color = rgb(0x56B4E9), .dash = {}, .marker = Marker::circle};
  theme.si = {.color = rgb(0xFFB243), .dash = si_dash(), .marker = Marker::square};
  theme.box2d = {.color = rgb(0x2DFEAB), .dash = box2d_dash(), .marker = Marker::triangle};
  theme.jacobi = {.color = rgb(0xBB6BA0), .dash = jacobi_dash(), .marker = Marker::diamond};
  theme.exact = {.color = rgb(0xF2F4F7), .dash = {}, .marker = Marker::tick};
  return theme;
}

Theme without_hues(const Theme& theme) {
  Theme gray = theme;
  for (Color* color :
       {&gray.background,     &gray.panel,        &gray.frame_line, &gray.grid,        &gray.text,
        &gray.secondary_text, &gray.outline,      &gray.body,       &gray.active_a,    &gray.active_b,
        &gray.static_body,    &gray.static_hatch, &gray.sleeping,   &gray.normal,      &gray.friction,
        &gray.joint,          &gray.velocity,     &gray.external,   &gray.penetration, &gray.inactive,
        &gray.positive,       &gray.negative,     &gray.pgs.color,  &gray.si.color,    &gray.box2d.color,
        &gray.jacobi.color,   &gray.exact.color,  &gray.water}) {
    *color = gray_of(*color);
  }
  return gray;
}

Sizes sizes_for(int height) {
  Sizes sizes;
  if (height >= 540) return sizes;
  sizes.title = 14, sizes.state = 12, sizes.label = 12, sizes.tick = 12;
  sizes.equation = 14, sizes.body_number = 18, sizes.question = 15;
  sizes.outline = 1.5, sizes.active_outline = 2;
  sizes.arrow = 3.5, sizes.inactive_arrow = 2, sizes.head_length = 10, sizes.head_width = 9;
  sizes.contact = 3.5, sizes.new_contact = 5, sizes.joint = 4;
  sizes.curve = 2, sizes.marker = 3.5, sizes.grid = 1, sizes.axis = 1, sizes.hatch_pitch = 10,
  sizes.ghost = 1;
  sizes.margin = 10, sizes.header = 30, sizes.footer = 18, sizes.gap = 8, sizes.padding = 8;
  return sizes;
}

}  // namespace cairn::render
