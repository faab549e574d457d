// What a run leaves for programs: its numbers as JSON, and an account of itself.
#pragma once

#include <string>

#include "lessons/kit/arguments.hpp"
#include "lessons/kit/claims.hpp"
#include "lessons/kit/film.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>

namespace cairn {

/// The rows as objects, named by the header; numbers read back bit-equal, those that are none are null.
std::string json_of(const CsvTable& table);
std::string csv_of(const CsvTable& table);

/// What a lesson answers to its question; no numbers where none was asked.
struct AnswerRecord {
  List<double> right = {};
  double tolerance = 0;
  std::string explanation = {};
};

/// The flags, claims, answer, state and pictures of a run: the same run gives the same text.
struct RunRecord {
  AnswerRecord answer = {};
  List<Claim> claims = {};
  std::string fingerprint = {};  // "" without one
  FilmReport film = {};
};
std::string run_json(const LessonInfo& info, const Options& options, const RunRecord& record);

/// The command line that repeats the run, every scene flag in it.
std::string command_line(const LessonInfo& info, const Options& options);

}  // namespace cairn
