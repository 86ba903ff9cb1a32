// Files written by ITK, an implementation of its own of each format, land where ITK says they lie (hazard H1).

#include <gtest/gtest.h>

#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"
#include "tests/reconstruction/io/itk_writer.h"

namespace glisson {
namespace {

TEST(Itk, H1FilesWrittenByItkLieWhereItkPutThem) {
  const fixtures::TemporaryFolder folder;
  for (const int code : {0, 1, 7, 10, 18, 29, 36, 47}) {
    for (const double degrees : {0.0, 3.0, 140.0}) {
      const ImageGeometry geometry = fixtures::permutedGrid(code, degrees);
      fixtures::ItkImage image;
      for (int a = 0; a < 3; ++a) {
        const auto n = static_cast<std::size_t>(a);
        image.size[n] = geometry.size[n];
        image.spacing[n] = geometry.spacing[a];
        image.origin[n] = geometry.origin[a];
        for (int b = 0; b < 3; ++b) {
          image.direction[3 * n + static_cast<std::size_t>(b)] = geometry.direction(a, b);
        }
      }
      for (std::size_t n = 0; n < geometry.voxelCount(); ++n) {
        image.voxels.push_back(static_cast<short>(static_cast<int>(n) - 250));
      }
      for (const char* name : {"a.nii", "b.nii.gz", "c.nrrd", "d.mha", "e.mhd"}) {
        SCOPED_TRACE(std::string(name) + " code " + std::to_string(code) + " turned by " + std::to_string(degrees));
        fixtures::writeWithItk(folder / name, image, code % 2 == 1);
        const CtVolume ct = readCt(folder / name);
        EXPECT_LE(ct.geometry.cornerDistance(geometry), 1e-3);
        for (std::size_t n = 0; n < geometry.voxelCount(); ++n) {
          ASSERT_EQ(ct.hounsfield[n], static_cast<int>(n) - 250);
        }
      }
    }
  }
}

}  // namespace
}  // namespace glisson
