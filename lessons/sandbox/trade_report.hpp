// What a finished study of work against error is told as: files, tables, a chart.
#pragma once

#include <filesystem>
#include <string>

#include "lessons/sandbox/trade_study.hpp"
#include "lessons/sandbox/verb.hpp"
#include "measure/csv.hpp"
#include "render/theme.hpp"

namespace cairn::sandbox {

/// The table that a journal holds; `name` is for messages. @throws std::invalid_argument.
CsvTable table_of(const std::string& csv, const std::string& name);

/// What --theme says. @throws UsageError.
render::Theme theme_of(const Words& words);

/// Writes the table as CSV and JSON, draws what there is to draw, prints. The exit code: check_failed when no
/// setting came to a number.
int report_trade(const Words& words, const TradeStudy& trade, const std::string& csv,
                 const std::filesystem::path& folder, Console& console);

}  // namespace cairn::sandbox
