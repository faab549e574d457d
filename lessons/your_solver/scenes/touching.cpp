// Where two boxes touch, however they are turned: the stages find contacts of upright boxes alone. It needs
// the reader's Body.

namespace cairn::filmed {

/// A point where two boxes touch; the normal leads from the first to the second.
struct Touch {
  double x = 0, y = 0, normal_x = 0, normal_y = 0, gap = 0;
  int feature = 0;  // which faces, and which end of them: stays from step to step
};

using Corners = std::array<std::array<double, 2>, 4>;

/// Counter-clockwise from the lower left; face i leads from corner i to corner i + 1.
static Corners corners_of(const Body& box) {
  const double cosine = std::cos(box.position[2]), sine = std::sin(box.position[2]);
  const double w = box.width / 2, h = box.height / 2;
  Corners corners = {{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
  for (auto& [x, y] : corners) {
    const double along = x;
    x = box.position[0] + cosine * along - sine * y;
    y = box.position[1] + sine * along + cosine * y;
  }
  return corners;
}

/// A face with its outward normal, and the least distance [m] of the other box's corners from it.
struct Face {
  int index = 0;
  double x = 0, y = 0, normal_x = 0, normal_y = 0, length = 0, distance = -1e300;
};

static Face face_of(const Corners& corners, int index, const Corners& other) {
  const auto from = corners[index], to = corners[(index + 1) % 4];
  Face face = {.index = index, .x = from[0], .y = from[1]};
  face.length = std::hypot(to[0] - from[0], to[1] - from[1]);
  face.normal_x = (to[1] - from[1]) / face.length;
  face.normal_y = -(to[0] - from[0]) / face.length;
  face.distance = 1e300;
  for (const auto& [x, y] : other)
    face.distance = std::min(face.distance, (x - face.x) * face.normal_x + (y - face.y) * face.normal_y);
  return face;
}

static Face farthest_face(const Corners& corners, const Corners& other) {
  Face best;
  for (int i = 0; i < 4; ++i) {
    const Face face = face_of(corners, i, other);
    if (face.distance > best.distance + 1e-6) best = face;
  }
  return best;
}

/// The face of the second box that looks at the first, cut to the width of the first box's face.
static std::vector<Touch> touches(const Body& first, const Body& second) {
  const Corners a = corners_of(first), b = corners_of(second);
  const Face of_a = farthest_face(a, b), of_b = farthest_face(b, a);
  const bool is_swapped = of_b.distance > of_a.distance + 1e-4;
  const Face& face = is_swapped ? of_b : of_a;
  const Corners& other = is_swapped ? a : b;
  std::vector<Touch> found;
  if (!(face.distance < 0.001)) return found;
  int facing = 0;
  double least = 1e300;
  for (int i = 0; i < 4; ++i) {
    const Face candidate = face_of(other, i, other);
    const double along = candidate.normal_x * face.normal_x + candidate.normal_y * face.normal_y;
    if (along < least) least = along, facing = i;
  }
  const auto from = other[facing], to = other[(facing + 1) % 4];
  const double tangent_x = -face.normal_y, tangent_y = face.normal_x;  // from corner to corner of the face
  const auto along = [&](const std::array<double, 2>& at) {
    return (at[0] - face.x) * tangent_x + (at[1] - face.y) * tangent_y;
  };
  const double begin = along(from), end = along(to);
  for (int k = 0; k < 2; ++k) {
    const double place = std::clamp(k == 0 ? begin : end, 0.0, face.length);
    const double share = begin == end ? 0 : std::clamp((place - begin) / (end - begin), 0.0, 1.0);
    const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
    const double gap = (x - face.x) * face.normal_x + (y - face.y) * face.normal_y,
                 sign = is_swapped ? -1 : 1;
    if (gap < 0.001)
      found.push_back({x, y, sign * face.normal_x, sign * face.normal_y, gap,
                       ((is_swapped * 4 + face.index) * 4 + facing) * 2 + k});
  }
  return found;
}

}  // namespace cairn::filmed
