// The tower and its loads, sweep by sweep under three solvers; the question, and the answer.
#include "lesson.hpp"

namespace cairn::cost {

namespace {

constexpr double least_asked = 1e-9;  // of the error
const FixedList<int, 8> shown = {1, 2, 5, 10, 20, 50, 100, 200};

const List<double>& lambda_after(const Curve& curve, int sweep) {
  return curve.lambda[std::min(sweep, curve.lambda.size() - 1)];
}

double error_after(const Curve& curve, int sweep) {
  return curve.error[std::min(sweep, curve.error.size() - 1)];
}

std::string error_text(double error) {
  if (error <= least_error) return "< 10^{−12}";
  if (error <= 5e-4) return significant(error, 2);
  return fmt::format("{:g} %", error > 0.05 ? std::round(100 * error) : std::round(1000 * error) / 10);
}

/// SI and SOR have one colour: panels of SOR are pale.
SeriesStyle panel_style(const Page& page, int which) {
  SeriesStyle style = style_of(page, which);
  if (which == sor_curve) style.color = render::faded(style.color, 0.4);
  return style;
}

/// The tower; beside each box what a solver gives it after so many sweeps, and a tick at what it should be.
void draw_tower(Page& page, const Rect& inside, const CostRun& run, int which, int sweep) {
  draw_tower_loads(page, inside, run.tower, lambda_after(run.curves[which], sweep),
                   {.box_weight = gravity,
                    .largest = 1.05 * exact_lambda(run.settings.boxes)[0],
                    .color = panel_style(page, which).color});
}

/// A solver's loads, and its error in large type where the bars are short.
void draw_loads(Page& page, const Rect& rect, const CostRun& run, int which, int sweep,
                const std::string& number = "") {
  const Rect inside = draw_solver_panel(page, rect, panel_style(page, which), short_name(run, which), number);
  draw_tower(page, inside, run, which, sweep);
  TextStyle text = page.value();
  text.size = page.sizes().question;
  text.bold = true;
  text.align = Align::right;
  page.canvas().text({inside.x + inside.width, inside.y + text.size},
                     error_text(error_after(run.curves[which], sweep)), text);
}

Series series_of(const Page& page, const CostRun& run, int which, int sweeps) {
  const List<double>& error = run.curves[which].error;
  List<double> shown_errors;
  for (int k = 0; k <= sweeps && k < error.size(); ++k)
    shown_errors.push_back(std::max(error[k], least_error));
  return over_steps(short_name(run, which), style_of(page, which), shown_errors);
}

Plot error_plot(double last_sweep, AxisScale scale, double least) {
  const bool is_linear = scale == AxisScale::linear;
  return {.title = "error: of the load that is most wrong, over the largest load; on a logarithmic axis",
          .x = {.title = "sweep", .min = 0, .max = last_sweep},
          .y = {.title = "", .scale = scale, .min = least, .max = is_linear ? 1.05 : 2}};
}

void draw_sweep(Page& page, const CostRun& run, int sweep) {
  const List<Rect> parts = in_rows(page, {0.54, 0.46});
  const List<Rect> panels = in_columns(page, parts[0], {1, 1, 1});
  Plot plot = error_plot(kept_sweeps, AxisScale::logarithmic, 1e-6);
  for (int which = 0; which < watched_curves; ++which) {
    draw_loads(page, panels[which], run, which, sweep);
    plot.series.push_back(series_of(page, run, which, kept_sweeps));
  }
  plot.goals.push_back({0.01, "1 %"});
  plot.now = sweep;
  draw_plot(page, parts[1], plot);
}

Shot sweep_shot(const CostRun& run, int sweep, bool key) {
  std::string alt = fmt::format("After {} sweeps the largest error is", sweep);
  for (int which = 0; which < watched_curves; ++which)
    alt += fmt::format(" {:.2g} with {},", error_after(run.curves[which], sweep), run.curves[which].name);
  alt.back() = '.';
  return {.state = fmt::format("sweep {} · ticks: exact loads", sweep),
          .alt = alt,
          .draw = [&run, sweep](Page& page) { draw_sweep(page, run, sweep); },
          .key = key};
}

std::string point_text(int sweep, const std::string& error) { return fmt::format("{}: {}", sweep, error); }

/// The tower three times, with SI's loads after ten sweeps, and where 10 % and 1 % of the error are left.
void draw_question(Page& page, const Rect& rect, const CostRun& run) {
  const List<Rect> parts = in_columns(page, rect, {1, 1, 1});
  const List<double>& error = run.curves[si_curve].error;
  const FixedList<int, 3> sweeps = {10, sweeps_to(error, 0.1), sweeps_to(error, 0.01)};
  for (int i = 0; i < sweeps.size(); ++i)
    draw_loads(page, parts[i], run, si_curve, sweeps[i], fmt::format("{} sweeps", sweeps[i]));
}

/// The errors of SI and SOR until a billionth is left, and a stair of which each step is one digit of SI.
void draw_answer(Page& page, const Rect& rect, const CostRun& run) {
  const List<double>& error = run.curves[si_curve].error;
  Plot plot = error_plot(1.15 * sweeps_to(error, least_asked), AxisScale::logarithmic, least_asked / 2);
  Series stair{.style = page.theme().exact, .markers = false};
  double before = 0, share = 1;
  for (int digit = 1; digit <= 9; ++digit) {
    const double sweep = sweeps_to(error, std::pow(10, -digit));
    stair.x.insert(stair.x.end(), {before, sweep, sweep});
    stair.y.insert(stair.y.end(), {share, share, share / 10});
    if (digit > 2 && digit < 9)
      plot.labels.push_back({sweep, share / 3, fmt::format("+{:g}", sweep - before)});
    share /= 10;
    if (digit <= 2) {
      const std::string name = digit == 1 ? "SI, " : "";
      plot.labels.push_back(
          {sweep, share, name + point_text(static_cast<int>(sweep), fixed(100 * share, 0) + " %")});
    }
    if (digit == 9) plot.labels.push_back({sweep, share, point_text(static_cast<int>(sweep), "10^{−9}")});
    before = sweep;
  }
  plot.series = {series_of(page, run, si_curve, static_cast<int>(before)), stair,
                 series_of(page, run, sor_curve, sweeps_to(run.curves[sor_curve].error, least_asked))};
  for (const int which : {0, 2}) plot.series[which].name.clear();  // labels name them
  const List<double>& fast = run.curves[sor_curve].error;
  for (const double left : {0.01, least_asked}) {
    const int sweep = sweeps_to(fast, left);
    plot.labels.push_back(
        {static_cast<double>(sweep), left,
         left > least_asked ? "SOR, " + point_text(sweep, "1 %") : point_text(sweep, "10^{−9}")});
  }
  plot.title = "error, on a logarithmic axis; every step down is one digit";
  draw_plot(page, rect, plot);
}

std::string answer_text(const CostRun& run) {
  const Curve &si = run.curves[si_curve], &sor = run.curves[sor_curve];
  return fmt::format(
      "{} sweeps. A sweep of SI leaves {} of the error, however small it is, so every digit costs {} sweeps. "
      "With the best ω it is about {}, as two errors fall together.",
      sweeps_to(sor.error, 0.01), fixed(si.rate, 4), fixed(sweeps_per_digit(si), 0),
      fixed((sweeps_to(sor.error, 1e-6) - sweeps_to(sor.error, 1e-2)) / 4.0, 0));
}

}  // namespace

SeriesStyle style_of(const Page& page, int curve) {
  if (curve == si_curve) return page.theme().si;
  if (curve == jacobi_curve) return page.theme().jacobi;
  return render::style_of_solver(page.theme(), curve == sor_curve ? "sor" : "accelerated");
}

std::string short_name(const CostRun& run, int curve) {
  if (curve == jacobi_curve) return "Jacobi, ω = ½";
  if (curve == sor_curve) return fmt::format("SOR, ω = {}", fixed(run.omega, 2));
  return curve == si_curve ? "SI" : "momentum";
}

List<Shot> cost_shots(const CostRun& run) {
  const int hundredth = sweeps_to(run.curves[si_curve].error, 0.01);
  List<Shot> shots;
  shots.push_back(question_shot(
      card(), {.state = "until 1 % is left · ticks: exact loads",
               .alt = fmt::format(
                   "A tower of {} boxes three times, with the loads that SI has found after 10, {} and "
                   "{} sweeps, and the question",
                   run.settings.boxes, sweeps_to(run.curves[si_curve].error, 0.1), hundredth),
               .scene = [&run](Page& page, const Rect& rect) { draw_question(page, rect, run); }}));
  for (const int sweep : shown)
    shots.push_back(sweep_shot(run, sweep, sweep == 1 || sweep == 10 || sweep == 50 || sweep == 200));
  shots.push_back(work_shot(run));
  shots.push_back(
      answer_shot(card(),
                  {.state = "answer",
                   .alt = "The errors of SI and of SOR until a billionth is left, two lines on a logarithmic "
                          "axis, that of SOR twelve times as steep; and the answer.",
                   .scene = [&run](Page& page, const Rect& rect) { draw_answer(page, rect, run); }},
                  answer_text(run)));
  return shots;
}

}  // namespace cairn::cost
