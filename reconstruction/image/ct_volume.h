#pragma once
// Purpose: the CT in Hounsfield units on its grid; immutable once loaded.

#include <cstdint>
#include <string>
#include <vector>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

/// Who the images belong to. Empty texts where the source has none. Leaves the program only when asked (hazard H8).
struct PatientIdentity {
  std::string patientName;
  std::string patientId;
  std::string birthDate;          ///< YYYYMMDD or empty
  std::string studyDate;          ///< YYYYMMDD or empty
  std::string seriesDescription;  ///< phase
  std::string frameOfReferenceUid;
};

struct CtVolume {
  ImageGeometry geometry;
  std::vector<std::int16_t> hounsfield;  ///< i fastest, then j, k; geometry.voxelCount() values
  PatientIdentity identity;
  std::string source;              ///< path it was read from
  std::vector<std::string> notes;  ///< corrections made with consent, assumptions
};

}  // namespace glisson
