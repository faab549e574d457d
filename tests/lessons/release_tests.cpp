// What is published is what was tested; and where it is published is said in one place.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "child_lesson.hpp"

using namespace cairn::testing;

namespace {

namespace fs = std::filesystem;

const fs::path project = CAIRN_SOURCE_DIR;

Ran shell(const std::string& line) { return run_program("/bin/bash", {"-c", line}); }

std::string text_of(const fs::path& file) { return shell("cat '" + file.string() + "'").out; }

/// The real scripts between a test and a book that are played.
struct ReleaseTree {
  ScratchFolder folder = {};

  ReleaseTree() {
    fs::create_directories(folder.path() + "/lessons/playground");
    for (const char* name : {"lessons/run", "lessons/playground/release.sh"})
      fs::copy_file(project / name, folder.path() + "/" + name);
    folder.write("lessons/new.sh", "");
    folder.write(
        "lessons/setup.sh",
        "cairn_root=$PWD\ncairn_set_up() { :; }\ncairn_build() { :; }\ncairn_make_playground() { :; }\n");
    write_test("page\n");
    folder.write("build/release/bin/lessons",
                 "#!/bin/bash\nmkdir -p \"$2\" && cp out/playground/index.html \"$2/playground.html\"\n"
                 "head -c 9999 /dev/zero >\"$2/index.html\"\n");
    fs::permissions(folder.path() + "/build/release/bin/lessons", fs::perms::owner_all);
    folder.write("tests/book/browser.mjs", "process.exit(0);\n");
  }

  /// What tests/run does: a page, and its sum; then what may come after.
  void write_test(const std::string& page, const std::string& then = ":") {
    folder.write("tests/run", "mkdir -p build/web_tests && cd build/web_tests || exit\nprintf '" + page +
                                  "' >index.html\nsha256sum index.html >tested\n" + then + "\n");
  }
  Ran release(const std::string& mask = "022") const {
    return shell("umask " + mask + " && cd '" + folder.path() + "' && bash lessons/run release");
  }
  std::string released(const std::string& file) const { return folder.text("out/release/" + file); }
};

}  // namespace

TEST_CASE("a release holds the page that was tested, in every place, and what is smaller compressed") {
  ReleaseTree tree;
  const Ran made = tree.release();
  CAPTURE(made.err);
  REQUIRE(made.code == 0);
  CHECK(tree.released("site/index.html") == "page\n");
  CHECK(tree.released("site/book/playground.html") == "page\n");
  CHECK(tree.released("playground.html") == "page\n");  // five bytes, which grow where they are packed
  const std::string sums = "cd '" + tree.folder.path() + "/out/release' && ";
  CHECK(shell(sums + "sha256sum --check SHA256SUMS").code == 0);
  CHECK(shell(sums + "tar -tzf book.tar.gz").out == "book/\nbook/index.html\nbook/playground.html\n");
  const std::string before = tree.released("SHA256SUMS");
  for (const char* mask : {"022", "077"}) {  // also where the maker's own files are nobody else's to read
    CHECK(tree.release(mask).code == 0);
    CHECK(tree.released("SHA256SUMS") == before);
  }
}

TEST_CASE("what was not tested, or failed, is not released, and an earlier release stays") {
  ReleaseTree tree;
  REQUIRE(tree.release().code == 0);
  tree.write_test("newer\n", "exit 1");
  CHECK(tree.release().code == 1);
  tree.write_test("newer\n", "echo changed >>index.html");
  const Ran changed = tree.release();
  CHECK(changed.code == 1);
  CHECK(changed.err.find("is not the page that bash tests/run web has tested") != std::string::npos);
  tree.write_test("newer\n");
  tree.folder.write("tests/book/browser.mjs", "console.log('FAILED a page'); process.exit(1);\n");
  const Ran broken = tree.release();
  CHECK(broken.code == 1);
  CHECK(broken.err.find("FAILED a page") != std::string::npos);
  CHECK(tree.released("site/index.html") == "page\n");
  CHECK_FALSE(fs::exists(tree.folder.path() + "/out/release.new"));
}

TEST_CASE("the film in README leads to the base address, and without one to the page on the playground") {
  const std::string address = text_of(project / "lessons/playground/base_address.txt");
  const std::string link =
      "<a href=\"" + (address.empty() ? "lessons/playground/README.md" : address) + "\">";
  CHECK(text_of(project / "README.md").find(link + "\n<picture>") != std::string::npos);
}

TEST_CASE("publish_at.sh sets both, and refuses what is no address") {
  const ScratchFolder folder;
  fs::create_directories(folder.path() + "/lessons/playground");
  fs::copy_file(project / "lessons/playground/publish_at.sh",
                folder.path() + "/lessons/playground/publish_at.sh");
  fs::copy_file(project / "README.md", folder.path() + "/README.md");
  const auto publish = [&](const std::string& address) {
    return shell("bash '" + folder.path() + "/lessons/playground/publish_at.sh' '" + address + "'");
  };
  CHECK(publish("https://name.example/cairn/").code == 0);
  CHECK(folder.text("lessons/playground/base_address.txt") == "https://name.example/cairn/");
  CHECK(folder.text("README.md").find("<a href=\"https://name.example/cairn/\">\n<picture>") !=
        std::string::npos);
  for (const char* wrong : {"name.example", "http://name.example/", "https://name.example"}) {
    const Ran refused = publish(wrong);
    CHECK(refused.code == 2);
    CHECK(refused.err.find("must be empty or https://.../") != std::string::npos);
  }
  CHECK(publish("").code == 0);
  CHECK(folder.text("README.md").find("<a href=\"lessons/playground/README.md\">\n<picture>") !=
        std::string::npos);
}

TEST_CASE("the workflow publishes the folder that lessons/run release makes") {
  const std::string workflow = text_of(project / ".github/workflows/publish.yml");
  CHECK(workflow.find("- run: bash lessons/run release\n") != std::string::npos);
  const std::string folder = std::regex_replace(text_of(project / "lessons/run"),
                                                std::regex("[^]*cairn_make_release (\\S+)[^]*"), "$1");
  CHECK(folder.find(' ') == std::string::npos);
  CHECK(workflow.find("path: " + folder + "/site\n") != std::string::npos);
}
