// NIfTI-1 (.nii, .nii.gz). Source: nifti1.h, "NIFTI-1 Data Format", https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h.
// World there is RAS; it is turned to LPS here. sform and qform are taken for one place where they agree to 0.1 mm.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/image_file.h"
#include "reconstruction/io/import/itk_folder.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
constexpr std::size_t kHeaderBytes = 348;
using HeaderBytes = std::array<std::uint8_t, kHeaderBytes>;

class Header {
 public:
  Header(const std::string& name, ByteSource& source) {
    if (source.read(bytes_.data(), kHeaderBytes) != kHeaderBytes) {
      throw InputError(name + " is cut off within its NIfTI header; copy or export it again.");
    }
    const auto size = at<std::int32_t>(0);
    swapped_ = size != static_cast<std::int32_t>(kHeaderBytes);
    if (size == 540 || at<std::int32_t>(0) == 540) {
      throw InputError(name + " is NIfTI-2, which is not read; save it as NIfTI-1.");
    }
    if (at<std::int32_t>(0) != static_cast<std::int32_t>(kHeaderBytes) || std::memcmp(&bytes_[344], "n+1\0", 4) != 0) {
      if (std::memcmp(&bytes_[344], "ni1\0", 4) == 0) {
        throw InputError(name + " is one half of a .hdr/.img pair; save it as one .nii file.");
      }
      throw InputError(name + " is not a NIfTI file although its name says so; export it again.");
    }
  }
  template <typename T>
  [[nodiscard]] T at(std::size_t offset) const {
    std::array<std::uint8_t, sizeof(T)> raw{};
    std::memcpy(raw.data(), &bytes_[offset], sizeof(T));
    if (swapped_) {
      std::reverse(raw.begin(), raw.end());
    }
    return std::bit_cast<T>(raw);
  }
  [[nodiscard]] double real(std::size_t offset) const { return at<float>(offset); }
  [[nodiscard]] int dim(std::size_t n) const { return at<std::int16_t>(40 + 2 * n); }
  [[nodiscard]] double pixdim(std::size_t n) const { return real(76 + 4 * n); }
  [[nodiscard]] bool swapped() const { return swapped_; }
  [[nodiscard]] const HeaderBytes& bytes() const { return bytes_; }

 private:
  HeaderBytes bytes_{};
  bool swapped_ = false;
};

Scalar scalarOf(const std::string& name, const Header& header) {
  static const std::map<int, Scalar> kTypes{{2, Scalar::U8},     {4, Scalar::I16},   {8, Scalar::I32},   {16, Scalar::F32},
                                            {64, Scalar::F64},   {256, Scalar::I8},  {512, Scalar::U16}, {768, Scalar::U32},
                                            {1024, Scalar::I64}, {1280, Scalar::U64}};
  const auto found = kTypes.find(header.at<std::int16_t>(70));
  if (found == kTypes.end()) {
    throw InputError(name + " holds voxels of NIfTI type " + std::to_string(header.at<std::int16_t>(70)) +
                     ", which are not single numbers; save it as integers or floats.");
  }
  if (header.at<std::int16_t>(72) != static_cast<int>(8 * bytesOf(found->second))) {
    throw InputError(name + " contradicts itself about the bits per voxel in its header; export it again.");
  }
  return found->second;
}

void requireOneVolume(const std::string& name, const Header& header) {
  const int dims = header.dim(0);
  if (dims < 3 || dims > 7) {
    throw InputError(name + " has " + std::to_string(dims) + " dimensions; a volume with three is needed.");
  }
  for (int n = 4; n <= dims; ++n) {
    if (header.dim(static_cast<std::size_t>(n)) > 1) {
      throw InputError(name + " is a time series or has several values per voxel (dimension " + std::to_string(n) + " is " +
                       std::to_string(header.dim(static_cast<std::size_t>(n))) + "); save the one volume that is meant.");
    }
  }
}

/// Steps and origin of a frame, RAS, in the file's unit.
struct Frame {
  Mat3 steps = Mat3::Identity();
  Vec3 origin = Vec3::Zero();
  double apartMm = 0;  ///< from the file's other form
};

Frame sformOf(const Header& header) {
  Frame frame;
  for (int row = 0; row < 3; ++row) {
    const std::size_t offset = 280 + 16 * static_cast<std::size_t>(row);
    for (int column = 0; column < 3; ++column) {
      frame.steps(row, column) = header.real(offset + 4 * static_cast<std::size_t>(column));
    }
    frame.origin[row] = header.real(offset + 12);
  }
  return frame;
}

