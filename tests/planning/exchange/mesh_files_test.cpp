// Hazards H1 (axis swap), H3 (scale), H7 (wrong frame or unit in an export), H9 (hostile files).
#include "planning/exchange/mesh_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <clocale>
#include <csignal>
#include <cstring>
#include <fstream>

#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"
#include "tests/planning/exchange/bodies.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/support/paths.h"

namespace glisson {
namespace {

using test::asymmetricBody;
using test::Scratch;

NamedMesh named(SurfaceMesh mesh) { return {"tumour_01", "Tumour 1", {144, 238, 144}, 1.0, std::move(mesh)}; }

/// Greatest distance from a corner of `expected` to the same corner of `got`; both hold the same triangles in the same order.
double greatestCornerDistance(const SurfaceMesh& expected, const SurfaceMesh& got) {
  EXPECT_EQ(expected.triangles.size(), got.triangles.size());
  double greatest = 0;
  for (std::size_t i = 0; i < std::min(expected.triangles.size(), got.triangles.size()); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      greatest = std::max(greatest, (expected.vertices.at(expected.triangles[i][k]) - got.vertices.at(got.triangles[i][k])).norm());
    }
  }
  return greatest;
}

class EveryFormat : public testing::TestWithParam<const char*> {};

TEST_P(EveryFormat, BringsAnAsymmetricBodyBackInPlaceAndUnmirrored) {
  const Scratch scratch;
  const SurfaceMesh body = asymmetricBody();
  const auto path = scratch.path / (std::string("body") + GetParam());
  writeMesh(named(body), path);
  const SurfaceMesh back = readMesh(path);
  EXPECT_LE(greatestCornerDistance(body, back), 1e-4);
  EXPECT_FALSE(back.defects().any());
  EXPECT_GT(signedVolumeMm3(back), 0);
  EXPECT_NEAR(signedVolumeMm3(back) / signedVolumeMm3(body), 1.0, 1e-6);
}

TEST_P(EveryFormat, SaysItsSpaceAndAHeaderOfTheOtherSpaceIsTurned) {
  const Scratch scratch;
  const SurfaceMesh body = asymmetricBody(1);
  const auto path = scratch.path / (std::string("body") + GetParam());
  writeMesh(named(body), path);
  std::string bytes = readWholeFile(path);
  const std::size_t at = bytes.find("SPACE=LPS");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 9, "SPACE=RAS");
  writeFileAtomically(path, bytes);
  const SurfaceMesh turned = readMesh(path);
  SurfaceMesh expected = body;
  for (Vec3& v : expected.vertices) {
    v = Vec3(-v.x(), -v.y(), v.z());
  }
  EXPECT_LE(greatestCornerDistance(expected, turned), 1e-4);
}

TEST_P(EveryFormat, IsRefusedWhereverItIsCutOffAndNeverReadPastItsEnd) {
  const Scratch scratch;
  const auto path = scratch.path / (std::string("body") + GetParam());
  const SurfaceMesh body = asymmetricBody(1);
  writeMesh(named(body), path);
  const std::string bytes = readWholeFile(path);
  const bool obj = std::string(GetParam()) == ".obj";
  for (std::size_t cut = 1; cut < 60; ++cut) {
    std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() * cut / 60);
    try {
      const SurfaceMesh read = readMesh(path);
      // An OBJ cut between two lines is a whole, smaller OBJ: its open edges tell.
      EXPECT_TRUE(obj && read.defects().any()) << "cut at " << cut << "/60";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
    }
  }
}

