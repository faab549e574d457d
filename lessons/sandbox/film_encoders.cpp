// ffmpeg and img2webp, started without a shell.
#include "lessons/sandbox/film_encoders.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "lessons/kit/film_encoding.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/whole_file.hpp>
#include "render/image.hpp"

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;

/// What waitpid() says of it. An interrupt kills it: all that it has written is thrown away.
int status_at_end(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (interrupted()) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return status;
}

/// Runs it with its output thrown away, and its standard input empty.
void run_encoder(const fs::path& program, List<std::string> words) {
  words.insert(words.begin(), program.string());
  List<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  const int status = error == 0 ? status_at_end(child) : 0;
  if (interrupted()) throw Interrupted("stopped before " + words.back() + " was written");
  if (error != 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw render::WriteError(program.string() + " could not write " + words.back());
  }
}

void encode(const fs::path& program, List<std::string> words, const fs::path& target) {
  WholeFile file(target);
  words.push_back(file.part().string());
  try {
    run_encoder(program, words);
    file.finish();
  } catch (const Interrupted&) {
    throw Interrupted("stopped before " + target.string() + " was written");
  } catch (const std::exception& failure) {
    throw render::WriteError(target.string() + ": " + failure.what());
  }
}

void encode_with_ffmpeg(const fs::path& folder, double frames_per_second, const List<std::string>& encoding,
                        const std::string& format, const fs::path& target) {
  List<std::string> words = {"-y", "-framerate", fmt::format("{:g}", frames_per_second), "-i",
                             (folder / "%04d.png").string()};
  words.insert(words.end(), encoding.begin(), encoding.end());
  words.insert(words.end(), {"-f", format});
  encode(*program_in_path("ffmpeg"), words, target);
}

}  // namespace

std::optional<fs::path> program_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    const fs::path candidate = fs::path(folders.substr(begin, end - begin)) / name;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0) return candidate;
    begin = end + 1;
  }
  return std::nullopt;
}

void require_encoders(const FilmFiles& files) {
  const bool has_ffmpeg = program_in_path("ffmpeg").has_value();
  if (files.gif && !has_ffmpeg) {
    throw render::WriteError("--gif needs the program ffmpeg, which is not in PATH; --apng needs none");
  }
  if (files.mp4 && !has_ffmpeg) {
    throw render::WriteError("--mp4 needs the program ffmpeg, which is not in PATH; --apng needs none");
  }
  if (files.webp && !has_ffmpeg && !program_in_path("img2webp")) {
    throw render::WriteError(
        "--webp needs the program img2webp or ffmpeg, neither of which is in PATH; --apng needs none");
  }
}

void encode_gif(const fs::path& folder, double frames_per_second, const fs::path& target) {
  encode_with_ffmpeg(folder, frames_per_second, gif_encoding(), "gif", target);
}

void encode_mp4(const fs::path& folder, double frames_per_second, const fs::path& target) {
  encode_with_ffmpeg(folder, frames_per_second, mp4_encoding(), "mp4", target);
}

void encode_webp(const fs::path& folder, int count, double frames_per_second, const fs::path& target) {
  const std::optional<fs::path> img2webp = program_in_path("img2webp");
  if (!img2webp) {
    const List<std::string> encoding = {"-c:v", "libwebp_anim", "-lossless", "1", "-loop", "0"};
    return encode_with_ffmpeg(folder, frames_per_second, encoding, "webp", target);
  }
  const long milliseconds = std::max(1L, std::lround(1000 / frames_per_second));
  List<std::string> words = {"-loop", "0", "-lossless", "-d", std::to_string(milliseconds)};
  for (int i = 0; i < count; ++i) words.push_back((folder / fmt::format("{:04}.png", i)).string());
  words.push_back("-o");
  encode(*img2webp, words, target);
}

}  // namespace cairn::sandbox
