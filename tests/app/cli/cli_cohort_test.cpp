// Many patients from the command line: each as `evaluate` leaves it, what they say together, whoever fails named, tasks gathered.

#include <numeric>

#include "reconstruction/evaluation/recipe.h"
#include "tests/app/cli/evaluated_labels.h"

namespace glisson::test {
namespace {

using Texts = std::vector<std::string>;
namespace fs = std::filesystem;

constexpr const char* kList =
    "# two that can be evaluated, two that cannot\n"
    "name,segmentation,label,structure,labels\n"
    "P1,labels.mha,1,,\"1=tumour,2=cyst\"\n"
    "speck,labels.mha,2,,\"1=tumour,2=cyst\"\n"
    "gone,nothing.mha,1\n"
    "P & 2,smaller.mha,,tumour,\"1=tumour,2=cyst\"\n";

std::string writeList(const TemporaryFolder& folder, const std::string& text) {
  std::ofstream(folder / "list.csv", std::ios::binary) << text;
  return folder / "list.csv";
}

Finished cohort(const std::string& list, const std::string& output, Texts more = {}) {
  Texts arguments{"evaluate", "--cohort", list, "-o", output};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return cli(arguments);
}

Texts linesOf(const std::string& text) {
  Texts lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

void expectSameCohort(const fs::path& a, const fs::path& b) {
  EXPECT_EQ(csvWithoutTimes(a / "cohort.csv", "bestPsrSeconds"), csvWithoutTimes(b / "cohort.csv", "bestPsrSeconds"));
  EXPECT_EQ(jsonWithoutTimes(a / "cohort.json"), jsonWithoutTimes(b / "cohort.json"));
  EXPECT_EQ(htmlWithoutTimes(a / "cohort.html"), htmlWithoutTimes(b / "cohort.html"));
}

class CliCohort : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    ellipsoidAndSpeck(*folder_ / "labels.mha");
    ellipsoidAndSpeck(*folder_ / "smaller.mha", 0.8);
    finished_ = cohort(writeList(*folder_, kList), *folder_ / "lab");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override { ASSERT_EQ(finished_.exitCode, 4) << finished_.err; }

  static std::string list() { return *folder_ / "list.csv"; }
  static fs::path lab() { return folder_->path() / "lab"; }
  /// A copy of the results to change.
  static fs::path copyIn(const TemporaryFolder& folder) {
    fs::copy(lab(), folder.path() / "lab", fs::copy_options::recursive);
    return folder.path() / "lab";
  }
  static Json json() { return Json::parse(bytesOf(lab() / "cohort.json")); }
  static std::map<std::string, std::map<std::string, std::string>> rows() {
    std::map<std::string, std::map<std::string, std::string>> byName;
    for (const auto& row : namedRows(bytesOf(lab() / "cohort.csv"))) {
      byName[row.at("patient")] = row;
    }
    return byName;
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline Finished finished_;
};

TEST_F(CliCohort, EachPatientHasTheFilesOfEvaluateAlone) {
  const TemporaryFolder folder;
  const Finished alone =
      cli({"evaluate", *folder_ / "labels.mha", "--labels", "1=tumour,2=cyst", "--label", "1", "-o", folder / "alone"});
  ASSERT_EQ(alone.exitCode, 0) << alone.err;
  expectSameResults(lab() / "P1", folder.path() / "alone");
  Texts expected = namesIn(folder.path() / "alone");
  expected.insert(std::find(expected.begin(), expected.end(), "report.html"), "outcome.json");
  EXPECT_EQ(namesIn(lab() / "P1"), expected);
}

TEST_F(CliCohort, WhoeverFailsIsNamedWithTheLineAndTheOthersGoOn) {
  const Texts lines = linesOf(finished_.err);
  ASSERT_EQ(lines.size(), 2U) << finished_.err;
  EXPECT_EQ(lines[0].rfind("glisson-cli: speck (line 4 of list.csv): ", 0), 0U) << lines[0];
  EXPECT_NE(lines[0].find("no surface to measure errors from"), std::string::npos) << lines[0];
  EXPECT_EQ(lines[1].rfind("glisson-cli: gone (line 5 of list.csv): ", 0), 0U) << lines[1];
  EXPECT_NE(lines[1].find("nothing.mha"), std::string::npos) << lines[1];
  EXPECT_NE(finished_.out.find("2 of 4 patients evaluated, 2 failed, 0 without a result"), std::string::npos) << finished_.out;

  const auto all = rows();
  EXPECT_EQ(all.at("P1").at("state"), "evaluated");
  EXPECT_EQ(all.at("P & 2").at("state"), "evaluated");
  EXPECT_EQ(all.at("speck").at("state"), "failed");
  EXPECT_NE(all.at("speck").at("failure").find("no surface"), std::string::npos);
  EXPECT_EQ(all.at("gone").at("line"), "5");
  EXPECT_EQ(all.at("gone").at("psrD5Score"), "");
  const Json cohort = json();
  EXPECT_EQ(cohort["listed"], 4);
  EXPECT_EQ(cohort["evaluated"], 2);
  EXPECT_EQ(cohort["failed"], 2);
  EXPECT_EQ(cohort["missing"], 0);
  EXPECT_EQ(cohort["patients"][1]["state"], "failed");
  EXPECT_NE(bytesOf(lab() / "cohort.html").find("speck (line 4 of list.csv)"), std::string::npos);
}

TEST_F(CliCohort, TheTableRepeatsTheNumbersOfThePatientsOwnFiles) {
  for (const std::string name : {"P1", "P & 2"}) {
    std::map<std::string, std::map<std::string, std::string>> models;
    for (const auto& row : namedRows(bytesOf(lab() / name / "models.csv"))) {
      models[row.at("model")] = row;
    }
    const Json summary = Json::parse(bytesOf(lab() / name / "summary.json"));
    const auto row = rows().at(name);
    EXPECT_EQ(row.at("psrD5Score"), models.at("psr_d5").at("score"));
    EXPECT_EQ(row.at("psrD6MeanErrorMm"), models.at("psr_d6").at("meanErrorMm"));
    EXPECT_EQ(row.at("psrD6Triangles"), models.at("psr_d6").at("triangles"));
    for (const std::string role : {"bestPsr", "bestMcsd", "mostSimilarMcsd", "bestSimplified", "bestOfAll"}) {
      EXPECT_EQ(row.at(role), summary[role]["model"].get<std::string>()) << role;
    }
    EXPECT_EQ(row.at("mostSimilarMcsdGaussianCurvaturePerMm2"), models.at(row.at("mostSimilarMcsd")).at("gaussianCurvaturePerMm2"));
    EXPECT_EQ(std::stod(row.at("fewerTrianglesPercentBestPsrAgainstMostSimilarMcsd")),
              summary["reductions"]["mostSimilarMcsd"]["fewerTrianglesPercent"].get<double>());
    EXPECT_EQ(std::stod(row.at("meanErrorDifferenceMmSimplifiedAgainstBestPsr")),
              summary["reductions"]["simplified"]["meanErrorDifferenceMm"].get<double>());
    EXPECT_NE(row.at("failedModels").find("PSR d=8: The label is too small for depth 8"), std::string::npos);
    EXPECT_EQ(row.at("bestPsrSeconds"), models.at(row.at("bestPsr")).at("seconds"));
  }
}

TEST_F(CliCohort, MeansCountEachEvaluatedPatientOnce) {
  const Json cohort = json();
  EXPECT_EQ(keysOf(cohort),
            (Texts{"program", "list", "parameters", "listed", "evaluated", "failed", "missing", "depths", "mcsdBestOfAll",
                   "bestPsr", "mostSimilarMcsd", "bestMcsd", "bestSimplified", "others", "reductions", "patients", "seconds"}));
  const auto all = rows();
  ASSERT_GE(cohort["depths"].size(), 2U);
  int best = cohort["mcsdBestOfAll"].get<int>();
  for (const Json& depth : cohort["depths"]) {
    best += depth["bestOfAll"].get<int>();
    std::vector<double> scores;
    for (const std::string name : {"P1", "P & 2"}) {
      const std::string& cell = all.at(name).at("psrD" + std::to_string(depth["depth"].get<int>()) + "Score");
      if (!cell.empty()) {
        scores.push_back(std::stod(cell));
      }
    }
    EXPECT_EQ(depth["score"]["patients"], scores.size());
    if (scores.size() == 2) {
      EXPECT_NEAR(depth["score"]["mean"].get<double>(), (scores[0] + scores[1]) / 2, 1e-12);
      EXPECT_NEAR(depth["score"]["deviation"].get<double>(), std::abs(scores[0] - scores[1]) / std::sqrt(2.0), 1e-12);
    } else {
      EXPECT_TRUE(depth["score"]["deviation"].is_null());
    }
  }
  EXPECT_EQ(best, 2);
  const double mean = (std::stod(all.at("P1").at("fewerTrianglesPercentBestPsrAgainstMostSimilarMcsd")) +
                       std::stod(all.at("P & 2").at("fewerTrianglesPercentBestPsrAgainstMostSimilarMcsd"))) /
                      2;
  EXPECT_NEAR(cohort["reductions"]["mostSimilarMcsd"]["fewerTrianglesPercent"]["mean"].get<double>(), mean, 1e-12);
}

TEST_F(CliCohort, OtherMethodsHaveTheirRowsToo) {
  const Json cohort = json();
  const auto all = rows();
  std::size_t made = 0;
  for (const Json& other : cohort["others"]) {
    const std::string id = other["model"].get<std::string>();
    std::vector<double> errors;
    for (const std::string name : {"P1", "P & 2"}) {
      std::map<std::string, std::map<std::string, std::string>> models;
      for (const auto& row : namedRows(bytesOf(lab() / name / "models.csv"))) {
        models[row.at("model")] = row;
      }
      const auto& row = all.at(name);
      EXPECT_EQ(row.at(id + "_Score"), models.at(id).at("score")) << id;
      EXPECT_EQ(row.at(id + "_Seconds"), row.at(id + "_Score").empty() ? "" : models.at(id).at("seconds")) << id;
      if (!row.at(id + "_MeanErrorMm").empty()) {
        errors.push_back(std::stod(row.at(id + "_MeanErrorMm")));
      }
    }
    made += errors.size();
    ASSERT_FALSE(errors.empty()) << id << " is of no patient";
    EXPECT_EQ(other["meanErrorMm"]["patients"], errors.size());
    EXPECT_NEAR(other["meanErrorMm"]["mean"].get<double>(),
                std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()), 1e-12);
  }
  EXPECT_GT(made, 6U);
  const std::string html = bytesOf(lab() / "cohort.html");
  EXPECT_NE(html.find("Other methods"), std::string::npos);
  EXPECT_NE(html.find("MPU implicits eps=0.005"), std::string::npos);
  EXPECT_NE(finished_.out.find("MPU implicits eps=0.005"), std::string::npos) << finished_.out;
}

TEST_F(CliCohort, TheReportIsOneFileWithEscapedNames) {
  const std::string html = bytesOf(lab() / "cohort.html");
  for (const char* part :
       {"Depths", "Objective score of each patient", "Reduction in triangles at equal smoothness", "Best and most similar models",
        "Processing time", "Not in these numbers", "P &amp; 2", "href=\"P%20%26%202/report.html\"", "too small for depth 8"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  for (const char* outside : {"http:", "https:", "src=", "@import", "url(", "nan", "inf ", "P & 2"}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
}

TEST_F(CliCohort, RepeatedOnKeptModelsIsTheSameBytesTimesAndAll) {
  const TemporaryFolder folder;
  const fs::path copy = copyIn(folder);
  EXPECT_EQ(cohort(list(), copy.string()).exitCode, 4);
  for (const std::string& name : namesIn(lab())) {
    if (fs::is_regular_file(lab() / name)) {
      EXPECT_EQ(bytesOf(copy / name), bytesOf(lab() / name)) << name;
    }
  }
}

TEST_F(CliCohort, TasksInAnyOrderThenGatheredAreTheSameAsOneRun) {
  const TemporaryFolder folder;
  const std::string output = folder / "lab";
  for (const auto& [task, exitCode] : {std::pair("4", 0), {"3", 3}, {"1", 0}, {"2", 3}}) {
    const Finished finished = cohort(list(), output, {"--task", task, "--threads", "1"});
    EXPECT_EQ(finished.exitCode, exitCode) << task << ": " << finished.err;
    EXPECT_FALSE(fs::exists(fs::path(output) / "cohort.csv"));
  }
  const Finished gather = cohort(list(), output, {"--gather"});
  EXPECT_EQ(gather.exitCode, 4);
  EXPECT_EQ(gather.err, finished_.err);
  expectSameCohort(output, lab());
}

TEST_F(CliCohort, ALostTaskIsNamedAndCanBeRerunAlone) {
  const TemporaryFolder folder;
  const fs::path copy = copyIn(folder);
  fs::remove(copy / "P1/outcome.json");
  std::ofstream(copy / "P & 2/outcome.json") << "{\"of\": \"half a file";
  const Finished gather = cohort(list(), copy.string(), {"--gather"});
  expectRefusal({gather.exitCode, "", linesOf(gather.err).back() + "\n"}, 3, "no patient of list.csv has a result");
  EXPECT_EQ(linesOf(gather.err).front(),
            "glisson-cli: P1 (line 3 of list.csv) has no result with these parameters; run it again with --task 1.");
  EXPECT_EQ(bytesOf(copy / "cohort.csv"), bytesOf(lab() / "cohort.csv"));

  const Finished again = cohort(list(), copy.string(), {"--task", "1"});
  ASSERT_EQ(again.exitCode, 0) << again.err;
  EXPECT_NE(again.out.find("0 made, " + std::to_string(allRecipes().size()) + " kept"), std::string::npos) << again.out;
  const Finished second = cohort(list(), copy.string(), {"--gather"});
  EXPECT_EQ(second.exitCode, 4);
  EXPECT_EQ(second.err.find("P1"), std::string::npos) << second.err;
  EXPECT_NE(second.err.find("P & 2 (line 6 of list.csv) has no result with these parameters; run it again with --task 4"),
            std::string::npos)
      << second.err;
  EXPECT_EQ(Json::parse(bytesOf(copy / "cohort.json"))["missing"], 1);

  ASSERT_EQ(cohort(list(), copy.string(), {"--task", "4"}).exitCode, 0);
  EXPECT_EQ(cohort(list(), copy.string(), {"--gather"}).err, finished_.err);
  expectSameCohort(copy, lab());
}

TEST_F(CliCohort, ResultsOfOtherParametersOrAnotherLineDoNotCount) {
  const TemporaryFolder folder;
  const fs::path copy = copyIn(folder);
  EXPECT_EQ(cohort(list(), copy.string(), {"--gather", "--as-published"}).exitCode, 3);
  EXPECT_EQ(bytesOf(copy / "cohort.json"), bytesOf(lab() / "cohort.json"));
  std::string changed = kList;
  changed.replace(changed.find("P1,labels.mha,1"), 15, "P1,labels.mha,2");
  const Finished gather = cohort(writeList(folder, changed), copy.string(), {"--gather"});
  EXPECT_EQ(gather.exitCode, 4);
  EXPECT_NE(gather.err.find("P1 (line 3 of list.csv) has no result"), std::string::npos) << gather.err;
}

TEST_F(CliCohort, ResultsWithOtherMethodsOrOfOlderModelsDoNotCount) {
  const TemporaryFolder folder;
  const fs::path copy = copyIn(folder);
  EXPECT_EQ(cohort(list(), copy.string(), {"--gather", "--methods", "none"}).exitCode, 3);
  EXPECT_EQ(cohort(list(), copy.string(), {"--gather", "--methods", "vessels,psr_knn,mpu"}).exitCode, 4) << "the same methods";
  Json outcome = Json::parse(bytesOf(copy / "P1/outcome.json"));
  outcome["of"]["models"] = outcome["of"]["models"].get<int>() - 1;
  std::ofstream(copy / "P1/outcome.json") << outcome.dump();
  const Finished gather = cohort(list(), copy.string(), {"--gather"});
  EXPECT_EQ(gather.exitCode, 4);
  EXPECT_NE(gather.err.find("P1 (line 3 of list.csv) has no result"), std::string::npos) << gather.err;
}

TEST_F(CliCohort, FlagsHoldWhereALineIsEmpty) {
  const TemporaryFolder folder;
  fs::copy(*folder_ / "labels.mha", folder / "labels.mha");
  const std::string list = writeList(folder, "name;segmentation;label\r\nall;labels.mha;\r\nspeck;labels.mha;2\r\n");
  const Texts flags{"--label", "1", "--labels", "1=tumour,2=cyst"};
  Finished finished = cohort(list, folder / "lab", {"--task", "1", flags[0], flags[1], flags[2], flags[3]});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  expectSameResults(folder.path() / "lab/all", lab() / "P1");
  finished = cohort(list, folder / "lab", {"--task", "2", flags[0], flags[1], flags[2], flags[3]});
  expectRefusal(finished, 3, "no surface to measure errors from");
}

TEST_F(CliCohort, WithNobodyToTellOfWritesNoTables) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "masks");
  writeLabels(fs::path(folder / "masks") / "liver.mha", {4, 4, 4}, std::string(64, '\1'));
  writeLabels(fs::path(folder / "masks") / "tumour.mha", {4, 4, 4}, std::string(64, '\0'));
  const std::string list = writeList(folder, "name\tsegmentation\tstructure\nempty\tmasks\ttumour\nnone\tmasks\tspleen\n");
  const Finished finished = cohort(list, folder / "lab");
  EXPECT_EQ(finished.exitCode, 3);
  const Texts lines = linesOf(finished.err);
  ASSERT_EQ(lines.size(), 3U) << finished.err;
  EXPECT_NE(lines[0].find("empty (line 2 of list.csv)"), std::string::npos);
  EXPECT_NE(lines[1].find("none (line 3 of list.csv)"), std::string::npos);
  EXPECT_NE(lines[1].find("names no structure"), std::string::npos);
  EXPECT_EQ(namesIn(folder.path() / "lab"), (Texts{"empty", "empty/outcome.json", "none", "none/outcome.json"}));
}

TEST(CliCohortInterrupt, TheFormerOutcomeDoesNotStandForARunThatIsLost) {
  const TemporaryFolder folder;
  const std::string list = writeList(folder, "name,segmentation,structure\nP1," + sampleSegmentation() + ",parenchyma\n");
  fs::create_directories(folder.path() / "lab/P1");
  std::ofstream(folder.path() / "lab/P1/outcome.json") << "{}";
  const Finished finished = runProgram("glisson-cli", {"evaluate", "--cohort", list, "-o", folder / "lab"}, {}, 1.0);
  EXPECT_EQ(finished.exitCode, 130) << finished.err;
  EXPECT_FALSE(fs::exists(folder.path() / "lab/P1/outcome.json"));
}

// ---- the list

TEST(CliCohortList, OfSpreadsheetsAndOfPeopleIsReadAlike) {
  const TemporaryFolder folder;
  const auto count = [&](const std::string& text) {
    const Finished finished = cli({"evaluate", "--cohort", writeList(folder, text), "--count"});
    return finished.exitCode == 0 ? finished.out : finished.err;
  };
  EXPECT_EQ(count(kList), "4\n");
  EXPECT_EQ(count("\xEF\xBB\xBFName;Segmentation;Label\r\nP1;a.nii;1\r\n;;\r\nP2;b,c.nii;2\r\n"), "2\n");
  EXPECT_EQ(count("\n# by hand, with tabs\nsegmentation\tname\na.nii\tM\u00fcller\n\n#\tlast\nb.nii\tP2"), "2\n");
  EXPECT_EQ(count("\"name\",\"segmentation\"\n\"# a note, from a spreadsheet\",\n\"P1\",\"folder, with a comma\"\n"), "1\n");
  EXPECT_EQ(namesIn(folder.path()), Texts{"list.csv"});
}

struct BadList {
  const char* text;
  const char* words;
};

class CliBadCohortList : public testing::TestWithParam<BadList> {};

TEST_P(CliBadCohortList, IsRefusedByItsLineBeforeAnyWork) {
  const TemporaryFolder folder;
  const std::string list = writeList(folder, GetParam().text);
  expectRefusal(cohort(list, folder / "lab"), 3, GetParam().words);
  expectRefusal(cli({"evaluate", "--cohort", list, "--count"}), 3, "list.csv");
  EXPECT_EQ(namesIn(folder.path()), Texts{"list.csv"});
}

INSTANTIATE_TEST_SUITE_P(
    Cli, CliBadCohortList,
    testing::Values(BadList{"", "lists no patient"}, BadList{"# nobody\n", "lists no patient"},
                    BadList{"name,segmentation\n", "lists no patient"}, BadList{"P1,a.nii\n", "line 1: column 1"},
                    BadList{"name,path\nP1,a.nii\n", "line 1: column 2"}, BadList{"name,name,segmentation\n", "line 1: column 2"},
                    BadList{"name,label\nP1,1\n", "line 1: there is no column segmentation"},
                    BadList{"segmentation,label\na.nii,1\n", "line 1: there is no column name"},
                    BadList{"name,segmentation\nP1,a.nii\n\nP1,b.nii\n", "line 4: the name P1 stands in line 2"},
                    BadList{"name,segmentation\nP1,a.nii\np1,b.nii\n", "line 3: the name p1 stands in line 2"},
                    BadList{"name,segmentation\n,a.nii\n", "line 2: the patient has no name"},
                    BadList{"name,segmentation\nP1,\n", "line 2: P1 has no segmentation"},
                    BadList{"name,segmentation\n../P1,a.nii\n", "line 2: the name cannot be"},
                    BadList{"name,segmentation\n..,a.nii\n", "line 2: the name cannot be"},
                    BadList{"name,segmentation\ncohort.csv,a.nii\n", "line 2: the name cannot be"},
                    BadList{"name,segmentation\n\"P\t1\",a.nii\n", "line 2: "},
                    BadList{"name,segmentation,label\nP1,a.nii,liver\n", "line 2: the label is no whole number"},
                    BadList{"name,segmentation,label\nP1,a.nii,5000000000\n", "line 2: the label is no whole number"},
                    BadList{"name,segmentation,label,structure\nP1,a.nii,1,liver\n", "line 2: there are a label and a structure"},
                    BadList{"name,segmentation\nP1,a.nii,1\n", "line 2: there are 3 cells for 2 columns"},
                    BadList{"name,segmentation\nP1,\"a.nii\n", "line 2: a quote is not closed"},
                    BadList{"\x1f\x8b\x08\xff\xfe binary", "line 1: "}));

TEST(CliCohortUsage, RefusesWhatDoesNotGoTogether) {
  const TemporaryFolder folder;
  const std::string list = writeList(folder, "name,segmentation\nP1,a.nii\nP2,b.nii\n");
  expectRefusal(cohort(list, folder / "lab", {"--task", "0"}), 2, "--task takes a number from 1 to 2");
  expectRefusal(cohort(list, folder / "lab", {"--task", "3"}), 2, "--task takes a number from 1 to 2");
  expectRefusal(cohort(list, folder / "lab", {"--task", "P1"}), 2, "--task");
  expectRefusal(cohort(list, folder / "lab", {"--task", "1", "--gather"}), 2, "--gather");
  expectRefusal(cohort(list, folder / "lab", {"a.nii"}), 2, "SEG");
  expectRefusal(cohort(list, folder / "missing/lab"), 3, "missing");
  expectRefusal(cli({"evaluate", "--cohort", list}), 2, "--output");
  expectRefusal(cli({"evaluate", "a.nii", "-o", folder / "lab", "--gather"}), 2, "--cohort");
  expectRefusal(cli({"evaluate", "-o", folder / "lab"}), 2, "--cohort");
  expectRefusal(cohort(folder / "none.csv", folder / "lab"), 3, "none.csv");
  expectRefusal(cohort(folder.path().string(), folder / "lab"), 3, "not a regular file");
  EXPECT_EQ(namesIn(folder.path()), Texts{"list.csv"});
}

TEST(CliCohortInterrupt, KeepsWhatIsDoneAndWritesNoTables) {
  const TemporaryFolder folder;
  const std::string list = writeList(folder, "name,segmentation,structure\nP1," + sampleSegmentation() + ",parenchyma\n");
  const Finished finished = runProgram("glisson-cli", {"evaluate", "--cohort", list, "-o", folder / "lab"}, {}, 1.0);
  expectRefusal(finished, 130, "the same command goes on from there");
  EXPECT_FALSE(fs::exists(folder / "lab/cohort.csv"));
  EXPECT_FALSE(fs::exists(folder / "lab/P1/outcome.json"));
}

}  // namespace
}  // namespace glisson::test
