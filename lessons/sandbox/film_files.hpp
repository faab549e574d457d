// A film on disk: numbered frames that can be taken up again, and films in one file.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "lessons/sandbox/scene_film.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {

/// Where a film goes.
struct FilmFiles {
  std::optional<std::filesystem::path> frames = {};  // a folder of its own
  std::optional<std::filesystem::path> apng = {};
  std::optional<std::filesystem::path> gif = {};
  std::optional<std::filesystem::path> mp4 = {};
  std::optional<std::filesystem::path> webp = {};
  double frames_per_second = 30;

  bool any() const { return frames || apng || gif || mp4 || webp; }
};

/// --frames, --fps, --apng, --gif, --mp4, --webp.
List<Flag> film_flags();

/// @throws UsageError; render::WriteError where a program that is needed is not to be found, before any work
/// is done.
FilmFiles film_files(const Words& words);

struct FilmOutcome {
  int drawn = 0;
  int kept = 0;  // frames that were there, of the same film
  bool stopped = false;
  List<std::string> written = {};
};

/// Draws the film into its files. Frames 0000.png, 0001.png ... appear whole or not at all. `identity` says
/// what the film is of: frames of the same film that are there stay, those of another one are removed.
/// @throws render::WriteError, also for a folder that another run fills, or that holds numbered pictures or a
/// frames.json of somebody else's.
FilmOutcome write_film(SceneFilm& film, const std::string& identity, const FilmFiles& files,
                       const std::function<bool()>& stops, const ConsoleSettings& console);

/// Tells this film from every other one: scene, settings, the states that the runs ended in, and its look.
std::string film_identity(const SceneEntry& scene, const List<SceneRun>& runs, const FilmLook& look,
                          double frames_per_second);

/// "written: 91 frames in out/stack (12 were there)".
std::string film_text(const FilmOutcome& outcome);

/// What a film that was stopped leaves: a folder of frames is taken up again, a film in one file is not.
std::string stopped_text(const FilmFiles& files, const FilmOutcome& outcome);

/// The program of that name in PATH; nothing if there is none.
std::optional<std::filesystem::path> program_in_path(const std::string& name);

}  // namespace cairn::sandbox
