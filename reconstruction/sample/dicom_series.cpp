// CT Image IOD: DICOM PS3.3 A.3.
#include <dcmtk/config/osconfig.h>
// osconfig.h comes first
#include <dcmtk/dcmdata/dctk.h>

#include <string>

#include "reconstruction/errors.h"
#include "reconstruction/sample/volume_writers.h"
#include "reconstruction/text.h"

namespace glisson::sample {

namespace {

constexpr int kStoredZero = 1024;  // stored value of 0 HU: unsigned 12 bits, intercept -1024

/// 2.25. and one number (PS3.5 B.2): a fixed beginning, what it names, the series, the slice.
std::string uidOf(int what, int seriesNumber, int slice) {
  return "2.25.2104365874021785533164703" + std::to_string(1000000000LL + what * 10000000LL + seriesNumber * 1000000LL + slice);
}

std::string padded(int number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

/// A decimal string of at most 16 characters without idle zeros.
std::string decimal(double value) {
  std::string text = formatNumber(value, 4);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string decimals(const Vec3& v) { return decimal(v[0]) + "\\" + decimal(v[1]) + "\\" + decimal(v[2]); }

class Slice {
 public:
  void text(const DcmTagKey& tag, const std::string& value) { check(data().putAndInsertString(tag, value.c_str())); }
  void number(const DcmTagKey& tag, unsigned value) { check(data().putAndInsertUint16(tag, static_cast<Uint16>(value))); }
  void pixels(const std::vector<Uint16>& values) {
    check(data().putAndInsertUint16Array(DCM_PixelData, values.data(), static_cast<unsigned long>(values.size())));
  }
  void save(const std::filesystem::path& path) {
    if (file_.saveFile(path.c_str(), EXS_LittleEndianExplicit).bad()) {
      throw Error(path.string() + " could not be written; check that the folder can be written to and the disk is not full.");
    }
  }

 private:
  DcmDataset& data() { return *file_.getDataset(); }
  static void check(const OFCondition& condition) {
    if (condition.bad()) {
      throw Error(std::string("The DICOM slice could not be made (") + condition.text() +
                  "); report this as a fault of the program.");
    }
  }
  DcmFileFormat file_;
};

void putPatientAndStudy(Slice& slice, const PatientIdentity& identity, int seriesNumber) {
  slice.text(DCM_SpecificCharacterSet, "ISO_IR 192");
  slice.text(DCM_PatientName, identity.patientName);
  slice.text(DCM_PatientID, identity.patientId);
  slice.text(DCM_PatientBirthDate, identity.birthDate);
  slice.text(DCM_PatientSex, "O");
  slice.text(DCM_StudyInstanceUID, uidOf(1, seriesNumber, 0));
  slice.text(DCM_StudyID, "1");
  slice.text(DCM_StudyDate, identity.studyDate);
  slice.text(DCM_StudyTime, "120000");
  slice.text(DCM_AccessionNumber, "");
  slice.text(DCM_ReferringPhysicianName, "");
  slice.text(DCM_StudyDescription, "Synthetic liver");
}

void putSeries(Slice& slice, const PatientIdentity& identity, int seriesNumber) {
  slice.text(DCM_Modality, "CT");
  slice.text(DCM_SeriesInstanceUID, uidOf(2, seriesNumber, 0));
  slice.text(DCM_SeriesNumber, std::to_string(seriesNumber));
  slice.text(DCM_SeriesDate, identity.studyDate);
  slice.text(DCM_SeriesTime, "120000");
  slice.text(DCM_SeriesDescription, identity.seriesDescription);
  slice.text(DCM_BodyPartExamined, "LIVER");
  slice.text(DCM_PatientPosition, "HFS");
  slice.text(DCM_FrameOfReferenceUID, identity.frameOfReferenceUid);
  slice.text(DCM_PositionReferenceIndicator, "");
  slice.text(DCM_Manufacturer, "Glisson");
  slice.text(DCM_ManufacturerModelName, "Sample patient");
}

void putImage(Slice& slice, const CtVolume& ct, int seriesNumber, int k) {
  const ImageGeometry& geometry = ct.geometry;
  slice.text(DCM_SOPClassUID, UID_CTImageStorage);
  slice.text(DCM_SOPInstanceUID, uidOf(3, seriesNumber, k + 1));
  slice.text(DCM_InstanceNumber, std::to_string(k + 1));
  slice.text(DCM_ContentDate, ct.identity.studyDate);
  slice.text(DCM_ContentTime, "120000");
  slice.text(DCM_AcquisitionDate, ct.identity.studyDate);
  slice.text(DCM_AcquisitionTime, "120000");
  slice.text(DCM_AcquisitionNumber, "1");
  slice.text(DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
  slice.text(DCM_BurnedInAnnotation, "NO");
  slice.text(DCM_KVP, "120");
  slice.text(DCM_PixelSpacing, decimal(geometry.spacing[1]) + "\\" + decimal(geometry.spacing[0]));
  slice.text(DCM_SliceThickness, decimal(geometry.spacing[2]));
  slice.text(DCM_ImageOrientationPatient, decimals(geometry.direction.col(0)) + "\\" + decimals(geometry.direction.col(1)));
  const Vec3 position = geometry.toWorld(Vec3(0, 0, k));
  slice.text(DCM_ImagePositionPatient, decimals(position));
  slice.text(DCM_SliceLocation, decimal(position[2]));
  slice.text(DCM_RescaleIntercept, std::to_string(-kStoredZero));
  slice.text(DCM_RescaleSlope, "1");
  slice.text(DCM_RescaleType, "HU");
  slice.text(DCM_WindowCenter, "40");
  slice.text(DCM_WindowWidth, "350");
  slice.text(DCM_PhotometricInterpretation, "MONOCHROME2");
  slice.number(DCM_SamplesPerPixel, 1);
  slice.number(DCM_Rows, static_cast<unsigned>(geometry.size[1]));
  slice.number(DCM_Columns, static_cast<unsigned>(geometry.size[0]));
  slice.number(DCM_BitsAllocated, 16);
  slice.number(DCM_BitsStored, 12);
  slice.number(DCM_HighBit, 11);
  slice.number(DCM_PixelRepresentation, 0);
  const auto perSlice = static_cast<std::size_t>(geometry.size[0]) * static_cast<std::size_t>(geometry.size[1]);
  std::vector<Uint16> stored(perSlice);
  for (std::size_t n = 0; n < perSlice; ++n) {
    stored[n] = static_cast<Uint16>(ct.hounsfield[static_cast<std::size_t>(k) * perSlice + n] + kStoredZero);
  }
  slice.pixels(stored);
}

}  // namespace

void writeDicomSeries(const std::filesystem::path& folder, const CtVolume& ct, int seriesNumber, const ExecutionContext& context) {
  for (int k = 0; k < ct.geometry.size[2]; ++k) {
    context.report(static_cast<double>(k) / ct.geometry.size[2], "DICOM series");
    Slice slice;
    putPatientAndStudy(slice, ct.identity, seriesNumber);
    putSeries(slice, ct.identity, seriesNumber);
    putImage(slice, ct, seriesNumber, k);
    slice.save(folder / ("IM" + padded(k + 1) + ".dcm"));
  }
}

}  // namespace glisson::sample
