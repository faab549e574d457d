// Child processes for the tests of whole lessons.
#include "child_lesson.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace cairn::testing {
namespace {

namespace fs = std::filesystem;

List<char*> pointers_to(List<std::string>& words) {
  List<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

void redirect(int stream, const std::string& path, int how) {
  const int file = open(path.c_str(), how, 0600);
  dup2(file, stream);
  close(file);
}

/// Runs `work` in a child whose streams are files.
Ran run_apart(const std::function<int()>& work) {
  const ScratchFolder folder;
  std::fflush(nullptr);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, folder.path() + "/out", O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, folder.path() + "/err", O_WRONLY | O_CREAT);
    const int code = work();
    std::fflush(nullptr);
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  return {.code = WEXITSTATUS(status), .out = folder.text("out"), .err = folder.text("err")};
}

}  // namespace

LessonInfo made_up_lesson() {
  LessonInfo info = {
      .number = 42, .name = "made_up", .title = "Made up", .idea = "A lesson that tests lessons."};
  info.paper = "paper 1, eq (1)";
  info.equations = {"(1)  λ = 1/60"};
  info.question = "What is six by seven?";
  info.unasked = {"dt"};
  info.wrong = {{.least = {12.5}, .most = {13.5}, .why = "That is the sum."}};
  info.hints = {"Count.", "It is 42."};
  info.parameters.push_back(
      {.flag = "dt", .standard = 0.02, .min = 0.001, .max = 0.1, .unit = "s", .what = "time step"});
  info.parameters.push_back(
      {.flag = "steps", .standard = 3, .min = 1, .max = 20, .what = "steps", .kind = Parameter::Kind::whole});
  info.choices.push_back({.flag = "precision", .values = {"double", "float"}, .what = "number type"});
  info.next = "lesson43_none";
  return info;
}

Ran run_in_child(const std::function<void(Lesson&)>& lesson, const List<std::string>& flags) {
  return run_apart([&lesson, &flags] {
    List<std::string> words = {"lesson42_made_up"};
    words.insert(words.end(), flags.begin(), flags.end());
    List<char*> pointers = pointers_to(words);
    return run_lesson(made_up_lesson(), lesson, words.size(), pointers.data());
  });
}

Ran run_program(const std::string& name, const List<std::string>& flags) {
  return run_apart([&name, &flags] {
    List<std::string> words = {(std::filesystem::path(CAIRN_BIN_DIR) / name).string()};
    words.insert(words.end(), flags.begin(), flags.end());
    const List<char*> pointers = pointers_to(words);
    execv(pointers[0], pointers.data());
    return 127;
  });
}

std::string driver_apart(const ScratchFolder& folder, const std::string& below,
                         const List<std::string>& lessons) {
  const fs::path built = CAIRN_BIN_DIR, tree = fs::path(folder.path()) / below, bin = tree / "bin";
  if (fs::exists(bin / "lessons")) return (bin / "lessons").string();
  fs::create_directories(bin);
  fs::copy_file(built / "lessons", bin / "lessons");
  fs::create_directory_symlink(built.parent_path() / "share", tree / "share");
  for (const std::string& name : lessons) fs::create_symlink(built / name, bin / name);
  return (bin / "lessons").string();
}

Shot word_shot(const std::string& word) {
  Shot shot = {.state = word, .alt = "The word " + word + ".", .key = true};
  shot.draw = [word](render::Page& page) {
    const render::Rect area = page.area();
    page.canvas().text({area.x + area.width / 4, area.y + area.height / 2}, word, page.label());
  };
  return shot;
}

}  // namespace cairn::testing
