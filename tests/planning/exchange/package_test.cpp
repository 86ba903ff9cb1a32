// Hazards H3 (wrong volume), H5, H7 (wrong frame in an export), H8 (identity leaks), and exports that must be whole or not there.
#include "planning/exchange/package.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/glb_reader.h"
#include "planning/exchange/mesh_files.h"
#include "planning/exchange/pseudonym.h"
#include "planning/exchange/version.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/parallel.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/exchange/synthetic_case.h"
#include "tests/support/paths.h"

namespace glisson {
namespace {

using test::Scratch;
using test::stamped;
using test::syntheticCase;
template <typename Refusal>
std::string messageOf(const Case& source, const std::filesystem::path& directory, const ExportOptions& options) {
  try {
    exportPackage(source, directory, options);
  } catch (const Refusal& error) {
    return error.what();
  }
  return "(exported)";
}

TEST(Package, HoldsStructuresRemnantResectedPartAndSurfaceAndPassesItsCheck) {
  const Scratch scratch;
  const ExportResult result = exportPackage(syntheticCase(), scratch.path, stamped());
  EXPECT_EQ(result.folder.filename(), "G-00C0DE_Left-plan_20260102-0304");
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(result.folder)) {
    files.insert(entry.path().filename().string());
  }
  EXPECT_EQ(files, (std::set<std::string>{"parenchyma.stl", "tumour_01.stl", "portal_vein.stl", "remnant.stl", "resected_01.stl",
                                          "resection_surface_01.stl", "model.glb", "plan.json", "manifest.json"}));
  EXPECT_EQ(std::set<std::string>(result.files.begin(), result.files.end()), files);
  EXPECT_EQ(verifyPackage(result.folder), std::vector<std::string>{});
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST(Package, VesselsAndTumoursAreSeenThroughTheRemnantAndTheResectedPartAsThroughTheLiver) {
  const Scratch scratch;
  Case source = syntheticCase();
  auto model = std::make_shared<LiverModel>(*source.model);
  for (Structure& structure : model->structures) {
    structure.opacity = structure.kind == StructureKind::Liver ? 0.35 : 1.0;
  }
  source.model = model;
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const GlbContent content = parseGlb(readWholeFile(folder / "model.glb"), "model.glb");
  std::size_t translucent = 0;
  for (const GlbNode& node : content.nodes) {
    const bool ofLiver = node.id == "parenchyma" || node.id == "remnant" || node.id == "resected_01";
    translucent += ofLiver ? 1 : 0;
    EXPECT_NEAR(node.baseColour[3], ofLiver ? 0.35 : 1.0, 1e-6) << node.id;
    EXPECT_EQ(node.alphaMode, ofLiver ? "BLEND" : "OPAQUE") << node.id;
  }
  EXPECT_EQ(translucent, 3U);
}

TEST(Package, PartsAddUpToTheLiverAndTheSurfaceLiesOnThePlaneFacingTheResectedSide) {
  const Scratch scratch;
  const std::filesystem::path folder = exportPackage(syntheticCase(), scratch.path, stamped()).folder;
  const SurfaceMesh whole = readMesh(folder / "parenchyma.stl");
  const SurfaceMesh remnant = readMesh(folder / "remnant.stl");
  const SurfaceMesh resected = readMesh(folder / "resected_01.stl");
  const SurfaceMesh surface = readMesh(folder / "resection_surface_01.stl");
  EXPECT_FALSE(remnant.defects().any());
  EXPECT_FALSE(resected.defects().any());
  EXPECT_NEAR(signedVolumeMm3(remnant) + signedVolumeMm3(resected), signedVolumeMm3(whole), 1e-5 * signedVolumeMm3(whole));
  // A sphere's cap of height h: pi h^2 (R - h/3); the polyhedron is 0.5 % smaller.
  const double h = test::kLiverRadiusMm - 3;
  const double cap = std::numbers::pi * h * h * (test::kLiverRadiusMm - h / 3);
  EXPECT_NEAR(signedVolumeMm3(resected) / cap, 1.0, 0.01);
  EXPECT_LT(boundsOf(resected).high.x(), test::kLiverCentre.x() - 2.999);
  EXPECT_GT(boundsOf(remnant).low.x(), test::kLiverCentre.x() - 3.001);
  const double r2 = test::kLiverRadiusMm * test::kLiverRadiusMm - 9;
  EXPECT_NEAR(areaMm2(surface) / (std::numbers::pi * r2), 1.0, 0.01);
  EXPECT_GT(surface.defects().openEdges, 0U);
  for (const Triangle& t : surface.triangles) {
    const Vec3 normal = (surface.vertices[t[1]] - surface.vertices[t[0]]).cross(surface.vertices[t[2]] - surface.vertices[t[0]]);
    ASSERT_LE(normal.x(), 1e-9);
    ASSERT_NEAR(surface.vertices[t[0]].x(), test::kLiverCentre.x() - 3, 1e-4);
  }
}

TEST(Package, PlanJsonStatesFrameAxesUnitsPlanesVolumesVersionAndHashes) {
  const Scratch scratch;
  Case source = syntheticCase();
  source.identity.frameOfReferenceUid = "1.2.840.99.1";
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const Json plan = Json::parse(readWholeFile(folder / "plan.json"));
  EXPECT_EQ(plan.at("frameOfReferenceUid"), "1.2.840.99.1");
  EXPECT_EQ(plan.at("axes"), "LPS");
  EXPECT_EQ(plan.at("units"), "mm");
  EXPECT_EQ(plan.at("version"), std::string(glissonVersion()));
  EXPECT_FALSE(plan.contains("patientId"));
  const Json& plane = plan.at("resections").at(0).at("planes").at(0);
  EXPECT_EQ(plane.at("originMm").get<std::vector<double>>(), (std::vector<double>{-53, -20, 300}));
  EXPECT_EQ(plane.at("normalToResectedSide").at(0).get<double>(), -1.0);
  const Json& numbers = plan.at("assessment");
  EXPECT_NEAR(numbers.at("resectedMl").get<double>() + numbers.at("remnantMl").get<double>(), numbers.at("totalMl").get<double>(),
              1e-9);
  EXPECT_EQ(numbers.at("tumours").at(0).at("name"), "tumour_01");
  EXPECT_EQ(plan.at("structures").size(), 3U);
  const Json& liver = plan.at("structures").at(0);
  EXPECT_EQ(liver.at("parameters").at("method"), "psr");
  for (const char* key : {"depth", "usedDepth", "sampling", "pointWeight", "scale"}) {
    EXPECT_TRUE(liver.at("parameters").contains(key)) << key;
  }
  EXPECT_EQ(liver.at("parameters").at("scale").get<double>(), PoissonParameters{}.scale);
  EXPECT_EQ(liver.at("volumeDeviationPercent").get<double>(), 0.0);
  EXPECT_TRUE(liver.at("notes").is_array());
  const Json& vein = plan.at("structures").at(2).at("parameters");
  EXPECT_EQ(vein.at("method"), "mcsd");
  for (const char* key : {"smoothing", "filter", "decimation", "order"}) {
    EXPECT_TRUE(vein.contains(key)) << key;
  }
  EXPECT_FALSE(vein.contains("depth"));
  std::size_t hashed = 0;
  for (const Json& file : plan.at("files")) {
    EXPECT_EQ(file.at("sha256").get<std::string>(), sha256HexOfFile(folder / file.at("file").get<std::string>()));
    ++hashed;
  }
  EXPECT_EQ(hashed, 7U);
}

TEST(Package, ItsModelPassesTheKhronosValidatorWithoutErrorsAndWarnings) {
  const char* modules = std::getenv("GLISSON_NODE_MODULES");
  const std::string validator = modules != nullptr ? modules : test::sourceFolder() + "/build/node/node_modules";
  if (!std::filesystem::exists(validator + "/gltf-validator") || std::system("command -v node > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "skipped: no gltf-validator in \"" << validator << "\" or no node";
  }
  const Scratch scratch;
  const std::filesystem::path folder = exportPackage(syntheticCase(), scratch.path, stamped()).folder;
  const std::string output = (scratch.path / "out.txt").string();
  const std::string command = "GLISSON_NODE_MODULES='" + validator + "' node '" + test::sourceFolder() +
                              "/tests/support/gltf_validate.mjs' '" + (folder / "model.glb").string() + "' > '" + output + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << readWholeFile(output);
  EXPECT_NE(readWholeFile(output).find("0 errors, 0 warnings"), std::string::npos) << readWholeFile(output);
}

TEST(Package, WithoutAFrameOfReferenceItSaysNone) {
  const Scratch scratch;
  const std::filesystem::path folder = exportPackage(syntheticCase(), scratch.path, stamped()).folder;
  EXPECT_EQ(Json::parse(readWholeFile(folder / "plan.json")).at("frameOfReferenceUid"), "none");
}

TEST(Package, AnotherExportOfTheSameMinuteGetsItsOwnFolder) {
  const Scratch scratch;
  const ExportResult first = exportPackage(syntheticCase(), scratch.path, stamped());
  const ExportResult second = exportPackage(syntheticCase(), scratch.path, stamped());
  EXPECT_EQ(second.folder.filename().string(), first.folder.filename().string() + "_2");
  EXPECT_EQ(verifyPackage(first.folder), std::vector<std::string>{});
  EXPECT_EQ(readWholeFile(first.folder / "manifest.json"), readWholeFile(second.folder / "manifest.json"));
}

TEST(Package, APlanWithoutResectionExportsTheStructuresOnly) {
  const Scratch scratch;
  Case source = syntheticCase();
  source.plans.front().resections.clear();
  const ExportResult result = exportPackage(source, scratch.path, stamped());
  EXPECT_FALSE(std::filesystem::exists(result.folder / "remnant.stl"));
  EXPECT_TRUE(std::filesystem::exists(result.folder / "parenchyma.stl"));
  EXPECT_EQ(verifyPackage(result.folder), std::vector<std::string>{});
}

TEST(Package, HoldsOnlyTheFormatsAskedFor) {
  const Scratch scratch;
  ExportOptions options = stamped();
  options.stl = false;
  const std::filesystem::path folder = exportPackage(syntheticCase(), scratch.path, options).folder;
  EXPECT_FALSE(std::filesystem::exists(folder / "parenchyma.stl"));
  EXPECT_EQ(verifyPackage(folder), std::vector<std::string>{});
  options.stl = true;
  options.glb = false;
  const std::filesystem::path other = exportPackage(syntheticCase(), scratch.path, options).folder;
  EXPECT_FALSE(std::filesystem::exists(other / "model.glb"));
  EXPECT_EQ(verifyPackage(other), std::vector<std::string>{});
}

TEST(Package, AWedgeOfTwoPlanesAndASecondResectionStillAddUpToTheLiver) {
  const Scratch scratch;
  Case source = syntheticCase();
  const Vec3 c = test::kLiverCentre;
  source.plans.front().resections = {{"Wedge", {{c - Vec3(3, 0, 0), -Vec3::UnitX()}, {c + Vec3(0, 5, 0), Vec3(-0.6, 0.8, 0)}}},
                                     {"Cap", {{c + Vec3(0, 0.7, 21), Vec3(0, 0.28, 0.96)}}}};
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  EXPECT_EQ(verifyPackage(folder), std::vector<std::string>{});
  double sum = 0;
  std::size_t surfaces = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("remnant") || name.starts_with("resected")) {
      sum += signedVolumeMm3(readMesh(entry.path()));
    }
    surfaces += name.starts_with("resection_surface") ? 1 : 0;
  }
  const double whole = signedVolumeMm3(readMesh(folder / "parenchyma.stl"));
  EXPECT_NEAR(sum, whole, 1e-5 * whole);
  EXPECT_EQ(surfaces, 2U);
}

TEST(Package, WhatAKilledExportLeftIsGoneAfterTheNextOne) {
  const Scratch scratch;
  const Case source = syntheticCase();
  const pid_t child = ::fork();
  if (child == 0) {
    const ThreadLimit alone(1);  // the parent's threads are not in this process
    const ExecutionContext context([](double, std::string_view phase) {
      if (phase == "Writing") {
        ::kill(::getpid(), SIGKILL);
      }
    });
    ExportOptions earlier = stamped();
    earlier.timestamp = "20260102-0300";
    exportPackage(source, scratch.path, earlier, context);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(scratch.entries(), 1U) << "the killed export left nothing, so there is nothing to prove";
  std::filesystem::create_directory(scratch.path / ".mine.tmp");
  exportPackage(source, scratch.path, stamped());
  EXPECT_EQ(scratch.entries(), 2U);
  EXPECT_TRUE(std::filesystem::exists(scratch.path / ".mine.tmp"));
}

TEST(Package, AnExportThatIsStillRunningIsNotTidiedAwayByAnother) {
  const Scratch scratch;
  const Case source = syntheticCase();
  bool done = false;
  const ExecutionContext context([&](double, std::string_view phase) {
    if (phase == "Writing" && !done) {
      done = true;
      exportPackage(source, scratch.path, stamped());
    }
  });
  const ExportResult result = exportPackage(source, scratch.path, stamped(), context);
  EXPECT_TRUE(done);
  EXPECT_EQ(verifyPackage(result.folder), std::vector<std::string>{});
  EXPECT_EQ(scratch.entries(), 2U);
}

TEST(PackageRefusal, NamesTheStructureAndItsDefect) {
  const Scratch scratch;
  Case source = syntheticCase();
  test::replaceStructure(source, "tumour_01", [](Structure&, Reconstruction& made) { made.mesh.triangles.pop_back(); });
  const std::string message = messageOf<CheckFailed>(source, scratch.path, stamped());
  EXPECT_NE(message.find("tumour_01"), std::string::npos) << message;
  EXPECT_NE(message.find("open"), std::string::npos) << message;
  EXPECT_EQ(scratch.entries(), 0U);
}

TEST(PackageRefusal, FindsASelfIntersection) {
  const Scratch scratch;
  Case source = syntheticCase();
  test::replaceStructure(source, "portal_vein", [](Structure&, Reconstruction& made) {
    made.mesh.vertices[0] = test::kLiverCentre - 2.5 * (made.mesh.vertices[0] - test::kLiverCentre);
  });
  const std::string message = messageOf<CheckFailed>(source, scratch.path, stamped());
  EXPECT_NE(message.find("portal_vein"), std::string::npos) << message;
  EXPECT_NE(message.find("self-intersection"), std::string::npos) << message;
}

TEST(PackageRefusal, DeviationsAreNamedWithTheFlagThatAcceptsThem) {
  const Scratch scratch;
  Case source = syntheticCase();
  test::replaceStructure(source, "portal_vein", [](Structure&, Reconstruction& made) { made.deviations = {"volume 3.4 %"}; });
  const std::string message = messageOf<PlanningError>(source, scratch.path, stamped());
  EXPECT_NE(message.find("portal_vein (volume 3.4 %)"), std::string::npos) << message;
  EXPECT_NE(message.find("--accept-deviations"), std::string::npos) << message;
  ExportOptions accepted = stamped();
  accepted.acceptDeviations = true;
  const std::filesystem::path folder = exportPackage(source, scratch.path, accepted).folder;
  EXPECT_NE(readWholeFile(folder / "plan.json").find("volume 3.4 %"), std::string::npos);
}

TEST(PackageRefusal, APlaneThatMissesTheLiverIsSaidSo) {
  const Scratch scratch;
  Case source = syntheticCase();
  source.plans.front().resections.front().planes.front().origin.x() = -200;
  const std::string message = messageOf<PlanningError>(source, scratch.path, stamped());
  EXPECT_NE(message.find("does not divide the liver"), std::string::npos) << message;
  EXPECT_EQ(scratch.entries(), 0U);
}

TEST(PackageRefusal, AnUnbuiltStructureAndAnUnknownPlanAreNamed) {
  const Scratch scratch;
  Case source = syntheticCase();
  ExportOptions options = stamped();
  options.planName = "No such plan";
  EXPECT_NE(messageOf<UsageError>(source, scratch.path, options).find("No such plan"), std::string::npos);
  auto model = std::make_shared<LiverModel>(*source.model);
  model->structures.back().reconstruction.reset();
  source.model = model;
  EXPECT_NE(messageOf<PlanningError>(source, scratch.path, stamped()).find("has not been built"), std::string::npos);
  model = std::make_shared<LiverModel>(*source.model);
  model->structures.erase(model->structures.begin());
  source.model = model;
  EXPECT_NE(messageOf<PlanningError>(source, scratch.path, stamped()).find("no parenchyma"), std::string::npos);
}

TEST(PackageFaults, ADirectoryThatCannotBeMadeOrWrittenIsNamedAndNothingIsLeft) {
  const Scratch scratch;
  std::ofstream(scratch.path / "file") << "x";
  EXPECT_THROW(exportPackage(syntheticCase(), scratch.path / "file", stamped()), InputError);
  EXPECT_THROW(exportPackage(syntheticCase(), scratch.path / "file" / "below", stamped()), InputError);
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST(PackageFaults, AWriteProtectedDirectoryIsNamedAndNothingIsLeft) {
  const Scratch scratch;
  const std::filesystem::path closed = scratch.path / "closed";
  std::filesystem::create_directory(closed);
  ::chmod(scratch.path.c_str(), 0755);
  ::chmod(closed.c_str(), 0555);
  const uid_t user = ::geteuid();
  constexpr uid_t kNobody = 65534;
  ASSERT_TRUE(user != 0 || ::seteuid(kNobody) == 0);  // root may write everywhere
  std::string message;
  try {
    exportPackage(syntheticCase(), closed, stamped());
  } catch (const InputError& error) {
    message = error.what();
  }
  ASSERT_TRUE(user != 0 || ::seteuid(user) == 0);
  EXPECT_NE(message.find("Permission denied"), std::string::npos) << message;
  EXPECT_NE(message.find(closed.string()), std::string::npos) << message;
  EXPECT_TRUE(std::filesystem::is_empty(closed));
}

TEST(PackageFaults, AMissingDirectoryIsMadeAndGoesAgainWhereTheExportFails) {
  const Scratch scratch;
  const ExportResult result = exportPackage(syntheticCase(), scratch.path / "a" / "b", stamped());
  EXPECT_EQ(verifyPackage(result.folder), std::vector<std::string>{});
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small{20000, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(exportPackage(syntheticCase(), scratch.path / "new" / "deep", stamped()), InputError);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
  EXPECT_FALSE(std::filesystem::exists(scratch.path / "new"));
}

TEST(PackageFaults, AtWhateverFileTheDiskFillsUpTheOlderPackageIsIntactAndNothingElseIsThere) {
  const Scratch scratch;
  const ExportResult older = exportPackage(syntheticCase(), scratch.path, stamped());
  std::set<std::uintmax_t> sizes;
  for (const std::string& file : older.files) {
    sizes.insert(std::filesystem::file_size(older.folder / file));
  }
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  for (const std::uintmax_t size : sizes) {
    const rlimit limit{size - 1, old.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    EXPECT_THROW(exportPackage(syntheticCase(), scratch.path, stamped()), InputError);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    EXPECT_EQ(scratch.entries(), 1U);
  }
  EXPECT_EQ(verifyPackage(older.folder), std::vector<std::string>{});
}

TEST(PackageFaults, CancelAtAnyProgressLeavesNothing) {
  const Scratch scratch;
  int steps = 0;
  const ExecutionContext counting([&](double, std::string_view) { ++steps; });
  exportPackage(syntheticCase(), scratch.path / "counted", stamped(), counting);
  ASSERT_GT(steps, 5);
  for (int stop = 1; stop < steps; ++stop) {
    const std::filesystem::path target = scratch.path / "cancelled";
    int seen = 0;
    ExecutionContext* running = nullptr;
    ExecutionContext context([&](double, std::string_view) {
      if (++seen == stop) {
        running->cancel();
      }
    });
    running = &context;
    EXPECT_THROW(exportPackage(syntheticCase(), target, stamped(), context), Cancelled) << stop << " of " << steps;
    EXPECT_FALSE(std::filesystem::exists(target));
  }
}

/// Every text of the source that may hold identity gets its own mark.
Case canaryCase(std::vector<std::string>& canaries) {
  Case source = syntheticCase();
  int number = 0;
  const auto canary = [&](const std::string& shape = "") {
    canaries.push_back("CANARY" + std::to_string(1000 + 37 * number++) + shape);
    return canaries.back();
  };
  source.identity.patientName = canary() + "^" + canary() + "^" + canary();
  source.identity.patientId = canary();
  source.identity.birthDate = "19380417";
  source.identity.studyDate = "20190928";
  canaries.insert(canaries.end(), {"19380417", "20190928"});
  source.identity.seriesDescription = canary();
  source.ctSource = "/data/" + canary() + "/" + canary() + ".nii";
  source.notes = {canary(), canary()};
  auto segmentation = std::make_shared<Segmentation>(*source.segmentation);
  segmentation->source = "/data/" + canary() + "/seg.nrrd";
  segmentation->patientId = canary();
  segmentation->notes = {canary(), canary()};
  for (LabelledMask& mask : segmentation->structures) {
    mask.name = canary();
  }
  source.segmentation = segmentation;
  auto model = std::make_shared<LiverModel>(*source.model);
  for (Structure& structure : model->structures) {
    structure.name = canary(" \xC3\xB6");
  }
  source.model = model;
  auto liver = std::make_shared<LiverVoxels>(*source.liver);
  liver->notes = {canary(), canary()};
  source.liver = liver;
  source.plans.front().name = "Plan for " + canaries[0];
  source.plans.front().resections.front().name = source.identity.patientId + " left";
  return source;
}

std::string allBytes(const std::filesystem::path& folder) {
  std::string bytes = folder.filename().string();
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    bytes += entry.path().filename().string() + readWholeFile(entry.path());
  }
  return bytes;
}

TEST(Package, WhoAcceptedAStructureStandsInPlanJsonAndNobodyIsNull) {
  const Scratch scratch;
  Case source = syntheticCase();
  const Acceptance accepted = acceptedNow("Dr. A");
  source.model = withAcceptance(*source.model, {"tumour_01"}, accepted);
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const Json plan = Json::parse(readWholeFile(folder / "plan.json"));
  EXPECT_TRUE(plan.at("structures").at(0).at("acceptedBy").is_null());
  EXPECT_TRUE(plan.at("structures").at(0).at("acceptedAt").is_null());
  EXPECT_EQ(plan.at("structures").at(1).at("acceptedBy"), "Dr. A");
  EXPECT_EQ(plan.at("structures").at(1).at("acceptedAt"), accepted.at);
  EXPECT_EQ(plan.at("notAccepted"), (Json{"parenchyma", "portal_vein"}));
  EXPECT_EQ(verifyPackage(folder), std::vector<std::string>{});
}

TEST(PackageIdentity, AConsentIsHandedOnWithoutTheFileItWasGivenFor_H2_H8) {
  const Scratch scratch;
  Case source = syntheticCase();
  EXPECT_TRUE(
      Json::parse(readWholeFile(exportPackage(source, scratch.path, stamped()).folder / "plan.json")).at("consents").empty());
  source.notes = {"Left out: series 4.",
                  "Resampled to a regular grid with consent: between doe_1.dcm and doe_2.dcm there are 5 mm.",
                  "Labels of another patient than the CT's were taken with consent (their PatientID differ)."};
  const std::filesystem::path folder = exportPackage(source, scratch.path / "again", stamped()).folder;
  EXPECT_EQ(Json::parse(readWholeFile(folder / "plan.json")).at("consents"),
            (Json{"Resampled to a regular grid with consent",
                  "Labels of another patient than the CT's were taken with consent (their PatientID differ)."}));
}

TEST(PackageIdentity, WordsOfAnAnonymisedNameTakeNoSentenceAway) {
  Case source = syntheticCase();
  source.identity.patientName = "liver_01^patient";
  EXPECT_EQ(pseudonymous("The liver of this patient.", "-", source), "The liver of this patient.");
  EXPECT_EQ(pseudonymous("Plan for liver_01", "-", source), "-");
  source.identity.patientName = "Patient^Jane";
  EXPECT_EQ(pseudonymous("Jane's plan", "-", source), "-");
}

TEST(PackageIdentity, AReviewerWhoBearsThePatientsNameIsNotNamed) {
  const Scratch scratch;
  Case source = syntheticCase();
  source.identity.patientName = "Doe^Jane";
  source.model = withAcceptance(*source.model, {"tumour_01"}, acceptedNow("Dr. Doe"));
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  EXPECT_EQ(Json::parse(readWholeFile(folder / "plan.json")).at("structures").at(1).at("acceptedBy"), "a person");
}

TEST(PackageIdentity, NoCanaryIsInAnyExportedByteOrName) {
  const Scratch scratch;
  std::vector<std::string> canaries;
  const Case source = canaryCase(canaries);
  ASSERT_GE(canaries.size(), 20U);
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const std::string bytes = allBytes(folder);
  for (const std::string& canary : canaries) {
    EXPECT_EQ(bytes.find(canary), std::string::npos) << canary;
  }
}

TEST(PackageIdentity, OnlyThePatientsIdLeavesAndOnlyWhenAsked) {
  const Scratch scratch;
  std::vector<std::string> canaries;
  const Case source = canaryCase(canaries);
  ExportOptions options = stamped();
  options.patientId = true;
  const std::filesystem::path folder = exportPackage(source, scratch.path, options).folder;
  EXPECT_EQ(Json::parse(readWholeFile(folder / "plan.json")).at("patientId"), source.identity.patientId);
  const std::string bytes = allBytes(folder);
  for (const std::string& canary : canaries) {
    EXPECT_EQ(bytes.find(canary) != std::string::npos, canary == source.identity.patientId) << canary;
  }
}

}  // namespace
}  // namespace glisson
