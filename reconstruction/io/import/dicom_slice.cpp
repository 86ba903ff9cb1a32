#include "reconstruction/io/import/dicom_slice.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <utility>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/text_header.h"
#include "reconstruction/parallel.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
namespace fs = std::filesystem;

constexpr std::uintmax_t kMagicEnd = 132;
constexpr const char* kNoDicom = "no DICOM";

std::string textOf(DcmItem& item, const DcmTagKey& key) {
  OFString value;
  return item.findAndGetOFStringArray(key, value).good() ? trim(value.c_str()) : std::string();
}

std::optional<double> numberOf(DcmItem& item, const DcmTagKey& key, unsigned long n = 0) {
  OFString value;
  return item.findAndGetOFString(key, value, n).good() ? parseNumber(value.c_str()) : std::nullopt;
}

int shortOf(DcmItem& item, const DcmTagKey& key, int otherwise) {
  Uint16 value = 0;
  return item.findAndGetUint16(key, value).good() ? value : otherwise;
}

std::optional<Vec3> vectorOf(DcmItem& item, const DcmTagKey& key, unsigned long first = 0) {
  Vec3 vector;
  for (unsigned long n = 0; n < 3; ++n) {
    const auto value = numberOf(item, key, first + n);
    if (!value) {
      return std::nullopt;
    }
    vector[static_cast<Eigen::Index>(n)] = *value;
  }
  return vector;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& fact) {
  throw InputError(path.string() + " " + fact + "; copy or export the series again.");
}

/// What a header says wrongly or not at all about one attribute of the slice's place.
std::string flawOf(DcmItem& data, const DcmTagKey& key, const std::string& what) {
  return textOf(data, key).empty() ? "does not say how it lies in the patient (no " + what + ")"
                                   : "has a broken " + what + ": it is not made of finite numbers";
}

/// Leaves slice.placed false and a flaw where the place cannot be told: whether that matters depends on the series around it.
void readPlace(DcmItem& data, DicomSlice& slice) {
  const auto position = vectorOf(data, DCM_ImagePositionPatient);
  const auto row = vectorOf(data, DCM_ImageOrientationPatient, 0);
  const auto column = vectorOf(data, DCM_ImageOrientationPatient, 3);
  const auto rowSpacing = numberOf(data, DCM_PixelSpacing, 0);
  const auto columnSpacing = numberOf(data, DCM_PixelSpacing, 1);
  slice.placed = position && row && column && rowSpacing && columnSpacing;
  if (!slice.placed) {
    slice.flaw = !position         ? flawOf(data, DCM_ImagePositionPatient, "position")
                 : !row || !column ? flawOf(data, DCM_ImageOrientationPatient, "orientation")
                                   : flawOf(data, DCM_PixelSpacing, "pixel spacing");
    return;
  }
  if (std::abs(row->norm() - 1) > 1e-2 || std::abs(column->norm() - 1) > 1e-2 || std::abs(row->dot(*column)) > 1e-2) {
    refuse(slice.path, "has image axes that are not perpendicular unit vectors");
  }
  if (!(*rowSpacing > 0) || !(*columnSpacing > 0)) {
    refuse(slice.path, "has a pixel spacing that is not above zero");
  }
  constexpr double kFarthestMm = 1e5;
  if (position->cwiseAbs().maxCoeff() > kFarthestMm) {
    slice.placed = false;
    slice.flaw = "has a broken position: it lies more than 100 m from the scanner";
    return;
  }
  slice.position = *position;
  slice.rowDirection = row->normalized();
  slice.columnDirection = (*column - column->dot(slice.rowDirection) * slice.rowDirection).normalized();
  slice.rowSpacing = *rowSpacing;
  slice.columnSpacing = *columnSpacing;
}

