// How the run of a lesson ends: its exit code, and what is said of a failure.
#include "lessons/kit/ending.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "lessons/kit/arguments.hpp"
#include "lessons/kit/film.hpp"
#include "lessons/kit/output.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/check.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/measure/whole_file.hpp>

namespace cairn {

int complain(const std::string& name, int code, const std::string& message) {
  std::fflush(stdout);
  fmt::print(stderr, "{}{}\n", message.rfind(name, 0) == 0 ? "" : name + ": ",
             excerpt(message, longest_message));
  return code;
}

int finished(const LessonInfo& info, int code) {
  if (output_is_written()) return code;
  return complain(short_name(info), 3, "the output cannot be written");
}

int explain_failure(const std::string& name) {
  try {
    throw;
  } catch (const UsageError& error) {
    return complain(name, 2, error.what());
  } catch (const NoSuchFrame& error) {
    return complain(name, 2, error.what());
  } catch (const std::invalid_argument& error) {
    return complain(name, 2, error.what());
  } catch (const render::RenderError& error) {
    return complain(name, 3, std::string(error.what()) + "; --frames none runs the lesson without pictures");
  } catch (const WriteError& error) {
    return complain(name, 3,
                    std::string(error.what()) + "; -o names another folder, --frames none draws no pictures");
  } catch (const Diverged& error) {
    return complain(name, 4, std::string("the simulation diverged: ") + error.what());
  } catch (const Skipped& error) {
    return complain(name, 77, std::string("skipped: ") + error.what());
  } catch (const std::exception& error) {
    return complain(name, 1, std::string("a mistake in the lesson: ") + error.what());
  }
}

}  // namespace cairn
