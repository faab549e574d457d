// The shell scripts that a student types: what they answer without building, what they build, what they say
// meanwhile.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>

#include "child_lesson.hpp"
#include <cairn/math/list.hpp>

using namespace cairn::testing;
using cairn::List;

namespace {

namespace fs = std::filesystem;

Ran shell(const std::string& line) { return run_program("/bin/bash", {"-c", line}); }

/// A tree with the real lessons/run and a set-up that says what it would have built.
struct StubbedTree {
  ScratchFolder folder = {};

  StubbedTree() {
    const fs::path source = fs::path(CAIRN_SOURCE_DIR) / "lessons";
    const fs::path copy = fs::path(folder.path()) / "lessons";
    fs::create_directories(copy / "driver");
    fs::copy_file(source / "run", copy / "run");
    fs::copy_file(source / "driver" / "main.cpp", copy / "driver" / "main.cpp");
    for (const char* name : {"00_one_body", "03_sequential_impulses"}) fs::create_directories(copy / name);
    folder.write("lessons/03_sequential_impulses/exercise.cpp", "");
    folder.write("lessons/setup.sh",
                 "cairn_root=.\ncairn_set_up() { :; }\ncairn_build() { echo \"$*\"; exit 0; }\n");
  }

  Ran run(const std::string& words) const {
    return shell("cd '" + folder.path() + "' && bash lessons/run " + words);
  }
  std::string built(const std::string& words) const { return run(words).out; }
};

}  // namespace

TEST_CASE("lessons/run answers help and refuses unknown words before anything is built") {
  const StubbedTree tree;
  const Ran help = tree.run("--help");
  CHECK(help.code == 0);
  CHECK(help.out == run_program("lessons", {"--help"}).out);
  for (const char* word : {"99", "lst", "check 98", "hint"}) {
    INFO(std::string(word));
    const Ran refused = tree.run(word);
    CHECK(refused.code == 2);
    CHECK(refused.out.empty());
    CHECK(refused.err.find("bash lessons/run --help") != std::string::npos);
  }
}

TEST_CASE("lessons/run builds what is asked for and no more") {
  const StubbedTree tree;
  for (const char* word :
       {"list", "progress", "legend", "coverage", "doctor", "solution 3", "--plain list"}) {
    INFO(std::string(word));
    CHECK(tree.built(word) == "release lessons\n");
  }
  for (const char* word : {"3", "03", "run 3 --help", "lesson03", "sequential_impulses --predict"}) {
    INFO(std::string(word));
    CHECK(tree.built(word) == "release lessons lesson03_sequential_impulses\n");
  }
  CHECK(tree.built("check 3") == "release lessons lesson03_sequential_impulses exercise03\n");
  CHECK(tree.built("check 0") == "release lessons lesson00_one_body\n");
  CHECK(tree.built("cairn list") == "release cairn_sandbox\n");
  for (const char* word : {"", "book", "--frames none", "check --all"}) {
    INFO(std::string(word));
    CHECK(tree.built(word).rfind("release lessons", 0) == 0);
    CHECK(tree.built(word).find("lessons/all") != std::string::npos);
  }
  CHECK(tree.built("next") == "release lessons lesson00_one_body\n");
  tree.folder.write("lessons-progress.txt", "00 passed 2026-11-20\n");
  CHECK(tree.built("next") == "release lessons lesson03_sequential_impulses\n");
}

TEST_CASE("the scripts run wherever CDPATH leads") {
  const Ran ran = shell("cd '" CAIRN_SOURCE_DIR "' && CDPATH=. bash tests/run --help");
  CHECK(ran.code == 0);
  CHECK(ran.err.empty());
}

TEST_CASE("a step that takes long says every five seconds how far it has come, and keeps what it was told") {
  const ScratchFolder folder;
  const std::string watch = ". '" CAIRN_SOURCE_DIR "/lessons/setup.sh'; ";
  const std::string log = "'" + folder.path() + "/log'";
  const Ran build = shell(watch + "{ echo '[1/3] a'; sleep 7; printf '[2/'; sleep 2; echo '3] b'; } | " +
                          "cairn_watch Building " + log + " '^\\[([0-9]+)/([0-9]+)\\]'");
  CHECK(build.err.rfind("Building: 1 of 3, ", 0) == 0);
  CHECK(folder.text("log") == "[1/3] a\n[2/3] b\n");
  const Ran packages = shell(watch + "{ echo 'Get:1 a'; echo b; echo 'Get:2 c'; sleep 7; } | " +
                             "cairn_watch Fetching " + log + " '^Get:' 9");
  CHECK(packages.err.rfind("Fetching: 2 of 9, ", 0) == 0);
}

TEST_CASE("a document quotes a region or a function of a source file, and none that is not there") {
  const ScratchFolder scratch;
  const std::string quote = "# T\n\n<!-- source: code.cpp NAME -->\n```cpp\nold\n```\nend\n";
  const std::string command = "bash '" CAIRN_SOURCE_DIR "/lessons/documents.sh' '" + scratch.path() + "' '" +
                              scratch.path() + "/tree' '" + scratch.path() + "/new' 2>'" + scratch.path() +
                              "/said'";
  for (const char* folder : {"/tree/src", "/tree/lessons"}) fs::create_directories(scratch.path() + folder);
  scratch.write("cairn", "#!/bin/sh\n");  // documents.sh also asks it for a page of results
  fs::permissions(scratch.path() + "/cairn", fs::perms::owner_all);
  scratch.write("tree/README.md", "");
  scratch.write(
      "tree/lessons/code.cpp",
      "int other() { return 1; }\n\nint whole(int a,\n          int b) {\n  // [part]\n  if (a < b) {\n"
      "    return a;\n  }\n  // [/part]\n  return b;\n}\n");
  const auto quoted = [&](const std::string& name) {
    scratch.write("tree/lessons/text.md", std::regex_replace(quote, std::regex("NAME"), name));
    return std::system(command.c_str()) == 0 ? scratch.text("new/lessons/text.md") : scratch.text("said");
  };
  CHECK(quoted("part").find("```cpp\nif (a < b) {\n  return a;\n}\n```\nend\n") != std::string::npos);
  CHECK(quoted("whole").find("```cpp\nint whole(int a,\n          int b) {\n") != std::string::npos);
  CHECK(quoted("whole").find("  return b;\n}\n```\nend\n") != std::string::npos);
  CHECK(quoted("gone").find("there is no code.cpp gone") != std::string::npos);
}
