#pragma once
// Purpose: small labels that are quick to evaluate, and results of `evaluate` without what may differ from run to run.

#include <array>

#include "tests/app/cli/cli_fixture.h"
#include "tests/reconstruction/evaluation/csv.h"

namespace glisson::test {

/// A MetaImage of `size` voxels of 0.8 x 0.8 x 1.6 mm.
inline void writeLabels(const std::filesystem::path& file, const std::array<int, 3>& size, const std::string& values) {
  std::ofstream(file, std::ios::binary)
      << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
         "Offset = 0 0 0\nElementSpacing = 0.8 0.8 1.6\nDimSize = "
      << size[0] << ' ' << size[1] << ' ' << size[2] << "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
      << values;
}

/// Label 1 is an ellipsoid that depth 6 is the deepest for, of `share` times its half axes; label 2 a single voxel.
inline std::string ellipsoidAndSpeck(const std::filesystem::path& file, double share = 1) {
  std::string values;
  for (int k = 0; k < 18; ++k) {
    for (int j = 0; j < 36; ++j) {
      for (int i = 0; i < 44; ++i) {
        const double x = (i - 21.7) / 18.7;
        const double y = (j - 17.6) / 15.0;
        const double z = (k - 8.3) / 6.2;
        values += x * x + y * y + z * z <= share * share ? '\1' : '\0';
      }
    }
  }
  values.back() = '\2';
  writeLabels(file, {44, 36, 18}, values);
  return file.string();
}

/// The rows of a table without the columns from `firstTimed` on.
inline std::string csvWithoutTimes(const std::filesystem::path& file, const std::string& firstTimed) {
  const auto rows = readCsv(bytesOf(file));
  const auto end = std::find(rows.at(0).begin(), rows.at(0).end(), firstTimed) - rows.at(0).begin();
  EXPECT_LT(end, std::ssize(rows.at(0)));
  std::string text;
  for (const auto& row : rows) {
    for (std::ptrdiff_t column = 0; column < end; ++column) {
      text += row.at(static_cast<std::size_t>(column)) + ",";
    }
    text += "\n";
  }
  return text;
}

inline std::string jsonWithoutTimes(const std::filesystem::path& file) {
  auto json = Json::parse(bytesOf(file));
  EXPECT_EQ(json.erase("seconds"), 1U);
  return json.dump();
}

inline std::string htmlWithoutTimes(const std::filesystem::path& file) {
  std::string html = bytesOf(file);
  const std::size_t from = html.find("<!-- times -->");
  const std::size_t to = html.find("<!-- end of times -->");
  EXPECT_NE(from, std::string::npos);
  EXPECT_GT(to, from);
  return html.erase(from, to - from);
}

inline std::string modelsWithoutTimes(const std::filesystem::path& folder) {
  return csvWithoutTimes(folder / "models.csv", "seconds");
}

/// Of one label.
inline void expectSameResults(const std::filesystem::path& a, const std::filesystem::path& b) {
  EXPECT_EQ(modelsWithoutTimes(a), modelsWithoutTimes(b));
  EXPECT_EQ(jsonWithoutTimes(a / "summary.json"), jsonWithoutTimes(b / "summary.json"));
  EXPECT_EQ(htmlWithoutTimes(a / "report.html"), htmlWithoutTimes(b / "report.html"));
}

}  // namespace glisson::test
