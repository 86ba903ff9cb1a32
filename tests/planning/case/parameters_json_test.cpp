#include "planning/case/parameters_json.h"

#include <gtest/gtest.h>

#include "reconstruction/errors.h"

namespace glisson {
namespace {

ReconstructionParameters psr(int depth) {
  ReconstructionParameters p;
  p.psr = {.depth = depth, .sampling = Sampling::Paper, .pointWeight = 0.1, .scale = 1.25};
  return p;
}

TEST(ParametersJson, EverySetOfParametersComesBackAsItWas) {
  std::vector<ReconstructionParameters> sets{{}, psr(5), psr(10), psr(7), psr(7)};
  sets[3].autoDepth = true;
  sets[3].simplify = SimplifyTarget{.distanceMm = 0.1};
  sets[4].simplify = SimplifyTarget{.triangles = 10000};
  ReconstructionParameters mcsd;
  mcsd.method = Method::Mcsd;
  mcsd.mcsd = {.smoothing = 22,
               .filter = SmoothingFilter::Laplacian,
               .decimation = 0.1 + 0.2,
               .order = McsdOrder::SmoothFirst,
               .splitNormals = true};
  sets.push_back(mcsd);
  ReconstructionParameters listed = psr(7);
  listed.method = Method::Listed;
  listed.listedMethod = "psr_knn";
  listed.listedVariant = "d6";
  sets.push_back(listed);
  for (const ReconstructionParameters& p : sets) {
    // As text, since that is what a case file holds.
    const auto back = parametersFromJson(Json::parse(parametersJson(p).dump()));
    EXPECT_EQ(back.describe(), p.describe());
    EXPECT_EQ(back.autoDepth, p.autoDepth);
    EXPECT_EQ(back.mcsd.decimation, p.mcsd.decimation);
    EXPECT_EQ(parametersJson(back), parametersJson(p));
  }
  EXPECT_EQ(usedParametersJson(sets[3])["depth"], "auto");
  EXPECT_EQ(usedParametersJson(sets[4])["depth"], 7);
}

TEST(ParametersJson, AListedMethodIsNamedByItsIdAndAnUnknownOneIsRefused) {
  ReconstructionParameters listed;
  listed.method = Method::Listed;
  listed.listedMethod = "mpu";
  listed.listedVariant = "e0.01";
  EXPECT_EQ(usedParametersJson(listed).dump(),
            R"({"method":"mpu","variant":"e0.01","sampling":"unbiased","scale":1.1,"simplify":null})");
  auto json = parametersJson(listed);
  json["method"] = "magic";
  EXPECT_THROW(parametersFromJson(json), UsageError);
  json["method"] = "mpu";
  json["variant"] = "d6";
  EXPECT_THROW(parametersFromJson(json), UsageError);
}

TEST(ParametersJson, ADepthThatIsNoneIsRefused) {
  auto json = parametersJson({});
  json["depth"] = 11;
  EXPECT_THROW(parametersFromJson(json), UsageError);
  json["depth"] = 0;
  EXPECT_THROW(parametersFromJson(json), UsageError);
  json["depth"] = "deep";
  EXPECT_THROW(parametersFromJson(json), Json::exception);
}

}  // namespace
}  // namespace glisson
