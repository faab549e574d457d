// Runs a lesson: narration, claims, pictures, data, and the exit code that sums it all up.
#include "lessons/kit/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <optional>
#include <utility>

#include "lessons/kit/arguments.hpp"
#include "lessons/kit/claims.hpp"
#include "lessons/kit/console.hpp"
#include "lessons/kit/ending.hpp"
#include "lessons/kit/film.hpp"
#include "lessons/kit/fitting.hpp"
#include "lessons/kit/frame_page.hpp"
#include "lessons/kit/help.hpp"
#include "lessons/kit/output.hpp"
#include "lessons/kit/records.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/check.hpp>
#include <cairn/math/printable.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/measure/whole_file.hpp>

namespace cairn {

struct Lesson::State {
  const LessonInfo& info;
  Options options;
  Console console;
  std::optional<List<double>> guess = {};
  bool is_wrong = false;  // the answer that was given with --answer
  bool was_filmed = false;
  bool has_theory_to_tell = false;  // held back until the reader has guessed
  RunRecord record = {};
  std::optional<CsvTable> table = {};

  void claim(Claim claim);
  void print_title();
  void print_theory();
  void print_end();
  void write_files();
  int exit_code() const;
  /// Whether the reader is asked for a guess, and waited for.
  bool asks() const;
  /// Whether each claim has a line of its own, or only those that fail.
  bool shows_claims() const;
};

static int page_width(const Console& console) { return std::min(104, console.width()); }

bool Lesson::State::asks() const {
  const bool sees = is_terminal(stdin) && is_terminal(options.console.narrates_on_stderr ? stderr : stdout);
  return options.predict || (sees && !options.console.quiet && !options.answer);
}

bool Lesson::State::shows_claims() const {
  return options.checks || options.check || options.console.quiet || options.console.verbose;
}

void Lesson::State::claim(Claim claim) {
  record.claims.push_back(claim);
  if (claim.holds && !shows_claims()) return;
  const std::string verdict = claim.holds ? console.colored("ok", Console::Color::good)
                                          : console.colored("FAILED", Console::Color::bad);
  Claim spelt = claim;
  spelt.text = console.spelt(claim.text);
  spelt.shown = console.spelt(with_minus_signs(claim.shown));
  console.result(claim_line(spelt, console.width()) + verdict);
  if (!claim.holds && !claim.demand.empty()) {
    console.result("       must be " + claim.demand + ", is " + shortest(claim.value));
  }
}

void Lesson::State::print_title() {
  const std::string title = fmt::format("Lesson {}  {}", two_digits(info.number), info.title);
  const int width = page_width(console);
  console.narrate(spread(console.spelt(title), console.spelt(info.paper), width), Console::Color::bold);
  if (options.check) return;
  has_theory_to_tell = true;
  if (!asks() || info.question.empty()) print_theory();
}

void Lesson::State::print_theory() {
  if (!std::exchange(has_theory_to_tell, false)) return;
  console.narrate(wrapped("Idea: " + info.idea, page_width(console), 6));
  for (const std::string& equation : info.equations) console.narrate("  " + equation);
}

void Lesson::State::print_end() {
  if (options.check || (!shows_claims() && !record.claims.empty())) {
    console.narrate(fmt::format("{} of {} checks held{}", holding(record.claims), record.claims.size(),
                                options.check ? "" : "   (--checks shows them)"));
  }
  if (options.check) return;
  if (record.film.pictures > 0) {
    console.narrate(fmt::format("{} picture{}: {}", record.film.pictures,
                                record.film.pictures == 1 ? "" : "s",
                                (options.out / "index.html").lexically_normal().string()));
  }
  const std::string again = "Again: " + command_line(info, options);
  const bool is_folded = console.width() < unlimited;
  const std::string state = record.fingerprint.empty() ? "" : (is_folded ? "\n       state " : "     state ");
  console.narrate(folded_command(again, console.width()) + state + record.fingerprint);
  if (!info.next.empty()) console.narrate("Next:  " + info.next);
}

void Lesson::State::write_files() {
  const bool may_write = !options.dry_run && !options.check;
  if (may_write && record.film.pictures > 0) {
    write_whole_file(options.out / "index.html", frame_page(info, record.film.index));
    if (table) write_whole_file(options.out / "rows.csv", csv_of(*table));
    write_whole_file(options.out / "run.json", run_json(info, options, record));
  }
  const auto deliver = [&](const std::string& place, const std::string& text) {
    if (place == "-") {
      std::cout << text << std::flush;
      if (!std::cout) throw WriteError("cannot write the data to stdout");
    } else if (!place.empty() && may_write) {
      write_whole_file(place, text);
    }
  };
  if (!table && (!options.csv.empty() || !options.json.empty()))
    console.warn(short_name(info) + ": has no data");
  if (!table) return;
  if (!options.csv.empty()) deliver(options.csv, csv_of(*table));
  if (!options.json.empty()) deliver(options.json, json_of(*table));
}

int Lesson::State::exit_code() const {
  const bool all_hold = holding(record.claims) == record.claims.size();
  return all_hold && !is_wrong ? 0 : 1;
}

Lesson::Lesson(std::unique_ptr<State> state) : state_(std::move(state)) {}
Lesson::~Lesson() = default;

double Lesson::real(std::string_view flag) const {
  const auto found = state_->options.numbers.find(flag);
  if (found == state_->options.numbers.end()) throw std::logic_error("no parameter --" + std::string(flag));
  return found->second;
}

int Lesson::whole(std::string_view flag) const { return static_cast<int>(std::lround(real(flag))); }

const std::string& Lesson::choice(std::string_view flag) const {
  const auto found = state_->options.choices.find(flag);
  if (found == state_->options.choices.end()) throw std::logic_error("no choice --" + std::string(flag));
  return found->second;
}

void Lesson::print(std::string_view line) {
  if (state_->options.check) return;
  state_->console.narrate(with_minus_signs(line));
  if (state_->options.step && !line.empty()) state_->console.wait();
}

void Lesson::detail(std::string_view line) {
  if (state_->options.console.verbose) print(line);
}

void Lesson::predict() {
  const Options& options = state_->options;
  if (options.check || state_->info.question.empty()) return;
  const bool asks = state_->asks();
  const std::string hint = asks ? "" : "   (--answer V to be checked)";
  state_->console.narrate(wrapped("PREDICT  " + state_->info.question + hint, page_width(state_->console), 9),
                          Console::Color::bold);
  state_->guess = options.answer;
  bool waits = asks && !options.answer;
  while (waits) {
    state_->console.ask("Your guess (numbers between commas; Enter to see): ");
    std::string line;
    if (!std::getline(std::cin, line) || line.empty()) break;
    state_->guess = parse_numbers(line);
    waits = !state_->guess;
    if (waits)
      state_->console.narrate("That is no number: a comma stands between numbers, a point before decimals.");
  }
  state_->print_theory();
}

void Lesson::answer(const List<double>& right, double tolerance, std::string_view explanation) {
  const Options& options = state_->options;
  const bool is_asked = !state_->info.question.empty();
  if (options.answer) state_->guess = options.answer;
  if (is_asked) state_->record.answer = {right, tolerance, std::string(explanation)};
  const std::string told = numbers_text(right) + ". " + std::string(explanation);
  Console& console = state_->console;
  const int width = page_width(console);
  if (!state_->guess) return is_asked ? print(wrapped("ANSWER   " + told, width, 9)) : void();
  const List<double>& guess = *state_->guess;
  const Judgement verdict =
      judged(guess, right, tolerance, is_asked ? state_->info.wrong : List<WrongGuess>());
  console.result(console.spelt(wrapped(verdict.words + told, width, 9)));
  // A guess at the prompt is free; an answer on the command line wants a verdict.
  if (options.answer && !verdict.is_right) state_->is_wrong = true;
}

void Lesson::check_small(std::string_view claim, double value, double limit) {
  state_->claim(small_claim(claim, value, limit));
}

void Lesson::check_equal(std::string_view claim, double value, double expected, double tolerance) {
  state_->claim(equal_claim(claim, value, expected, tolerance));
}

void Lesson::check_that(std::string_view claim, bool holds, std::string_view shown) {
  state_->claim(plain_claim(claim, holds, shown));
}

bool Lesson::draws() const { return state_->options.frames.kind != FrameChoice::Kind::none; }

void Lesson::film(const List<Shot>& shots) {
  if (std::exchange(state_->was_filmed, true)) throw std::logic_error("a lesson has one film");
  if (!draws()) return;
  FilmReport& report = state_->record.film;
  report = draw_film(state_->info, state_->options, shots, state_->console);
  for (const std::string& finding : report.findings) {
    if (state_->options.console.verbose) state_->console.warn(finding);
  }
  if (report.findings.empty()) return;
  check_that("layout: nothing overlaps, is cut off or too pale (-v tells where)", false,
             std::to_string(report.findings.size()));
}

void Lesson::data(const CsvTable& table) {
  if (state_->table) throw std::logic_error("a lesson has one table of data");
  state_->table = table;
}

void Lesson::fingerprint(const Snapshot& final_state) {
  state_->record.fingerprint = hexadecimal(fingerprint_of(final_state));
}

void Lesson::fingerprint(const List<double>& numbers) {
  state_->record.fingerprint = hexadecimal(fingerprint_of(numbers));
}

int run_lesson(const LessonInfo& info, const std::function<void(Lesson&)>& lesson, int argc, char** argv) {
  try {
    Options options = read_arguments(info, argc, argv);
    if (options.request != Options::Request::run) {
      const std::string text = text_asked_for(info, options);
      const bool is_data = options.request == Options::Request::list_params;
      const int width = is_data ? unlimited : width_of_stream(stdout);
      std::cout << fitted(text, width, options.console.plain) << std::flush;
      return finished(info, 0);
    }
    const bool can_pause = is_terminal(stdin);
    if (options.step && !can_pause) {
      complain(short_name(info), 0, "--step needs a terminal; going on without pauses");
    }
    options.step = options.step && can_pause;
    const LessonInfo told = card_for(info, options);
    Console console(options.console);
    Lesson run(std::make_unique<Lesson::State>(Lesson::State{told, std::move(options), std::move(console)}));
    Lesson::State& state = *run.state_;
    state.print_title();
    if (state.options.step) state.console.narrate("Enter goes on.");
    lesson(run);
    if (!state.options.expect.empty()) {
      run.check_that("the state is " + state.options.expect + ", as expected",
                     state.record.fingerprint == state.options.expect, state.record.fingerprint);
    }
    state.print_end();
    state.console.flush();
    state.write_files();
    return finished(info, state.exit_code());
  } catch (...) {
    return explain_failure(short_name(info));
  }
}

}  // namespace cairn