TEST_P(EveryFormat, SurvivesAnyChangedByte) {
  const Scratch scratch;
  const auto path = scratch.path / (std::string("body") + GetParam());
  writeMesh(named(asymmetricBody(0)), path);
  const std::string bytes = readWholeFile(path);
  std::size_t refused = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? 0x80 : 0x11));
    std::ofstream(path, std::ios::binary) << changed;
    try {
      const SurfaceMesh read = readMesh(path);
      for (const Triangle& t : read.triangles) {
        ASSERT_LT(std::max({t[0], t[1], t[2]}), read.vertices.size());
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
}

TEST_P(EveryFormat, KeepsTheOldFileWhereWritingFails) {
  const Scratch scratch;
  const auto path = scratch.path / (std::string("body") + GetParam());
  writeMesh(named(asymmetricBody(0)), path);
  const std::string before = readWholeFile(path);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small{400, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(writeMesh(named(asymmetricBody(3)), path), InputError);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
  EXPECT_EQ(readWholeFile(path), before);
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST_P(EveryFormat, HoldsTheSameBytesInEveryLocale) {
  const Scratch scratch;
  const std::string extension = GetParam();
  writeMesh(named(asymmetricBody(1)), scratch.path / ("c" + extension));
  ::setenv("LOCPATH", test::localesFolder().c_str(), 1);
  for (const std::string locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "tr_TR.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale.c_str()), nullptr) << locale << " is missing: see tests/support/CMakeLists.txt";
    ASSERT_EQ(std::string(std::localeconv()->decimal_point), ",");
    writeMesh(named(asymmetricBody(1)), scratch.path / ("other" + extension));
    const SurfaceMesh back = readMesh(scratch.path / ("c" + extension));
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(readWholeFile(scratch.path / ("c" + extension)), readWholeFile(scratch.path / ("other" + extension)));
    EXPECT_LE(greatestCornerDistance(asymmetricBody(1), back), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::Values(".stl", ".ply", ".obj", ".vtp"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

TEST(Stl, HeaderNamesTheSpaceAndNeverBeginsWithSolid) {
  const Scratch scratch;
  writeMesh(named(asymmetricBody(1)), scratch.path / "a.stl");
  const std::string bytes = readWholeFile(scratch.path / "a.stl");
  EXPECT_EQ(bytes.substr(0, 8), "Glisson ");
  EXPECT_NE(bytes.substr(0, 80).find("SPACE=LPS"), std::string::npos);
  EXPECT_NE(bytes.substr(0, 80).find("UNIT=mm tumour_01"), std::string::npos);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(count, 80U);
  EXPECT_EQ(bytes.size(), 84U + 50U * 80U);
}

TEST(Stl, IsReadTheSameByAnotherReader) {
  const Scratch scratch;
  const SurfaceMesh body = asymmetricBody(2);
  writeMesh(named(body), scratch.path / "a.stl");
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName((scratch.path / "a.stl").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), static_cast<vtkIdType>(body.triangles.size()));
  std::array<double, 6> bounds{};
  reader->GetOutput()->GetBounds(bounds.data());
  const Bounds expected = boundsOf(body);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(bounds[2 * axis], expected.low[static_cast<int>(axis)], 1e-4);
    EXPECT_NEAR(bounds[2 * axis + 1], expected.high[static_cast<int>(axis)], 1e-4);
  }
}

TEST(Vtp, IsReadTheSameByAnotherReader) {
  const Scratch scratch;
  const SurfaceMesh body = asymmetricBody(2);
  NamedMesh mesh = named(body);
  mesh.id = "liver--v2---";  // no two hyphens in an XML comment
  writeMesh(mesh, scratch.path / "a.vtp");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((scratch.path / "a.vtp").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(body.vertices.size()));
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPolys(), static_cast<vtkIdType>(body.triangles.size()));
  std::array<double, 6> bounds{};
  reader->GetOutput()->GetBounds(bounds.data());
  EXPECT_NEAR(bounds[0], boundsOf(body).low.x(), 1e-4);
  EXPECT_NEAR(bounds[5], boundsOf(body).high.z(), 1e-4);
}

TEST(Stl, ACountBombIsRefusedBeforeMemoryIsAskedFor) {
  const Scratch scratch;
  std::string bytes(84 + 50, '\0');
  std::memset(bytes.data() + 80, 0xFF, 4);
  std::ofstream(scratch.path / "bomb.stl", std::ios::binary) << bytes;
  EXPECT_THROW(readMesh(scratch.path / "bomb.stl"), InputError);
}

TEST(Ply, ACountBombIsRefusedBeforeMemoryIsAskedFor) {
  const Scratch scratch;
  std::ofstream(scratch.path / "bomb.ply", std::ios::binary)
      << "ply\nformat binary_little_endian 1.0\nelement vertex 9000000000000000000\nproperty float x\nproperty float y\nproperty "
         "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n123";
  EXPECT_THROW(readMesh(scratch.path / "bomb.ply"), InputError);
}

TEST(Stl, AnAsciiFileOfAnotherProgramIsRead) {
  const Scratch scratch;
  std::ofstream(scratch.path / "a.stl") << "solid x\r\nfacet normal 0 0 0\r\n outer loop\r\n  vertex 0 0 0\r\n  vertex 1.5 0 0\r\n"
                                           "  vertex 0 1e1 0\r\n endloop\r\nendfacet\r\nendsolid x\r\n";
  const SurfaceMesh mesh = readMesh(scratch.path / "a.stl");
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.vertices.at(2), Vec3(0, 10, 0));
}

TEST(Ply, AnAsciiFileWithExtraPropertiesAndQuadsIsRead) {
  const Scratch scratch;
  std::ofstream(scratch.path / "a.ply")
      << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float nx\nproperty double x\nproperty "
         "double y\nproperty double z\nelement face 1\nproperty list uchar uint vertex_index\n"
         "end_header\n9 0 0 0\n9 1 0 0\n9 1 1 0\n9 0 1 0\n4 0 1 2 3\n";
  const SurfaceMesh mesh = readMesh(scratch.path / "a.ply");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_NEAR(areaMm2(mesh), 1.0, 1e-12);
}

TEST(RoundedToFloat, WeldsWhatCollapsesAndStaysClosed) {
  SurfaceMesh body = asymmetricBody(2);
  // A second copy of every vertex of one triangle, closer than a float can tell: a seam of slivers.
  const Triangle t = body.triangles[7];
  const Vec3 middle = body.vertices[t[0]] + Vec3(1e-10, 1e-10, 0);
  const auto extra = static_cast<std::uint32_t>(body.vertices.size());
  body.vertices.push_back(middle);
  body.triangles[7] = {extra, t[1], t[2]};
  body.triangles.push_back({t[0], t[1], extra});
  body.triangles.push_back({t[0], extra, t[2]});
  const SurfaceMesh rounded = roundedToFloat(body);
  EXPECT_EQ(rounded.triangles.size(), body.triangles.size() - 2);
  EXPECT_FALSE(rounded.defects().any());
}

TEST(RoundedToFloat, AFlatTriangleLeavesNoOpenEdge) {
  // A tetrahedron whose one edge carries a vertex that a flat triangle joins to its opposite side.
  SurfaceMesh body;
  body.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1e-9, 0}};
  body.triangles = {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}};
  ASSERT_EQ(body.defects().openEdges, 0U);
  const SurfaceMesh rounded = roundedToFloat(body);
  EXPECT_FALSE(rounded.defects().any());
  EXPECT_NEAR(signedVolumeMm3(rounded), 8.0 / 6, 1e-6);
}

TEST(WriteMesh, AnUnknownExtensionIsNamed) {
  const Scratch scratch;
  EXPECT_THROW(writeMesh(named(asymmetricBody(0)), scratch.path / "a.xyz"), UsageError);
  EXPECT_THROW(writeMesh(named(asymmetricBody(0)), scratch.path / "missing" / "a.stl"), InputError);
  EXPECT_EQ(scratch.entries(), 0U);
}

}  // namespace
}  // namespace glisson
