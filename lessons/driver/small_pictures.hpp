// The pictures of a film, made small for a page.
#pragma once

#include <cstdint>
#include <filesystem>

#include <cairn/math/list.hpp>

namespace cairn::driver {

/// A picture that a lesson drew, and where the small one goes.
struct FilmPicture {
  std::filesystem::path from = {};
  std::filesystem::path to = {};
  bool is_key = true;  // that stands for itself
};

/// What became of a film.
struct SmallFilm {
  List<int> bases = {};  // of each picture the one that it lies upon, by its place in the film; itself
  std::uintmax_t bytes = 0;
};

/// Writes all of a film, each as a PNG of at most 256 colours: those that it has, or the ones that come
/// nearest to all of them. A picture that is no key has only what differs from an earlier one, and lies upon
/// that, where this is much less. `bases` says so beforehand, as another theme has it. The same pictures give
/// the same bytes.
/// @throws std::runtime_error for a file that is no picture of a lesson, or of another size than the one
/// that it lies upon; WriteError
SmallFilm make_small(const List<FilmPicture>& film, const List<int>& bases = {});

}  // namespace cairn::driver
