// What a solver has moved, for a film. Scenes of stages note it here as numbers; film.cpp reads and draws
// them. It is compiled together with the reader's code, and needs the standard library only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cairn {

/// A file of lines: a word, and numbers or a text behind it. A film has the same bodies in all frames.
class Motion {
 public:
  /// @throws std::runtime_error if there is no such place to write.
  explicit Motion(const char* path) : file_(std::fopen(path, "w")) {
    if (file_ == nullptr) throw std::runtime_error(std::string("cannot write ") + path);
  }
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;
  ~Motion() { close(); }

  /// The part of the world that pictures show [m]. Comes first.
  void view(double left, double bottom, double right, double top) {
    line("view", {left, bottom, right, top});
  }
  /// What follows belongs to this time [s].
  void frame(double time) { line("frame", {time}); }

  template <typename Bodies>
  void bodies(const Bodies& all) {
    for (const auto& body : all)
      line("body", {body.position[0], body.position[1], body.position[2], body.width, body.height,
                    body.inverse_mass[1]});
  }
  /// A rod between two points [m].
  void rod(double x1, double y1, double x2, double y2) { line("rod", {x1, y1, x2, y2}); }
  /// An arrow at a point [m], as long as a metre where it is 1.
  void arrow(double x, double y, double dx, double dy) { line("arrow", {x, y, dx, dy}); }
  /// A line of text below the picture.
  void words(const std::string& text) { std::fprintf(file_, "words %s\n", text.c_str()); }

  /// False if something could not be written.
  bool close() {
    if (file_ == nullptr) return true;
    const bool is_written = std::ferror(file_) == 0, is_closed = std::fclose(file_) == 0;
    file_ = nullptr;
    return is_written && is_closed;
  }

 private:
  void line(const char* word, std::initializer_list<double> numbers) {
    std::fputs(word, file_);
    for (const double number : numbers) std::fprintf(file_, " %.17g", number);
    std::fputc('\n', file_);
  }

  std::FILE* file_;
};

/// "−12.3 mm": a length [m] in millimetres; from 10 m on in metres.
inline std::string in_mm(double length) {
  char text[48] = "";
  const bool is_long = !(std::abs(length) < 10);
  std::snprintf(text, sizeof text, is_long ? "%s%.3g m" : "%s%.1f mm", length < 0 ? "−" : "",
                std::abs(length) * (is_long ? 1 : 1000));
  return text;
}

}  // namespace cairn
