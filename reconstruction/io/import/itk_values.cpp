#include "reconstruction/io/import/itk_values.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <new>

#include "reconstruction/errors.h"

namespace glisson::import {

namespace {
itk::ImageIOBase::Pointer decoderOf(ItkFormat format) {
  switch (format) {
    case ItkFormat::Nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case ItkFormat::Nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case ItkFormat::MetaImage:
      break;
  }
  return itk::MetaImageIO::New().GetPointer();
}

std::optional<Scalar> scalarOf(itk::IOComponentEnum type) {
  static_assert(sizeof(long) == 8, "ITK's LONG is taken for 64 bits");
  switch (type) {
    case itk::IOComponentEnum::UCHAR:
      return Scalar::U8;
    case itk::IOComponentEnum::CHAR:
      return Scalar::I8;
    case itk::IOComponentEnum::USHORT:
      return Scalar::U16;
    case itk::IOComponentEnum::SHORT:
      return Scalar::I16;
    case itk::IOComponentEnum::UINT:
      return Scalar::U32;
    case itk::IOComponentEnum::INT:
      return Scalar::I32;
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      return Scalar::U64;
    case itk::IOComponentEnum::LONG:
    case itk::IOComponentEnum::LONGLONG:
      return Scalar::I64;
    case itk::IOComponentEnum::FLOAT:
      return Scalar::F32;
    case itk::IOComponentEnum::DOUBLE:
      return Scalar::F64;
    default:
      return std::nullopt;
  }
}

ItkHeader headerOf(const itk::ImageIOBase& io, bool placed) {
  ItkHeader header;
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a) {
    header.sizes.push_back(io.GetDimensions(a));
  }
  header.valuesPerVoxel = io.GetNumberOfComponents();
  header.scalar = scalarOf(io.GetComponentType());
  header.placed = placed && header.sizes.size() == 3;
  for (unsigned a = 0; header.sizes.size() == 3 && a < 3; ++a) {
    header.spacing[a] = io.GetSpacing(a);
    header.origin[a] = io.GetOrigin(a);
    const std::vector<double> axis = io.GetDirection(a);
    std::copy_n(axis.begin(), 3, header.axes[a].begin());
  }
  return header;
}

/// The last line of ITK's report tells the cause; the folder in it is one that the user never saw.
std::string reasonOf(const itk::ExceptionObject& error, const std::filesystem::path& folder) {
  constexpr std::size_t kMostLetters = 160;
  std::string reason = error.GetDescription();
  reason.erase(reason.find_last_not_of(" \r\n.") + 1);
  reason.erase(0, reason.find_last_of("\r\n") + 1);
  if (const std::size_t at = reason.find("): "); at != std::string::npos && reason.starts_with("itk::ERROR")) {
    reason.erase(0, at + 3);
  }
  if (const std::size_t at = reason.find(folder.string()); at != std::string::npos) {
    reason.erase(at, folder.string().size());
  }
  return reason.substr(0, kMostLetters);
}

itk::ImageIOBase::Pointer open(ItkFormat format, const std::filesystem::path& path) {
  itk::ImageIOBase::Pointer io = decoderOf(format);
  io->SetFileName(path.string());
  io->ReadImageInformation();
  return io;
}

std::vector<std::uint8_t> decode(itk::ImageIOBase& io) {
  itk::ImageIORegion whole(io.GetNumberOfDimensions());
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a) {
    whole.SetIndex(a, 0);
    whole.SetSize(a, io.GetDimensions(a));
  }
  io.SetIORegion(whole);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(io.GetImageSizeInBytes()));
  io.Read(bytes.data());
  return bytes;
}
}  // namespace

std::vector<std::uint8_t> decodeWithItk(const ItkFile& file, const std::function<void(const ItkHeader&)>& accept) {
  itk::Object::GlobalWarningDisplayOff();
  try {
    itk::ImageIOBase::Pointer io;
    bool placed = file.path != file.placeless;
    try {
      io = open(file.format, file.path);
    } catch (const itk::ExceptionObject&) {
      if (file.placeless.empty() || !placed) {
        throw;
      }
      placed = false;
      io = open(file.format, file.placeless);
    }
    accept(headerOf(*io, placed));
    return decode(*io);
  } catch (const itk::MemoryAllocationError&) {
    throw std::bad_alloc();
  } catch (const itk::ExceptionObject& error) {
    throw InputError(file.name + " cannot be decoded by ITK (" + reasonOf(error, file.path.parent_path() / "") +
                     "); export it again.");
  }
}

}  // namespace glisson::import
