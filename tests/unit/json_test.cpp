// What JSON from outside may not hold, and where a message says it stands.
#include "base/json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/errors.hpp"

using namespace bitrock;

namespace {

std::string message(const std::string& text) {
  try {
    base::json_from_text(text, "m.json");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Json, ReadsWhatIsWhole) {
  const nlohmann::json json = base::json_from_text(R"({"a": [1, {"b": 2.5}], "c": {"a": "x"}, "n": null})", "m.json");
  EXPECT_EQ(json["a"][1]["b"], 2.5);
  EXPECT_EQ(json["c"]["a"], "x");
  EXPECT_EQ(base::json_from_text("\xef\xbb\xbf[1]", "m.json")[0], 1);
}

TEST(Json, RefusesAKeyTwice) {
  EXPECT_EQ(message(R"({"a": 1, "a": 1})"), "m.json: a stands there twice (keep the one that is meant)");
  EXPECT_EQ(message(R"({"outputs": [{"low": 1}, {"x": {}, "low": 1, "scale": [2, {"q": 1}], "low": 3}]})"),
            "m.json: outputs[1].low stands there twice (keep the one that is meant)");
  EXPECT_EQ(message(R"([{"a": 1}, {"a": 1}])"), "accepted");
}

TEST(Json, RefusesNumbersBeyondADouble) {
  EXPECT_EQ(message("{\"a\": 1,\n\"list\": [1, -1e999]}"),
            "m.json:2: list[1] = -1e999 is beyond what a number can be (1e308 at most)");
}

TEST(Json, RefusesWhatIsCutShortOrNotJson) {
  for (const char* text :
       {"", "{", "{\"a\": ", "[1, 2", "[nan]", "[Infinity]", "[0x14]", "[1,]", "{} {}", "[01]", "[.5]", "[+1]"}) {
    EXPECT_EQ(message(text).substr(0, 29), "m.json: not a whole JSON file") << text;
  }
  EXPECT_NE(message("{\n\"a\": tru}").find("line 2"), std::string::npos);
}

TEST(Json, RefusesNestingWithoutEnd) {
  EXPECT_EQ(message(std::string(64, '[') + std::string(64, ']')), "accepted");
  EXPECT_EQ(message(std::string(1000000, '[')).substr(0, 45), "m.json: nested deeper than 64 levels at [0][0");
}

TEST(Json, RefusesOtherEncodings) {
  EXPECT_EQ(message("{\"rock\": \"k\xf6rnig\"}").substr(0, 32), "m.json:1: byte F6 is not UTF-8 (");
}

}  // namespace
