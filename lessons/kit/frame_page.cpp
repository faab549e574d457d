// A page without anything from elsewhere: what it says is in it, and its pictures lie beside it.
#include "lessons/kit/frame_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "lessons/kit/arguments.hpp"

namespace cairn {
namespace {

constexpr const char* page_begin = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
)";

constexpr const char* page_style = R"(<style>
:root { color-scheme: light dark; --paper: #fff; --ink: #1a1f26; --soft: #5a6472; --line: #c9d0d8; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #14181d; --ink: #e4e8ed; --soft: #a3adb9; --line: #3a434e; }
}
body { margin: 0 auto; max-width: 1280px; padding: 1rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 "DejaVu Sans", system-ui, sans-serif; }
h1 { font-size: 1.4rem; margin: 0; }
p { margin: .2rem 0 1rem; }
figure { margin: 0 0 2rem; }
img { display: block; width: 100%; height: auto; border: 1px solid var(--line); box-sizing: border-box; }
figcaption { margin-top: .5rem; max-width: 75ch; }
figcaption b { display: block; }
nav { display: flex; flex-wrap: wrap; gap: .75rem; align-items: center; margin-bottom: .75rem; }
nav[hidden], figure[hidden] { display: none; }
nav input { flex: 1 1 12rem; min-width: 8rem; }
button { font: inherit; padding: .3rem .9rem; }
.soft { color: var(--soft); }
</style>
)";

constexpr const char* page_end = R"(<script>
const frames = [...document.querySelectorAll("figure")];
const slider = document.querySelector("input"), count = document.querySelector("output");
let at = 0;
const show = (index) => {
  at = Math.max(0, Math.min(frames.length - 1, index));
  frames.forEach((frame, i) => { frame.hidden = i !== at; });
  slider.value = at;
  count.textContent = `${at + 1} of ${frames.length}`;
  slider.setAttribute("aria-valuetext", count.textContent);
  history.replaceState(null, "", "#" + frames[at].id);
};
const steps = { ArrowLeft: -1, ArrowRight: 1, Home: -Infinity, End: Infinity };
addEventListener("keydown", (event) => {
  if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  show(at + steps[event.key]);
});
slider.addEventListener("input", () => show(Number(slider.value)));
document.querySelectorAll("button").forEach((button) => {
  button.addEventListener("click", () => show(at + Number(button.value)));
});
if (frames.length > 1) {
  document.querySelector("nav").hidden = false;
  show(frames.findIndex((frame) => "#" + frame.id === location.hash));
}
</script>
</html>
)";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

}  // namespace

std::string frame_page(const LessonInfo& info, const std::string& index) {
  const auto frames = nlohmann::json::parse(index).at("frames");
  std::string figures;
  std::set<std::string> shown;  // a film is one file of many frames
  for (const auto& frame : frames) {
    const std::string file = frame.at("file"), state = frame.at("state"), alt = frame.at("alt");
    const int number = frame.at("frame");
    if (!shown.insert(file).second) continue;
    figures += fmt::format(R"(<figure id="frame-{}">
<img src="{}" alt="Frame {}">
<figcaption><b>{}</b> {}</figcaption>
</figure>
)",
                           number, escaped(file), number, escaped(state), escaped(alt));
  }
  const std::string title = fmt::format("Lesson {}: {}", two_digits(info.number), escaped(info.title));
  return page_begin + fmt::format("<title>{}</title>\n", title) + page_style +
         fmt::format(R"(<h1>{}</h1>
<p>{}</p>
<nav hidden aria-label="Frames">
<button type="button" value="-1">Back</button>
<button type="button" value="1">Next</button>
<input type="range" min="0" max="{}" value="0" aria-label="Frame">
<output></output> <span class="soft">arrow keys step</span>
</nav>
<main>
{}</main>
)",
                     title, escaped(info.idea), shown.size() - 1, figures) +
         page_end;
}

}  // namespace cairn
