#pragma once
// Purpose: the table of undo records, one form for every kind of edit (case_tables.h has the columns). Private to storage/. None of
// these opens a transaction; what does not fit throws InputError about the file.

#include <string>
#include <vector>

#include "planning/storage/database.h"
#include "planning/storage/edit_step.h"

namespace glisson::caseTables {

/// The plans as text, proven to read back. Throws PlanningError: a number that is not finite would spoil the file.
std::string plansText(const std::vector<ResectionPlan>& plans);

/// What an edit but one of the plans replaced, as text.
struct OtherEdit {
  const char* kind;  ///< "patient", "territories", "structures": the columns' first part
  std::string before;
  std::string after;
};

void appendPlans(const Database& database, const std::string& before, const std::string& after, const std::string& name);
/// `plans`: as they stand. To a program that does not know the kind it is an edit that changes nothing.
void append(const Database& database, const std::string& plans, const OtherEdit& edit, const std::string& name);
/// The edit goes on from the newest record, which ends with `edit.before`: they become one. False where it does not.
bool goOn(const Database& database, const OtherEdit& edit);

void writeHistory(const Database& database, const std::vector<EditStep>& steps);
/// The newest `atMost` edits, oldest first. `named`: the file's version has names of edits.
std::vector<EditStep> readHistory(const Database& database, std::size_t atMost, bool named);

}  // namespace glisson::caseTables
