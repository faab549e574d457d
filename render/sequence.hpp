// Pictures in sequence: numbered PNG files written behind the renderer's back, and animated PNG.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <cairn/math/list.hpp>
#include "render/image.hpp"
#include "render/palette.hpp"

namespace cairn::render {

struct FrameWriterSettings {
  int digits = 4;   // of the number in the file name, at least
  int threads = 2;  // that encode
};

/// Writes `<stem>_0001.png`, `<stem>_0002.png`, ... while the next frame is drawn. Encoding is most of a
/// frame's cost; at most two frames per thread wait, then add() does. To be used from one thread.
class FrameWriter {
 public:
  /// Makes the folder.
  /// @throws WriteError when that fails, std::invalid_argument unless digits and threads are 1 to 64.
  FrameWriter(std::filesystem::path folder, std::string stem, const FrameWriterSettings& settings = {});
  /// Waits for what was added. Errors are lost: call finish() to hear of them.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Takes the next frame and returns the path it will have.
  /// @throws std::invalid_argument as require_image(), and what finish() throws once a frame has failed.
  std::filesystem::path add(Image image);

  /// Returns when every frame is on disk.
  /// @throws WriteError of the first frame, by number, that could not be written; frames after it may be
  /// missing.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// An animated PNG that repeats for ever. Only the pixels that changed are stored of every frame, and written
/// at once: however long the film, memory holds one frame. A viewer that knows no animation shows the first.
/// Without a palette it shows exactly the given pixels, but for one green: #03FD02 becomes one level bluer.
class ApngWriter {
 public:
  /// A picture as the file keeps it.
  struct Picture {
    int width = 0, height = 0;  // [px]
    int depth = 3;              // [bytes] of a pixel: of a colour, or of a number in the palette
    List<std::uint8_t> bytes = {};
  };

  /// `frames`: as many as add() is going to bring. `palette`: colours 0xRRGGBB (ColorCount) of which each
  /// pixel becomes the nearest, in a file of half the size.
  /// @throws WriteError; std::invalid_argument unless there are frames, the rate is 0.01 to 655 frames per
  /// second (the format's limits), and the colours at most 255.
  ApngWriter(const std::filesystem::path& path, int frames, double frames_per_second,
             const List<std::uint32_t>& palette = {});

  /// `times`: how often as long as others it stays.
  /// @throws WriteError; std::invalid_argument as require_image(), for another size than the first, and for
  /// more than 654 times.
  void add(const Image& image, int times = 1);
  /// Puts the file into its place; without, there is none. @throws WriteError; std::invalid_argument unless
  /// all frames were added.
  void finish();

 private:
  void begin(const Picture& first);

  WholeFile file_;
  int frames_;
  Palette palette_;  // without colours: none
  int added_ = 0;
  std::uint32_t hundredths_ = 0;       // [frames per 100 s]
  std::uint32_t sequence_number_ = 0;  // one count for control and data chunks
  Picture last_ = {};
};

}  // namespace cairn::render
