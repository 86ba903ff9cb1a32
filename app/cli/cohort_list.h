#pragma once
// Purpose: the list of a cohort: a CSV file that a person or a spreadsheet writes, one patient a line.

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/choose.h"
#include "app/cli/command.h"

namespace glisson::cli {

/// One patient. What the list leaves empty is left to the flags of the command.
struct CohortEntry {
  int number = 0;                      ///< 1 for the first patient: --task
  int line = 0;                        ///< of the file, from 1
  std::string name;                    ///< also that of the folder for the results
  std::string listedSegmentation;      ///< as it stands in the list
  std::filesystem::path segmentation;  ///< relative paths start at the list's folder
  MaskChoice choice;
  InputFlags input;
};

struct CohortList {
  std::string file;  ///< without its folder
  std::vector<CohortEntry> entries;
};

/// The first line names the columns: name and segmentation, and where wanted label or structure, labels, accept, prefer, with the
/// meaning of the flags. Cells are separated by commas, semicolons or tabs, as in the first line; a cell that holds one stands in
/// quotes. Empty lines and those that begin with # are skipped. Throws InputError, which names the line, where the list is no such
/// file: all of it is read before any work is done.
CohortList readCohortList(const std::filesystem::path& file);

}  // namespace glisson::cli
