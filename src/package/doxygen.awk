# How Cairn's headers are shown to Doxygen, line for line: the sources keep their plain comments.

# The comment at the head of a file, down to its first directive, is about the file.
FNR == 1 { in_head = 1; state = "text"; column = 0 }
in_head && /^#pragma once/ { print "/// @file"; in_head = 0; next }
in_head { gsub(/eq\. \(/, "eq.\\ ("); sub(/^\/\/ ((Beside floor|Floor) [0-9]\. )?/, "/// "); print; next }

# No sentence ends behind "eq."
/^ *\/\/\/ / { gsub(/eq\. \(/, "eq.\\ (") }

# Lines of a comment that are set in are formulas, each in a line of its own; in a list they go on with its text.
/^ *\/\/\/( |$)/ {
  column = 0
  text = $0
  sub(/^ *\/\/\//, "", text)
  if (text ~ /^ +- /) {
    state = "list"
  } else if (state != "list" && text ~ /^   /) {
    sub(/^ +/, "", text)
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    print "/// " (state == "formula" ? "" : "<br>") "<code>" text "</code><br>"
    state = "formula"
    next
  } else if (text !~ /^  /) {
    state = "text"
  }
  print
  next
}
{ state = "text" }

# A comment behind a declaration is about it, and so are the lines that go on with it right below.
/^ *\/\/ / && index($0, "//") == column { sub(/\/\/ /, "///< "); print; next }
{ column = 0 }
/[^ ] +\/\/ / && !/^ *\/\// && !/^#/ {
  column = index($0, "// ")
  sub(/\/\/ /, "///< ")
}
{ print }