Frame qformOf(const Header& header) {
  const double b = header.real(256);
  const double c = header.real(260);
  const double d = header.real(264);
  const double rest = 1 - (b * b + c * c + d * d);
  Eigen::Quaterniond rotation(rest > 1e-7 ? std::sqrt(rest) : 0.0, b, c, d);
  Frame frame;
  frame.origin = Vec3(header.real(268), header.real(272), header.real(276));
  if (!rotation.coeffs().allFinite() || !(rotation.norm() > 0)) {
    frame.steps.setConstant(std::nan(""));
    return frame;
  }
  rotation.normalize();
  const double flip = header.pixdim(0) < 0 ? -1 : 1;
  frame.steps = rotation.toRotationMatrix() * Vec3(header.pixdim(1), header.pixdim(2), flip * header.pixdim(3)).asDiagonal();
  return frame;
}

double cornerDistance(const Frame& a, const Frame& b, const Index3& size) {
  double worst = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int n = 0; n < 3; ++n) {
      index[n] = ((corner >> n) & 1) != 0 ? size[static_cast<std::size_t>(n)] - 1 : 0;
    }
    const double distance = (a.steps * index + a.origin - b.steps * index - b.origin).norm();
    worst = std::isfinite(distance) ? std::max(worst, distance) : std::numeric_limits<double>::infinity();
  }
  return worst;
}

/// A form that holds NaN cannot be compared with the other one, so each that may be used is checked by itself first.
void requireFinite(const std::string& name, const Header& header, bool takesS, bool takesQ) {
  const auto refuse = [&](const std::string& fact) {
    throw InputError(name + " does not say how it lies in the patient: its " + fact + "; export it again.");
  };
  const auto finite = [](const Frame& frame) { return frame.steps.allFinite() && frame.origin.allFinite(); };
  if (takesS && !finite(sformOf(header))) {
    refuse("sform holds a number that is not finite (NaN or infinite)");
  }
  for (std::size_t n = 1; takesQ && n <= 3; ++n) {
    if (!std::isfinite(header.pixdim(n))) {
      refuse("voxel size (pixdim) holds a number that is not finite (NaN or infinite)");
    }
    if (header.pixdim(n) == 0) {
      refuse("voxel size (pixdim) is zero");
    }
  }
  if (takesQ && !finite(qformOf(header))) {
    refuse("qform holds a number that is not finite (NaN or infinite)");
  }
}

Frame chooseFrame(const std::string& name, const Header& header, double unit, const Index3& size, const ReadOptions& options) {
  const bool hasQ = header.at<std::int16_t>(252) > 0;
  const bool hasS = header.at<std::int16_t>(254) > 0;
  if (!hasQ && !hasS) {
    throw InputError(name + " says nowhere how it lies in the patient (no sform, no qform); export it again with its orientation.");
  }
  const bool onlyS = hasS && (!hasQ || options.niftiFrame == NiftiFrame::SForm);
  const bool onlyQ = hasQ && (!hasS || options.niftiFrame == NiftiFrame::QForm);
  requireFinite(name, header, !onlyQ, !onlyS);
  if (options.niftiFrame == NiftiFrame::SForm && hasS) {
    return sformOf(header);
  }
  if (options.niftiFrame == NiftiFrame::QForm && hasQ) {
    return qformOf(header);
  }
  Frame frame = hasS ? sformOf(header) : qformOf(header);
  if (hasQ && hasS) {
    frame.apartMm = cornerDistance(frame, qformOf(header), size) * unit;
    if (!(frame.apartMm <= kSamePlaceMm)) {
      throw InputError(name + " lies in two places: its sform and qform are " + formatNumber(frame.apartMm, 2) +
                       " mm apart; choose with --prefer sform or --prefer qform.");
    }
  }
  return frame;
}

double unitInMm(const Header& header) {
  switch (header.bytes()[123] & 7) {
    case 1:
      return 1000;
    case 3:
      return 1e-3;
    default:
      return 1;
  }
}

/// The label names that TotalSegmentator and Connectome Workbench embed: <Label Key="5" ...><![CDATA[liver]]></Label>.
std::map<int, std::string> labelNamesIn(const std::string& extension) {
  std::map<int, std::string> names;
  std::size_t at = 0;
  while ((at = extension.find("<Label ", at)) != std::string::npos) {
    const std::size_t open = extension.find('>', at);
    const std::size_t close = extension.find("</Label>", at);
    if (open == std::string::npos || close == std::string::npos || close < open) {
      break;
    }
    const std::string attributes = extension.substr(at, open - at);
    std::string name = extension.substr(open + 1, close - open - 1);
    constexpr std::string_view kCdata = "<![CDATA[";
    if (name.starts_with(kCdata) && name.ends_with("]]>")) {
      name = name.substr(kCdata.size(), name.size() - kCdata.size() - 3);
    }
    const std::size_t key = attributes.find("Key=\"");
    if (key != std::string::npos) {
      const std::size_t end = attributes.find('"', key + 5);
      if (const auto number = parseInteger(attributes.substr(key + 5, end == std::string::npos ? end : end - key - 5));
          number && std::abs(*number) < 1000000 && name.size() < 256) {
        names[static_cast<int>(*number)] = name;
      }
    }
    at = close;
  }
  return names;
}