void readCoding(DcmItem& data, DicomSlice& slice) {
  slice.bitsAllocated = shortOf(data, DCM_BitsAllocated, 16);
  slice.bitsStored = shortOf(data, DCM_BitsStored, slice.bitsAllocated);
  slice.highBit = shortOf(data, DCM_HighBit, slice.bitsStored - 1);
  slice.isSigned = shortOf(data, DCM_PixelRepresentation, 0) == 1;
  slice.samples = shortOf(data, DCM_SamplesPerPixel, 1);
  slice.photometric = textOf(data, DCM_PhotometricInterpretation);
  slice.frames = static_cast<int>(std::clamp(numberOf(data, DCM_NumberOfFrames).value_or(1), 1.0, 1e6));
  slice.slope = 1;
  for (const auto& [key, target] : {std::pair(DCM_RescaleSlope, &slice.slope), std::pair(DCM_RescaleIntercept, &slice.intercept)}) {
    if (textOf(data, key).empty()) {
      continue;
    }
    const auto value = numberOf(data, key);
    if (!value || (target == &slice.slope && *value == 0)) {
      refuse(slice.path, "has a rescale slope or intercept that is not a usable number");
    }
    *target = *value;
    ++slice.rescaleValues;
  }
}

void readIdentity(DcmItem& data, DicomSlice& slice) {
  slice.identity.patientName = textOf(data, DCM_PatientName);
  slice.identity.patientId = textOf(data, DCM_PatientID);
  slice.identity.birthDate = textOf(data, DCM_PatientBirthDate);
  slice.identity.studyDate = textOf(data, DCM_StudyDate);
  slice.identity.seriesDescription = textOf(data, DCM_SeriesDescription);
  slice.identity.frameOfReferenceUid = textOf(data, DCM_FrameOfReferenceUID);
  slice.seriesUid = textOf(data, DCM_SeriesInstanceUID);
  slice.modality = textOf(data, DCM_Modality);
  slice.localizer = textOf(data, DCM_ImageType).find("LOCALIZER") != std::string::npos;
  slice.instanceNumber = static_cast<long>(std::clamp(numberOf(data, DCM_InstanceNumber).value_or(0), -1e9, 1e9));
}

/// Files that lie beside slices without being one: notes, viewers, pictures.
bool isCompanion(const fs::path& path) {
  constexpr std::array kCompanions{".txt", ".xml", ".json", ".csv", ".html", ".htm", ".inf", ".ini", ".exe", ".dll", ".jpg",
                                   ".png", ".pdf", ".md",   ".log", ".bat",  ".db",  ".js",  ".css", ".sh",  ".zip", ".sha256"};
  const std::string ending = toLower(path.extension().string());
  return std::ranges::any_of(kCompanions, [&](const char* known) { return ending == known; });
}

std::string withoutDigits(const fs::path& path) {
  std::string name = path.filename().string();
  std::erase_if(name, [](char c) { return c >= '0' && c <= '9'; });
  return name;
}

/// Files that are no DICOM and lie among slices, but were slices once: too short for a header, or numbered like the slices.
void requireNoRuins(const std::vector<DicomSlice>& slices, const std::vector<fs::path>& noDicom) {
  for (const fs::path& file : noDicom) {
    if (!slices.empty() && fs::file_size(file) < kMagicEnd) {
      refuse(file, "is cut off before its header");
    }
    const auto likeIt = [&](const DicomSlice& slice) {
      return slice.path.parent_path() == file.parent_path() && withoutDigits(slice.path) == withoutDigits(file);
    };
    if (std::ranges::any_of(slices, likeIt)) {
      refuse(file, "is named like the slices beside it but is no DICOM any more");
    }
  }
}

/// Objects that carry no image by their nature. Anything else without pixels is an image that was cut off.
bool isWithoutImage(const std::string& sopClass) {
  for (const char* known : {UID_MediaStorageDirectoryStorage, "1.2.840.10008.5.1.4.1.1.88.", "1.2.840.10008.5.1.4.1.1.11.",
                            "1.2.840.10008.5.1.4.1.1.104.", "1.2.840.10008.5.1.4.1.1.481.", "1.2.840.10008.5.1.4.1.1.66"}) {
    if (sopClass.starts_with(known)) {
      return true;
    }
  }
  return false;
}
}  // namespace

