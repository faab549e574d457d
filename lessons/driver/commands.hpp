// What the driver can do, one function per word.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/console.hpp"
#include "lessons/driver/catalogue.hpp"

namespace cairn::driver {

struct Context {
  std::vector<Program> programs = {};
  ConsoleSettings settings = {};
  std::filesystem::path progress_file = "lessons-progress.txt";  // in the current directory
};

/// Each returns the exit code of the driver.
int run_all(const Context& context, const std::vector<std::string>& flags);
int list(const Context& context);
int next(const Context& context, const std::vector<std::string>& flags);
int check_one(const Context& context, const Program& program, const std::vector<std::string>& flags);
int check_all(const Context& context, const std::vector<std::string>& flags);
int progress(const Context& context);
int doctor(const Context& context);
int legend(const Context& context);

/// "  00  One body" for every lesson: for complaints about words that are none.
std::string short_list(const Context& context);

}  // namespace cairn::driver
