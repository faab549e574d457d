// The scripts for a cluster, without one: an sbatch that runs what it is given stands in for Slurm's.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <cairn/math/list.hpp>
#include "sandbox_program.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

namespace fs = std::filesystem;

const std::string study_script = CAIRN_SOURCE_DIR "/lessons/sandbox/cluster/study";

// Runs each task at once, as Slurm would: by sh, with what it says in the file of --output. A job that
// depends on one that failed is not run.
constexpr const char* sbatch_that_runs = R"(#!/usr/bin/env bash
array=none dependency=
for word in "$@"; do
  case $word in
    --wrap=*) wrap=${word#*=} ;;
    --array=*) array=${word#*=} ;;
    --output=*) output=${word#*=} ;;
    --dependency=*) dependency=${word##*:} ;;
    --time=soon) echo 'sbatch: error: Invalid --time specification' >&2; exit 1 ;;
  esac
done
count=$(($(cat "$SLURM_FAKE/count" 2>/dev/null || echo 0) + 1))
echo $count >"$SLURM_FAKE/count"
if [[ ! $dependency || ! -e $SLURM_FAKE/failed$dependency ]]; then
  for task in ${array//,/ }; do
    log=${output//%%/$'\1'}
    log=${log//%a/$task}
    SLURM_ARRAY_TASK_ID=$task sh -c "$wrap" >>"${log//$'\1'/%}" 2>&1 || touch "$SLURM_FAKE/failed$count"
  done
fi
echo "$count;here"
)";

// What a shell, sbatch, find or cairn could take for something else than a letter.
const std::string every_sign = "it's \"a, b\" $(touch run) `touch run` $HOME %a {c} * #; é";

/// A folder with that sbatch, and `study` in it.
struct Cluster {
  ScratchFolder folder = {};

  Cluster() {
    fs::create_directories(folder.path() + "/fake");
    folder.write("fake/sbatch", sbatch_that_runs);
    fs::permissions(folder.path() + "/fake/sbatch", fs::perms::owner_all);
  }

  Ran study(const List<std::string>& words) const {
    const std::string fake = folder.path() + "/fake";
    List<std::string> all = {
        "-C",   folder.path(), "PATH=" + fake + ":" + std::getenv("PATH"), "SLURM_FAKE=" + fake,
        "bash", study_script};
    all.insert(all.end(), words.begin(), words.end());
    return run_program("/usr/bin/env", all);
  }
  Ran submit(const std::string& place, List<std::string> words) const {
    words.insert(words.begin(), {"submit", place});
    words.insert(words.begin() + 2 + (words[2][0] == '-' ? 0 : 1), {"--cairn", CAIRN_BIN_DIR "/cairn"});
    return study(words);
  }
  /// Refused before anything was submitted or made.
  void refuses(const std::string& place, const List<std::string>& words, const std::string& message) const {
    const Ran ran = submit(place, words);
    CAPTURE(message);
    CAPTURE(ran.err);
    CHECK(ran.code == 2);
    CHECK(text_has(ran.err, message));
    CHECK_FALSE(fs::exists(folder.path() + "/fake/count"));
    CHECK_FALSE(fs::exists(fs::path(folder.path()) / place));
  }
};

const List<std::string> small_study = {"tradeoff", "--all", "--level", "1", "--quick", "--solvers", "si"};

}  // namespace

TEST_CASE("a study comes through in a folder with any sign in its name, and nothing in it is executed") {
  const Cluster cluster;
  List<std::string> words = small_study;
  words.insert(words.begin(), "2");
  const Ran ran = cluster.submit(every_sign, words);
  CAPTURE(ran.err);
  CHECK(ran.code == 0);
  CHECK(ran.out == "parts 1,2: job 1; merge: job 2\n");
  CAPTURE(cluster.folder.text(every_sign + "/log/part-1.txt"));
  CAPTURE(cluster.folder.text(every_sign + "/log/merge.txt"));
  List<std::string> whole = small_study;
  whole.insert(whole.end(), {"--out", cluster.folder.path() + "/whole", "--quiet"});
  REQUIRE(run_cairn(whole).code == 0);
  CHECK_FALSE(cluster.folder.text("whole/level1.csv").empty());
  CHECK(cluster.folder.text(every_sign + "/merged/level1.csv") == cluster.folder.text("whole/level1.csv"));
  const Ran status = cluster.study({"status", every_sign});
  CHECK(status.code == 0);
  CHECK(text_has(status.out, "2 of 2 parts are done; merged: "));
  CHECK(cluster.folder.names() == List<std::string>{"fake", every_sign, "whole"});
  CHECK(cluster.folder.names("fake") == List<std::string>{"count", "sbatch"});
}

TEST_CASE("what every part would refuse is refused when the study is submitted") {
  const Cluster cluster;
  const auto with = [](List<std::string> more) {
    List<std::string> words = small_study;
    words.insert(words.begin(), "2");
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  cluster.refuses("two\nlines", with({}), "DIR must be one line");
  cluster.refuses("back\\slash", with({}), "DIR must be without backslashes");
  for (const std::string flag : {"--out", "--shard", "--merge", "--progress", "--table"})
    cluster.refuses("study", with({flag, "x"}), flag + " must be left out");
  cluster.refuses("study", with({"--out=x"}), "--out must be left out");
  cluster.refuses("study", with({"--quiet"}), "--quiet must be left out");
  cluster.refuses("study", with({"--levle", "1"}), "unknown flag --levle; did you mean --level?");
  cluster.refuses("study", {"2", "tradeoff", "--all", "--level", "9"}, "--level must be");
  cluster.refuses("study", {"2", "run", "stack"}, "what is run must be tradeoff or extremes, got run");
  cluster.refuses("study", {"0", "extremes"}, "PARTS must be 1 to 10000, got 0");
}

TEST_CASE("a study that sbatch does not take leaves a folder that can be used again") {
  const Cluster cluster;
  List<std::string> words = small_study;
  words.insert(words.begin(), {"2", "--time", "soon"});
  const Ran refused = cluster.submit("study", words);
  CHECK(refused.code == 2);
  CHECK(text_has(refused.err, "sbatch did not take the study"));
  words[2] = "5";
  CHECK(cluster.submit("study", words).code == 0);
  CHECK(fs::exists(cluster.folder.path() + "/study/merged/level1.csv"));
}

TEST_CASE("the commands of a file may have quotes, and any ends of lines") {
  const Cluster cluster;
  fs::copy_file(CAIRN_SOURCE_DIR "/lessons/scenes/stack.toml", cluster.folder.path() + "/my stack.toml");
  cluster.folder.write("commands",
                       "list solvers\r\n\r\n  \nrun \"./my stack.toml\" --seconds 0.1 --sweeps 1 --quiet\r\n"
                       "list 'scenes'");
  const Ran ran = cluster.submit("lines", {"--lines", "commands"});
  CAPTURE(ran.err);
  CAPTURE(cluster.folder.text("lines/log/part-2.txt"));
  CHECK(ran.code == 0);
  CHECK(ran.out == "parts 1,2,3: job 1; merge: job 2\n");
  const std::string merged = cluster.folder.text("lines/merged/lines.txt");
  CHECK(merged.starts_with("# cairn list solvers\n" + run_cairn({"list", "solvers"}).out + "# cairn run "));
  CHECK(merged.ends_with("# cairn list 'scenes'\n" + run_cairn({"list", "scenes"}).out));
  CHECK(merged.find('\r') == std::string::npos);
}

TEST_CASE("a line that its part would refuse is refused with its number") {
  const Cluster cluster;
  const struct {
    const char *lines, *message;
  } cases[] = {
      {"list scenes\nrun 'stack\n", "line 2 of --lines must have its quotes in pairs, got run 'stack"},
      {"list scenes\nlist --sollvers\n", "line 2 of --lines: cairn list: unknown flag --sollvers"},
      {"lst scenes\n", "line 1 of --lines: cairn: there is no verb lst"},
      {"list --progress never\n", "line 1 of --lines: cairn list: --progress is given twice"},
      {"\r\n\n", "--lines must be a file of 1 to 10000 commands, got 0 in "}};
  for (const auto& [lines, message] : cases) {
    cluster.folder.write("commands", lines);
    cluster.refuses("lines", {"--lines", "commands"}, message);
  }
  cluster.refuses("lines", {"--lines", "nothing"},
                  "--lines must be a file with a command in each line, got ");
}

TEST_CASE("what stands in a study's folder is read, and never run") {
  const Cluster cluster;
  const std::string whole = "parts=2\ntime=\ncairn=/bin/true\nfrom=/\nword=tradeoff\n";
  fs::create_directories(cluster.folder.path() + "/study/done");
  cluster.folder.write("study/study.txt", whole + "touch run\n");
  const Ran foreign = cluster.study({"status", "study"});
  CHECK(foreign.code == 2);
  CHECK(text_has(foreign.err, "study.txt must be as submit has written it, got the line 'touch run'"));
  cluster.folder.write("study/study.txt", whole + "word=$(touch run)\n");
  CHECK(cluster.study({"status", "study"}).code == 1);
  cluster.folder.write("study/study.txt", "parts=$(touch run)\n");
  CHECK(cluster.study({"status", "study"}).code == 2);
  CHECK_FALSE(fs::exists(cluster.folder.path() + "/run"));
}
