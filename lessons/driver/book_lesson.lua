-- The page of a lesson, and what every page of the book is put together from.
local source = PANDOC_SCRIPT_FILE:match("^(.*/)") or ""
local text = dofile(source .. "book_text.lua")
local escaped, filled = text.escaped, text.filled
local parts = { text = text }
local book  -- what the driver has gathered, and what book.lua adds to it

function parts.begin(facts) book = facts end

function parts.read(file)
  local stream = io.open(file, "rb")
  if not stream then return nil end
  local all = stream:read("a")
  stream:close()
  return all
end

function parts.of_the_lessons(file) return parts.read(book.lessons_folder .. "/" .. file) end

function parts.page(page)
  return filled(parts.read(source .. "book.html"), {
    title = escaped(page.title), description = escaped(page.description), scripts = page.scripts or "",
    kind = page.kind, body = page.body, version = book.version,
  })
end

function parts.numbered(lesson) return ("%02d %s"):format(lesson.number, lesson.title) end

function parts.link(lesson, words, relation)
  local rel = relation and " rel=\"" .. relation .. "\"" or ""
  return "<a href=\"" .. lesson.page .. "\"" .. rel .. ">" .. escaped(words or parts.numbered(lesson)) .. "</a>"
end

-- One picture in its themes. One that is lazy is fetched when it is first shown. Of one that is sharp there is another
-- for screens that have more pixels than it where it stands, as wide as the page.
local function layer(lesson, frame, alt, is_lazy, is_sharp)
  local function srcset(theme)
    local file = "frames/" .. frame[theme]
    if not is_sharp then return "srcset=\"" .. file .. "\"" end
    return filled([[srcset="{file} {width}w, {sharp} 1920w" sizes="(max-width: 63rem) 100vw, 61rem"]], {
      file = file, width = lesson.width, sharp = file:gsub("%l+%.png$", "sharp_%0"),
    })
  end
  local dark = frame.dark and "<source media=\"screen and (prefers-color-scheme: dark)\" " .. srcset("dark") .. ">"
  return filled(
    [[<picture>{dark}<img src="frames/{light}" width="{width}" height="{height}" alt="{alt}"{lazy}{more}></picture>]], {
      dark = dark or "", light = frame.light, width = lesson.width, height = lesson.height, alt = escaped(alt),
      lazy = is_lazy and " loading=\"lazy\"" or "", more = is_sharp and " " .. srcset("light") or "",
    })
end

local function frame_of(lesson, number)
  for _, frame in ipairs(lesson.frames) do
    if frame.frame == number then return frame end
  end
end

-- A frame: one picture, or what differs from another one, upon that.
function parts.picture(lesson, frame, is_lazy, is_sharp)
  local top = layer(lesson, frame, frame.alt, is_lazy, is_sharp)
  if frame.base == frame.frame then return top end
  return "<span class=\"layers\">" .. layer(lesson, frame_of(lesson, frame.base), "", is_lazy) .. top .. "</span>"
end

-- The frame that stands for a lesson, or its first; nil where there is none.
function parts.cover_of(lesson)
  local number = lesson.cover < 0 and lesson.frames_in_all + 1 + lesson.cover or lesson.cover
  return frame_of(lesson, number) or lesson.frames[1]
end

function parts.cover_figure(lesson)
  local cover = parts.cover_of(lesson)
  return cover and "<figure class=\"cover\">" .. parts.picture(lesson, cover) .. "</figure>" or ""
end

local frame_title = [[<a href="#frame-{number}">Frame {number} of {all}</a>{state}]]
local frame_item = [[<li id="frame-{number}"{class}><figure>{picture}
<figcaption>
<p>{title}</p>
<details><summary>What it shows</summary><p>{words}</p></details>
</figcaption></figure></li>
]]
local player_frame = [[<section class="player" aria-label="Frames">
<ol class="frames">
{items}</ol>
<div class="controls" hidden>
<button type="button" class="previous" aria-label="Previous frame">◀&#xFE0E;</button>
<button type="button" class="play">Play</button>
<button type="button" class="next" aria-label="Next frame">▶&#xFE0E;</button>
<input type="range" min="0" max="{last}" value="0" step="1" aria-label="Frame">
<button type="button" class="enlarge" aria-label="Frames in full size" aria-pressed="false">1:1</button>
<button type="button" class="full" aria-label="Full screen">
<svg viewbox="0 0 16 16" aria-hidden="true"><path d="M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4"></path></svg></button>
</div>
<div class="caption" hidden></div>
<p class="spoken" aria-live="polite"></p>
{note}</section>
]]
local others_note = [[<p class="note">{shown} of {all} frames; <code>bash lessons/run {number} --frames all</code> draws
the others too.</p>
]]

local function title_of(lesson, frame)
  return filled(frame_title, {
    number = frame.frame, all = lesson.frames_in_all,
    state = frame.state ~= "" and " · " .. text.prose(frame.state) or "",
  })
end

-- What a line <!-- frame: 5 --> of a lesson's text stands for: that frame, where the text speaks of it.
local function frame_beside(lesson, number)
  if number > lesson.frames_in_all then
    error(("%s: <!-- frame: %d -->, and it has %d frames"):format(lesson.folder, number, lesson.frames_in_all))
  end
  local frame = frame_of(lesson, number)
  return frame and filled([[<figure class="beside">{picture}<figcaption>{title}</figcaption></figure>]], {
    picture = parts.picture(lesson, frame, true, frame.is_sharp), title = title_of(lesson, frame),
  }) or ""
end

