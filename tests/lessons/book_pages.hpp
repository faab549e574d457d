// The book of all lessons, made once for all tests that look at it.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>
#include "scratch_folder.hpp"

namespace cairn::testing {

/// The text of each by its name.
using Pages = std::map<std::string, std::string>;

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Without pandoc there are no books.
inline bool book_is_missing(const Ran& ran) {
  const bool cannot = ran.code == 3 && ran.err.find("made by pandoc") != std::string::npos;
  if (cannot) MESSAGE("pandoc is not installed: there is no book to look at");
  return cannot;
}

/// `lessons book` in a folder of its own: where a playground was made, its page would come with the book.
inline Ran make_book(const ScratchFolder& scratch, const std::string& driver, List<std::string> words) {
  words.insert(words.begin(), {"-C", scratch.path(), driver, "book"});
  return run_program("/usr/bin/env", words);
}

/// The whole book of key frames, made once for all tests.
struct WholeBook {
  ScratchFolder scratch = {};
  std::filesystem::path folder = scratch.path() + "/book";
  Ran ran = make_book(scratch, CAIRN_BIN_DIR "/lessons", {folder.string(), "--frames", "key"});
  Pages pages = {};

  WholeBook() {
    if (!std::filesystem::exists(folder)) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".html") {
        pages[entry.path().filename().string()] = bytes_of(entry.path());
      }
    }
  }
};

inline const WholeBook& whole_book() {
  static const WholeBook book;
  return book;
}

}  // namespace cairn::testing
