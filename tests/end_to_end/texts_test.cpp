// Texts that come from outside and go out again: messages on a terminal, results as JSON, standard output that cannot
// be written to, warnings.
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run, program::shell;
namespace fs = std::filesystem;

const std::string me = BITROCK_PROGRAM;
const std::string model = BITROCK_SOURCE_DIR "/campaigns/paper240/model.json";
const std::string outside = "predict " + model + " --speed-m-per-s 9 --depth-mm 2 --rake-deg 15";

class Texts : public testing::Test {
 protected:
  const scratch::Folder dir{"texts"};

  std::string file(const std::string& name, const std::string& content) const {
    base::write_whole(dir / name, content);
    return (dir / name).string();
  }
  /// Nothing that a terminal would obey or a reader not see.
  static void expect_clean(const std::string& text) {
    for (const char* raw : {"\x1b", "\x07", "\r", "\u202e", "\u200b", "\xff"})
      EXPECT_EQ(text.find(raw), std::string::npos) << text;
    EXPECT_EQ(text.find('\0'), std::string::npos) << text;
  }
};

TEST_F(Texts, AMessageShowsTheBytesOfAFile) {
  const std::string cell = std::string("\x1b[2J\xff\u202e") + '\0' + "end";
  for (const std::string& arguments :
       {"peaks " + file("cell.csv", "time_s,force\n0,1\n1," + cell + "\n"),
        "peaks " + file("name.csv", "time_s,fo" + cell + "rce\n0,1\n1,2\n") + " --column farce",
        "cut " + file("value.toml", "rock = \"a\\u001b[2J\\u202e.toml\"\n[cut]\ncutter_speed_m_per_s = 1\n"),
        "cut " + file("key.toml", "\"ro\\u001b[2J\\u202eck\" = 1\n"),
        "cut " + file("bytes.toml", "rock = \"" + cell + "\"\n"),
        "predict " + file("model.json", "{\"format\": \"" + cell + "\"}") +
            " --speed-m-per-s 1 --depth-mm 1 --rake-deg 1",
        "cut '" + (dir / "no\x1b[2J\u202e\nbitrock: done.toml").string() + "'", std::string("dan\x1b[2Jce"),
        std::string("peaks x --colu\x1b[2Jmn")}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_TRUE(outcome.text.starts_with("bitrock: ")) << outcome.text;
    EXPECT_EQ(outcome.text.find("\nbitrock: done"), std::string::npos) << "a name that looks like our own message";
    expect_clean(outcome.text);
  }
  const auto shown = run("peaks " + file("cell.csv",
                                         "time_s,force\n0,1\n1,\x1b[2J\u202e"
                                         "end\n"));
  EXPECT_NE(shown.text.find("'\\x1B[2J\\u{202E}end' is not a number"), std::string::npos) << shown.text;
}

TEST_F(Texts, ALongCellDoesNotFloodTheScreen) {
  const auto outcome = run("peaks " + file("long.csv", "time_s,force\n0,1\n1," + std::string(3000000, 'x') + "\n"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_LT(outcome.text.size(), 2500u);
  EXPECT_NE(outcome.text.find("is not a number"), std::string::npos) << "what it says stands at its end";
}

TEST_F(Texts, JsonHoldsNothingThatCannotBeSeen) {
  const std::string name = (dir / "m\u202eodel\u200b.c").string();
  const auto outcome = run("export c " + model + " -o '" + name + "' --json " + (dir / "r.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  expect_clean(outcome.text);
  expect_clean(base::read_whole(dir / "r.json"));
  EXPECT_NE(program::json(dir / "r.json").dump().find("m\u202eodel\u200b.c"), std::string::npos) << "the same name";
}

TEST_F(Texts, WarningsAreShownWithQuietToo) {
  for (const char* quiet : {"", " --quiet"}) {
    const auto outcome = run(outside + quiet);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.text.find("bitrock: warning: outside the training range"), std::string::npos) << outcome.text;
  }
  EXPECT_NE(run("predict --help").text.find("prints only warnings and errors"), std::string::npos);
  const std::string inside = "predict " + model + " --speed-m-per-s 1 --depth-mm 2 --rake-deg 15 --quiet";
  EXPECT_EQ(run(inside).text, "");
}

TEST_F(Texts, AFullDiskBehindStandardOutput) {
  for (const std::string& arguments : {outside, std::string("--help"), std::string("--version"),
                                       "peaks " + file("f.csv", "time_s,force\n0,0\n1,2\n2,1\n")}) {
    const auto outcome = shell(me + " " + arguments + " 2>&1 >/dev/full");
    EXPECT_EQ(outcome.status, 3) << arguments;
    EXPECT_NE(outcome.text.find("cannot write to standard output: No space left on device"), std::string::npos)
        << outcome.text;
  }
  EXPECT_EQ(shell(me + " " + outside + " --quiet >/dev/full 2>&1").status, 0) << "nothing is to be printed";
  const auto json = shell(me + " " + outside + " --json /dev/full 2>&1");
  EXPECT_EQ(json.status, 3);
  EXPECT_NE(json.text.find("cannot write /dev/full: No space left on device"), std::string::npos) << json.text;
}

TEST_F(Texts, StandardOutputThatIsClosed) {
  const auto outcome = shell(me + " " + outside + " 2>&1 >&-");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.text.find("cannot write to standard output: it is closed"), std::string::npos) << outcome.text;
  const std::string written = (dir / "m.c").string();
  EXPECT_EQ(shell(me + " export c " + model + " -o " + written + " >&- 2>&-").status, 3);
  EXPECT_EQ(base::read_whole(written).find("-> "), std::string::npos) << "a message went into a file";
  EXPECT_EQ(shell(me + " cut /nonexistent.toml 2>&-").status, 2) << "errors that nobody sees are errors all the same";
  EXPECT_EQ(shell(me + " cut /nonexistent.toml 2>/dev/full").status, 2);
}

/// As `cat` and `grep` do: the status of SIGPIPE, and no word.
TEST_F(Texts, AReaderThatHasGone) {
  const std::string words = (dir / "words").string();
  const auto outcome = shell("bash -c '" + me + " --help 2>" + words + " | true; echo ${PIPESTATUS[0]}'; sleep 0.1");
  EXPECT_TRUE(outcome.text == "141\n" || outcome.text == "0\n") << outcome.text;  // 0: all was in the pipe before
  EXPECT_EQ(base::read_whole(words), "");
  const auto late = shell("bash -c '(sleep 0.3; " + me + " --help) 2>" + words + " | true; echo ${PIPESTATUS[0]}'");
  EXPECT_EQ(late.text, "141\n");
  EXPECT_EQ(base::read_whole(words), "");
}

TEST_F(Texts, TheFolderForTemporaryFiles) {
  const std::string data = BITROCK_SOURCE_DIR "/campaigns/paper240/features.csv", figures = (dir / "figures").string();
  const auto outcome =
      shell("TMPDIR=/no/such " + me + " parity " + model + " " + data + " --figures " + figures + " 2>&1");
  if (outcome.text.find("gnuplot is not installed") != std::string::npos) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(outcome.status, 2) << outcome.text;
  EXPECT_NE(outcome.text.find("TMPDIR"), std::string::npos) << outcome.text;
}

}  // namespace