local function player(lesson)
  local shown, all = #lesson.frames, lesson.frames_in_all
  if shown == 0 then return "" end
  local items = ""
  for _, frame in ipairs(lesson.frames) do
    items = items .. filled(frame_item, {
      number = frame.frame, picture = parts.picture(lesson, frame, true), words = (text.prose(frame.alt)),
      title = title_of(lesson, frame), class = frame.key and " class=\"key\"" or "",
    })
  end
  local note = shown < all and filled(others_note, { shown = shown, all = all, number = lesson.number }) or ""
  return filled(player_frame, { items = items, last = shown - 1, note = note })
end

local stage_note = [[<p class="note">This lesson is also a stage of <a href="your_solver.html">a solver of your own</a>:
<code>bash lessons/run solver {number}</code></p>
]]

local function exercise(lesson)
  local file = lesson.folder .. "/exercise.cpp"
  local code = parts.of_the_lessons(file)
  local figure = code and text.figure("exercise.cpp", "<code>lessons/" .. file .. "</code>", text.code(code, "cpp"))
  return (figure or "") .. (lesson.has_stage and filled(stage_note, { number = lesson.number }) or "")
end

local function console(lesson)
  local caption = "What <code>bash lessons/run " .. lesson.number .. "</code> prints"
  return text.figure("output", caption, text.code(lesson.console))
end

-- Puts something behind the heading of a section or at its end, or, where there is no such section, at the end of
-- the page under a title of its own.
local function with_addition(html, section, title, addition, is_first)
  if addition == "" then return html end
  local heading = html:find("<h2 id=\"" .. text.anchor_of(section) .. "\">", 1, true)
  if not heading then return html .. "<h2 id=\"" .. text.anchor_of(title) .. "\">" .. title .. "</h2>\n" .. addition end
  local _, behind = html:find("</h2>", heading, true)
  local at = is_first and behind or (html:find("<h2", behind, true) or #html + 1) - 1
  return html:sub(1, at) .. "\n" .. addition .. html:sub(at + 1)
end

-- Puts what the reader does with the playground, a section or a paragraph of that name, where a line
-- <!-- in your hand --> says that one can press along.
local function with_hand(html)
  local from, behind = html:match("()<h2 id=\"in%-your%-hand\">.-()<h2")
  if not from then from, behind = html:match("()<p><strong>In your hand%.</strong>.-()<h2") end
  local mark = "<!-- in your hand -->"
  local at = html:find(mark, 1, true)
  if not at then return html end
  if not from then return html:sub(1, at - 1) .. html:sub(at + #mark) end
  return html:sub(1, at - 1) .. html:sub(from, behind - 1) .. html:sub(at + #mark, from - 1) .. html:sub(behind)
end

local fold_begin = [[<form class="guess" hidden data-answer="{answer}">
<label>Your guess <input name="guess" autocomplete="off" aria-describedby="verdict"></label>
<button>Go on</button>
<p class="verdict" id="verdict" role="status"></p>
</form>
<details class="fold"><summary>Go on to the answer</summary>
<nav class="sections" aria-label="On this page">
<ul>
{links}</ul>
</nav>
]]

-- Closes everything behind the question. What is there is listed there: headings tell, too.
local function folded(html, answer)
  local asked, behind = html:match("^(.-)<!%-%- fold %-%->(.*)$")
  if not asked then return html end
  local links = ""
  for anchor, title in behind:gmatch("<h2 id=\"([^\"]*)\">(.-)</h2>") do
    links = links .. "<li><a href=\"#" .. anchor .. "\">" .. escaped(text.without_tags(title)) .. "</a></li>\n"
  end
  return asked .. filled(fold_begin, { links = links, answer = escaped(answer) }) .. behind .. "</details>\n"
end

function parts.places(more)
  local result = { files = {}, has_playground = book.has_playground, is_for_print = book.is_for_print }
  for _, name in ipairs({ "pages", "symbols", "terms" }) do result[name] = book[name] end
  for name, value in pairs(more or {}) do result[name] = value end
  return result
end

-- The inside of a lesson's page, its answer folded.
function parts.lesson_body(lesson)
  local markdown = parts.of_the_lessons(lesson.folder .. "/README.md") or "# " .. parts.numbered(lesson)
  local html = text.html(markdown, parts.places({
    cover = parts.cover_figure(lesson), files = { ["exercise.cpp"] = "#exercise.cpp" },
    frame = function(number) return lesson.frames_in_all and frame_beside(lesson, number) or "" end,
  }))
  html = "<p class=\"kicker\">" .. escaped(lesson.paper) .. "</p>\n" ..
    html:gsub("</h1>", function(tag) return tag .. "\n<p class=\"idea\">" .. text.prose(lesson.idea) .. "</p>" end, 1)
  html = with_addition(with_hand(html), "What to look at", "The frames", player(lesson), true)
  html = with_addition(html, "Run it", "What it prints", console(lesson))
  html = with_addition(html, "Your turn", "The exercise", exercise(lesson))
  return folded(html, lesson.answer or "{}")
end

function parts.teaching_page(lesson) return ("teaching%02d.html"):format(lesson.number) end

-- The lessons before and behind this one.
function parts.turning(i)
  local before, lesson, behind = book.lessons[i - 1], book.lessons[i], book.lessons[i + 1]
  return "<nav class=\"turn\" aria-label=\"Lessons\">\n" ..
    (before and parts.link(before, "← " .. parts.numbered(before), "prev") .. "\n" or "") ..
    "<a href=\"index.html\">All lessons</a>\n" ..
    (lesson.teaching and "<a href=\"" .. parts.teaching_page(lesson) .. "\">For teachers</a>\n" or "") ..
    (behind and parts.link(behind, parts.numbered(behind) .. " →", "next") .. "\n" or "") .. "</nav>\n"
end

return parts
