// Matrices as pictures: pixels of single cells, read back.
#include "render/matrix.hpp"
#include "render/pictures.hpp"

namespace cairn::render {

namespace {

constexpr double matrix_nan = std::numeric_limits<double>::quiet_NaN();

PagePicture picture_of(const MatrixView& view, const Rect& rect, const Theme& theme = light_theme()) {
  return picture_of_page(theme, [&](Page& page) { draw_matrix(page, rect, view); });
}

Color matrix_pixel(const Image& image, int x, int y) {
  const int at = 3 * (y * image.width + x);
  const auto channel = [&](int i) { return static_cast<float>(image.pixels.at(at + i)) / 255.0F; };
  return {channel(0), channel(1), channel(2), 1};
}

double matrix_distance(Color a, Color b) {
  return 255 * static_cast<double>(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}));
}

// Without title and names, the cells of this rectangle are 40 px and begin at (102, 52).
constexpr Rect matrix_room = {100, 50, 124, 84};

// Near the corner of a cell of matrix_room, beside its number or dot.
Color cell_pixel(const Image& image, int row, int column) {
  return matrix_pixel(image, 102 + 40 * column + 5, 52 + 40 * row + 5);
}

// Both signs, and a zero.
Eigen::MatrixXd signed_matrix() {
  Eigen::MatrixXd values(2, 3);
  values << 4, 2, 0, -4, -2, -1;
  return values;
}

MatrixView example_matrix() {
  Eigen::MatrixXd values(3, 3);
  values << 1, -1, 0, -1, 2, -1, 0, -1, 2;
  return {.title = "A = J M⁻¹ Jᵀ (1/kg)",
          .values = values,
          .row_names = {"1", "2", "3"},
          .column_names = {"1", "2", "3"},
          .active_row = 1};
}

}  // namespace

TEST_CASE(
    "a cell has the colour of its sign, as strong as its share of the largest entry, and zero has none") {
  const Eigen::MatrixXd values = signed_matrix();
  for (const Theme& theme : {light_theme(), dark_theme()}) {
    const Image image = picture_of({.values = values}, matrix_room, theme).image;
    CHECK(matrix_distance(cell_pixel(image, 0, 0), theme.positive) <= 1);
    CHECK(matrix_distance(cell_pixel(image, 1, 0), theme.negative) <= 1);
    CHECK(matrix_distance(cell_pixel(image, 0, 2), theme.background) <= 1);
    const auto strength = [&](int row, int column) {
      return matrix_distance(cell_pixel(image, row, column), theme.background);
    };
    CHECK(strength(0, 0) > strength(0, 1));
    CHECK(strength(1, 0) > strength(1, 1));
    CHECK(strength(1, 1) > strength(1, 2));
    CHECK(strength(1, 2) > 10);
  }
}

TEST_CASE("the same number has the same colour in matrices that name the same strongest value") {
  const Eigen::MatrixXd values = signed_matrix();
  const Theme theme = light_theme();
  const Image whole = picture_of({.values = values}, matrix_room, theme).image;
  const Image half = picture_of({.values = values / 2, .strongest = 4}, matrix_room, theme).image;
  CHECK(matrix_distance(cell_pixel(half, 0, 0), cell_pixel(whole, 0, 1)) == 0);
  CHECK(matrix_distance(cell_pixel(half, 1, 1), cell_pixel(whole, 1, 2)) == 0);
}

TEST_CASE("rounding errors of a matrix are drawn as the zeros they stand for") {
  Eigen::MatrixXd values(1, 2);
  values << 3, 4e-16;
  const PagePicture picture = picture_of({.values = values}, matrix_room);
  CHECK(is_written(picture, "+3"));
  CHECK(picture.boxes.size() == 1);
}

TEST_CASE("magnitudes have one hue whatever their sign") {
  const Eigen::MatrixXd values = signed_matrix();
  const Theme theme = light_theme();
  const PagePicture picture =
      picture_of({.values = values, .colors = MatrixColors::magnitude}, matrix_room, theme);
  for (const int column : {0, 1}) {
    CHECK(matrix_distance(cell_pixel(picture.image, 0, column), cell_pixel(picture.image, 1, column)) == 0);
  }
  CHECK(matrix_distance(cell_pixel(picture.image, 0, 0), theme.secondary_text) <= 1);
  CHECK(is_written(picture, "4"));
}

TEST_CASE("entries that are no numbers are shown as such and leave the others alone") {
  Eigen::MatrixXd values = signed_matrix();
  const Image clean = picture_of({.values = values}, matrix_room).image;
  values(0, 2) = matrix_nan;
  values(1, 2) = -std::numeric_limits<double>::infinity();
  const PagePicture broken = picture_of({.values = values}, matrix_room);
  CHECK(is_written(broken, "NaN"));
  CHECK(is_written(broken, "−∞"));
  CHECK(broken.faults.empty());
  CHECK(matrix_distance(cell_pixel(broken.image, 1, 2), light_theme().negative) <= 1);
  for (const int column : {0, 1}) {
    CHECK(matrix_distance(cell_pixel(clean, 0, column), cell_pixel(broken.image, 0, column)) == 0);
    CHECK(matrix_distance(cell_pixel(clean, 1, column), cell_pixel(broken.image, 1, column)) == 0);
  }
  picture_of({.values = Eigen::MatrixXd::Constant(3, 3, matrix_nan)}, matrix_room);
}

