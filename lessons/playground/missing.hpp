// What the C++ library of Debian 12's emscripten lacks of C++20, and later ones have. Included before every
// file of the build for browsers.
#pragma once

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>
#include <version>

namespace std {

#ifndef __cpp_lib_bit_cast
template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

template <typename Number, enable_if_t<is_floating_point_v<Number>, int> = 0>
from_chars_result from_chars(const char* first, const char* last, Number& value) {
  const string text(first, last);
  if (text.empty() || text[0] == '+' || isspace(static_cast<unsigned char>(text[0])))
    return {first, errc::invalid_argument};
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  value = static_cast<Number>(read);
  return {first + (end - text.c_str()), errc{}};
}

#ifndef __cpp_lib_jthread
class jthread : public thread {
 public:
  using thread::thread;
  jthread(jthread&&) = default;
  ~jthread() {
    if (joinable()) join();
  }
};
#endif

#if _LIBCPP_VERSION < 14000
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
  char text[400];
  const char* pattern = format == chars_format::fixed        ? "%.*f"
                        : format == chars_format::scientific ? "%.*e"
                                                             : "%.*g";
  const int length = snprintf(text, sizeof text, pattern, precision, value);
  if (length > last - first) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(length));
  return {first + length, errc{}};
}
#endif

}  // namespace std
