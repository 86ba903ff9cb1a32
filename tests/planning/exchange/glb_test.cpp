// Hazard H7: wrong frame, unit or colour in a GLB.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/glb_reader.h"
#include "planning/exchange/mesh_files.h"
#include "planning/exchange/tiny_gltf_config.h"
#include "reconstruction/errors.h"
#include "tests/planning/exchange/bodies.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/support/paths.h"

namespace glisson {
namespace {

using test::Scratch;

std::vector<NamedMesh> threeMeshes() {
  SurfaceMesh open = test::asymmetricBody(1);
  open.triangles.resize(open.triangles.size() / 2);
  return {{"parenchyma", "Leber (ganz) \xC3\xA4", {221, 130, 101}, 0.35, test::asymmetricBody(3)},
          {"portal_vein", "Portal vein", {150, 90, 200}, 1.0, test::sphere(Vec3(-100, 60, 1000), 5, 2)},
          {"resection_surface_01", "\xFF\xFE not UTF-8", {255, 255, 0}, 1.0, open}};
}

tinygltf::Model loadedByTheLibrary(const std::string& bytes) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  EXPECT_TRUE(loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                          static_cast<unsigned int>(bytes.size())))
      << error;
  EXPECT_EQ(error + warning, "");
  return model;
}

TEST(Glb, RootMatrixTakesMillimetresLpsToMetresYUp) {
  const Scratch scratch;
  writeGlb(threeMeshes(), scratch.path / "m.glb");
  const std::string bytes = readWholeFile(scratch.path / "m.glb");
  const GlbContent content = parseGlb(bytes, "m.glb");
  EXPECT_LE((toScene(content.rootMatrix, Vec3(0, 0, 1000)) - Vec3(0, 1, 0)).norm(), 1e-12);
  EXPECT_LE((toScene(content.rootMatrix, Vec3(0, -1000, 0)) - Vec3(0, 0, 1)).norm(), 1e-12);
  EXPECT_LE((toScene(content.rootMatrix, Vec3(1000, 0, 0)) - Vec3(1, 0, 0)).norm(), 1e-12);
  const std::vector<double> expected{0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1};
  const tinygltf::Model model = loadedByTheLibrary(bytes);
  EXPECT_EQ(model.nodes.at(static_cast<std::size_t>(model.scenes.at(0).nodes.at(0))).matrix, expected);
}

TEST(Glb, NodesCarryIdNameColourAndOpacity) {
  const Scratch scratch;
  writeGlb(threeMeshes(), scratch.path / "m.glb");
  const GlbContent content = parseGlb(readWholeFile(scratch.path / "m.glb"), "m.glb");
  ASSERT_EQ(content.nodes.size(), 3U);
  EXPECT_EQ(content.nodes[0].id, "parenchyma");
  EXPECT_EQ(content.nodes[0].alphaMode, "BLEND");
  EXPECT_NEAR(content.nodes[0].baseColour[3], 0.35, 1e-12);
  EXPECT_EQ(content.nodes[1].alphaMode, "OPAQUE");
  EXPECT_FALSE(content.nodes[1].doubleSided);
  EXPECT_TRUE(content.nodes[2].doubleSided);
  const auto srgb = [](double linear) {
    return std::lround(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055));
  };
  EXPECT_EQ(srgb(content.nodes[0].baseColour[0]), 221);
  EXPECT_EQ(srgb(content.nodes[0].baseColour[1]), 130);
  EXPECT_EQ(srgb(content.nodes[0].baseColour[2]), 101);
  const tinygltf::Model model = loadedByTheLibrary(readWholeFile(scratch.path / "m.glb"));
  EXPECT_EQ(model.nodes.at(1).extras.Get("name").Get<std::string>(), "Leber (ganz) \xC3\xA4");
  EXPECT_EQ(model.nodes.at(3).extras.Get("name").Get<std::string>(), "__ not UTF-8");
}

TEST(Glb, HoldsAnAsymmetricBodyInPlaceAndUnmirrored) {
  const Scratch scratch;
  const SurfaceMesh body = test::asymmetricBody(3);
  writeMesh({"tumour_01", "Tumour 1", {144, 238, 144}, 1.0, body}, scratch.path / "m.glb");
  const GlbContent content = parseGlb(readWholeFile(scratch.path / "m.glb"), "m.glb");
  const SurfaceMesh& back = content.nodes.at(0).mesh;
  ASSERT_EQ(back.triangles.size(), body.triangles.size());
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LE((body.vertices[body.triangles[i][k]] - back.vertices[back.triangles[i][k]]).norm(), 1e-4);
    }
  }
  EXPECT_NEAR(signedVolumeMm3(back) / signedVolumeMm3(body), 1.0, 1e-6);
}

TEST(Glb, EveryChangedByteIsReadOrRefusedButNeverCrashes) {
  const Scratch scratch;
  writeMesh({"tumour_01", "Tumour 1", {144, 238, 144}, 1.0, test::asymmetricBody(0)}, scratch.path / "m.glb");
  const std::string bytes = readWholeFile(scratch.path / "m.glb");
  std::size_t refused = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x41);
    try {
      parseGlb(changed, "m.glb");
    } catch (const InputError&) {
      ++refused;
    }
    EXPECT_THROW(parseGlb(std::string_view(bytes).substr(0, at), "m.glb"), InputError);
  }
  EXPECT_GT(refused, 100U);
}

TEST(Glb, AnEmptyMeshIsRefusedByName) {
  const Scratch scratch;
  try {
    writeGlb({{"cyst_01", "Cyst", {1, 2, 3}, 1.0, {}}}, scratch.path / "m.glb");
    FAIL() << "an empty mesh was written";
  } catch (const PlanningError& error) {
    EXPECT_NE(std::string(error.what()).find("cyst_01"), std::string::npos);
  }
  EXPECT_EQ(scratch.entries(), 0U);
}

TEST(Glb, PassesTheKhronosValidatorWithoutErrorsAndWarnings) {
  const char* modules = std::getenv("GLISSON_NODE_MODULES");
  const std::string folder = modules != nullptr ? modules : test::sourceFolder() + "/build/node/node_modules";
  if (!std::filesystem::exists(folder + "/gltf-validator") || std::system("command -v node > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "skipped: no gltf-validator in \"" << folder << "\" or no node";
  }
  const Scratch scratch;
  writeGlb(threeMeshes(), scratch.path / "m.glb");
  const std::string output = (scratch.path / "out.txt").string();
  const std::string command = "GLISSON_NODE_MODULES='" + folder + "' node '" + test::sourceFolder() +
                              "/tests/support/gltf_validate.mjs' '" + (scratch.path / "m.glb").string() + "' > '" + output +
                              "' 2>&1";
  const int status = std::system(command.c_str());
  EXPECT_EQ(status, 0) << readWholeFile(output);
  EXPECT_NE(readWholeFile(output).find("0 errors, 0 warnings"), std::string::npos) << readWholeFile(output);
}

}  // namespace
}  // namespace glisson