bool hasDicomMagic(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, kMagicEnd> head{};
  return file.read(head.data(), head.size()) && std::string_view(&head[128], 4) == "DICM";
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.')) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::vector<fs::path> foldersIn(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory() && !entry.path().filename().string().starts_with('.')) {
      folders.push_back(entry.path());
    }
  }
  std::ranges::sort(folders);
  return folders;
}

std::optional<DicomSlice> readDicomSlice(const fs::path& path, std::string& why) {
  const bool magic = hasDicomMagic(path);
  DicomSlice slice;
  slice.path = path;
  slice.file = std::make_shared<DcmFileFormat>();
  const OFFilename fileName(path.c_str());
  const OFCondition loaded = slice.file->loadFile(fileName, EXS_Unknown, EGL_noChange, 4096);
  DcmDataset* data = slice.file->getDataset();
  if (!magic) {  // a file of the time before the preamble, or no DICOM at all
    if (loaded.bad() || data == nullptr || !data->tagExists(DCM_Rows) || !data->tagExists(DCM_PixelData)) {
      why = kNoDicom;
      return std::nullopt;
    }
  } else if (loaded.bad() || data == nullptr) {
    refuse(path, std::string("is damaged or cut off (") + loaded.text() + ")");
  }
  std::string sopClass = textOf(*data, DCM_SOPClassUID);
  if (sopClass.empty()) {
    sopClass = textOf(*slice.file->getMetaInfo(), DCM_MediaStorageSOPClassUID);
  }
  // A CT slice under a wrong class is a slice still; dose grids and segmentations name their own modality.
  const bool slicesPixels = data->tagExists(DCM_PixelData) && textOf(*data, DCM_Modality) == "CT";
  if (isWithoutImage(sopClass) && !slicesPixels) {
    why = "no image";
    return std::nullopt;
  }
  if (!data->tagExists(DCM_PixelData)) {
    refuse(path, "is cut off: it holds no pixels");
  }
  slice.rows = shortOf(*data, DCM_Rows, 0);
  slice.columns = shortOf(*data, DCM_Columns, 0);
  if (slice.rows < 1 || slice.columns < 1) {
    refuse(path, "has no rows or columns");
  }
  readIdentity(*data, slice);
  readCoding(*data, slice);
  readPlace(*data, slice);
  return slice;
}

std::vector<DicomSlice> readDicomSlices(const std::vector<fs::path>& files, std::vector<std::string>& notes,
                                        const ExecutionContext& context) {
  std::vector<std::optional<DicomSlice>> read(files.size());
  std::vector<std::string> whys(files.size());
  std::atomic<std::size_t> done{0};
  parallelFor(files.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      read[n] = readDicomSlice(files[n], whys[n]);
    }
    context.report(static_cast<double>(done += end - begin) / static_cast<double>(files.size()), "headers");
  });
  std::vector<DicomSlice> slices;
  std::vector<fs::path> strangers;
  std::vector<fs::path> noDicom;
  for (std::size_t n = 0; n < files.size(); ++n) {
    if (read[n]) {
      slices.push_back(std::move(*read[n]));
    } else if (toLower(files[n].filename().string()) != "dicomdir") {
      strangers.push_back(files[n]);
      if (whys[n] == kNoDicom && !isCompanion(files[n])) {
        noDicom.push_back(files[n]);
      }
    }
  }
  requireNoRuins(slices, noDicom);
  if (!slices.empty() && !strangers.empty()) {
    notes.push_back(std::to_string(strangers.size()) + " file(s) hold no DICOM image and were left out, such as " +
                    strangers.front().filename().string() + ".");
  }
  return slices;
}

}  // namespace glisson::import
