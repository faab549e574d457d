// What a scene file with a mistake is answered: about bodies.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "math/list.hpp"
#include "scenes/scene_file.hpp"

using namespace cairn;

namespace {

struct BodyMistakes {
  std::string mistake = {};
  std::string text = {};
  std::string message = {};
};

const List<BodyMistakes> body_mistakes = {
    {"an unknown table", "[gruond]\nheight = 1\n",
     "my.toml:1:2: gruond must be a known key, but the file itself has none of that name (ground?)"},
    {"an unknown key", "[[body]]\ncircle = 1\ndensty = 2\n",
     "my.toml:3:1: body[1].densty must be a known key, but [[body]] has none of that name (density?)"},
    {"an unknown key that is like none", "[camera]\nzoom = 2\n",
     "my.toml:2:1: camera.zoom must be a known key, but [camera] has none of that name; it may have center, "
     "height"},
    {"one bracket too few", "[body]\ncircle = 1\n",
     "my.toml:1:1: body must be a list of tables, each [[body]], got a table"},
    {"one bracket too many", "[[ground]]\nheight = 1\n",
     "my.toml:1:1: ground must be one table, [ground], got a list of 1"},
    {"a text for a number", "[[body]]\ncircle = 1\ndensity = \"heavy\"\n",
     "my.toml:3:11: body[1].density must be a number > 0 kg/m^2, got \"heavy\": unknown word heavy"},
    {"a unit that a number has none of", "[[body]]\ncircle = \"50 cm\"\n",
     "my.toml:2:10: body[1].circle must be a number > 0 m, got \"50 cm\": unknown unit cm, only deg and rad "
     "can stand behind a number"},
    {"an angle in degree", "[[body]]\ncircle = 1\nangle = \"30 degrees\"\n",
     "my.toml:3:9: body[1].angle must be a number of rad, got \"30 degrees\": unknown unit degrees, only deg "
     "and rad can stand behind a number"},
    {"a number for a text", "title = 7\n", "my.toml:1:9: title must be a text in quotes, got 7"},
    {"a text for a flag", "[[body]]\ncircle = 1\nsensor = \"yes\"\n",
     "my.toml:3:10: body[1].sensor must be true or false, got \"yes\""},
    {"a date", "seconds = 2020-01-01\n",
     "my.toml:1:11: seconds must be a number from 1e-6 to 3600 s, got a date or time"},
    {"a number out of range", "[[body]]\ncircle = 1\nrestitution = 1.5\n",
     "my.toml:3:15: body[1].restitution must be a number from 0 to 1, got 1.5"},
    {"a radius below 0", "[[body]]\ncircle = -0.5\n",
     "my.toml:2:10: body[1].circle must be a number > 0 m, got -0.5"},
    {"a side of 0", "[[body]]\nbox = [1, 0]\n", "my.toml:2:11: body[1].box[2] must be a number > 0 m, got 0"},
    {"a sum out of range", "[[body]]\ncircle = \"1 - 2\"\n",
     "my.toml:2:10: body[1].circle must be a number > 0 m, got \"1 - 2\", which is -1"},
    {"a division by zero", "[[body]]\ncircle = \"1 / 0\"\n",
     "my.toml:2:10: body[1].circle must be a number > 0 m, got \"1 / 0\": its value is not finite"},
    {"not a number", "[[body]]\ncircle = 1\nposition = [nan, 0]\n",
     "my.toml:3:13: body[1].position[1] must be a number of m, got nan"},
    {"a half of a body", "[[stack]]\nn = 2.5\nbox = [1, 1]\n",
     "my.toml:2:5: stack[1].n must be a whole number from 1 to 20000, got 2.5"},
    {"three coordinates", "[[body]]\ncircle = 1\nposition = [0, 1, 2]\n",
     "my.toml:3:12: body[1].position must be two numbers of m in brackets, got a list of 3"},
    {"one number for two", "[[body]]\nbox = 1\n",
     "my.toml:2:7: body[1].box must be two numbers > 0 m in brackets, got 1"},
    {"an unknown word", "[[body]]\ntype = \"statc\"\nbox = [1, 1]\n",
     "my.toml:2:8: body[1].type must be one of dynamic, static, kinematic, got \"statc\" (static?)"},
    {"a key that is missing", "[[stack]]\nbox = [1, 1]\n",
     "my.toml:1:1: stack[1].n must be given: a whole number from 1 to 20000 (how many)"},
    {"a name twice", "[[body]]\nname = \"ball\"\ncircle = 1\n[[body]]\nname = \"ball\"\ncircle = 1\n",
     "my.toml:5:8: body[2].name must be a name that nothing else has, got \"ball\" once more"},
    {"the name of the world", "[[body]]\nname = \"ground\"\ncircle = 1\n",
     "my.toml:2:8: body[1].name must be another name: \"ground\" is what cannot move, got \"ground\""},
    {"two stacks without a name", "[[stack]]\nn = 1\nbox = [1, 1]\n[[stack]]\nn = 1\nbox = [1, 1]\n",
     "my.toml:4:1: stack[2].name must be a name that nothing else has, got \"stack\" once more"},
    {"a name with a space", "[[body]]\nname = \"my ball\"\ncircle = 1\n",
     "my.toml:2:8: body[1].name must be 1 to 60 letters, digits, _ and -, got \"my ball\""},
    {"two shapes", "[[body]]\ncircle = 1\nbox = [1, 1]\n",
     "my.toml:2:10: body[1].circle must be the only shape; for several there is shapes = [{...}, {...}], got "
     "a box beside it"},
    {"a body without a shape", "[[body]]\nname = \"nothing\"\n",
     "my.toml:1:1: body[1]: nothing has no shape; give it a box, circle, capsule or polygon, or else mass "
     "and inertia"},
    {"a row without a shape", "[[row]]\nn = 2\nfirst = [0, 0]\nstep = [1, 0]\n",
     "my.toml:1:1: row[1]: row.1 has no shape; give it a box, circle, capsule or polygon, or else mass and "
     "inertia"},
    {"a mass without a shape", "[[body]]\nmass = 1\n",
     "my.toml:1:1: body[1]: body.1 has no shape; give it a box, circle, capsule or polygon, or else mass and "
     "inertia"},
    {"a capsule of one point", "[[body]]\ncapsule = [[0, 0]]\nradius = 1\n",
     "my.toml:2:11: body[1].capsule must be two points [[x, y], [x, y]], got a list of 1"},
    {"a number too large", "seconds = \"1e309\"\n",
     "my.toml:1:11: seconds must be a number from 1e-6 to 3600 s, got \"1e309\": a number too large"},
    {"a number too small", "seconds = \"2 + 1e-400\"\n",
     "my.toml:1:11: seconds must be a number from 1e-6 to 3600 s, got \"2 + 1e-400\": a number too small"},
    {"a title that commands the terminal", "title = \"\\u001b[31mred\"\n",
     "my.toml:1:9: title must be one line of at most 1000 bytes without control characters, got "
     "\"\\x1b[31mred\""},
    {"a look of two lines", "look = \"\"\"one\ntwo\"\"\"\n",
     "my.toml:1:8: look must be one line of at most 1000 bytes without control characters, got "
     "\"one\\ntwo\""},
    {"a sum that goes on in another script", "seconds = \"2 \u00b7 3\"\n",
     "my.toml:1:11: seconds must be a number from 1e-6 to 3600 s, got \"2 \u00b7 3\": unexpected \"\u00b7 "
     "3\""},
    {"a polygon with a dent", "[[body]]\npolygon = [[0, 0], [2, 0], [0.5, 0.5], [0, 2]]\n",
     "my.toml:1:1: body[1]: polygon: points[2] must be a corner that turns outwards (convex), got (0.5, "
     "0.5)"},
    {"a capsule without a radius", "[[body]]\ncapsule = [[0, 0], [1, 0]]\n",
     "my.toml:1:1: body[1]: capsule: radius must be > 0 m, got 0"},
    {"a static body that moves", "[[body]]\ntype = \"static\"\nbox = [1, 1]\nvelocity = [1, 0]\n",
     "my.toml:4:12: body[1].velocity must be 0 for a static body, got 1"},
    {"too many bodies", "[[stack]]\nn = 20000\nbox = [1, 1]\n[[body]]\ncircle = 1\n",
     "my.toml:4:1: body[1] must be part of a scene of at most 20000 bodies, got one more"},
    {"a row with two beginnings",
     "[[row]]\nn = 2\nstep = [1, 0]\nfirst = [0, 0]\nposition = [0, 0]\ncircle = 0.4\n",
     "my.toml:4:9: row[1].first must be given, or else position, and not both, got both"},
    {"a number named as a function", "[numbers]\nsin = 3\n",
     "my.toml:2:1: numbers.sin must be a name of letters, digits and _ that sums do not have yet"},
    {"a number of your own that is none", "[numbers]\nmu = \"5 percent\"\n",
     "my.toml:2:6: numbers.mu must be a finite number, or a sum of numbers above it, got \"5 percent\": "
     "unknown "
     "unit percent, only deg and rad can stand behind a number"},
    {"an unknown word in a sum", "[numbers]\nradius = 0.5\n[[body]]\ncircle = \"raduis * 2\"\n",
     "my.toml:4:10: body[1].circle must be a number > 0 m, got \"raduis * 2\": unknown word raduis "
     "(radius?)"},
    {"an unknown key of the file", "titel = \"my scene\"\n",
     "my.toml:1:1: titel must be a known key, but the file itself has none of that name (title?)"},
    {"an arch that is too thick", "[[arch]]\nn = 9\nradius = 2\nthickness = 5\n",
     "my.toml:4:13: arch[1].thickness must be less than twice the radius, got 5"},
    {"a shape that is no table", "[[body]]\nshapes = [1, 2]\n",
     "my.toml:2:11: body[1].shapes must be a list of tables: [{...}, {...}], got 1"},
    {"an expectation of nothing", "[expect]\npenetration = 0\n",
     "my.toml:2:15: expect.penetration must be a number > 0 m, got 0"},
    {"masses that no number can hold", "[[body]]\ncircle = 1\nmass = 1e-30\n",
     "my.toml:3:8: body[1].mass must be a number from 1e-15 to 1e15 kg, got 1e-30"},
};

}  // namespace