/// A header-and-image pair for ITK, whatever the file's name (niftilib refuses .Nii), extensions and intent. The slope is taken
/// out: ITK would turn every scaled value to a float and obeys an intercept whose slope is zero.
ItkFile pairForItk(const std::string& name, const ItkFolder& folder, bool compressed, HeaderBytes header) {
  constexpr std::size_t kIntentCode = 68;
  constexpr std::size_t kSlopeAndIntercept = 112;
  constexpr std::size_t kFormCodes = 252;
  constexpr std::size_t kMagic = 344;
  std::fill_n(&header[kIntentCode], 2, std::uint8_t{0});
  std::fill_n(&header[kSlopeAndIntercept], 8, std::uint8_t{0});
  std::memcpy(&header[kMagic], "ni1", 4);
  const auto write = [&](const std::string& pair) {
    folder.link(pair + (compressed ? ".img.gz" : ".img"), name);
    return folder.write(pair + ".hdr", {reinterpret_cast<const char*>(header.data()), header.size()});
  };
  ItkFile file{ItkFormat::Nifti, name, write("placed"), {}};
  std::fill_n(&header[kFormCodes], 4, std::uint8_t{0});
  file.placeless = write("placeless");
  return file;
}

}  // namespace

ImageFile readNifti(const std::filesystem::path& path, const ReadOptions& options, Extent extent) {
  const std::string name = path.string();
  const bool compressed = toLower(path.extension().string()) == ".gz";
  ByteSource source(path, 0, compressed ? Coding::Gzip : Coding::Raw);
  const Header header(name, source);
  ImageFile file;
  file.bigEndian = header.swapped();
  requireOneVolume(name, header);
  file.scalar = scalarOf(name, header);
  file.geometry.size = {header.dim(1), header.dim(2), header.dim(3)};
  requireBudget(name, {1.0 * header.dim(1), 1.0 * header.dim(2), 1.0 * header.dim(3)}, 1, static_cast<double>(bytesOf(file.scalar)),
                options);
  const double unit = unitInMm(header);
  const Frame frame = chooseFrame(name, header, unit, file.geometry.size, options);
  const Vec3 rasToLps(-1, -1, 1);
  file.geometry.origin = rasToLps.cwiseProduct(frame.origin) * unit;
  setSteps(name, rasToLps.asDiagonal() * frame.steps * unit, file);
  file.ambiguityMm += frame.apartMm;

  const double slope = header.real(112);
  const double intercept = header.real(116);
  if (std::isfinite(slope) && slope != 0) {  // anything else means "not scaled" (nibabel writes NaN)
    file.slope = slope;
    file.intercept = std::isfinite(intercept) ? intercept : 0;
  }
  const double offset = header.real(108);
  constexpr double kMostExtensionBytes = 64.0 * 1024 * 1024;
  if (!(offset >= 352) || offset > kMostExtensionBytes || offset != std::floor(offset)) {
    throw InputError(name + " has an impossible data offset in its NIfTI header; export it again.");
  }
  std::string extension(static_cast<std::size_t>(offset) - kHeaderBytes, '\0');
  if (source.mostBytesLeft() < extension.size() || source.read(extension.data(), extension.size()) != extension.size()) {
    throw InputError(name + " is cut off before its voxels; copy or export it again.");
  }
  file.labelNames = labelNamesIn(extension);
  const ItkFolder folder(path);
  ItkInput itk{pairForItk(name, folder, compressed, header.bytes())};
  // ITK never takes an origin in metres for what it is, has its own way of choosing between the forms, and aborts on NaN in a form
  // that nobody wants. It also gives up on most oblique sforms without a qform; then it reads the placeless pair by itself.
  itk.judgesPlace = options.niftiFrame == NiftiFrame::Agreeing && unit == 1;
  if (!itk.judgesPlace) {
    itk.file.path = itk.file.placeless;
  }
  readValues(name, source, itk, file, extent);
  return file;
}

}  // namespace glisson::import
