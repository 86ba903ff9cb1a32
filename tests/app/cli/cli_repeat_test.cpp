// The same bytes whatever the locale and the number of threads.

#include "tests/app/cli/cli_fixture.h"
#include "tests/support/paths.h"

namespace glisson::test {
namespace {

/// The environment of a user with this locale.
std::vector<std::string> under(const std::string& locale) {
  const std::filesystem::path made = localesFolder();
  return {"LOCPATH=" + made.string(), "LC_ALL=" + locale};
}

class EveryMethod : public testing::TestWithParam<std::vector<std::string>> {
 protected:
  /// Bytes of the surface written with `more` arguments in `environment`.
  static std::string surface(const std::vector<std::string>& more, const std::vector<std::string>& environment) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments{"reconstruct", sampleSegmentation(), "-o", folder / "out.stl"};
    arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = cli(arguments, environment);
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    return bytesOf(folder / "out.stl");
  }
};

TEST_P(EveryMethod, GivesTheSameBytesForOneTwoAndEightThreads) {
  const std::string one = surface({"--threads", "1"}, {});
  ASSERT_FALSE(one.empty());
  EXPECT_EQ(surface({"--threads", "2"}, {}), one);
  EXPECT_EQ(surface({"--threads", "8"}, {}), one);
}

TEST_P(EveryMethod, GivesTheSameBytesUnderADecimalComma) {
  const std::string plain = surface({}, {"LC_ALL=C"});
  ASSERT_FALSE(plain.empty());
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "tr_TR.UTF-8"}) {
    ASSERT_TRUE(std::filesystem::exists(std::filesystem::path(localesFolder()) / locale / "LC_NUMERIC"))
        << locale << " is missing: install the package locales and configure again";
    EXPECT_EQ(surface({}, under(locale)), plain) << locale;
  }
}

INSTANTIATE_TEST_SUITE_P(Cli, EveryMethod,
                         testing::Values(std::vector<std::string>{"--structure", "parenchyma", "--method", "psr", "--depth", "6"},
                                         std::vector<std::string>{"--structure", "portal_vein", "--method", "mcsd"}));

TEST(CliRepeat, ThePlansNumbersAreTheSameTextUnderADecimalComma) {
  const std::vector<std::string> arguments{"plan", sampleCase().string(), "--json"};
  const Finished plain = cli(arguments, {"LC_ALL=C"});
  ASSERT_EQ(plain.exitCode, 0) << plain.err;
  EXPECT_EQ(cli(arguments, under("de_DE.UTF-8")).out, plain.out);
}

TEST(CliRepeat, TheSamplePatientIsTheSameBytesEveryTime) {
  const TemporaryFolder folder;
  ASSERT_EQ(cli({"sample", folder / "again"}, under("de_DE.UTF-8")).exitCode, 0);
  const std::vector<std::string> names = namesIn(samplePatient());
  ASSERT_EQ(namesIn(folder / "again"), names);
  for (const std::string& name : names) {
    if (std::filesystem::is_regular_file(samplePatient() / name)) {
      EXPECT_EQ(bytesOf(folder.path() / "again" / name), bytesOf(samplePatient() / name)) << name;
    }
  }
}

}  // namespace
}  // namespace glisson::test
