// What every C function goes through: the one playground of the process, and an end to all that is thrown.
#pragma once

#include <exception>
#include <new>
#include <string>
#include <type_traits>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include "lessons/playground/playground.hpp"

namespace cairn::playground {

inline constexpr double patience = 0.5;  // [s] that a page may stand still

/// All that a page shows, and what was returned last.
struct Session {
  Session() { playground.set_patience(patience); }

  Playground playground;
  std::string text;
  List<double> numbers;
};

/// The only one. It is made when it is first asked for.
inline Session& session() {
  static Session session;
  return session;
}

/// Why the last call refused. Apart from the session, which may itself be what cannot be made.
inline std::string& last_refusal() {
  static std::string refusal;
  return refusal;
}

/// What every function returns: what `act` does, or else `harmless`, and then a refusal is kept. Nothing that
/// is thrown passes through it.
template <typename Value, typename Act>
Value guarded(Value harmless, const Act& act) noexcept {
  try {
    try {
      return act(session());
    } catch (const std::bad_alloc&) {
      last_refusal() = "There is not enough memory.";
    } catch (const std::exception& error) {
      last_refusal() = error.what();
    } catch (...) {
      last_refusal() = "It cannot be done, for an unknown reason.";
    }
  } catch (...) {  // no memory for the words either
    last_refusal().clear();
  }
  return harmless;
}

/// 1 where `act` is done, and 0 where it is refused.
template <typename Act>
int done(const Act& act) noexcept {
  return guarded(0, [&](Session& now) {
    act(now.playground);
    last_refusal().clear();
    return 1;
  });
}

/// A text that `tell` makes, or that is there already; or else "".
template <typename Tell>
const char* told(const Tell& tell) noexcept {
  return guarded("", [&](Session& now) {
    const Playground& playground = now.playground;
    if constexpr (std::is_reference_v<decltype(tell(playground))>) return tell(playground).c_str();
    now.text = tell(playground);
    return now.text.c_str();
  });
}

/// Numbers that `make` makes; or else the harmless ones.
template <typename Make>
const double* listed(const double* harmless, const Make& make) noexcept {
  return guarded(harmless, [&](Session& now) {
    now.numbers = make(static_cast<const Playground&>(now.playground));
    return static_cast<const double*>(now.numbers.data());
  });
}

/// The text. @throws std::invalid_argument for null.
inline const char* given(const char* text, const char* function, const char* name) {
  require(text != nullptr, function, name, "a text", "null");
  return text;
}

}  // namespace cairn::playground
