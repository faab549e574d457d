// What a stranger sees first.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "render/image.hpp"

namespace cairn::testing {

namespace {

namespace fs = std::filesystem;

std::string bytes_in(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("the README begins with what Cairn is, a moving picture and one command") {
  const fs::path source = CAIRN_SOURCE_DIR;
  const std::string readme = bytes_in(source / "README.md");
  std::smatch image, command;
  REQUIRE(std::regex_search(readme, image, std::regex("<img [^>]*src=\"([^\"]*)\"")));
  REQUIRE(std::regex_search(readme, command, std::regex("\n```\nbash lessons/run 1 ")));
  const std::string film = bytes_in(source / image[1].str());
  CHECK(film.find("acTL") != std::string::npos);  // an animated PNG
  const std::string before = readme.substr(0, static_cast<std::size_t>(command.position()));
  CHECK(before.find("teaches how constraint solvers work") != std::string::npos);
  CHECK(before.find("\n## ") == std::string::npos);
  CHECK(before.size() < 1000);  // a screen: a few lines and the film
}

TEST_CASE("no picture of the README is shown so small that its text cannot be read") {
  const fs::path source = CAIRN_SOURCE_DIR;
  const std::string readme = bytes_in(source / "README.md");
  const std::regex sized("<img width=\"([0-9]+)\"[^>]*src=\"([^\"]*)\"");
  for (std::sregex_iterator at(readme.begin(), readme.end(), sized), end; at != end; ++at) {
    CAPTURE((*at)[2].str());
    const render::Image picture = render::read_png((source / (*at)[2].str()).string());
    CHECK(std::stoi((*at)[1].str()) >= 0.73 * picture.width);  // 15 px of type become 11
  }
}

}  // namespace cairn::testing
