// Frames written in the background: the right names, the same bytes on any number of threads, and no lost
// error.
#include <atomic>
#include <chrono>
#include <sys/stat.h>
#include <thread>

#include "render/picture_files.hpp"
#include "render/pictures.hpp"
#include "render/sequence.hpp"

using namespace cairn;
using namespace cairn::render;
using namespace cairn::test;
namespace fs = std::filesystem;

namespace {

/// Frames that take different times to encode, so that threads overtake each other.
Image frame_of_sequence(int index) {
  const int side = index % 3 == 0 ? 200 : 10;
  return random_picture(side, side + index, static_cast<std::uint64_t>(index));
}

std::string name_of_frame(int number) {
  const std::string text = std::to_string(number);
  return "l06_" + std::string(4 - text.size(), '0') + text + ".png";
}

}  // namespace

TEST_CASE("frames are numbered from 1 with four digits in a folder that is made for them") {
  const TemporaryFolder folder;
  const fs::path target = folder / "out/lesson03";
  FrameWriter writer(target, "l06");
  for (int i = 1; i <= 12; ++i) CHECK(writer.add(frame_of_sequence(i)) == target / name_of_frame(i));
  writer.finish();
  for (int i = 1; i <= 12; ++i) {
    const Image image = read_png(target / name_of_frame(i));
    CHECK(image.height == frame_of_sequence(i).height);
    CHECK(image.pixels == frame_of_sequence(i).pixels);
  }
  CHECK(std::distance(fs::directory_iterator(target), fs::directory_iterator()) == 12);
}

TEST_CASE("a number that needs more digits than asked for gets them") {
  const TemporaryFolder folder;
  FrameWriter writer(folder.path(), "f", {.digits = 1});
  fs::path last;
  for (int i = 1; i <= 10; ++i) last = writer.add(flat_picture(1, 1, 0));
  CHECK(last == folder / "f_10.png");
}

TEST_CASE("one, two and four threads write the same bytes as none") {
  for (const int threads : {1, 2, 4}) {
    const TemporaryFolder folder;
    FrameWriter writer(folder.path(), "l06", {.threads = threads});
    for (int i = 1; i <= 20; ++i) writer.add(frame_of_sequence(i));
    writer.finish();
    for (int i = 1; i <= 20; ++i) {
      CHECK(text_of_file(folder / name_of_frame(i)) == as_text(encode_png(frame_of_sequence(i))));
    }
  }
}

TEST_CASE("after finish the sequence can go on, and a writer that is destroyed has written every frame") {
  const TemporaryFolder folder;
  {
    FrameWriter writer(folder.path(), "l06");
    writer.finish();
    writer.add(flat_picture(3, 3, 1));
    writer.finish();
    CHECK(fs::exists(folder / "l06_0001.png"));
    for (int i = 2; i <= 9; ++i) writer.add(flat_picture(3, 3, 1));
  }
  for (int i = 1; i <= 9; ++i) CHECK(read_png(folder / name_of_frame(i)).width == 3);
}

TEST_CASE("finish throws the error of the first frame that failed, whichever thread was faster") {
  for (int combination = 0; combination < 6; ++combination) {
    const int threads = 1 << combination % 3;
    const int slow = combination < 3 ? 3 : 4;  // the number of a frame that takes long to encode
    const TemporaryFolder folder;
    for (const int number : {3, 4, 5}) fs::create_directory(folder / name_of_frame(number));
    FrameWriter writer(folder.path(), "l06", {.threads = threads});
    const std::string expected = "cannot write " + (folder / "l06_0003.png").string() + ": Is a directory";
    List<Image> images;  // made beforehand, so that the threads have several at a time
    for (int i = 1; i <= 8; ++i) images.push_back(random_picture(i == slow ? 500 : i == 3 ? 100 : 5, 500, 1));
    const auto add_frames = [&] {
      for (Image& image : images) writer.add(std::move(image));
      writer.finish();
    };
    CHECK(message_of<WriteError>(add_frames) == expected);
    CHECK(message_of<WriteError>([&] { writer.finish(); }) == expected);
    CHECK(message_of<WriteError>([&] { writer.add(flat_picture(1, 1, 0)); }) == expected);
    for (const int number : {1, 2}) CHECK(read_png(folder / name_of_frame(number)).width == 5);
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      CHECK(entry.path().extension() == ".png");  // nothing half-written
    }
  }
}

TEST_CASE("once a frame has failed no later one is begun") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "l06_0001.png");
  FrameWriter writer(folder.path(), "l06", {.threads = 1});
  const auto add_frames = [&] {
    for (int i = 1; i <= 8; ++i) writer.add(frame_of_sequence(i));
    writer.finish();
  };
  CHECK_THROWS_AS(add_frames(), WriteError);
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a writer is destroyed in peace although a frame could not be written") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "l06_0001.png");
  {
    FrameWriter writer(folder.path(), "l06", {.threads = 1});
    writer.add(flat_picture(2, 2, 0));
  }
  CHECK(fs::is_directory(folder / "l06_0001.png"));
}

TEST_CASE("at most two frames per thread wait: drawing cannot run away from the disk") {
  const TemporaryFolder folder;
  const fs::path stuck = folder / "l06_0001.png";
  REQUIRE(mkfifo(stuck.c_str(), 0600) == 0);  // a pipe: writing hangs until somebody reads
  {
    const TemporaryFolder other;  // a pipe of the wrong name would wait for ever
    REQUIRE(FrameWriter(other.path(), "l06").add(flat_picture(1, 1, 0)).filename() == stuck.filename());
  }
  FrameWriter writer(folder.path(), "l06", {.threads = 1});
  std::atomic<int> added = 0;
  std::thread producer([&] {
    for (int i = 1; i <= 6; ++i, ++added) writer.add(flat_picture(2, 2, 7));
  });
  while (added < 3) std::this_thread::yield();  // one is being written, two wait
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  CHECK(added == 3);
  CHECK(text_of_file(stuck) == as_text(encode_png(flat_picture(2, 2, 7))));
  producer.join();
  writer.finish();
  CHECK(fs::exists(folder / "l06_0006.png"));
}

TEST_CASE("a frame that is no picture is refused and takes no number") {
  const TemporaryFolder folder;
  FrameWriter writer(folder.path(), "l06");
  CHECK(message_of<std::invalid_argument>([&] { writer.add({}); }) ==
        "FrameWriter::add: width must be positive px, got 0");
  CHECK(writer.add(flat_picture(1, 1, 0)) == folder / "l06_0001.png");
}

TEST_CASE("a writer with no folder, no digits or no threads is refused") {
  const TemporaryFolder folder;
  write_whole_file(folder / "file", "");
  CHECK(message_of<WriteError>([&] { FrameWriter(folder / "file/out", "l06"); }) ==
        "cannot make the folder " + (folder / "file/out").string() + ": Not a directory");
  CHECK(message_of<WriteError>([&] { FrameWriter(folder / "file", "l06"); }).find("file: ") !=
        std::string::npos);
  for (const int value : {-1, 0, 65}) {
    CHECK_THROWS_AS(FrameWriter(folder.path(), "l06", {.digits = value}), std::invalid_argument);
    CHECK_THROWS_AS(FrameWriter(folder.path(), "l06", {.threads = value}), std::invalid_argument);
  }
}
