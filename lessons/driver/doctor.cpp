// Looks whether a picture can be drawn here, and says what the drawings mean.
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "lessons/driver/commands.hpp"
#include "lessons/driver/process.hpp"
#include "lessons/driver/work_folder.hpp"

namespace cairn::driver {
namespace {

namespace fs = std::filesystem;

constexpr const char* legend_text =
    R"(What the pictures mean. Colour never stands alone: shape, dash or marker says the same.

Arrows      orange, solid shaft, filled head       normal impulse or force, on the body that receives it
            orange, hatched shaft                  a correction that takes back
            purple, filled head, bracket [ ]       friction and its limit
            text colour, solid shaft, filled head  joint force
            blue, open head                        velocity
            grey, dashed shaft                     gravity and other forces from outside
Bodies      dark outline, pale fill, number        a body that moves
            blue fill and a, ochre fill and b      bodies a and b of the row that is being solved
            grey with 45 degree hatch              static: the ground
            dashed outline, z                      asleep
            yellow with cross-hatch                overlap, with its depth
            fading outlines                        where a body was before
            dot, larger dot                        contact point, new contact point
            ring                                   joint
Curves      blue, solid, circle                    PGS (projected Gauss-Seidel)
            blue, dotted, triangle                 accelerated: PGS with momentum
            ochre, dashed, square                  SI (sequential impulses)
            ochre, dash-dot, diamond               block; of its points: block-contact
            ochre, dotted, circle                  wide
            ochre, solid, triangle                 SOR
            plum, dotted, diamond                  Jacobi
            plum, long dashes, square              damped Jacobi
            plum, solid, triangle                  split Jacobi
            green, dash-dot, triangle              Box2D
            text colour, dash-dot-dot, square      newton
            thin, text colour, tick                exact
            grey, any dash and marker              no solver: settings of one, and what is measured
            pale ochre area                        block, in the map of settings
Numbers     heat map, blue to red                  negative to positive; the value stands in the cell
            line of ticks at the bottom            the frames of the sequence; the dot is this one
)";

std::string seen_backend(const fs::path& folder) {
  std::ifstream stream(folder / "run.json");
  const auto record = nlohmann::json::parse(stream, nullptr, false);
  return record.is_object() ? record.value("backend", "") : "";
}

}  // namespace

int doctor(const Context& context) {
  Console console(context.settings);
  const List<Program> programs = built(context.programs);
  console.result(fmt::format("Lessons   {} of {} built", programs.size(), context.programs.size()));
#ifdef CAIRN_HAVE_BOX2D
  console.result("Box2D     built in: the lessons that compare with it run");
#else
  console.result(
      "Box2D     not built in: lessons that need it are skipped; apt-get install libbox2d-dev, build again");
#endif
  if (programs.empty()) {
    console.result("Pictures  no lesson that could draw one: bash lessons/run 1 builds the first");
    return 1;
  }
  std::optional<WorkFolder> folder;
  try {
    folder.emplace(fs::temp_directory_path());
  } catch (const std::exception&) {
    console.result("Pictures  there is no temporary folder that can be written");
    return 1;
  }
  const ProcessResult result = run_quietly(
      {programs.front().path.string(), "--frames", "cover", "-q", "-o", (folder->path / "out").string()});
  const std::string backend = seen_backend(folder->path / "out");
  if (backend.empty()) {
    console.result(fmt::format("Pictures  cannot be drawn (exit code {}):\n{}", result.code, result.output));
    console.result(
        "          apt-get install libosmesa6 or libegl1; every lesson also runs with --frames none");
    return 1;
  }
  console.result("Pictures  can be drawn, through " + backend);
  console.result("Fonts     DejaVu Sans and Sans Mono, inside the programs");
  std::error_code error;
  const auto here = fs::current_path(error);
  console.result(fmt::format("Folder    {}: {}", here.string(),
                             access(here.c_str(), W_OK) == 0 ? "pictures go to out/ in it"
                                                             : "cannot be written; use the flag -o FOLDER"));
  return result.code;
}

int legend(const Context& context) {
  Console console(context.settings);
  console.result(legend_text);
  return 0;
}

}  // namespace cairn::driver
