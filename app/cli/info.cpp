#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/report.h"
#include "app/cli/table.h"
#include "planning/storage/case_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

struct InfoFlags {
  std::vector<std::string> paths;
  bool json = false;
  InputFlags input;
};

Json geometryJson(const ImageGeometry& geometry) {
  Json direction = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    direction.push_back(vectorJson(geometry.direction.row(row)));
  }
  return {{"size", geometry.size},
          {"spacingMm", vectorJson(geometry.spacing)},
          {"originMm", vectorJson(geometry.origin)},
          {"directionRows", direction}};
}

std::string kindText(const std::optional<StructureKind>& kind) { return kind ? std::string(kindId(*kind)) : "unknown"; }

Json ctJson(const CtVolume& ct) {
  const auto [low, high] = std::minmax_element(ct.hounsfield.begin(), ct.hounsfield.end());
  return {
      {"holds", "ct"}, {"geometry", geometryJson(ct.geometry)}, {"lowestHu", *low}, {"highestHu", *high}, {"warnings", ct.notes}};
}

Json segmentationJson(const Segmentation& segmentation) {
  Json structures = Json::array();
  for (const LabelledMask& structure : segmentation.structures) {
    Json entry = {{"name", structure.name}, {"label", structure.label}, {"kind", kindText(structure.kind)}};
    entry["voxels"] = structure.mask ? Json(structure.mask->count()) : Json(nullptr);
    entry["volumeMl"] = structure.mask ? Json(volumeMl(*structure.mask, segmentation.geometry)) : Json(nullptr);
    structures.push_back(std::move(entry));
  }
  Json json = {{"holds", "segmentation"}, {"geometry", geometryJson(segmentation.geometry)}, {"structures", structures}};
  Json warnings = segmentation.notes;
  const bool hasLiver = std::any_of(segmentation.structures.begin(), segmentation.structures.end(), [](const LabelledMask& s) {
    return s.kind == StructureKind::Liver && s.mask && !s.mask->empty();
  });
  if (hasLiver) {
    const LiverVoxels liver = liverVoxels(segmentation);
    json["totalMl"] = liver.totalMl();
    json["tumourMl"] = liver.tumourMl();
    json["functionalMl"] = liver.functionalMl();
    for (const std::string& note : liver.notes) {
      warnings.push_back(note);
    }
  } else {
    warnings.push_back("no structure is known to be the liver; say which with --labels N=liver or --labels NAME=liver");
  }
  for (const LabelledMask& structure : segmentation.structures) {
    if (!structure.kind) {
      warnings.push_back(structure.name + " is of unknown kind; say which with --labels \"" + labelsKey(structure) + "=KIND\"");
    }
  }
  json["warnings"] = std::move(warnings);
  return json;
}

Json caseJson(const CaseFile& file) {
  const Case source = file.load();
  Json structures = Json::array();
  for (const Structure& structure : source.model->structures) {
    Json entry = {{"id", structure.id}, {"name", structure.name}, {"kind", kindId(structure.kind)}};
    if (structure.reconstruction) {
      const Reconstruction& made = *structure.reconstruction;
      entry["method"] = made.parameters.describe();
      entry["triangles"] = made.mesh.triangles.size();
      entry["volumeMl"] = number(made.meshVolumeMl);
      entry["voxelVolumeMl"] = number(made.voxelVolumeMl);
      entry["defects"] = made.defects.names();
    }
    structures.push_back(std::move(entry));
  }
  Json plans = Json::array();
  for (const ResectionPlan& plan : source.plans) {
    plans.push_back({{"name", plan.name}, {"resections", plan.resections.size()}, {"safetyMarginMm", plan.safetyMarginMm}});
  }
  return {{"holds", "case"},
          {"code", source.code},
          {"geometry", geometryJson(source.liver->geometry)},
          {"ctEmbedded", file.hasEmbeddedCt()},
          {"structures", structures},
          {"plans", plans},
          {"warnings", source.notes}};
}

Json describe(const std::string& path, const ReadOptions& options, const ExecutionContext& context) {
  switch (guessInput(path)) {
    case InputKind::Ct:
      return ctJson(readCt(path, options, context));
    case InputKind::Case:
      return caseJson(CaseFile::open(path));
    case InputKind::Segmentation:
    case InputKind::Unknown:  // the reader says best why it cannot be read
      break;
  }
  return segmentationJson(readSegmentation(path, options, context));
}

/// A number with a few digits, a list in brackets, a text as it is.
std::string wordOf(const Json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (value.is_null()) {
    return "-";
  }
  if (value.is_number_float()) {
    return formatNumber(value.get<double>(), 4);
  }
  if (!value.is_array()) {
    return value.dump();
  }
  std::string words;
  for (const Json& part : value) {
    words += (words.empty() ? "" : ", ") + wordOf(part);
  }
  return value.empty() ? "none" : "(" + words + ")";
}

void printGeometry(const Json& geometry) {
  std::cout << "  size " << wordOf(geometry["size"]) << ", spacing " << wordOf(geometry["spacingMm"]) << " mm, origin "
            << wordOf(geometry["originMm"]) << " mm LPS\n  direction, by rows " << wordOf(geometry["directionRows"]) << '\n';
}

void printStructures(const Json& structures) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& structure : structures) {
    if (rows.empty()) {
      rows.emplace_back();
      for (const auto& [key, value] : structure.items()) {
        rows.back().push_back("  " + key);
      }
    }
    rows.emplace_back();
    for (const auto& [key, value] : structure.items()) {
      rows.back().push_back("  " + wordOf(value));
    }
  }
  std::cout << alignedTable(rows);
}

void printText(const Json& all) {
  for (const Json& entry : all) {
    std::cout << entry["path"].get<std::string>() << ": " << entry["holds"].get<std::string>() << '\n';
    printGeometry(entry["geometry"]);
    for (const auto& [key, value] : entry.items()) {
      if (key == "structures") {
        printStructures(value);
      } else if (key == "ctEmbedded") {
        std::cout << "  CT: " << (value.get<bool>() ? "embedded" : "not embedded") << '\n';
      } else if (value.is_number()) {
        std::cout << "  " << key << ": " << (value.is_number_float() ? formatNumber(value.get<double>(), 2) : value.dump()) << '\n';
      } else if (key == "plans") {
        for (const Json& plan : value) {
          std::cout << "  plan: " << plan["name"].get<std::string>() << ", " << plan["resections"] << " resections\n";
        }
      }
    }
    for (const Json& warning : entry["warnings"]) {
      std::cout << "  warning: " << warning.get<std::string>() << '\n';
    }
  }
}

}  // namespace

void addInfo(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<InfoFlags>();
  auto* command = app.add_subcommand("info", "What files or folders hold: geometry, labels, volumes, warnings");
  command->add_option("PATH", flags->paths, "CT, segmentation or case; file or folder")->required();
  command->add_flag("--json", flags->json, "JSON on stdout");
  addInputFlags(*command, flags->input);
  command->callback([flags, &chosen] {
    chosen = [flags](const ExecutionContext& context) {
      const ReadOptions options = readOptions(flags->input);
      Json all = Json::array();
      for (const std::string& path : flags->paths) {
        Json entry = {{"path", path}};
        entry.update(describe(path, options, context));
        all.push_back(std::move(entry));
      }
      if (flags->json) {
        std::cout << textOf(all) << '\n';
      } else {
        printText(all);
      }
      return kDone;
    };
  });
}

}  // namespace glisson::cli
