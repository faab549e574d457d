// The queue between one renderer and the threads that encode.
#include "render/sequence.hpp"

#include <fmt/core.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <iterator>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include <cairn/math/check.hpp>

namespace cairn::render {
namespace {

namespace fs = std::filesystem;

struct Frame {
  long long number = 0;
  fs::path path = {};
  Image image = {};
};

}  // namespace

struct FrameWriter::Impl {
  fs::path folder = {};
  std::string stem = {};
  int digits = 4;
  int capacity = 4;  // frames that may wait
  long long added = 0;

  std::mutex mutex = {};  // guards all below
  std::condition_variable work = {};
  std::condition_variable progress = {};
  std::deque<Frame> waiting = {};
  int busy = 0;  // frames that a thread encodes now
  bool closed = false;
  // Frames start in order and none after a failure, so the smallest number that failed does not depend on
  // timing.
  long long failed_number = std::numeric_limits<long long>::max();
  std::exception_ptr failure = {};

  List<std::thread> threads = {};

  ~Impl() {
    {
      const std::lock_guard lock(mutex);
      closed = true;
    }
    work.notify_all();
    for (std::thread& thread : threads) thread.join();
  }

  /// One encoding thread, until the queue is closed and empty.
  void encode_frames() {
    std::unique_lock lock(mutex);
    for (;;) {
      work.wait(lock, [this] { return closed || !waiting.empty(); });
      if (waiting.empty()) return;
      const Frame frame = std::move(waiting.front());
      waiting.pop_front();
      progress.notify_all();  // there is room again
      if (failure == nullptr) {
        ++busy;
        lock.unlock();
        std::exception_ptr error = written(frame);
        lock.lock();
        --busy;
        if (error != nullptr && frame.number < failed_number) {
          failed_number = frame.number;
          failure = std::move(error);
        }
      }
      progress.notify_all();
    }
  }

  static std::exception_ptr written(const Frame& frame) {
    try {
      write_png(frame.path, frame.image);
    } catch (...) {
      return std::current_exception();
    }
    return nullptr;
  }

  fs::path path_of(long long number) const {
    return folder / fmt::format("{}_{:0{}}.png", stem, number, digits);
  }
};

FrameWriter::FrameWriter(fs::path folder, std::string stem, const FrameWriterSettings& settings)
    : impl_(std::make_unique<Impl>()) {
  require(settings.digits >= 1 && settings.digits <= 64, "FrameWriter", "digits", "1 to 64", settings.digits);
  require(settings.threads >= 1 && settings.threads <= 64, "FrameWriter", "threads", "1 to 64",
          settings.threads);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WriteError("cannot make the folder " + folder.string() + ": " + error.message());
  impl_->folder = std::move(folder);
  impl_->stem = std::move(stem);
  impl_->digits = settings.digits;
  impl_->capacity = 2 * settings.threads;
  for (int i = 0; i < settings.threads; ++i) {
    impl_->threads.emplace_back([impl = impl_.get()] { impl->encode_frames(); });
  }
}

FrameWriter::~FrameWriter() = default;

fs::path FrameWriter::add(Image image) {
  require_image(image, "FrameWriter::add");
  std::unique_lock lock(impl_->mutex);
  impl_->progress.wait(lock, [this] { return std::ssize(impl_->waiting) < impl_->capacity; });
  if (impl_->failure != nullptr) {
    lock.unlock();
    finish();  // throws; drawing on is of no use when the disk is full
  }
  const long long number = ++impl_->added;
  fs::path path = impl_->path_of(number);
  impl_->waiting.push_back({number, path, std::move(image)});
  lock.unlock();
  impl_->work.notify_one();
  return path;
}

void FrameWriter::finish() {
  std::unique_lock lock(impl_->mutex);
  impl_->progress.wait(lock, [this] { return impl_->waiting.empty() && impl_->busy == 0; });
  if (impl_->failure != nullptr) std::rethrow_exception(impl_->failure);
}

}  // namespace cairn::render
