// The paper's experiment from the command line: three files, the same bytes again, goes on where it stopped, refuses by name.

#include <set>

#include "reconstruction/file_lock.h"
#include "tests/app/cli/evaluated_labels.h"
#include "tests/support/real_data.h"

namespace glisson::test {
namespace {

using Keys = std::vector<std::string>;
namespace fs = std::filesystem;

Finished evaluate(const std::string& segmentation, const std::string& output, Keys more = {}) {
  Keys arguments{"evaluate", segmentation, "--labels", "1=tumour,2=cyst", "-o", output};
  if (std::find(more.begin(), more.end(), "--label") == more.end()) {
    more.insert(more.end(), {"--label", "1"});
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return cli(arguments);
}

class CliEvaluate : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    finished_ = evaluate(ellipsoidAndSpeck(*folder_ / "labels.mha"), *folder_ / "lab");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override { ASSERT_EQ(finished_.exitCode, 0) << finished_.err; }

  static std::string labels() { return *folder_ / "labels.mha"; }
  static fs::path lab() { return folder_->path() / "lab"; }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline Finished finished_;
};

TEST_F(CliEvaluate, WritesARowForEachOfThePapersModelsAndTheThirdFamily) {
  const auto rows = namedRows(bytesOf(lab() / "models.csv"));
  std::map<std::string, int> families;
  for (const auto& row : rows) {
    ++families[row.at("family")];
    if (!row.at("failure").empty()) {
      EXPECT_EQ(row.at("meanErrorMm"), "");
      EXPECT_EQ(row.at("score"), "");
      continue;
    }
    EXPECT_GT(std::stod(row.at("triangles")), 0);
    EXPECT_LE(std::stod(row.at("meanErrorMm")), std::stod(row.at("p95ErrorMm")));
    EXPECT_LE(std::stod(row.at("p95ErrorMm")), std::stod(row.at("maxErrorMm")));
    EXPECT_LE(std::stod(row.at("lowQuartileErrorMm")), std::stod(row.at("highQuartileErrorMm")));
    EXPECT_TRUE(row.at("pareto") == "0" || row.at("pareto") == "1");
    if (row.at("family") == "psr" || row.at("family") == "mcsd") {
      EXPECT_GE(std::stod(row.at("normalisedError")), 0);
      EXPECT_LE(std::stod(row.at("normalisedError")), 1);
      EXPECT_GE(std::stod(row.at("normalisedTriangles")), 0);
      EXPECT_LE(std::stod(row.at("normalisedTriangles")), 1);
    }
  }
  EXPECT_EQ(families, (std::map<std::string, int>{{"mcsd", 50}, {"psr", 4}, {"simplified", 4}, {"other", 11}}));
}

TEST_F(CliEvaluate, SaysOfWhichModelsTheLabelIsTooSmallAndScoresTheOthers) {
  std::map<std::string, std::string> failures;
  for (const auto& row : namedRows(bytesOf(lab() / "models.csv"))) {
    if (!row.at("failure").empty()) {
      failures[row.at("model")] = row.at("failure");
    }
  }
  EXPECT_EQ(failures,
            (std::map<std::string, std::string>{
                {"psr_d7", "The label is too small for depth 7: depth 6 is the deepest that its voxels carry."},
                {"psr_d8", "The label is too small for depth 8: depth 6 is the deepest that its voxels carry."},
                {"psr_knn_d7", "The label is too small for depth 7: depth 6 is the deepest that its voxels carry."},
                {"psr_knn_d7_k40", "The label is too small for depth 7: depth 6 is the deepest that its voxels carry."},
                {"psr_knn_d8", "The label is too small for depth 8: depth 6 is the deepest that its voxels carry."},
                {"mpu_e0.0025_d8", "The label is too small for depth 8: depth 6 is the deepest that its voxels carry."}}));
  EXPECT_NE(finished_.out.find("note: PSR d=8: The label is too small for depth 8"), std::string::npos) << finished_.out;
  const Json summary = Json::parse(bytesOf(lab() / "summary.json"));
  EXPECT_EQ(summary["failed"].size(), 6U);
  EXPECT_EQ(summary["failed"][0]["model"], "psr_d7");
}

TEST_F(CliEvaluate, TheSummaryNamesTheChosenModelsAndTheReductions) {
  const Json summary = Json::parse(bytesOf(lab() / "summary.json"));
  EXPECT_EQ(keysOf(summary), (Keys{"program",
                                   "label",
                                   "parameters",
                                   "models",
                                   "failed",
                                   "bounds",
                                   "bestPsr",
                                   "bestMcsd",
                                   "bestOfAll",
                                   "mostSimilarMcsd",
                                   "bestSimplified",
                                   "bestOther",
                                   "paretoFront",
                                   "paretoFrontSimplified",
                                   "paretoFrontOther",
                                   "paretoFrontOfAll",
                                   "otherMethods",
                                   "reductions",
                                   "notes",
                                   "seconds"}));
  EXPECT_EQ(summary["otherMethods"].size(), 3U);
  EXPECT_EQ(summary["label"]["file"], "labels.mha");
  EXPECT_EQ(summary["parameters"]["sampling"], "paper");
  std::map<std::string, std::map<std::string, std::string>> rows;
  for (const auto& row : namedRows(bytesOf(lab() / "models.csv"))) {
    rows[row.at("model")] = row;
  }
  for (const auto& [key, role] : {std::pair("bestPsr", "bestPsr"),
                                  {"bestMcsd", "bestMcsd"},
                                  {"bestOfAll", "bestOfAll"},
                                  {"mostSimilarMcsd", "mostSimilar"},
                                  {"bestSimplified", "bestSimplified"},
                                  {"bestOther", "bestOther"}}) {
    const auto& row = rows.at(summary[key]["model"].get<std::string>());
    EXPECT_NE((" " + row.at("roles") + " ").find(std::string(" ") + role + " "), std::string::npos) << role;
    EXPECT_EQ(summary[key]["paperErrorMm"]["mean"], std::stod(row.at("meanErrorMm")));
  }
  const Json& reduction = summary["reductions"]["mostSimilarMcsd"];
  EXPECT_NEAR(reduction["fewerTrianglesPercent"].get<double>(),
              100 * (1 - summary["bestPsr"]["triangles"].get<double>() / summary["mostSimilarMcsd"]["triangles"].get<double>()),
              1e-9);
  std::set<std::string> front;
  for (const auto& [model, row] : rows) {
    if (row.at("pareto") == "1" && (row.at("family") == "psr" || row.at("family") == "mcsd")) {
      front.insert(model);
    }
  }
  EXPECT_EQ(summary["paretoFront"].get<std::set<std::string>>(), front);
}

TEST_F(CliEvaluate, TheReportIsOneFileWithEveryTableAndTwoPictures) {
  const std::string html = bytesOf(lab() / "report.html");
  for (const char* part :
       {"Objective score", "Best and most similar models", "Mean Gaussian curvature", "Processing time",
        "Distribution of the error", "Accuracy and complexity", "too small for depth 8", "Other methods", "Ohtake"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  const auto count = [&](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = html.find(word); at != std::string::npos; at = html.find(word, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("<svg"), 2U);
  for (const char* element : {"section", "table", "tr", "td", "svg", "text", "div", "p", "details"}) {
    EXPECT_EQ(count(std::string("<") + element + ">") + count(std::string("<") + element + " "),
              count(std::string("</") + element + ">"))
        << element;
  }
  for (const char* outside : {"http:", "https:", "src=", "@import", "url(", "nan", "inf "}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
}

TEST_F(CliEvaluate, ARunOnOneThreadElsewhereWritesTheSameBytesTimesAside) {
  const TemporaryFolder folder;
  const Finished finished = evaluate(labels(), folder / "again", {"--threads", "1"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  EXPECT_NE(finished.out.find("69 made, 0 kept"), std::string::npos) << finished.out;
  expectSameResults(folder.path() / "again", lab());
}

TEST_F(CliEvaluate, GoesOnWhereItStoppedAndMakesOnlyWhatIsMissing) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "lab";
  fs::copy(lab(), copy, fs::copy_options::recursive);
  const std::set<std::string> lost{"psr_d5.json", "mcsd_s45_e30.json", "mcsd_s90_e90.json", "simplified_32.json", "mpu_e0.01.json"};
  std::map<std::string, std::string> kept;
  for (const auto& entry : fs::directory_iterator(copy / "models")) {
    const std::string name = entry.path().filename().string();
    if (!lost.contains(name)) {
      kept[name] = bytesOf(entry.path());
    }
  }
  for (const std::string& name : lost) {
    ASSERT_TRUE(fs::remove(copy / "models" / name)) << name;
  }
  std::ofstream(copy / "models/mcsd_s0_e0.json") << "{\"key\": \"half a file";
  std::ofstream(copy / "models/.mcsd_s0_e10.json.123.tmp") << "half a file";
  kept.erase("mcsd_s0_e0.json");
  for (const char* result : {"models.csv", "summary.json", "report.html"}) {
    fs::remove(copy / result);
  }
  const Finished finished = evaluate(labels(), copy.string() + "/");
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  EXPECT_NE(finished.out.find("6 made, 63 kept"), std::string::npos) << finished.out;
  expectSameResults(copy, lab());
  for (const auto& [name, bytes] : kept) {
    EXPECT_EQ(bytesOf(copy / "models" / name), bytes) << name;
  }
  EXPECT_EQ(namesIn(copy), namesIn(lab()));
}

TEST_F(CliEvaluate, WithoutOtherMethodsThePublishedModelsAreTheSame) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "lab";
  fs::copy(lab(), copy, fs::copy_options::recursive);
  const Finished none = evaluate(labels(), copy.string(), {"--methods", "none"});
  ASSERT_EQ(none.exitCode, 0) << none.err;
  EXPECT_NE(none.out.find("0 made, 58 kept"), std::string::npos) << none.out;
  const auto with = namedRows(bytesOf(lab() / "models.csv"));
  const auto without = namedRows(bytesOf(copy / "models.csv"));
  ASSERT_EQ(without.size(), 58U);
  for (std::size_t n = 0; n < without.size(); ++n) {
    for (const char* column : {"model", "meanErrorMm", "score", "pareto", "roles"}) {
      EXPECT_EQ(without[n].at(column), with[n].at(column)) << without[n].at("model");
    }
  }
  EXPECT_EQ(bytesOf(copy / "report.html").find("Other methods"), std::string::npos);
  EXPECT_EQ(Json::parse(bytesOf(copy / "summary.json"))["bestOther"], nullptr);
  const Finished one = evaluate(labels(), copy.string(), {"--methods", "vessels,mpu"});
  EXPECT_NE(one.out.find("0 made, 64 kept"), std::string::npos) << one.out;
}

TEST_F(CliEvaluate, ASecondRunInOneFolderIsRefusedAndTakesNothingFromTheFirst) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "lab";
  fs::copy(lab(), copy, fs::copy_options::recursive);
  std::ofstream(copy / "models/.mcsd_s0_e10.json.123.tmp") << "half a file of the first run";
  const Keys before = namesIn(copy);
  {
    const FileLock first(copy / "models");
    ASSERT_TRUE(first.isWriter());
    expectRefusal(evaluate(labels(), copy.string()), 3, "another evaluate is at work in");
    EXPECT_EQ(namesIn(copy), before);
  }
  EXPECT_EQ(evaluate(labels(), copy.string()).exitCode, 0);
  EXPECT_EQ(namesIn(copy), namesIn(lab()));
}

TEST_F(CliEvaluate, AFinishedRunRepeatedWritesTheSameBytesTimesAndAll) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "lab";
  fs::copy(lab(), copy, fs::copy_options::recursive);
  ASSERT_EQ(evaluate(labels(), copy.string()).exitCode, 0);
  for (const std::string& name : namesIn(lab())) {
    if (fs::is_regular_file(lab() / name)) {
      EXPECT_EQ(bytesOf(copy / name), bytesOf(lab() / name)) << name;
    }
  }
}

TEST_F(CliEvaluate, StoredModelsOfOtherParametersDoNotCount) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "lab";
  fs::copy(lab(), copy, fs::copy_options::recursive);
  const Finished finished = evaluate(labels(), copy.string(), {"--as-published"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  EXPECT_NE(finished.out.find("69 made, 0 kept"), std::string::npos) << finished.out;
  EXPECT_EQ(Json::parse(bytesOf(copy / "summary.json"))["parameters"]["scale"], 1.25);
  EXPECT_NE(modelsWithoutTimes(copy), modelsWithoutTimes(lab()));
}

TEST_F(CliEvaluate, TextsFromTheInputAreEscapedInTheReport) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "masks");
  std::string values(12 * 12 * 12, '\0');
  for (int n = 0; n < 12 * 12 * 12; ++n) {
    const auto inner = [](int at) { return at > 1 && at < 10; };
    values[static_cast<std::size_t>(n)] = inner(n % 12) && inner(n / 12 % 12) && inner(n / 144) ? '\1' : '\0';
  }
  writeLabels(fs::path(folder / "masks") / "a<b>&c.mha", {12, 12, 12}, values);
  const Finished finished =
      cli({"evaluate", folder / "masks", "--labels", "a<b>&c=tumour", "--structure", "a<b>&c", "-o", folder / "lab"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const std::string html = bytesOf(folder / "lab/report.html");
  EXPECT_NE(html.find("a&lt;b&gt;&amp;c"), std::string::npos);
  EXPECT_EQ(html.find("a<b>"), std::string::npos);
}

TEST_F(CliEvaluate, RefusesByNameAndWritesNothing) {
  const TemporaryFolder folder;
  expectRefusal(evaluate(labels(), folder / "lab", {"--label", "2"}), 3, "no surface to measure errors from");
  expectRefusal(evaluate(labels(), folder / "lab", {"--label", "7"}), 2, "--label 7 names no structure");
  expectRefusal(evaluate(labels(), folder / "lab", {"--threads", "-1"}), 2, "--threads");
  expectRefusal(evaluate(labels(), folder / "lab", {"--sampling", "dense"}), 2, "--sampling");
  expectRefusal(evaluate(labels(), folder / "lab", {"--methods", "magic"}), 2, "\"magic\"; choose");
  expectRefusal(evaluate(labels(), folder / "lab", {"--methods", ""}), 2, "--methods");
  expectRefusal(evaluate(labels(), folder / "missing/lab"), 3, "missing");
  expectRefusal(evaluate(folder / "nothing.mha", folder / "lab"), 3, "nothing.mha");
  expectRefusal(cli({"evaluate", labels(), "--label", "1"}), 2, "--output");
  EXPECT_EQ(namesIn(folder.path()), Keys{});
  expectRefusal(evaluate(labels(), labels()), 2, "is a file");
}

TEST_F(CliEvaluate, RefusesAnEmptyLabel) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "masks");
  writeLabels(fs::path(folder / "masks") / "liver.mha", {4, 4, 4}, std::string(64, '\1'));
  writeLabels(fs::path(folder / "masks") / "tumour.mha", {4, 4, 4}, std::string(64, '\0'));
  const Keys before = namesIn(folder.path());
  expectRefusal(cli({"evaluate", folder / "masks", "--structure", "tumour", "-o", folder / "lab"}), 3, "tumour");
  EXPECT_EQ(namesIn(folder.path()), before);
}

TEST_F(CliEvaluate, AMeshIsNotMeasuredAgainstALabelWithoutASurface) {
  const TemporaryFolder folder;
  std::ofstream(folder / "mesh.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  fs::create_directory(folder / "masks");
  writeLabels(fs::path(folder / "masks") / "liver.mha", {4, 4, 4}, std::string(64, '\1'));
  writeLabels(fs::path(folder / "masks") / "tumour.mha", {4, 4, 4}, std::string(64, '\0'));
  const Keys empty{"measure", folder / "mesh.obj", "--reference", folder / "masks", "--structure", "tumour"};
  expectRefusal(cli(empty), 3, "there is no surface to measure errors from");
}

TEST(CliEvaluateInterrupt, KeepsWhatIsDoneAndWritesNoTables) {
  const TemporaryFolder folder;
  const Finished finished =
      runProgram("glisson-cli", {"evaluate", sampleSegmentation(), "--structure", "parenchyma", "-o", folder / "lab"}, {}, 1.0);
  expectRefusal(finished, 130, "interrupted");
  for (const std::string& name : namesIn(folder.path())) {
    EXPECT_TRUE(name == "lab" || name == "lab/models" || (name.starts_with("lab/models/") && name.ends_with(".json"))) << name;
  }
}

TEST(CliEvaluateRealData, ATumourOfIrcadbHasEveryMcsdModelAndOneOfEachOtherMethod) {
  const auto masks = unpackedIrcadb01Masks();
  if (!masks) {
    GTEST_SKIP() << "skipped: no real data";
  }
  const TemporaryFolder folder;
  const Finished finished =
      cli({"evaluate", (masks->path() / "MASKS_DICOM").string(), "--structure", "livertumor01", "-o", folder / "lab"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  int mcsd = 0;
  std::set<std::string> others;
  for (const auto& row : namedRows(bytesOf(folder.path() / "lab/models.csv"))) {
    if (row.at("failure").empty()) {
      mcsd += row.at("family") == "mcsd" ? 1 : 0;
      others.insert(row.at("family") == "other" ? row.at("method") : "");
    }
  }
  EXPECT_EQ(mcsd, 50);
  EXPECT_EQ(others, (std::set<std::string>{"", "psr_knn", "mpu", "vessels"}));
}

}  // namespace
}  // namespace glisson::test
