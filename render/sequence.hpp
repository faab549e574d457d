// Pictures in sequence: numbered PNG files written behind the renderer's back, and animated PNG.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <cairn/math/list.hpp>
#include "render/image.hpp"

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

/// An animated PNG that shows exactly the given pixels and repeats for ever; one green, #03FD02, becomes one
/// level bluer. Only the pixels that changed are stored of every frame, and written at once: however long the
/// film, memory holds one frame. A viewer that knows no animation shows the first.
class ApngWriter {
 public:
  /// `frames`: as many as add() is going to bring.
  /// @throws WriteError; std::invalid_argument unless there are frames, and the rate is 0.01 to 655 frames
  /// per second (the format's limits).
  ApngWriter(const std::filesystem::path& path, int frames, double frames_per_second);

  /// @throws WriteError; std::invalid_argument as require_image(), and for another size than the first.
  void add(Image image);
  /// Puts the file into its place; without, there is none. @throws WriteError; std::invalid_argument unless
  /// all frames were added.
  void finish();

 private:
  WholeFile file_;
  int frames_;
  int added_ = 0;
  std::uint32_t hundredths_ = 0;       // [frames per 100 s]
  std::uint32_t sequence_number_ = 0;  // one count for control and data chunks
  Image last_ = {};
};

}  // namespace cairn::render