TEST_CASE("numbers stand in cells of 28 px and are missing in smaller ones") {
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Constant(2, 2, 1);
  CHECK(picture_of({.values = ones}, {100, 50, 60, 60}).boxes.size() == 4);
  CHECK(picture_of({.values = ones}, {100, 50, 59, 59}).boxes.empty());
}

TEST_CASE("numbers lie inside their cells, and those that do not fit are left out") {
  Eigen::MatrixXd values(2, 3);
  values << 0.333333, -12.3456, 1e-9, 1, -123456, 5;
  for (double side = 28; side <= 64; side += 4) {
    const PagePicture picture = picture_of({.values = values}, {100, 50, 3 * side + 4, 2 * side + 4});
    CAPTURE(side);
    CHECK(picture.boxes.size() >= 2);
    CHECK(picture.faults.empty());
    for (const TextBox& box : picture.boxes) {
      const double first = std::floor((box.rect.x - 102) / side);
      const double last = std::floor((box.rect.x + box.rect.width - 102) / side);
      CHECK(first == last);
    }
  }
}

TEST_CASE("cells grow to 64 px and no further") {
  const PagePicture picture = picture_of({.values = Eigen::MatrixXd::Constant(1, 2, 1)}, {0, 0, 640, 360});
  REQUIRE(picture.boxes.size() == 2);
  CHECK(picture.boxes[1].rect.x - picture.boxes[0].rect.x == doctest::Approx(64));
}

TEST_CASE("a matrix of 200 x 200 is a spy plot with a pixel or more for each entry") {
  const Eigen::MatrixXd diagonal = Eigen::MatrixXd::Identity(200, 200);
  const Theme theme = light_theme();
  const Image image = picture_of({.values = diagonal}, {50, 50, 204, 204}).image;
  for (int i = 0; i < 200; ++i) {
    REQUIRE(matrix_distance(matrix_pixel(image, 52 + i, 52 + i), theme.positive) <= 1);
    if (i + 2 < 200) REQUIRE(matrix_distance(matrix_pixel(image, 52 + i + 2, 52 + i), theme.background) <= 1);
  }
}

TEST_CASE(
    "a matrix with more entries than pixels stays in its rectangle and loses none of its large entries") {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(900, 1500);
  values(400, 700) = -1;
  const Theme theme = light_theme();
  const Rect room = {50, 50, 300, 200};
  const Image image = picture_of({.values = values}, room).image;
  int negative = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Color color = matrix_pixel(image, x, y);
      const bool inside = x >= 50 && x < 350 && y >= 50 && y < 250;
      if (!inside) REQUIRE(matrix_distance(color, theme.background) <= 1);
      if (matrix_distance(color, theme.negative) <= 1) ++negative;
    }
  }
  CHECK(negative == 1);
}

TEST_CASE("the frame of the active row begins and ends at that row") {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(2, 3);
  const Theme theme = light_theme();
  const Image plain = picture_of({.values = values}, matrix_room).image;
  const Image framed = picture_of({.values = values, .active_row = 1}, matrix_room).image;
  const auto has_ink = [&](const Image& image, int y) {
    return matrix_distance(matrix_pixel(image, 110, y), theme.text) <= 1;
  };
  CHECK_FALSE(has_ink(plain, 52 + 40 - 3));
  CHECK(has_ink(framed, 52 + 40 - 3));
  CHECK(has_ink(framed, 52 + 80 + 2));
  CHECK_FALSE(has_ink(framed, 52 + 20));
}

TEST_CASE("a matrix with names has a sound layout in every size and theme") {
  for (const Theme& theme : {light_theme(), dark_theme(), without_hues(light_theme())}) {
    for (const Rect& room : {Rect{10, 10, 300, 300}, Rect{10, 10, 120, 300}, Rect{10, 10, 620, 90}}) {
      const PagePicture picture = picture_of(example_matrix(), room, theme);
      CAPTURE(room.width);
      for (const std::string& fault : picture.faults) FAIL_CHECK(fault);
    }
  }
}

TEST_CASE("an empty matrix and nonsense in its options do no harm") {
  const Image empty = picture_of({}, matrix_room).image;
  CHECK(matrix_distance(matrix_pixel(empty, 110, 60), light_theme().background) <= 1);
  picture_of({.values = Eigen::MatrixXd::Zero(2, 2), .column_group = -1, .active_row = 9}, matrix_room);
  picture_of(example_matrix(), {10, 10, 0, 0});
}

TEST_CASE("the matrix of a stack of three boxes looks as it did") {
  Page page(640, 360, light_theme());
  page.begin({.number = "04", .title = "The big matrices", .state = "3 bodies · 3 rows"});
  const List<Rect> parts = rows(page.area(), {1, 1}, page.sizes().gap);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, 9);
  jacobian(0, 1) = jacobian(1, 4) = jacobian(2, 7) = 1;
  jacobian(1, 1) = jacobian(2, 4) = -1;
  draw_matrix(page, parts[0],
              {.title = "J (3 × 9)",
               .values = jacobian,
               .row_names = {"g–1", "1–2", "2–3"},
               .column_names = {"x_1", "y_1", "θ_1", "x_2", "y_2", "θ_2", "x_3", "y_3", "θ_3"},
               .column_group = 3});
  draw_matrix(page, parts[1], example_matrix());
  CHECK(lint(page).empty());
  test::check_golden("matrix_light", page.canvas().read());
}

}  // namespace cairn::render
