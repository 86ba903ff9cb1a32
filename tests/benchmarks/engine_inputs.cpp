// Writes what tests/benchmarks/run hands to Glisson and to PCL: the same boundary samples both solve from.
//   engine_inputs SEGMENTATION STRUCTURE OUT.pcd         samples (`paper`, method.md 1) of a structure of a patient
//   engine_inputs --ball RADIUS OUT.nii.gz OUT.pcd          a ball of 1 mm voxels as a label map, and its samples

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "reconstruction/poisson/poisson.h"
#include "reconstruction/sample/volume_writers.h"

namespace glisson {
namespace {

void writePcd(const OrientedPoints& points, const std::string& file) {
  std::ofstream out(file);
  const std::size_t count = points.positions.size();
  out << "VERSION .7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH "
      << count << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << count << "\nDATA ascii\n";
  for (std::size_t n = 0; n < count; ++n) {
    out << points.positions[n].transpose() << ' ' << points.normals[n].transpose() << '\n';
  }
  if (!out.flush()) {
    throw Error(file + " cannot be written.");
  }
  std::printf("%zu\n", count);
}

void ofPatient(const std::string& path, const std::string& structure, const std::string& file) {
  const Segmentation segmentation = readSegmentation(path);
  for (const LabelledMask& one : segmentation.structures) {
    if (one.name == structure) {
      writePcd(sampleBoundary(*one.mask, segmentation.geometry, Sampling::Paper), file);
      return;
    }
  }
  throw UsageError(path + " has no structure " + structure + ".");
}

void ofBall(double radius, const std::string& labels, const std::string& file) {
  const int side = static_cast<int>(2 * radius) + 7;
  ImageGeometry geometry;
  geometry.size = {side, side, side};
  std::vector<std::uint8_t> values(geometry.voxelCount(), 0);
  const Vec3 centre = Vec3::Constant(0.5 * (side - 1) + 0.25);
  std::size_t n = 0;
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i, ++n) {
        values[n] = (Vec3(i, j, k) - centre).norm() <= radius ? 1 : 0;
      }
    }
  }
  sample::writeNifti(labels, geometry, values);
  writePcd(sampleBoundary(Mask::fromGrid(geometry.size, values), geometry, Sampling::Paper), file);
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 3) {
    ofPatient(words[0], words[1], words[2]);
  } else if (words.size() == 4 && words[0] == "--ball") {
    ofBall(std::atof(words[1].c_str()), words[2], words[3]);
  } else {
    std::fputs("usage: engine_inputs SEGMENTATION STRUCTURE OUT.pcd | --ball RADIUS OUT.nii.gz OUT.pcd\n", stderr);
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace glisson

int main(int count, char** words) {
  try {
    return glisson::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "engine_inputs: %s\n", error.what());
    return 3;
  }
}
