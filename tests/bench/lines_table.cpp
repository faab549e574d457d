// How much code each solver is, counted in the source tree (paper 4.2).
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include <cairn/math/list.hpp>
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

namespace fs = std::filesystem;

/// What every iterative solver uses, and none is charged for.
const List<std::string> shared_parts = {"solver", "stopping", "row_order"};

/// A file of src/solvers, or of those of its folders that has the iterative solvers.
fs::path solver_file(const std::string& name) {
  const fs::path solvers = fs::path(CAIRN_SOURCE_DIR) / "src" / "solvers";
  return fs::exists(solvers / name) ? solvers / name : solvers / "iterative" / name;
}

/// The lines of a file that are neither blank nor only a comment, without the white space before them. The
/// solvers have no comments of several lines but those with // in each.
List<std::string> code_lines(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cairn_bench: cannot read " + file.string());
  List<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin != std::string::npos && !line.substr(begin).starts_with("//"))
      lines.push_back(line.substr(begin));
  }
  return lines;
}

int code_line_count(const std::string& part) {
  return code_lines(solver_file(part + ".hpp")).size() + code_lines(solver_file(part + ".cpp")).size();
}

/// Adds the parts of src/solvers that `part` includes, and those that they include.
void add_included_parts(const std::string& part, std::set<std::string>& parts) {
  const std::string prefix = "#include \"solvers/";
  for (const std::string ending : {".hpp", ".cpp"}) {
    for (const std::string& line : code_lines(solver_file(part + ending))) {
      if (!line.starts_with(prefix)) continue;
      const fs::path file = line.substr(prefix.size(), line.find(".hpp") - prefix.size());
      const std::string name = file.filename().string();
      const bool shared = std::find(shared_parts.begin(), shared_parts.end(), name) != shared_parts.end();
      if (name != part && !shared && parts.insert(name).second) add_included_parts(name, parts);
    }
  }
}

}  // namespace

void print_lines_table() {
  print_heading("5. Lines of code of each solver");
  fmt::print(
      "Paper 4.2: not much code is needed for either, and exploiting the zeros of A makes PGS harder to\n"
      "maintain. Lines of .hpp and .cpp that are neither blank nor only a comment, counted as this program\n"
      "runs; \"uses\" names parts that not every solver needs, and \"in all\" has their lines too.\n\n");
  TextTable table({{"solver", ""},
                   {".hpp", "lines"},
                   {".cpp", "lines"},
                   {"both", "lines"},
                   {"in all", "lines"},
                   {"uses", ""}});
  for (const std::string solver :
       {"sequential_impulse", "block_sequential_impulse", "jacobi", "accelerated_projected_gauss_seidel",
        "naive_projected_gauss_seidel", "factored_projected_gauss_seidel", "projected_gauss_seidel",
        "sparse_projected_gauss_seidel"}) {
    const int header = code_lines(solver_file(solver + ".hpp")).size();
    const int both = code_line_count(solver);
    std::set<std::string> parts;
    add_included_parts(solver, parts);
    int all = both;
    std::string names;
    for (const std::string& part : parts) {
      all += code_line_count(part);
      names += names.empty() ? part : ", " + part;
    }
    table.add({solver, std::to_string(header), std::to_string(both - header), std::to_string(both),
               std::to_string(all), names.empty() ? "-" : names});
  }
  fmt::print("{}\n", table.text());
  int shared = 0;
  for (const std::string& part : shared_parts) shared += code_line_count(part);
  fmt::print("  Shared by all of them: solver, stopping, row_order, with {} lines.\n", shared);
}

}  // namespace cairn::bench
