// Text of others in messages.
#include <cairn/math/printable.hpp>

#include <doctest/doctest.h>

using namespace cairn;

TEST_CASE("what could command a terminal is escaped, and what people write is left alone") {
  CHECK(printable("plain, caf\u00e9, \u03bb\u2082 and \U0001d6d1\n") ==
        "plain, caf\u00e9, \u03bb\u2082 and \U0001d6d1\n");
  CHECK(printable("\x1b[31mred\a\r\t\x7f") == "\\x1b[31mred\\x07\\x0d\\x09\\x7f");
  CHECK(printable("\u009b2J") == "\\x9b2J");
  CHECK(printable("a\u202eb\u2066c\u200fd\u2028e") == "a\\u202eb\\u2066c\\u200fd\\u2028e");
  CHECK(printable(std::string_view("\0", 1)) == "\\x00");
}

TEST_CASE("bytes that are no UTF-8 are escaped one by one") {
  CHECK(printable("caf\xe9!") == "caf\\xe9!");
  CHECK(printable("\x9b") == "\\x9b");
  CHECK(printable("\xc0\x9b") == "\\xc0\\x9b");           // an ESC in two bytes
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");  // a surrogate
  CHECK(printable("\xe2\x80") == "\\xe2\\x80");           // an end that is missing
}

TEST_CASE("a quotation is one line, and no longer than is wanted") {
  CHECK(excerpt("two\nlines") == "two\\nlines");
  CHECK(excerpt("123456789", 9) == "123456789");
  CHECK(excerpt("0123456789", 9) == "012345...789");
  CHECK(excerpt(std::string(1000000, 'k')).size() == 63);
  // Never in the middle of a letter.
  CHECK(excerpt("\u00e9\u00e9\u00e9\u00e9\u00e9", 8) == "\u00e9\u00e9\u00e9...\u00e9");
}
