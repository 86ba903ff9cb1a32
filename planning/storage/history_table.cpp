#include "planning/storage/history_table.h"

#include <algorithm>
#include <array>

#include "planning/storage/case_json.h"
#include "planning/storage/table_access.h"
#include "reconstruction/errors.h"

namespace glisson::caseTables {

namespace {

constexpr std::array kKinds{"patient", "territories", "structures"};

bool records(const Database& database, const std::string& kind) {
  Statement statement(database, "SELECT 1 FROM pragma_table_info('history') WHERE name = ?");
  return statement.bind(0, std::string_view(kind + "_after")).step();
}

/// Of an edit of a kind that is not the plans'.
template <typename Value, typename From>
OtherEdit textsOf(const char* kind, const Change<Value>& change, const From& from) {
  return {kind, textOf(from(change.before)), textOf(from(change.after))};
}

template <typename Value, typename To>
void take(std::optional<Change<Value>>& change, const Statement& row, int column, const To& to) {
  if (const std::string after = row.text(column + 1); !after.empty()) {
    change = {to(Json::parse(row.text(column))), to(Json::parse(after))};
  }
}

EditStep stepOf(const Statement& row) {
  EditStep step{row.text(2), caseJson::toPlans(Json::parse(row.text(0))), caseJson::toPlans(Json::parse(row.text(1)))};
  take(step.patient, row, 3, caseJson::toFacts);
  take(step.territories, row, 5, caseJson::toMarks);
  take(step.structures, row, 7, caseJson::toStates);
  if (step.structures &&
      !std::ranges::equal(step.structures->before, step.structures->after, {}, &StructureState::id, &StructureState::id)) {
    throw std::runtime_error("an edit of structures has not the same ones before and after");
  }
  return step;
}
}  // namespace

std::string plansText(const std::vector<ResectionPlan>& plans) {
  std::string text = textOf(caseJson::fromPlans(plans));
  try {
    (void)caseJson::toPlans(Json::parse(text));
  } catch (const std::exception&) {
    throw PlanningError(
        "The plan holds a number that is not finite, a normal that is not of unit length or a bend that is none; place the plane "
        "again.");
  }
  return text;
}

void appendPlans(const Database& database, const std::string& before, const std::string& after, const std::string& name) {
  Statement(database, "INSERT INTO history(before, after, name) VALUES(?, ?, ?)")
      .bind(0, std::string_view(before))
      .bind(1, std::string_view(after))
      .bind(2, std::string_view(name))
      .step();
}

void append(const Database& database, const std::string& plans, const OtherEdit& edit, const std::string& name) {
  const std::string kind = edit.kind;
  if (!records(database, kind)) {
    database.execute(("ALTER TABLE history ADD COLUMN " + kind + "_before TEXT").c_str());
    database.execute(("ALTER TABLE history ADD COLUMN " + kind + "_after TEXT").c_str());
  }
  const std::string sql = "INSERT INTO history(before, after, name, " + kind + "_before, " + kind + "_after) VALUES(?, ?, ?, ?, ?)";
  Statement(database, sql.c_str())
      .bind(0, std::string_view(plans))
      .bind(1, std::string_view(plans))
      .bind(2, std::string_view(name))
      .bind(3, std::string_view(edit.before))
      .bind(4, std::string_view(edit.after))
      .step();
}

bool goOn(const Database& database, const OtherEdit& edit) {
  const std::string kind = edit.kind;
  if (!records(database, kind)) {
    return false;
  }
  const std::string newest = "SELECT step, " + kind + "_after FROM history ORDER BY step DESC LIMIT 1";
  Statement row(database, newest.c_str());
  if (!row.step() || row.text(1) != edit.before) {
    return false;
  }
  const std::string sql = "UPDATE history SET " + kind + "_after = ? WHERE step = ?";
  Statement(database, sql.c_str()).bind(0, std::string_view(edit.after)).bind(1, row.number(0)).step();
  return true;
}

void writeHistory(const Database& database, const std::vector<EditStep>& steps) {
  for (const EditStep& step : steps) {
    const std::string plans = plansText(step.after);
    if (step.patient) {
      append(database, plans, textsOf(kKinds[0], *step.patient, caseJson::fromFacts), step.name);
    } else if (step.territories) {
      append(database, plans, textsOf(kKinds[1], *step.territories, caseJson::fromMarks), step.name);
    } else if (step.structures) {
      append(database, plans, textsOf(kKinds[2], *step.structures, caseJson::fromStates), step.name);
    } else {
      appendPlans(database, plansText(step.before), plans, step.name);
    }
  }
}

std::vector<EditStep> readHistory(const Database& database, std::size_t atMost, bool named) {
  std::string columns = named ? "before,after,name" : "before,after,''";
  for (const std::string kind : kKinds) {
    columns += records(database, kind) ? "," + kind + "_before," + kind + "_after" : std::string(",'',''");
  }
  const std::string sql = "SELECT " + columns + " FROM history ORDER BY step DESC LIMIT ?";
  Statement statement(database, sql.c_str());
  statement.bind(0, static_cast<std::int64_t>(atMost));
  return readOrDamaged(database, "its history cannot be read", [&] {
    std::vector<EditStep> steps;
    while (statement.step()) {
      steps.push_back(stepOf(statement));
    }
    std::ranges::reverse(steps);
    return steps;
  });
}

}  // namespace glisson::caseTables
