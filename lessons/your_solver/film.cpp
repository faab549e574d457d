// solver_film light|dark "Stage 04: A λ = b" STEM YOURS MODEL: draws two motions side by side, as
// STEM_0001.png and so on, and as STEM.apng. Each is a file of scenes/motion.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <cairn/world/snapshot.hpp>
#include "render/draw.hpp"
#include "render/lint.hpp"
#include "render/sequence.hpp"

namespace {

using namespace cairn;
using render::Rect;

constexpr int width = 1280, height = 720;
constexpr double words_height = 30;

struct Frame {
  Snapshot snapshot = {};
  List<List<double>> arrows = {};  // x, y, dx, dy
  std::string words = {};
};

struct Film {
  Aabb<double> view = {};
  List<Frame> frames = {};
};

/// Also "nan" and "inf", which streams do not read.
List<double> numbers_of(const std::string& text) {
  List<double> numbers;
  const char* at = text.c_str();
  char* end = nullptr;
  for (double number = std::strtod(at, &end); end != at; number = std::strtod(at, &end)) {
    numbers.push_back(number);
    at = end;
  }
  return numbers;
}

/// A side that nobody has set is drawn thin.
double side_of(double given) { return std::isfinite(given) ? std::clamp(given, 0.05, 1e3) : 0.05; }

SnapshotBody body_of(const List<double>& n) {
  return {.type = n[5] > 0 ? BodyType::dynamic : BodyType::static_body,
          .pose = {.position = {n[0], n[1]}, .angle = n[2]},
          .mass = n[5] > 0 ? 1 / n[5] : 0,
          .shapes = List<Shape<double>>{box(side_of(n[3]), side_of(n[4]))}};
}

SnapshotJoint rod_of(const List<double>& n) {
  return {.traits = {.is_line = true}, .anchor_a = {n[0], n[1]}, .anchor_b = {n[2], n[3]}};
}

void add_line(Film& film, const std::string& word, const std::string& rest) {
  const List<double> n = word == "words" ? List<double>{} : numbers_of(rest);
  if (word == "view") film.view = {{n[0], n[1]}, {n[2], n[3]}};
  if (word == "frame") film.frames.push_back({});
  if (film.frames.empty()) return;
  Frame& frame = film.frames.back();
  if (word == "frame") frame.snapshot.time = n[0];
  if (word == "body") frame.snapshot.bodies.push_back(body_of(n));
  if (word == "rod") frame.snapshot.joints.push_back(rod_of(n));
  if (word == "arrow") frame.arrows.push_back(n);
  if (word == "words") frame.words = rest;
}

/// @throws std::runtime_error for a file without frames.
Film film_of(const std::string& path) {
  Film film;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const std::size_t end = std::min(line.find(' '), line.size());
    add_line(film, line.substr(0, end), line.substr(std::min(end + 1, line.size())));
  }
  if (film.frames.empty()) throw std::runtime_error("there is no motion in " + path);
  return film;
}

/// How far a corner of one film is from the same corner of the other, at most [m]; infinite where one is no
/// number.
double distance_of(const Snapshot& first, const Snapshot& second) {
  double most = 0;
  const std::ptrdiff_t count = std::min(first.bodies.size(), second.bodies.size());
  for (int i = 0; i < count; ++i) {
    const SnapshotBody &one = first.bodies[{i}], &two = second.bodies[{i}];
    const auto& corners = std::get<Polygon<double>>(one.shapes[0]).vertices;
    const auto& others = std::get<Polygon<double>>(two.shapes[0]).vertices;
    for (const int k : corners.indices()) {
      const double apart = (one.pose.world(corners[k]) - two.pose.world(others[k])).norm();
      most = std::isfinite(apart) ? std::max(most, apart) : HUGE_VAL;
    }
  }
  return most;
}

/// Draws one film beside the other.
class SideBySide {
 public:
  SideBySide(const render::Theme& theme, const std::string& title, const Film& yours, const Film& model)
      : page_(render::ImageSize{width, height}, theme), title_(title), yours_(yours), model_(model) {}

  int count() const { return std::min(yours_.frames.size(), model_.frames.size()); }

  render::Image draw(int index) {
    const std::size_t number = title_.find("0"), name = title_.find(": ");
    const double time = model_.frames[index].snapshot.time;
    page_.begin({.number = title_.substr(number, 2),
                 .title = title_.substr(name + 2),
                 .state = "t = " + render::fixed(time, 2) + " s",
                 .frame = index,
                 .frames = count()});
    const List<Rect> halves = render::columns(page_.area(), {1, 1}, page_.sizes().gap);
    draw_half(halves[0], "yours", yours_.frames[index]);
    draw_half(halves[1], "the model", model_.frames[index]);
    for (const std::string& finding : render::lint(page_))
      std::fprintf(stderr, "frame %d: %s\n", index + 1, finding.c_str());
    return page_.canvas().read();
  }

 private:
  void draw_half(const Rect& rect, const char* title, const Frame& frame) {
    const Rect inside = page_.panel(rect, title);
    const Rect above = {inside.x, inside.y, inside.width, inside.height - words_height};
    const render::Camera camera = render::fit(above, model_.view);
    const render::WorldLook look{.contacts = false, .penetration = false};
    render::draw_world(page_, camera, frame.snapshot, look);
    for (const List<double>& n : frame.arrows)
      render::draw_arrow(page_, camera, {.pixels_per_unit = camera.scale, .longest = above.height},
                         {.tail = {n[0], n[1]}, .value = {n[2], n[3]}});
    render::draw_unseen(page_, camera, frame.snapshot, look);
    page_.canvas().text({inside.x, inside.y + inside.height - 8}, frame.words, page_.value());
  }

  render::Page page_;
  std::string title_;
  const Film& yours_;
  const Film& model_;
};

void write_film(const std::string& theme, const std::string& title, const std::filesystem::path& stem,
                const Film& yours, const Film& model) {
  SideBySide pictures(theme == "dark" ? render::dark_theme() : render::light_theme(), title, yours, model);
  render::FrameWriter frames(stem.parent_path(), stem.filename());
  const double seconds = model.frames.back().snapshot.time - model.frames[0].snapshot.time;
  render::ApngWriter moving(stem.string() + ".apng", pictures.count(), (pictures.count() - 1) / seconds);
  for (int i = 0; i < pictures.count(); ++i) {
    render::Image image = pictures.draw(i);
    frames.add(image);
    moving.add(image);
  }
  frames.finish();
  moving.finish();
  double most = 0;
  for (int i = 0; i < pictures.count(); ++i)
    most = std::max(most, distance_of(yours.frames[i].snapshot, model.frames[i].snapshot));
  fmt::print("{} pictures: {}_0001.png and so on; as a film: {}.apng\n", pictures.count(), stem.string(),
             stem.string());
  if (most < 1e-3)
    fmt::print("Your bodies move as the model's do: no corner is ever 1 mm away from the model's.\n");
  else if (most < 1e3)
    fmt::print("Your bodies do not move as the model's: a corner is up to {:.3g} m away from the model's.\n",
               most);
  else
    fmt::print("Your bodies do not move as the model's: one flies away, further than 1 km.\n");
}

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    std::fprintf(stderr, "solver_film light|dark TITLE STEM YOURS MODEL\n");
    return 2;
  }
  try {
    write_film(words[1], words[2], words[3], film_of(words[4]), film_of(words[5]));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "solver: %s\n", error.what());
    return 3;
  }
}
