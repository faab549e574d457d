// JSON and CSV texts of a run.
#include "lessons/kit/records.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "lessons/kit/words.hpp"
#include <cairn/math/check.hpp>

namespace cairn {
namespace {

using Json = nlohmann::ordered_json;

Json flags_json(const LessonInfo& info, const Options& options) {
  Json flags = Json::object();
  for (const Parameter& parameter : info.parameters) {
    const double value = options.numbers.at(parameter.flag);
    flags[parameter.flag] = value;
    if (parameter.kind == Parameter::Kind::whole) flags[parameter.flag] = static_cast<long long>(value);
  }
  for (const Choice& choice : info.choices) flags[choice.flag] = options.choices.at(choice.flag);
  return flags;
}

Json array_of(const List<double>& numbers) {
  Json array = Json::array();
  for (const double number : numbers) array.push_back(number);
  return array;
}

/// With the wrong guesses that are known, so that a page judges a guess as the lesson does.
Json answer_json(const LessonInfo& info, const AnswerRecord& answer) {
  Json wrong = Json::array();
  for (const WrongGuess& guess : info.wrong)
    wrong.push_back({{"least", array_of(guess.least)}, {"most", array_of(guess.most)}, {"why", guess.why}});
  return {{"right", array_of(answer.right)},
          {"tolerance", answer.tolerance},
          {"explanation", answer.explanation},
          {"wrong", wrong}};
}

}  // namespace

std::string json_of(const CsvTable& table) {
  Json rows = Json::array();
  for (const List<CsvCell>& row : table.rows) {
    require(row.size() == table.header.size(), "json_of", "row", "as long as the header",
            static_cast<double>(row.size()));
    Json object = Json::object();
    for (int i = 0; i < row.size(); ++i) {
      std::visit([&](const auto& value) { object[table.header[i]] = value; }, row[i]);
    }
    rows.push_back(std::move(object));
  }
  return rows.dump(1) + "\n";
}

std::string csv_of(const CsvTable& table) {
  std::ostringstream stream;
  write_csv(stream, table);
  return stream.str();
}

std::string run_json(const LessonInfo& info, const Options& options, const RunRecord& record) {
  Json claims = Json::array();
  for (const Claim& claim : record.claims) {
    claims.push_back(
        {{"claim", claim.text}, {"value", claim.value}, {"shown", claim.shown}, {"holds", claim.holds}});
  }
  const Json run = {{"lesson", info.number},
                    {"title", info.title},
                    {"command", command_line(info, options)},
                    {"flags", flags_json(info, options)},
                    {"width", options.width},
                    {"height", options.height},
                    {"pictures", record.film.pictures},
                    {"backend", record.film.backend},
                    {"claims", claims},
                    {"answer", answer_json(info, record.answer)},
                    {"state", record.fingerprint}};
  return run.dump(2) + "\n";
}

std::string command_line(const LessonInfo& info, const Options& options) {
  List<std::string> words = {typed_command(info)};
  for (const Parameter& parameter : info.parameters) {
    words.push_back("--" + parameter.flag + " " + shortest(options.numbers.at(parameter.flag)));
  }
  for (const Choice& choice : info.choices) {
    words.push_back("--" + choice.flag + " " + shell_quoted(options.choices.at(choice.flag)));
  }
  words.insert(words.end(), options.picture_flags.begin(), options.picture_flags.end());
  return joined(words, " ");
}

}  // namespace cairn
