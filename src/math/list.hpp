// Floor 0. Arrays that say what they are indexed by: numbers, rows, or bodies; and views of them.
#pragma once

#include <algorithm>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <ranges>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace cairn {

/// The place of an index in memory, from 0. An index type of its own has an overload beside it.
constexpr std::ptrdiff_t place_of(std::ptrdiff_t index) { return index; }

/// What operator[] of an array takes: its own index, or any signed number where that is a number.
template <typename Index>
using IndexArgument = std::conditional_t<std::convertible_to<Index, std::ptrdiff_t>, std::ptrdiff_t, Index>;

/// All indices of an array, in order: `for (const BodyId body : velocity.indices())`.
template <typename Index>
class Indices {
 public:
  /// Of `count` elements.
  explicit constexpr Indices(int count) : count_(count) {}

  /// Counts up.
  class Iterator {
   public:
    /// Begins with `number`.
    explicit constexpr Iterator(int number) : number_(number) {}
    /// The index that it has come to.
    constexpr Index operator*() const { return Index{number_}; }
    /// On to the next.
    constexpr Iterator& operator++() {
      ++number_;
      return *this;
    }
    /// Whether both have come equally far.
    constexpr bool operator==(const Iterator&) const = default;

   private:
    int number_;
  };
  /// The first index.
  constexpr Iterator begin() const { return Iterator(0); }
  /// Behind the last.
  constexpr Iterator end() const { return Iterator(count_); }

 private:
  int count_;
};

/// A std::vector with an index of its own kind and signed sizes. Builds with _GLIBCXX_ASSERTIONS check every
/// index; all presets but the release are such builds. Use it as List, PerRow or PerBody.
template <typename T, typename Index>
class IndexedVector {
  using Values = std::vector<T>;

 public:
  /// @cond
  // As in std::vector.
  using index_type = Index;
  using value_type = T;
  using size_type = std::ptrdiff_t;
  using difference_type = std::ptrdiff_t;
  using reference = typename Values::reference;
  using const_reference = typename Values::const_reference;
  using iterator = typename Values::iterator;
  using const_iterator = typename Values::const_iterator;
  /// @endcond

  IndexedVector() = default;
  /// So many elements, each T{}.
  explicit IndexedVector(std::ptrdiff_t count) : values_(static_cast<std::size_t>(count)) {}
  /// So many copies of `value`.
  IndexedVector(std::ptrdiff_t count, const T& value) : values_(static_cast<std::size_t>(count), value) {}
  /// These elements.
  IndexedVector(std::initializer_list<T> values) : values_(values) {}
  /// Copies of what lies between two iterators.
  template <std::input_iterator It>
  IndexedVector(It first, It last) : values_(first, last) {}
  /// What a library gave.
  explicit IndexedVector(Values values) : values_(std::move(values)) {}

  /// How many elements there are.
  int size() const { return static_cast<int>(values_.size()); }
  /// Whether there are none.
  bool empty() const { return values_.empty(); }
  /// What the elements take up [bytes]: not what is set aside for more.
  std::size_t bytes() const { return values_.size() * sizeof(T); }
  /// All indices, in order.
  Indices<Index> indices() const { return Indices<Index>(size()); }
  /// One element.
  reference operator[](IndexArgument<Index> index) { return values_[place_in_memory(index)]; }
  /// One element.
  const_reference operator[](IndexArgument<Index> index) const { return values_[place_in_memory(index)]; }
  /// One element. @throws std::out_of_range where there is none.
  const_reference at(IndexArgument<Index> index) const { return values_.at(place_in_memory(index)); }

