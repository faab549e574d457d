-- Markdown of the lessons as HTML: links that lead on within the book, formulas as MathML, code in colours.
local text = {}

function text.escaped(words)
  return (words:gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ["\""] = "&quot;" }))
end

-- The text of HTML, on one line.
function text.without_tags(html)
  local words = html:gsub("<[^>]*>", " "):gsub("%s+", " "):gsub("^ ", ""):gsub(" $", "")
  return (words:gsub("&lt;", "<"):gsub("&gt;", ">"):gsub("&quot;", "\""):gsub("&amp;", "&"))
end

-- "What to look at" -> "what-to-look-at".
function text.anchor_of(title)
  return (title:lower():gsub("[^a-z0-9]+", "-"):gsub("^%-", ""):gsub("%-$", ""))
end

-- A template with each {name} replaced by the value of that name.
function text.filled(template, values)
  return (template:gsub("{(%l+)}", values))
end

local function written(blocks)
  local options = { html_math_method = "mathml", wrap_text = "wrap-none" }
  return (pandoc.write(pandoc.Pandoc(blocks), "html", options):gsub("&#39;", "'"))
end

-- <math> of TeX, of a kind of pandoc's. Words are one identifier each, and the names of functions stand as close as
-- letters do. Symbols that the notation explains are links to there.
local function math(tex, kind, places)
  local inside = written({ pandoc.Plain({ pandoc.Math(kind, tex) }) }):match("<semantics>(.*)<annotation")
  if not inside then error("pandoc cannot read the formula " .. tex) end
  inside = inside:gsub("<mstyle mathvariant=\"normal\">(.-)</mstyle>", function(letters)
    return (letters:gsub("</mi><mi>", ""):gsub("<mi>(%a+)</mi>", "<mi mathvariant=\"normal\">%1</mi>"))
  end)
  inside = inside:gsub("<mo>(%l%l+)</mo>", "<mo lspace=\"0em\" rspace=\"0.167em\">%1</mo>")
  inside = inside:gsub("<mi>/</mi>", "<mo lspace=\"0em\" rspace=\"0em\">/</mo>")
  inside = inside:gsub("<mi>Δ</mi><mi>(%a)</mi>", "<mi>Δ%1</mi>")
  inside = inside:gsub("<mi>([^<]*)</mi>", function(name)
    local address = places.symbols[name]
    return address and ("<mi data-symbol=\"%s\">%s</mi>"):format(address, name)  -- book.js follows it
  end)
  if kind == "DisplayMath" then return "<math displaystyle=\"true\">" .. inside .. "</math>" end
  return "<math>" .. inside:gsub("stretchy=\"true\"", "stretchy=\"false\"") .. "</math>"
end

-- A cell of a row: a formula, or the \text beside it.
local function cell_html(cell, places)
  local words = cell:match("^\\text{([^{}]*)}$")
  local html = words and text.inline(words, places) or math(cell, "DisplayMath", places)
  return "<span>" .. html .. "</span>"
end

-- A formula as a table: the number of the equation, then what && or \qquad part. Rows end with \\ in an align.
local function formula(tex, places)
  local matrices, rows = {}, ""
  tex = tex:gsub("\\begin{bmatrix}.-\\end{bmatrix}", function(matrix)
    table.insert(matrices, matrix)
    return "\1" .. #matrices .. "\2"
  end)
  tex = tex:gsub("\\begin{align}", ""):gsub("\\end{align}", ""):gsub("\\qquad", "&&")
  for row in (tex .. "\\\\"):gmatch("(.-)\\\\") do
    local star, tag = row:match("\\tag(%*?){(.-)}")
    if star == "" then tag = "(" .. tag .. ")" end
    local id = tag and places.first_use("eq-" .. text.anchor_of(tag))
    local cells = tag and "<span class=\"tag\"" .. id .. ">" .. tag .. "</span>" or ""
    for cell in (row:gsub("\\tag%*?{.-}", "") .. "&&"):gmatch("(.-)&&") do
      cell = cell:gsub("^%s*&?%s*", ""):gsub("%s+$", "")
      cell = cell:gsub("\1(%d+)\2", function(i) return matrices[tonumber(i)] end)
      cells = cells .. (cell == "" and "<span></span>" or cell_html(cell, places))
    end
    rows = rows .. "<div>" .. cells .. "</div>\n"
  end
  return "<div class=\"formula\" tabindex=\"0\" role=\"group\" aria-label=\"Formula\">\n" .. rows .. "</div>"
end

-- A block that the keyboard can scroll. One without a language holds commands or what they print.
function text.code(code, language)
  if not language and code:find("^bash ") then language = "bash" end
  local html = written({ pandoc.CodeBlock(code, { class = language or "" }) })
  local lines = html:match("<code[^>]*>(.*)</code>"):gsub("<span id=\"cb[^>]*><a [^>]*></a>", "<span>")
  local class = language and " class=\"" .. language .. "\"" or ""
  return "<pre tabindex=\"0\"><code" .. class .. ">" .. lines .. "</code></pre>"
