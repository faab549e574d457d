// Frames in a folder: which are there, which are to be drawn.
#include "lessons/sandbox/film_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/film_encoders.hpp"
#include "lessons/sandbox/progress_line.hpp"
#include <cairn/measure/whole_file.hpp>
#include "render/sequence.hpp"

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string frame_name(int index) { return fmt::format("{:04}.png", index); }

bool is_frame_name(const std::string& name) {
  return name.size() >= 8 && name.substr(name.size() - 4) == ".png" &&
         name.find_first_not_of("0123456789") == name.size() - 4;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WriteError("cannot make the folder " + folder.string() + ": " + error.message());
}

/// What the folder's note says that its frames are of; nothing without a note.
std::optional<std::string> identity_in(const fs::path& folder) {
  std::ifstream stream(folder / "frames.json");
  if (!stream) return std::nullopt;
  const Json note = Json::parse(stream, nullptr, false);
  if (!note.is_object() || !note.contains("film") || !note["film"].is_string()) return std::nullopt;
  return note["film"].get<std::string>();
}

/// Frames in the folder, and what is left of those that were not finished.
List<fs::path> numbered_pictures(const fs::path& folder) {
  List<fs::path> numbered;
  std::error_code none_there;
  for (const auto& entry : fs::directory_iterator(folder, none_there)) {
    const fs::path name = entry.path().filename();
    const bool is_part = name.extension() == ".part";  // 0004.png.3f...9c.part: see WholeFile
    if (is_frame_name(is_part ? name.stem().stem().string() : name.string()))
      numbered.push_back(entry.path());
  }
  return numbered;
}

void require_own_folder(const fs::path& folder) {
  if (identity_in(folder)) return;
  const fs::path note = folder / "frames.json";
  if (fs::exists(note)) {
    throw WriteError(note.string() +
                     " is not of a film of cairn; name another folder, or move the file away");
  }
  if (numbered_pictures(folder).empty()) return;
  throw WriteError(folder.string() +
                   " holds numbered pictures that are no film of cairn; name an empty folder, or a new one");
}

