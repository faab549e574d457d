// Text that fits a window: prose is wrapped, and tables are set anew, column by column.
#pragma once

#include <string>
#include <string_view>

namespace cairn {

/// A width that every line fits.
inline constexpr int unlimited = 1 << 20;

/// Whether a line has cells: words with two blanks or more between them.
bool has_cells(std::string_view line);

/// The lines of `text`, each at most `width` columns wide. Lines that fit stay as they are. Prose is wrapped
/// below its first word. Neighbouring lines with cells are a table: it gets narrower gaps; then its last
/// column is wrapped if that is prose; else the table is cut into several, each with the first column. With
/// `plain` the text is in ASCII, and cells still stand below their heads.
std::string fitted(std::string_view text, int width, bool plain = false);

/// A line in two parts, the second at the right edge, or below the first.
std::string spread(const std::string& left, const std::string& right, int width);

/// A command on as many lines as it needs; the shell reads them as one.
std::string folded_command(const std::string& command, int width);

}  // namespace cairn
