// What cairn writes of a run: films, whole or interrupted, and time series.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include "render/image.hpp"
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

namespace fs = std::filesystem;

/// A short, small film of the stack into a folder: 7 frames, at 0, 0.1 ... 0.6 s.
List<std::string> small_film(const std::string& folder) {
  return {"run", "stack", "--seconds", "0.6s", "--fps", "10", "--size", "320x180", "--frames", folder};
}

List<std::string> frame_names(int count) {
  List<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("000" + std::to_string(i) + ".png");
  return names;
}

/// Starts a film and interrupts it once there is a frame. The exit code.
int run_interrupted(const std::string& folder, const List<std::string>& flags) {
  const pid_t child = started_cairn(flags, "/dev/null");
  int status = 0;
  bool is_sent = false;
  for (int i = 0; i < 24000; ++i) {
    if (waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (!is_sent && fs::exists(folder + "/0000.png")) {
      kill(child, SIGINT);
      is_sent = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return -1;
}

/// PATH with a folder in front, or that folder alone, for as long as it lives.
class OtherPath {
 public:
  explicit OtherPath(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~OtherPath() { setenv("PATH", before_.c_str(), 1); }
  OtherPath(const OtherPath&) = delete;
  OtherPath& operator=(const OtherPath&) = delete;

 private:
  std::string before_;
};

}  // namespace

TEST_CASE(
    "the time series has a row for the start and for every step, and its numbers are those of the run") {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/made/for/it/series.csv";
  const nlohmann::json run = cairn_json({"run", "double-pendulum", "--seconds", "0.5s", "--csv", path});
  std::ifstream stream(path);
  const CsvTable table = read_csv(stream, path);
  REQUIRE(table.rows.size() == run["steps"].get<int>() + 1);
  const auto column = [&table](const std::string& name) {
    return std::find(table.header.begin(), table.header.end(), name) - table.header.begin();
  };
  const auto number = [](const CsvCell& cell) {
    return std::holds_alternative<double>(cell) ? std::get<double>(cell)
                                                : static_cast<double>(std::get<long long>(cell));
  };
  double worst_drift = 0, updates = 0;
  for (int i = 0; i < table.rows.size(); ++i) {
    CHECK(number(table.rows[i][column("time_s")]) ==
          doctest::Approx(static_cast<double>(i) * run["dt_s"].get<double>()));
    worst_drift = std::max(worst_drift, number(table.rows[i][column("drift")]));
    updates += number(table.rows[i][column("row_updates")]);
  }
  // 17 digits read back bit for bit.
  CHECK(worst_drift == run["drift_m_or_rad"].get<double>());
  CHECK(updates == run["row_updates"].get<double>());
  CHECK(number(table.rows.back()[column("energy_gain")]) == run["energy_gain"].get<double>());
  CHECK(number(table.rows.back()[column("energy_loss")]) == run["energy_loss"].get<double>());
  const Ran piped = run_cairn({"run", "double-pendulum", "--seconds", "0.5s", "--csv", "-"});
  CHECK(piped.out == folder.text("made/for/it/series.csv"));
  CHECK(text_has(piped.err, "meets"));
}

TEST_CASE("a film is whole frames from 0000 and a note; the same command draws only what is missing") {
  const ScratchFolder folder;
  const Ran first = run_cairn(small_film(folder.path() + "/film"));
  CHECK(first.code == 0);
  List<std::string> names = frame_names(7);
  names.push_back("frames.json");
  CHECK(folder.names("film") == names);
  CHECK(nlohmann::json::parse(folder.text("film/frames.json"))["frames"] == 7);
  const render::Image start = render::read_png(folder.path() + "/film/0000.png");
  CHECK(start.width == 320);
  CHECK(start.height == 180);
  const std::string last = folder.text("film/0006.png");
  // A frame that is kept is not even read: what stands there stays.
  folder.write("film/0002.png", "marked");
  folder.write("film/0004.png.0123456789abcdef.part", "half");
  fs::remove(folder.path() + "/film/0006.png");
  const Ran second = run_cairn(small_film(folder.path() + "/film"));
  CHECK(text_has(second.out, "(6 frames were there)"));
  CHECK(folder.text("film/0002.png") == "marked");
  CHECK(folder.text("film/0006.png") == last);
  CHECK(folder.names("film") == names);
  // Another film in the same folder begins anew.
  List<std::string> other = small_film(folder.path() + "/film");
  other.insert(other.end(), {"--theme", "dark"});
  CHECK_FALSE(text_has(run_cairn(other).out, "were there"));
  CHECK(folder.text("film/0002.png") != "marked");
  CHECK(folder.text("film/0006.png") != last);
}

TEST_CASE("a film that is interrupted leaves whole frames, and goes on where it was") {
  const ScratchFolder folder;
  const std::string film = folder.path() + "/film";
  const List<std::string> flags = {"run",    "pyramid", "--seconds", "1s", "--fps",    "40",
                                   "--size", "large",   "--frames",  film, "--sweeps", "4"};
  CHECK(run_interrupted(film, flags) == 130);
  const List<std::string> names = folder.names("film");
  const int frames = names.size() - 1;  // beside the note
  CHECK(frames >= 1);
  CHECK(frames < 41);
  for (int i = 0; i < frames; ++i) CHECK(render::read_png(film + "/" + names[i]).width == 1920);
  const Ran rest = run_cairn(flags);
  CHECK(rest.code == 0);
  CHECK(text_has(rest.out, "(" + std::to_string(frames) + " frames were there)"));
  CHECK(folder.names("film").size() == 42);
}

TEST_CASE("a folder that another run fills is refused, and free once that run is killed") {
  const ScratchFolder folder;
  const std::string film = folder.path() + "/film";
  const pid_t other =
      started_cairn({"run", "pyramid", "--seconds", "20s", "--size", "large", "--frames", film}, "/dev/null");
  for (int i = 0; i < 12000 && !fs::exists(film + "/0000.png"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const Ran refused = run_cairn(small_film(film));
  CHECK(refused.code == 3);
  CHECK(refused.out.empty());
  CHECK(text_has(refused.err, film + " is being filled by another run"));
  kill(other, SIGKILL);
  int status = 0;
  waitpid(other, &status, 0);
  CHECK(run_cairn(small_film(film)).code == 0);
  CHECK(folder.names("film").size() == 8);  // 7 frames and the note, and nothing of the run that was killed
}

TEST_CASE("an APNG that is interrupted leaves nothing, and does not promise to go on") {
  const ScratchFolder folder;
  // Stops it once there is the beginning of a file.
  const std::string script =
      "\"$0\" run pyramid --seconds 20s --size large --apng \"$1/film.png\" & for i in $(seq 12000); do "
      "ls \"$1\"/film.png.*.part > /dev/null 2>&1 && break; sleep 0.01; done; kill -TERM $!; wait $!";
  const Ran ran =
      run_program("/bin/sh", {"-c", script, std::string(CAIRN_BIN_DIR) + "/cairn", folder.path()});
  CHECK(ran.code == 130);
  CHECK(text_has(ran.err, "no film is written, and the same command begins anew"));
  CHECK(folder.names().empty());
}

TEST_CASE("a folder with numbered pictures of somebody else's is left alone") {
  const ScratchFolder folder;
  folder.write("holiday/0001.png", "the sea");
  const Ran ran = run_cairn(small_film(folder.path() + "/holiday"));
  CHECK(ran.code == 3);
  CHECK(text_has(ran.err, "no film of cairn"));
  CHECK(folder.names("holiday") == List<std::string>{"0001.png"});
  CHECK(run_cairn(small_film("/dev/null/film")).code == 3);
  folder.write("notes/frames.json", "{\"mine\": 1}");
  const Ran noted = run_cairn(small_film(folder.path() + "/notes"));
  CHECK(noted.code == 3);
  CHECK(text_has(noted.err, "notes/frames.json is not of a film of cairn; name another folder"));
  CHECK(folder.text("notes/frames.json") == "{\"mine\": 1}");
  CHECK(folder.names("notes") == List<std::string>{"frames.json"});
}

TEST_CASE("films in one file: APNG always, GIF and WebP where their programs are") {
  const ScratchFolder folder;
  fs::create_directories(folder.path() + "/programs");
  const std::string apng = folder.path() + "/film.png", gif = folder.path() + "/film.gif";
  const List<std::string> run = {"run", "stack", "--seconds", "0.2s", "--fps", "10", "--size", "320x180"};
  const auto with = [&run](const List<std::string>& more) {
    List<std::string> words = run;
    words.insert(words.end(), more.begin(), more.end());
    return run_cairn(words);
  };
  const OtherPath nothing(folder.path() + "/programs");
  CHECK(with({"--apng", apng}).code == 0);
  CHECK(text_has(folder.text("film.png"), "acTL"));  // the chunk that says how many frames
  const Ran missing = with({"--gif", gif});
  CHECK(missing.code == 3);
  CHECK(text_has(missing.err, "ffmpeg"));
  CHECK(missing.out.empty());
  CHECK(text_has(with({"--webp", folder.path() + "/film.webp"}).err, "img2webp or ffmpeg"));
  // A stand-in that writes its arguments where it should write the film.
  folder.write("programs/ffmpeg", "#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"$last\"\n");
  fs::permissions(folder.path() + "/programs/ffmpeg", fs::perms::owner_all);
  CHECK(with({"--gif", gif}).code == 0);
  CHECK(text_has(folder.text("film.gif"), "-framerate 10 -i "));
  folder.write("programs/img2webp", "#!/bin/sh\nexit 1\n");
  fs::permissions(folder.path() + "/programs/img2webp", fs::perms::owner_all);
  // Nothing is written through a link that lies in wait.
  folder.write("victim", "precious");
  fs::create_symlink(folder.path() + "/victim", folder.path() + "/.unfinished-film.gif");
  CHECK(with({"--gif", gif}).code == 0);
  CHECK(folder.text("victim") == "precious");
  fs::remove(folder.path() + "/.unfinished-film.gif");
  fs::remove(folder.path() + "/victim");
  const Ran failed = with({"--webp", folder.path() + "/film.webp"});
  CHECK(failed.code == 3);
  CHECK_FALSE(fs::exists(folder.path() + "/film.webp"));
  CHECK(folder.names() == List<std::string>{"film.gif", "film.png", "programs"});
}

TEST_CASE("a comparison is drawn side by side, with as many frames as its longest run") {
  const ScratchFolder folder;
  // Jacobi diverges within some steps; its panel then shows where it was.
  const Ran ran = run_cairn({"compare", "ragdoll", "--solvers", "si,jacobi", "--seconds", "0.3s", "--fps",
                             "10", "--size", "small", "--frames", folder.path() + "/film"});
  CHECK(ran.code == 4);
  List<std::string> names = frame_names(4);
  names.push_back("frames.json");
  CHECK(folder.names("film") == names);
  CHECK(render::read_png(folder.path() + "/film/0003.png").height == 540);
}
