-- Makes the pages of the lesson book, within pandoc, of what the driver has gathered:
--   pandoc --from gfm --to plain --lua-filter book.lua --metadata facts=FACTS.lua --output /dev/null /dev/null
-- FACTS.lua returns what book_making.cpp knows of the lessons beside their texts.
local source = PANDOC_SCRIPT_FILE:match("^(.*/)") or ""
local parts = dofile(source .. "book_lesson.lua")
local text = parts.text
local escaped = text.escaped
local book

local function write(name, all)
  local stream = assert(io.open(book.folder .. "/" .. name, "wb"))
  assert(stream:write(all))
  assert(stream:close())
end

local function text_page(title, body)
  return parts.page({
    title = title .. " · Cairn", description = title .. " of the lesson book.", kind = "reference", body = body,
  })
end

local function document_page(title, markdown) return text_page(title, text.html(markdown, parts.places())) end

-- The terms of the glossary: "- **term**: what it means".
local function terms_of(glossary)
  local terms = {}
  for name, meaning in glossary:gsub("\n  ", " "):gmatch("\n%- %*%*(.-)%*%*: ([^\n]*)") do
    local words = text.without_tags(text.inline(meaning, parts.places()))
    table.insert(terms, { name = name, anchor = text.anchor_of(name), meaning = words })
  end
  return terms
end

-- Which row of the table of symbols explains a symbol: "| v (1), (16) |" has v in its first cell.
local function symbols_of(notation)
  local symbols, row = {}, -1  -- the head
  for cell in notation:gmatch("\n| ([^|]*) |") do
    for part in (cell .. ", "):gmatch("(.-), ") do
      local two = part:match("^Δ[%a\xCE\xCF][\x80-\xBF]?")
      local symbol = two or part:match("^[\xCE\xCF][\x80-\xBF]") or part:match("^%a%f[^%w]")
      if row >= 0 and symbol and not symbols[symbol] then symbols[symbol] = "notation.html#symbol-" .. row end
    end
    row = row + 1
  end
  return symbols
end

-- Where the lessons show each item of the paper: in a frame, and where their text has the formula.
local function equation_places(item, bodies)
  local all = {}
  for _, lesson in ipairs(book.lessons) do
    local frame = lesson.covers[item.name]
    local formula = "eq-" .. text.anchor_of(item.name)
    local here = {}
    if frame then
      table.insert(here, parts.link(lesson))
      local is_shown = bodies[lesson.page]:find("id=\"frame-" .. frame .. "\"", 1, true)
      local link = "<a href=\"" .. lesson.page .. "#frame-" .. frame .. "\">frame " .. frame .. "</a>"
      if frame > 0 then table.insert(here, is_shown and link or "frame " .. frame) end
    end
    if bodies[lesson.page]:find("id=\"" .. formula .. "\"", 1, true) then
      local words = frame and "in its text" or escaped(parts.numbered(lesson)) .. ", in its text"
      table.insert(here, "<a href=\"" .. lesson.page .. "#" .. formula .. "\">" .. words .. "</a>")
    end
    if #here > 0 then table.insert(all, table.concat(here, ", ")) end
  end
  return table.concat(all, "<br>")
end

local equations_begin = [[<h1>Equations</h1>
<p>The equations, the algorithm and the claims of the paper, and the lessons that show them.</p>
<div class="table" role="group" aria-label="Table" tabindex="0">
<table><thead><tr><th>Paper</th><th>What it says</th><th>Where</th></tr></thead>
<tbody>
]]

local function equations_page(bodies)
  local rows = ""
  for _, item in ipairs(book.items) do
    rows = rows .. ("<tr><th scope=\"row\">%s</th><td>%s</td><td>%s</td></tr>\n"):format(
      escaped(item.name), text.typeset(item.what, parts.places()), equation_places(item, bodies))
  end
  return text_page("Equations", equations_begin .. rows .. "</tbody></table></div>\n")
end

local function glossary_page(glossary)
  local html = text.html(glossary, parts.places({ terms = {}, symbols = {} }))
  return text_page("Glossary", (html:gsub("<li><strong>(.-)</strong>", function(name)
    return "<li id=\"" .. text.anchor_of(name) .. "\"><strong>" .. name .. "</strong>"
  end)))
end

