// What the driver can do, one function per word.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/driver/catalogue.hpp"
#include "lessons/kit/console.hpp"
#include <cairn/math/list.hpp>

namespace cairn::driver {

struct Context {
  List<Program> programs = {};
  ConsoleSettings settings = {};
  std::filesystem::path progress_file = "lessons-progress.txt";  // in the current directory
};

/// Each returns the exit code of the driver.
int run_all(const Context& context, const List<std::string>& flags);
int list(const Context& context);
int next(const Context& context, const List<std::string>& flags);
/// A lesson's own checks, then its exercise; notes a pass.
int check_one(const Context& context, const Program& program, const List<std::string>& flags);
/// Of the exercise, or of the question of a lesson that has none.
int hint(const Context& context, const Program& program, const List<std::string>& number);
/// The model answer, once the exercise has been passed.
int solution(const Context& context, const Program& program);
/// The lessons' own checks, without the exercises; notes nothing.
int check_all(const Context& context, const List<std::string>& flags);
int progress(const Context& context);
int doctor(const Context& context);
int legend(const Context& context);
/// Every item of the paper, with the lesson, frame and check where it is met. 1 where one is in no lesson.
int coverage(const Context& context);
/// The lesson book, as pages that work from a file: book [FOLDER] [flags of the lessons].
int book(const Context& context, const List<std::string>& words);
/// All lessons as one PDF, printed by Chromium: handouts [FILE].
int handouts(const Context& context, const List<std::string>& words);

/// Pictures for documents, with alt texts beside them: export N|all [flags].
int export_pictures(const Context& context, const List<std::string>& words);

/// "  00  One body" for every lesson: for complaints about words that are none.
std::string short_list(const Context& context);

}  // namespace cairn::driver