TEST_CASE("a mistake in a table or a body is told with its place, its field and its rule") {
  for (const BodyMistakes& each : body_mistakes) {
    CAPTURE(each.mistake);
    CHECK_THROWS_WITH_AS(read_scene_text(each.text, "my.toml"), each.message.c_str(), std::invalid_argument);
  }
}

TEST_CASE("no message is longer than a few lines, however long a key, a text or a word of the file is") {
  const std::string huge(900000, 'k');
  for (const std::string& text :
       {huge + " = 1\n", "[ground]\n" + huge + " = 1\n", "seconds = \"" + huge + "\"\n",
        "title = \"" + huge + "\"\n", "seconds = \"2 " + huge + "\"\n", "[numbers]\n" + huge + " = true\n",
        "x = " + huge + "\n", huge.substr(0, 400000) + " = 1\n" + huge.substr(0, 400000) + " = 1\n",
        "[[body]]\ncircle = 1\n[[joint]]\ntype = \"weld\"\nb = \"" + huge + "\"\n"}) {
    std::string message;
    try {
      read_scene_text(text, "my.toml");
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    CAPTURE(text.substr(0, 40));
    CHECK_FALSE(message.empty());
    CHECK(message.size() <= 500);
  }
}

TEST_CASE("what is no TOML is told with its line and column") {
  const List<BodyMistakes> mistakes = {
      {"a word without quotes", "title = stack\n",
       "my.toml:1:9: the text must be TOML: a value must be a number, a list, or a text in quotes"},
      {"a bracket that is not closed", "[[body]]\nbox = [1, 1\nposition = [0, 1]\n",
       "my.toml:3:1: the text must be TOML: "},
      {"a key twice", "[[body]]\ncircle = 1\ncircle = 2\n", "my.toml:3:10: the text must be TOML: "},
      {"a text that goes on", "title = \"one\ntwo\"\n",
       "my.toml:1:13: the text must be TOML: a text must end on its line, and have no control characters"},
      {"a number too large", "seconds = 1e309\n",
       "my.toml:1:16: the text must be TOML: '1e309' is a number too large"},
      {"a key without a value", "seconds =\n", "my.toml:1:10: the text must be TOML: "},
      {"a heading that is not closed", "[ground\nheight = 1\n", "my.toml:1:8: the text must be TOML: "},
      {"letters that are none", "title = \"\xff\"\n", "my.toml:1:9: the text must be TOML: "},
  };
  for (const BodyMistakes& each : mistakes) {
    CAPTURE(each.mistake);
    std::string message;
    try {
      read_scene_text(each.text, "my.toml");
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    // Releases of toml++ differ in the words behind it.
    CHECK(message.substr(0, each.message.size()) == each.message);
  }
}

TEST_CASE("keys and lists that go deeper than any scene are refused before they go too deep") {
  std::string key = "a";
  for (int i = 0; i < 300000; ++i) key += ".a";
  const char* dots = "my.toml:1:83: a key must have at most 40 dots";
  CHECK_THROWS_WITH_AS(read_scene_text("[" + key + "]\n", "my.toml"), dots, std::invalid_argument);
  const std::string lists = "x = " + std::string(100, '[') + std::string(100, ']') + "\n";
  CHECK_THROWS_WITH_AS(read_scene_text(lists, "my.toml"),
                       "my.toml:1:45: the text must have at most 40 tables and lists in each other",
                       std::invalid_argument);
  CHECK_NOTHROW(read_scene_text("# " + std::string(200, '.') + "\n", "my.toml"));
}