  /// @cond
  // As in std::vector.
  iterator begin() { return values_.begin(); }
  iterator end() { return values_.end(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }
  auto rbegin() const { return values_.rbegin(); }
  auto rend() const { return values_.rend(); }
  reference front() { return values_.front(); }
  reference back() { return values_.back(); }
  const_reference front() const { return values_.front(); }
  const_reference back() const { return values_.back(); }
  auto data() { return values_.data(); }
  auto data() const { return values_.data(); }
  void clear() { values_.clear(); }
  void push_back(const T& value) { values_.push_back(value); }
  void push_back(T&& value) { values_.push_back(std::move(value)); }
  template <typename... Arguments>
  reference emplace_back(Arguments&&... arguments) {
    return values_.emplace_back(std::forward<Arguments>(arguments)...);
  }
  void pop_back() { values_.pop_back(); }
  iterator insert(const_iterator before, T value) { return values_.insert(before, std::move(value)); }
  iterator insert(const_iterator before, std::initializer_list<T> values) {
    return values_.insert(before, values);
  }
  template <std::input_iterator It>
  iterator insert(const_iterator before, It first, It last) {
    return values_.insert(before, first, last);
  }
  iterator erase(const_iterator first, const_iterator last) { return values_.erase(first, last); }
  iterator erase(const_iterator element) { return values_.erase(element); }
  void resize(std::ptrdiff_t count) { values_.resize(static_cast<std::size_t>(count)); }
  void resize(std::ptrdiff_t count, const T& value) {
    values_.resize(static_cast<std::size_t>(count), value);
  }
  void reserve(std::ptrdiff_t count) { values_.reserve(static_cast<std::size_t>(count)); }
  void assign(std::ptrdiff_t count, const T& value) {
    values_.assign(static_cast<std::size_t>(count), value);
  }
  template <std::input_iterator It>
  void assign(It first, It last) {
    values_.assign(first, last);
  }
  void swap(IndexedVector& other) { values_.swap(other.values_); }
  /// @endcond

  /// For a library that takes nothing else.
  const Values& as_vector() const { return values_; }

  /// Element by element.
  bool operator==(const IndexedVector&) const = default;

 private:
  static std::size_t place_in_memory(IndexArgument<Index> index) {
    return static_cast<std::size_t>(place_of(index));
  }

  Values values_;
};

/// Takes out the elements for which `condition` holds.
template <typename T, typename Index, typename Condition>
void erase_if(IndexedVector<T, Index>& list, const Condition& condition) {
  list.erase(std::remove_if(list.begin(), list.end(), condition), list.end());
}

/// A view of elements that lie side by side, with the index of the array that they belong to. T is const
/// unless they may be changed. Use it as Span or PerBodySpan.
template <typename T, typename Index>
class IndexedSpan : private std::span<T> {
  using Base = std::span<T>;

 public:
  /// @cond
  // As in std::span.
  using index_type = Index;
  using typename Base::iterator;
  using typename Base::reference;
  using typename Base::value_type;
  /// @endcond

  constexpr IndexedSpan() = default;
  /// So many elements from `first` on.
  constexpr IndexedSpan(T* first, std::ptrdiff_t count) : Base(first, static_cast<std::size_t>(count)) {}
  /// All of an array; of its own kind, if it is one of Cairn's.
  template <typename Array>
  requires(std::constructible_from<std::span<T>, Array&&> &&
           !std::same_as<std::remove_cvref_t<Array>, IndexedSpan> &&
           (!requires { typename std::remove_cvref_t<Array>::index_type; } ||
            std::same_as<typename std::remove_cvref_t<Array>::index_type,
                         Index>)) constexpr IndexedSpan(Array&& array)
      : Base(std::forward<Array>(array)) {}

  /// @cond
  using Base::back;
  using Base::begin;
  using Base::data;
  using Base::empty;
  using Base::end;
  using Base::front;
  using Base::rbegin;
  using Base::rend;
  /// @endcond

  /// How many elements it shows.
  constexpr int size() const { return static_cast<int>(Base::size()); }
  /// All indices, in order.
  constexpr Indices<Index> indices() const { return Indices<Index>(size()); }
  /// One element.
  constexpr reference operator[](IndexArgument<Index> index) const {
    return Base::operator[](static_cast<std::size_t>(place_of(index)));
  }
  /// `count` elements from number `first` on.
  constexpr IndexedSpan subspan(std::ptrdiff_t first, std::ptrdiff_t count) const {
    return {Base::data() + first, count};
  }
};

/// As many elements as its type says: a std::array with signed indices.
template <typename T, int count>
struct FixedList {
  T values[count];  // in order

  /// How many elements there are.
  static constexpr int size() { return count; }
  /// All indices, in order.
  static constexpr Indices<int> indices() { return Indices<int>(count); }
  /// One element.
  constexpr T& operator[](std::ptrdiff_t index) {
    assert(0 <= index && index < count);
    return values[index];
  }
  /// One element.
  constexpr const T& operator[](std::ptrdiff_t index) const {
    assert(0 <= index && index < count);
    return values[index];
  }
  /// The first element.
  constexpr T* begin() { return values; }
  /// The first element.
  constexpr const T* begin() const { return values; }
  /// Behind the last.
  constexpr T* end() { return values + count; }
  /// Behind the last.
  constexpr const T* end() const { return values + count; }
  /// Where the elements lie.
  constexpr T* data() { return values; }
  /// Where the elements lie.
  constexpr const T* data() const { return values; }
  /// The last element.
  constexpr const T& back() const { return values[count - 1]; }
  /// Makes all elements alike.
  constexpr void fill(const T& value) { std::fill(begin(), end(), value); }
  /// Element by element.
  bool operator==(const FixedList&) const = default;
};

/// Numbered from 0.
template <typename T>
using List = IndexedVector<T, int>;
/// A view of a List, or of what a library has side by side.
template <typename T>
using Span = IndexedSpan<T, int>;

/// Room for so many elements in a list that lives as long as its world: where it has to grow, for an eighth
/// more, and not for twice as many as there are.
template <typename Array>
void make_room(Array& list, int count) {
  if (static_cast<int>(list.as_vector().capacity()) < count) list.reserve(count + count / 8);
}

}  // namespace cairn