end

-- A file or an output with a caption, which is HTML.
function text.figure(anchor, caption, block)
  local id = anchor and " id=\"" .. anchor .. "\"" or ""
  return ("<figure class=\"code\"%s>\n<figcaption>%s</figcaption>\n%s\n</figure>\n"):format(id, caption, block)
end

-- What a comment before a block of code says, as a caption and an anchor:
-- <!-- source: ../../src/peg.cpp push -->, <!-- output of: cairn validate (not compared) -->.
local function quote_of(comment)
  local file, name = comment:match("^<!%-%- source: (%S+) (.-) %-%->")
  local command = comment:match("^<!%-%- output of: (.-) %-%->")
  if command then
    local all = command:gsub(" %(not compared%)", "")
    local first = all:match("^(.-) | ")  -- what filters it says nothing to a reader
    return (first and "From what <code>" or "What <code>") .. text.escaped(first or all) .. "</code> prints"
  end
  local path = file and file:gsub("%.%./", "")
  return file and "<code>" .. name .. "</code> in <code>" .. path .. "</code>", file and path .. "-" .. name
end

local missing_playground = [[<p class="note">The playground would stand here: <code>bash lessons/run playground</code>
makes it, and then <code>bash lessons/run book</code> puts it into the book.</p>]]
local playground_on_screen = [[<p class="note">In the playground this scene moves:
<code>bash lessons/run playground</code>.</p>]]
local playground = [[<figure class="playground">
<iframe src="playground.html{at}&amp;embed=1" title="Playground" loading="lazy"></iframe>
<figcaption><a href="playground.html{at}">On a page of its own</a></figcaption>
</figure>]]

-- A paragraph that is one link to the playground, with a scene as its title, is the playground itself.
local function paragraph(para, places)
  local only = #para.content == 1 and para.content[1]
  if not only then return nil end
  if only.t == "Math" then return pandoc.RawBlock("html", formula(only.text, places)) end
  if only.t ~= "Link" or only.target ~= "../playground/README.md" or only.title == "" then return nil end
  local html = places.has_playground and text.filled(playground, { at = text.escaped(only.title) })
  return pandoc.RawBlock("html", places.is_for_print and playground_on_screen or html or missing_playground)
end

-- Where a link leads in the book; nil for nowhere.
local function led_on(target, places)
  if target:find("^http") or target:find("^#") or target:find("^playground%.html") then return target end
  local page = target:match("(%d%d_[%w_]+)/README%.md$")
  return places.files[target] or places.pages[page] or target:find("NOTATION%.md") and "notation.html" or
    target:find("your_solver/README%.md") and "your_solver.html" or
    target:find("glossary%.md") and "glossary.html" or target:find("conclusion%.md") and "conclusion.html"
end

local function block_filter_for(places)
  local raw = function(html) return pandoc.RawBlock("html", html) end
  return {
    Blocks = function(blocks)
      local result = pandoc.List()
      local comment = ""
      for _, block in ipairs(blocks) do
        if block.t == "CodeBlock" and block.classes[1] == "math" then
          block = raw(formula(block.text, places))
        elseif block.t == "CodeBlock" then
          local caption, anchor = quote_of(comment)
          local html = text.code(block.text, block.classes[1])
          block = raw(caption and text.figure(anchor, caption, html) or html)
        end
        comment = block.t == "RawBlock" and block.text or ""
        if not quote_of(comment) then result:insert(block) end
      end
      return result
    end,
    Header = function(header)
      header.identifier = header.level == 2 and text.anchor_of(pandoc.utils.stringify(header)) or ""
      return header
    end,
    Para = function(para) return paragraph(para, places) end,
    RawBlock = function(block)
      local frame = block.text:match("^<!%-%- frame: (%d+) %-%->")
      if frame then return raw(places.frame(tonumber(frame))) end
      return block.text:find("^<picture>") and raw(places.cover or "") or nil
    end,
    Table = function(rows)
      return { raw("<div class=\"table\" role=\"group\" aria-label=\"Table\" tabindex=\"0\">"), rows, raw("</div>") }
    end,
  }
end

-- Prose as HTML, its subscripts set: one letter and what stands behind its _, such as e_i, λ_max or s_{n+1}. Then
-- whether there were any.
function text.prose(words)
  local html = text.escaped(words)
  local found = 0
  for _, letter in ipairs({ "%f[%a](%a)", "([\xCC-\xCF][\x80-\xBF])" }) do
    for _, below in ipairs({ "{([^{}]*)}", "(%w+)" }) do
      local count
      html, count = html:gsub(letter .. "_" .. below, "%1<sub>%2</sub>")
      found = found + count
    end
  end
  return html, found > 0
