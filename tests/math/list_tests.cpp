// Arrays by number, by row and by body: what indexes them, and what does not.
#include <concepts>

#include "testing.hpp"

using namespace cairn;

namespace {

template <typename Array, typename Index>
constexpr bool is_indexed_by = requires(Array& array, Index index) {
  array[index];
};

}  // namespace

TEST_CASE("an array over bodies takes a body and no number, any other array a number and no body") {
  CHECK(is_indexed_by<PerBody<double>, BodyId>);
  CHECK_FALSE(is_indexed_by<PerBody<double>, int>);
  CHECK(is_indexed_by<PerRow<double>, int>);
  CHECK_FALSE(is_indexed_by<PerRow<double>, BodyId>);
  CHECK(is_indexed_by<List<double>, std::ptrdiff_t>);
  CHECK_FALSE(is_indexed_by<List<double>, BodyId>);
  CHECK_FALSE(is_indexed_by<PerBodySpan<double>, int>);
}

TEST_CASE("an array over one kind of things is no array over another, nor is a view") {
  CHECK_FALSE(std::convertible_to<PerBody<double>, List<double>>);
  CHECK_FALSE(std::convertible_to<PerRow<double>, List<double>>);
  CHECK_FALSE(std::convertible_to<PerBody<double>&, Span<double>>);
  CHECK_FALSE(std::convertible_to<List<double>&, PerBodySpan<double>>);
  CHECK(std::convertible_to<PerBody<double>&, PerBodySpan<const double>>);
  CHECK(std::convertible_to<std::vector<double>&, Span<const double>>);
}

TEST_CASE("the indices of an array count from 0 and have its type") {
  const PerBody<double> masses = {0, 2, 3};
  int count = 0;
  double sum = 0;
  for (const BodyId body : masses.indices()) {
    CHECK(body.index == count++);
    sum += masses[body];
  }
  CHECK(count == masses.size());
  CHECK(sum == 5);
  for (const int i : List<double>().indices()) FAIL_CHECK(i);
}

TEST_CASE("a list is a std::vector with signed sizes") {
  List<int> list(3, 7);
  CHECK(list == List<int>{7, 7, 7});
  list.assign(2, 1);
  list.push_back(5);
  list.insert(list.begin(), {8, 9});
  CHECK(list == List<int>{8, 9, 1, 1, 5});
  CHECK(list.size() == 5);
  CHECK(list.bytes() == 5 * sizeof(int));
  erase_if(list, [](int x) { return x == 1; });
  CHECK(list == List<int>{8, 9, 5});
  CHECK(List<int>(std::vector<int>{8, 9, 5}) == list);
  CHECK(list.as_vector() == std::vector<int>{8, 9, 5});
  CHECK_THROWS_AS(list.at(3), std::out_of_range);
}

TEST_CASE("a view shows what it was made from, and a part of it") {
  List<int> list = {1, 2, 3, 4};
  const Span<int> all = list;
  all[3] = 9;
  CHECK(list.back() == 9);
  const Span<const int> middle = all.subspan(1, 2);
  CHECK(middle.size() == 2);
  CHECK(middle.front() == 2);
  CHECK(middle.back() == 3);
}

TEST_CASE("a fixed list has as many elements as its type says") {
  FixedList<double, 3> list = {1, 2};
  CHECK(list[2] == 0);
  list.fill(4);
  CHECK(list == FixedList<double, 3>{4, 4, 4});
  CHECK(list.size() == 3);
  CHECK(list.end() - list.begin() == 3);
}
