// A cohort on a cluster, without one: `submit` of installer/slurm with an sbatch that runs at once what Slurm would run later.

#include <array>
#include <cstdlib>

#include "tests/app/cli/evaluated_labels.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

/// Takes what `submit` hands in, runs the script for each task of the array but the one in LOSE, and prints a job's number.
constexpr const char* kSbatch = R"(#!/bin/bash
set -euo pipefail
echo "$*" >> "$CALLS"
array="" log=""
while [[ $1 == --* ]]; do
  case $1 in
    --array=*) array=${1#*=} ;;
    --output=*) log=${1#*=} ;;
  esac
  shift
done
if [[ -z $array ]]; then
  bash "$@" > "$log" 2>&1 || true
  echo 42
  exit
fi
for task in $(seq "${array%-*}" "${array#*-}"); do
  [[ $task == "${LOSE:-}" ]] || SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=1 bash "$@" > "${log/\%a/$task}" 2>&1 || true
done
echo 41
)";

class CliSlurm : public testing::Test {
 protected:
  void SetUp() override {
    ellipsoidAndSpeck(folder_ / "labels.mha", 0.5);
    std::ofstream(folder_ / "list.csv") << "name,segmentation,label\nP1,labels.mha,1\nspeck,labels.mha,2\nP3,labels.mha,1\n";
    fs::create_directory(folder_ / "bin");
    std::ofstream(folder_ / "bin/sbatch") << kSbatch;
    fs::permissions(folder_ / "bin/sbatch", fs::perms::owner_all);
  }
  /// Its exit code; what it says is in `said`, on both streams.
  int submit(const std::string& arguments, const std::string& lost = {}) const {
    const std::string command = "cd '" + folder_.path().string() + "' && PATH=\"$PWD/bin:$PATH\" CALLS=\"$PWD/calls\" LOSE='" +
                                lost + "' GLISSON_CLI='" + programFolder() + "/glisson-cli' bash '" + sourceFolder() +
                                "/installer/slurm/submit' " + arguments + " > said 2>&1";
    const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe)
    return WEXITSTATUS(status);
  }
  [[nodiscard]] std::string textOf(const std::string& file) const { return bytesOf(folder_ / file); }

  const TemporaryFolder folder_;
};

TEST_F(CliSlurm, ALostTaskIsNamedByTheGatheringJobAndRunAgainAlone) {
  const std::string flags = " list.csv lab --labels 1=tumour,2=cyst";
  ASSERT_EQ(submit(flags, "3"), 0) << textOf("said");
  EXPECT_NE(textOf("said").find("tasks 1-3: job 41; gather: job 42"), std::string::npos) << textOf("said");
  const std::string calls = textOf("calls");
  EXPECT_NE(calls.find("--array=1-3"), std::string::npos) << calls;
  EXPECT_NE(calls.find("--dependency=afterany:41"), std::string::npos) << calls;
  EXPECT_NE(textOf("lab/logs/task_2.log").find("speck (line 3 of list.csv)"), std::string::npos) << textOf("lab/logs/task_2.log");
  const std::string gather = textOf("lab/logs/gather.log");
  EXPECT_NE(gather.find("speck (line 3 of list.csv): "), std::string::npos) << gather;
  EXPECT_NE(gather.find("P3 (line 4 of list.csv) has no result with these parameters; run it again with --task 3"),
            std::string::npos)
      << gather;
  EXPECT_NE(gather.find("1 of 3 patients evaluated, 1 failed, 1 without a result"), std::string::npos) << gather;

  ASSERT_EQ(submit("--tasks 3" + flags), 0) << textOf("said");
  EXPECT_NE(textOf("lab/logs/gather.log").find("2 of 3 patients evaluated, 1 failed, 0 without a result"), std::string::npos)
      << textOf("lab/logs/gather.log");
  EXPECT_NE(textOf("calls").find("--array=3 "), std::string::npos) << textOf("calls");
}

TEST_F(CliSlurm, TheUsersThreadsHoldBeforeThoseOfTheTask) {
  ASSERT_EQ(submit("--tasks 2-2 list.csv lab --labels 1=tumour,2=cyst --threads 4"), 0) << textOf("said");
  const std::string log = textOf("lab/logs/task_2.log");
  EXPECT_EQ(log.rfind("glisson-cli: speck (line 3 of list.csv): ", 0), 0U) << log;
}

TEST_F(CliSlurm, AMistypedFlagIsToldBeforeAnythingIsHandedIn) {
  EXPECT_EQ(submit("list.csv lab --methods magic"), 2);
  EXPECT_NE(textOf("said").find("\"magic\""), std::string::npos) << textOf("said");
  EXPECT_EQ(submit("list.csv lab --as-publshed"), 2);
  EXPECT_EQ(submit("list.csv lab -o elsewhere"), 2);
  EXPECT_FALSE(fs::exists(folder_ / "calls"));
  EXPECT_FALSE(fs::exists(folder_ / "lab"));
}

TEST_F(CliSlurm, AFaultyListIsToldBeforeAnythingIsHandedIn) {
  std::ofstream(folder_ / "list.csv") << "name,segmentation\nP1,labels.mha\nP1,labels.mha\n";
  EXPECT_EQ(submit("list.csv lab"), 3);
  EXPECT_NE(textOf("said").find("line 3: the name P1 stands in line 2 already"), std::string::npos) << textOf("said");
  EXPECT_EQ(submit("list.csv"), 2);
  EXPECT_EQ(submit("--tasks 1"), 2);
  EXPECT_FALSE(fs::exists(folder_ / "calls"));
  EXPECT_FALSE(fs::exists(folder_ / "lab"));
}

}  // namespace
}  // namespace glisson::test