end

-- For what is left once some paragraphs have become blocks.
local function inline_filter_for(places)
  return {
    Link = function(link)
      link.target = led_on(link.target, places) or ""
      return link.target == "" and link.content or link
    end,
    Math = function(tex) return pandoc.RawInline("html", math(tex.text, tex.mathtype, places)) end,
    Str = function(str)
      local html, has_any = text.prose(str.text)
      return has_any and pandoc.RawInline("html", html) or nil
    end,
  }
end

-- Where a text has a word, its first letter large or small, its end with or without an s: from and to.
local function place_of(words, term)
  local from, to = 0, nil
  while true do
    from, to = words:lower():find(term:lower(), from + 1, true)
    if not from then return nil end
    if words:sub(to + 1, to + 1) == "s" then to = to + 1 end
    if not words:sub(from - 1, from - 1):find("[%a-]") or from == 1 then
      if not words:sub(to + 1, to + 1):find("%a") then return from, to end
    end
  end
end

-- Links each of `left` where a piece of text first has it, and takes it out of `left`.
local function linked(words, left)
  for i, term in ipairs(left) do
    local from, to = place_of(words, term.name)
    if from then
      table.remove(left, i)
      local link = ("<a class=\"term\" href=\"glossary.html#%s\" title=\"%s\">%s</a>"):format(
        term.anchor, text.escaped(term.meaning), words:sub(from, to))
      return linked(words:sub(1, from - 1), left) .. link .. linked(words:sub(to + 1), left)
    end
  end
  return words
end

local closed = pandoc.List({ "a", "code", "pre", "h1", "h2", "h3", "summary", "figure", "math", "th", "nav" })

-- HTML in which the first use of each term is a link to the glossary, but not in elements that are closed to it.
function text.with_terms(html, terms)
  local left = { table.unpack(terms) }
  local open = {}
  return (("<>" .. html):gsub("(<(/?)(%w*)[^>]*>)([^<]*)", function(tag, ends, name, words)
    if ends == "" and closed:includes(name) then table.insert(open, name) end
    if ends == "/" and open[#open] == name then table.remove(open) end
    return (tag == "<>" and "" or tag) .. (#open == 0 and linked(words, left) or words)
  end))
end

-- HTML of a text. `places` says where its links and pictures lead:
--   pages   "03_sequential_impulses" -> "lesson03.html"
--   files   shown on this page: "exercise.cpp" -> "#exercise.cpp"; files that are quoted come to it here
--   cover   HTML that stands for every picture of the text
--   frame   HTML that stands for a frame, by its number
--   symbols of formulas, and terms: where they are explained
function text.html(markdown, places)
  for file, name in markdown:gmatch("<!%-%- source: (%S+) (.-) %-%->") do
    places.files[file] = places.files[file] or "#" .. file:gsub("%.%./", "") .. "-" .. name
  end
  local seen = {}
  places.first_use = function(anchor)
    local id = seen[anchor] and "" or " id=\"" .. anchor .. "\""
    seen[anchor] = true
    return id
  end
  local blocks = pandoc.read(markdown, "gfm+tex_math_dollars").blocks
  local led = pandoc.walk_block(pandoc.Div(blocks), block_filter_for(places))
  local html = written(pandoc.walk_block(led, inline_filter_for(places)).content)
  -- No line begins with the comma behind a formula.
  html = html:gsub("%(?<math>.-</math>[,.;:?)]*", function(formula)
    return not formula:find("</math>$") and "<span class=\"together\">" .. formula .. "</span>" or nil
  end)
  html = html:gsub("<th([^>]*)></th>", "<td%1></td>")  -- the corner of a table is no head
  return text.with_terms(html, places.terms)
end

-- HTML of a few words, without their paragraph.
function text.inline(markdown, places)
  local blocks = pandoc.read(markdown, "gfm+tex_math_dollars").blocks
  if #blocks == 0 then return "" end
  return written({ pandoc.Plain(pandoc.walk_block(blocks[1], inline_filter_for(places)).content) })
end

-- A formula that a program prints, such as "v₂ = v₁ + M⁻¹ Jᵀ λ Δt", as MathML; words as they are.
local scripts = { ["⁻¹"] = "^{-1}", ["ᵀ"] = "^T", ["₁"] = "_1", ["₂"] = "_2" }
function text.typeset(words, places)
  if words:find("%l%l%l") then return (text.prose(words)) end
  for from, to in pairs(scripts) do words = words:gsub(from, to) end
  words = words:gsub("%(([^()]*)%) / %(([^()]*)%)", "\\frac{%1}{%2}"):gsub("%(([^()]*)%) / (Δt)", "\\frac{%1}{%2}")
  words = words:gsub("−([^()=]+) / (Δt)$", "-\\frac{%1}{%2}")
  return math(words, "DisplayMath", places)
end

return text