local function notation_page(notation)
  local row = -1
  local html = text.html(notation, parts.places({ terms = {}, symbols = {} }))
  return text_page("Notation", (html:gsub("<tr class=\"(%l+)\">", function(class)
    row = class == "header" and -1 or row + 1
    return class == "header" and "<tr>" or "<tr id=\"symbol-" .. row .. "\">"
  end)))
end

local teachers_begin = [[<h1>Notes for teachers</h1>
<p>Minutes, misconceptions and what to draw on the board: a page for each lesson. <code>bash lessons/run handouts</code>
makes PDFs for print, one of all lessons and one of each; the answers stand at their ends.</p>
<ul>
]]

local function teachers_page()
  local items = ""
  for _, lesson in ipairs(book.lessons) do
    if lesson.teaching then
      items = items .. ("<li><a href=\"%s\">%s</a></li>\n"):format(
        parts.teaching_page(lesson), escaped(parts.numbered(lesson)))
    end
  end
  return text_page("Notes for teachers", teachers_begin .. items .. "</ul>\n")
end

local function contents()
  local items = ""
  for _, lesson in ipairs(book.lessons) do
    local cover = parts.cover_of(lesson)
    items = items .. ("<li>%s<div><h3>%s</h3><p>%s</p></div></li>\n"):format(
      cover and parts.picture(lesson, cover) or "", parts.link(lesson), escaped(lesson.idea))
  end
  return "<ol class=\"contents\">\n" .. items .. "</ol>\n"
end

local function lesson_of(number)
  for _, lesson in ipairs(book.lessons) do
    if lesson.number == number then return lesson end
  end
end

local open_playground = [[<p><a href="playground.html">Open the playground</a>: the lessons lead to it with scenes of
their own.</p>
]]
local make_playground = [[<p><code>bash lessons/run playground</code> makes it; then <code>bash lessons/run book</code>
puts it into this book.</p>
]]

