// Floor 0. A list whose copies share their elements.
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>

#include <cairn/math/list.hpp>

namespace cairn {

/// Elements that never change, so that all copies share them: whoever adds one gets a list of its own.
template <typename T>
class SharedList {
 public:
  /// Of nothing.
  SharedList() = default;
  /// These elements.
  SharedList(std::initializer_list<T> values) : SharedList(List<T>(values)) {}
  /// These elements.
  SharedList(List<T> values) {
    if (!values.empty()) values_ = std::make_shared<const List<T>>(std::move(values));
  }

  /// As a list, as long as this one lives and is left alone.
  operator const List<T>&() const {
    static const List<T> nothing;
    return values_ ? *values_ : nothing;
  }

  /// @cond
  // As in List.
  int size() const { return all().size(); }
  bool empty() const { return all().empty(); }
  const T& operator[](int i) const { return all()[i]; }
  const T& at(int i) const { return all().at(i); }
  auto begin() const { return all().begin(); }
  auto end() const { return all().end(); }
  auto data() const { return all().data(); }
  void clear() { values_.reset(); }
  void push_back(T value) {
    List<T> values = all();
    values.push_back(std::move(value));
    *this = std::move(values);
  }
  /// @endcond

  /// Element by element.
  bool operator==(const SharedList& other) const { return values_ == other.values_ || all() == other.all(); }

 private:
  const List<T>& all() const { return *this; }

  std::shared_ptr<const List<T>> values_;  // null: nothing
};

}  // namespace cairn
