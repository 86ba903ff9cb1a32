#include "reconstruction/csv.h"

#include <gtest/gtest.h>

#include <random>

namespace glisson {
namespace {

using Cells = std::vector<std::string>;

TEST(CsvCells, AreSplitAtTheSeparatorAlone) {
  EXPECT_EQ(csvCells("a,b;c,", ','), (Cells{"a", "b;c", ""}));
  EXPECT_EQ(csvCells("a,b;c,", ';'), (Cells{"a,b", "c,"}));
  EXPECT_EQ(csvCells("", ','), Cells{""});
  EXPECT_EQ(csvCells(",", ','), (Cells{"", ""}));
}

TEST(CsvCells, InQuotesMayHoldSeparatorsAndDoubledQuotes) {
  EXPECT_EQ(csvCells(R"("5=liver,64=vein","say ""a""",)", ','), (Cells{"5=liver,64=vein", "say \"a\"", ""}));
}

TEST(CsvCells, WithAnOpenOrMisplacedQuoteAreNone) {
  EXPECT_EQ(csvCells(R"(a,"b)", ','), std::nullopt);
  EXPECT_EQ(csvCells(R"("a"b,c)", ','), std::nullopt);
  EXPECT_EQ(csvCells(R"(")", ','), std::nullopt);
  EXPECT_EQ(csvCells(R"(6" slices,b)", ','), std::nullopt);
  EXPECT_EQ(csvCells("a,b\nc", ','), std::nullopt) << "more than a line";
}

TEST(CsvCells, ComeBackAsTheyWereWritten) {
  std::mt19937 random(3);
  const std::string letters = "ab,\" ;'";
  for (int trial = 0; trial < 500; ++trial) {
    Cells cells(1 + random() % 4);
    for (std::string& cell : cells) {
      for (std::size_t n = random() % 6; n > 0; --n) {
        cell += letters[random() % letters.size()];
      }
    }
    const std::string line = csvLine(cells);
    ASSERT_EQ(csvCells(std::string_view(line).substr(0, line.size() - 1)), cells) << line;
    ASSERT_EQ(parseCsv(line), std::vector<Cells>(1, cells)) << line;
  }
}

}  // namespace
}  // namespace glisson