/// Two runs must not fill one folder. The system frees it with the process that had it, however that ended.
class FolderLock {
 public:
  /// A folder that is missing, or that cannot be locked, is free.
  explicit FolderLock(const fs::path& folder)
      : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(file_);
    throw WriteError(folder.string() +
                     " is being filled by another run; wait for it, or name another folder");
  }
  ~FolderLock() {
    if (file_ >= 0) close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

/// Makes the folder ready: afterwards, numbered pictures in it are whole frames of this very film.
void prepare_folder(const fs::path& folder, const std::string& identity, const Json& note) {
  require_own_folder(folder);
  const std::optional<std::string> before = identity_in(folder);
  for (const fs::path& path : numbered_pictures(folder)) {
    if (before != identity || path.extension() == ".part") fs::remove(path);
  }
  write_whole_file(folder / "frames.json", note.dump(1) + "\n");
}

/// Encodes one picture while the next is drawn.
class FrameSaver {
 public:
  void save(const fs::path& path, render::Image image) {
    finish();
    pending_ = std::async(std::launch::async,
                          [path, picture = std::move(image)] { render::write_png(path, picture); });
  }
  void finish() {
    if (pending_.valid()) pending_.get();
  }

 private:
  std::future<void> pending_ = {};
};

/// A folder that is gone when this is.
class PassingFolder {
 public:
  PassingFolder() {
    std::error_code error;
    path_ = (fs::temp_directory_path(error) / "cairn-film-XXXXXX").string();
    if (error) {
      const char* named = std::getenv("TMPDIR");
      throw WriteError(std::string("TMPDIR must name a folder for temporary files, got ") +
                       (named == nullptr ? "nothing" : named));
    }
    if (mkdtemp(path_.data()) == nullptr) throw WriteError("cannot make the folder " + path_);
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Every frame of the film into the folder and the APNG, where they are wanted; what is in the folder already
/// stays.
FilmOutcome write_frames(SceneFilm& film, const std::optional<fs::path>& folder, render::ApngWriter* apng,
                         const std::function<bool()>& stops, const ConsoleSettings& console) {
  FilmOutcome outcome;
  FrameSaver saver;
  ProgressLine progress(console, "frames", film.frame_count());
  for (int i = 0; i < film.frame_count() && !outcome.stopped; ++i) {
    const fs::path path = folder ? *folder / frame_name(i) : fs::path();
    if (folder && fs::exists(path)) {
      if (apng != nullptr) apng->add(render::read_png(path));
      outcome.kept += 1;
    } else {
      const render::Image image = film.draw(i);
      if (folder) saver.save(path, image);
      if (apng != nullptr) apng->add(image);
      outcome.drawn += 1;
    }
    progress.advance(i + 1);
    outcome.stopped = stops && stops();
  }
  saver.finish();
  return outcome;
}

void write_encoded_films(const FilmFiles& files, const fs::path& folder, int count, FilmOutcome& outcome) {
  if (files.gif) {
    encode_gif(folder, files.frames_per_second, *files.gif);
    outcome.written.push_back(files.gif->string());
  }
  if (files.mp4) {
    encode_mp4(folder, files.frames_per_second, *files.mp4);
    outcome.written.push_back(files.mp4->string());
  }
  if (files.webp) {
    encode_webp(folder, count, files.frames_per_second, *files.webp);
    outcome.written.push_back(files.webp->string());
  }
}

}  // namespace

List<Flag> film_flags() {
  return {{"frames", "DIR",
           "a film: 0000.png, 0001.png ... in a folder of its own; taken up again if interrupted"},
          {"fps", "N", "frames for each second of the scene (30)"},
          {"apng", "FILE", "the film in one file, as animated PNG"},
          {"gif", "FILE", "the same as GIF; needs ffmpeg"},
          {"mp4", "FILE", "the same as MP4; needs ffmpeg"},
          {"webp", "FILE", "the same as WebP; needs img2webp or ffmpeg"}};
}

FilmFiles film_files(const Words& words) {
  FilmFiles files;
  if (const auto path = words.text("frames")) files.frames = *path;
  if (const auto path = words.text("apng")) files.apng = *path;
  if (const auto path = words.text("gif")) files.gif = *path;
  if (const auto path = words.text("mp4")) files.mp4 = *path;
  if (const auto path = words.text("webp")) files.webp = *path;
  for (const char* flag : {"fps", "size", "theme", "show"}) {
    if (!files.any()) words.refuse_beside(flag, "without --frames, --apng, --gif, --mp4 or --webp");
  }
  files.frames_per_second = words.number("fps", 30, 0.01, 600);
  require_encoders(files);
  if (files.frames) {
    require_own_folder(*files.frames);
    const FolderLock is_free(*files.frames);
  }
  return files;
}

std::string film_identity(const SceneEntry& scene, const List<SceneRun>& runs, const FilmLook& look,
                          double frames_per_second) {
  std::string text = scene.name + ", " + scene.title;
  for (const SceneRun& run : runs) {
    text += fmt::format("; {}, {:.17g} s, state {:016x}", setting_text(run.setting), run.result.seconds,
                        run.result.state_hash);
  }
  text += fmt::format("; {}x{}, {}, {:.17g} a second, shows", look.width, look.height,
                      look.dark ? "dark" : "light", frames_per_second);
  for (const std::string& what : look.shows) text += " " + what;
  return text;
}

std::string film_text(const FilmOutcome& outcome) {
  std::string text = "written: " + joined(outcome.written, ", ");
  if (outcome.kept > 0) text += fmt::format(" ({} frames were there)", outcome.kept);
  return text;
}

std::string stopped_text(const FilmFiles& files, const FilmOutcome& outcome) {
  return fmt::format("stopped after {} frames; {}", outcome.drawn + outcome.kept,
                     files.frames ? "the same command goes on there"
                                  : "no film is written, and the same command begins anew");
}

FilmOutcome write_film(SceneFilm& film, const std::string& identity, const FilmFiles& files,
                       const std::function<bool()>& stops, const ConsoleSettings& console) {
  if (film.frame_count() == 0) throw WriteError("there is no frame to draw");
  std::optional<PassingFolder> passing;
  std::optional<fs::path> folder = files.frames;
  if (!folder && (files.gif || files.mp4 || files.webp)) folder = passing.emplace().path();
  const Json note = {{"film", identity},
                     {"frames", film.frame_count()},
                     {"frames_per_second", files.frames_per_second},
                     {"first", frame_name(0)},
                     {"last", frame_name(film.frame_count() - 1)}};
  std::optional<FolderLock> lock;
  if (folder) {
    make_folder(*folder);
    lock.emplace(*folder);
    prepare_folder(*folder, identity, note);
  }
  std::optional<render::ApngWriter> apng;
  if (files.apng) apng.emplace(*files.apng, film.frame_count(), files.frames_per_second);
  FilmOutcome outcome = write_frames(film, folder, apng ? &*apng : nullptr, stops, console);
  if (outcome.stopped && outcome.drawn + outcome.kept < film.frame_count()) return outcome;
  outcome.stopped = false;
  if (files.frames) {
    outcome.written.push_back(fmt::format("{} frames in {}", film.frame_count(), folder->string()));
  }
  if (apng) {
    apng->finish();
    outcome.written.push_back(files.apng->string());
  }
  if (folder) write_encoded_films(files, *folder, film.frame_count(), outcome);
  return outcome;
}

}  // namespace cairn::sandbox
