#include "tests/reconstruction/io/itk_writer.h"

#include <itkImage.h>
#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>

namespace glisson::fixtures {

void writeWithItk(const std::filesystem::path& path, const ItkImage& from, bool compressed) {
  using Image = itk::Image<short, 3>;
  constexpr std::array<int, 3> kStart{3, -2, 5};
  const Image::Pointer image = Image::New();
  Image::RegionType region;
  Image::PointType origin;
  Image::SpacingType spacing;
  Image::DirectionType direction;
  for (unsigned a = 0; a < 3; ++a) {
    region.SetIndex(a, kStart[a]);
    region.SetSize(a, static_cast<itk::SizeValueType>(from.size[a]));
    spacing[a] = from.spacing[a];
    origin[a] = from.origin[a];
    for (unsigned b = 0; b < 3; ++b) {
      direction[a][b] = from.direction[3 * a + b];
      origin[a] -= from.direction[3 * a + b] * from.spacing[b] * kStart[b];
    }
  }
  image->SetRegions(region);
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  image->SetDirection(direction);
  image->Allocate();
  std::copy(from.voxels.begin(), from.voxels.end(), image->GetBufferPointer());
  const auto writer = itk::ImageFileWriter<Image>::New();
  writer->SetInput(image);
  writer->SetFileName(path.string());
  writer->SetUseCompression(compressed);
  const std::string ending = path.extension().string();
  if (ending == ".nrrd") {
    writer->SetImageIO(itk::NrrdImageIO::New());
  } else if (ending == ".mha" || ending == ".mhd") {
    writer->SetImageIO(itk::MetaImageIO::New());
  } else {
    writer->SetImageIO(itk::NiftiImageIO::New());
  }
  writer->Update();
}

}  // namespace glisson::fixtures