-- What a line such as <!-- contents --> of book.md stands for.
local function filled_in(mark)
  if mark == "cover" then
    local tower = lesson_of(17)
    return parts.cover_figure(tower and #tower.frames > 0 and tower or book.lessons[1])
  end
  if mark == "contents" then return contents() end
  if mark == "playground" then return book.has_playground and open_playground or make_playground end
  local target, words = mark:match("^link: (%S+) (.*)$")
  if target then return "<a href=\"" .. target .. "\">" .. words .. "</a>" end
  local links = {}
  for number in mark:gmatch("%d+") do
    local lesson = lesson_of(tonumber(number))
    if lesson then table.insert(links, parts.link(lesson)) end
  end
  return table.concat(links, ", ")
end

local function index_page()
  local html = text.html(parts.read(source .. "book.md"), parts.places({ terms = {} }))
  return parts.page({
    title = "Cairn: the lesson book", description = "How constraint solvers work, lesson by lesson.", kind = "index",
    body = html:gsub("<!%-%- (.-) %-%->", filled_in),
  })
end

local function json(words)
  return "\"" .. words:gsub("[%c\"\\]", function(c) return ("\\u%04x"):format(c:byte()) end) .. "\""
end

local function search_entry(address, title, heading, words, is_folded)
  return ("[%s,%s,%s,%s,%s]"):format(json(address), json(title), json(heading), json(words), is_folded)
end

-- Every term, and the text of every section without what is folded in it. A section that is itself folded says so:
-- the search hides it until somebody has guessed.
local function search_index(pages)
  local entries = {}
  for _, term in ipairs(book.terms) do
    table.insert(entries, search_entry("glossary.html#" .. term.anchor, "Glossary", term.name, term.meaning, false))
  end
  local names = {}
  for name in pairs(pages) do if name ~= "glossary.html" then table.insert(names, name) end end
  table.sort(names)
  for _, name in ipairs(names) do
    local main = pages[name]:match("<main.*</main>"):gsub("<h2", "\1<h2") .. "\1"
    local title = text.without_tags(main:match("<h1>(.-)</h1>"))
    local fold = main:find("<details class=\"fold\">", 1, true) or #main
    for at, section in main:gmatch("()(.-)\1") do
      local words = section:gsub("<nav.-</nav>", ""):gsub("</summary>.-</details>", "")
      local anchor, heading = words:match("<h2 id=\"(.-)\">(.-)</h2>")
      table.insert(entries, search_entry(name .. (anchor and "#" .. anchor or ""), title,
        text.without_tags(heading or ""), text.without_tags(words), at > fold))
    end
  end
  return "const cairnSections = [\n" .. table.concat(entries, ",\n") .. "\n];\n"
end

local search_body = [[<h1>Search</h1>
<p class="found" role="status">The search needs JavaScript.</p>
<ol class="results"></ol>
]]

local handouts_begin = [[<article class="front">
<h1>Cairn: the lessons</h1>
<ol start="0">
{list}</ol>
</article>
]]

local function filled_answer(lesson, html)
  if html == "" then return "" end
  return "<article>\n<p class=\"kicker\">Answer of lesson " .. escaped(parts.numbered(lesson)) .. "</p>\n" ..
    html .. "</article>\n"
end

-- What stands before and behind the fold of a lesson.
local function parted(html)
  local asked, behind = html:match("^(.-)<details class=\"fold\">.-</summary>(.*)</details>\n$")
  if not asked then return html, "" end
  return asked, behind
end

-- Some lessons on one page, for paper: first all questions, then all answers.
local function handouts_page(lessons, bodies, title)
  local list, all, answers = "", "", ""
  for _, lesson in ipairs(lessons) do
    list = list .. ("<li><a href=\"#%s\">%s</a><br>%s</li>\n"):format(
      lesson.page, escaped(lesson.title), escaped(lesson.idea))
    local stem = lesson.page:gsub("%..*", "-")
    local html = bodies[lesson.page]:gsub(" id=\"", " id=\"" .. stem):gsub(" href=\"#", " href=\"#" .. stem)
    local asked, behind = parted(html)
    all = all .. "<article id=\"" .. lesson.page .. "\">\n" .. asked .. "</article>\n"
    answers = answers .. filled_answer(lesson, behind)
  end
  local front = #lessons > 1 and text.filled(handouts_begin, { list = list }) or ""
  return parts.page({
    title = title .. " · Cairn", description = "For print.", kind = "lesson handouts", body = front .. all .. answers,
  })
end

local function write_book()
  local glossary, notation = parts.of_the_lessons("glossary.md"), parts.of_the_lessons("../src/NOTATION.md")
  book.pages, book.symbols, book.terms = {}, symbols_of(notation), {}
  for _, lesson in ipairs(book.lessons) do
    lesson.page = ("lesson%02d.html"):format(lesson.number)
    lesson.teaching = parts.of_the_lessons(lesson.folder .. "/teaching.md")
    book.pages[lesson.folder] = lesson.page
  end
  book.terms = terms_of(glossary)
  local bodies, pages = {}, {}
  for i, lesson in ipairs(book.lessons) do
    bodies[lesson.page] = parts.lesson_body(lesson)
    pages[lesson.page] = parts.page({
      title = parts.numbered(lesson) .. " · Cairn", description = lesson.idea, kind = "lesson",
      body = bodies[lesson.page] .. parts.turning(i),
    })
  end
  pages["equations.html"] = equations_page(bodies)
  pages["glossary.html"] = glossary_page(glossary)
  pages["notation.html"] = notation_page(notation)
  pages["your_solver.html"] = document_page("A solver of your own", parts.of_the_lessons("your_solver/README.md"))
  pages["prerequisites.html"] = document_page("Prerequisites", parts.of_the_lessons("prerequisites.md"))
  pages["conclusion.html"] = document_page("What the course found", parts.of_the_lessons("conclusion.md"))
  write("search.js", search_index(pages))
  -- The pages from here on are not searched.
  for _, lesson in ipairs(book.lessons) do
    if lesson.teaching then
      pages[parts.teaching_page(lesson)] = document_page(parts.numbered(lesson) .. ", for teachers", lesson.teaching)
    end
  end
  pages["teachers.html"], pages["index.html"] = teachers_page(), index_page()
  pages["search.html"] = parts.page({
    title = "Search · Cairn", description = "A search over all pages of the lesson book.", kind = "reference",
    body = search_body, scripts = "<script src=\"search.js\"></script>\n",
  })
  if book.is_for_print then
    pages["handouts.html"] = handouts_page(book.lessons, bodies, "Handouts")
    for _, lesson in ipairs(book.lessons) do
      pages[("handout%02d.html"):format(lesson.number)] = handouts_page({ lesson }, bodies, parts.numbered(lesson))
    end
  end
  for name, html in pairs(pages) do write(name, html) end
  for _, name in ipairs({ "book.css", "book.js" }) do write(name, parts.read(source .. name)) end
end

function Pandoc(document)
  book = dofile(pandoc.utils.stringify(document.meta.facts))
  parts.begin(book)
  write_book()
end
