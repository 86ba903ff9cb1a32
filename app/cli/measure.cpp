#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>

#include "app/cli/choose.h"
#include "app/cli/command.h"
#include "app/cli/report.h"
#include "planning/exchange/mesh_files.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/curvature.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

struct MeasureFlags {
  std::string mesh;
  std::string reference;
  bool json = false;
  MaskChoice choice;
  InputFlags input;
};

struct Measures {
  SurfaceMesh mesh;
  MeshDefects defects;
  std::vector<std::string> notes;
  double volumeMl = std::nan("");  ///< an open mesh has none, nor one whose triangles disagree about outside
  std::uint32_t components = 0;
  CurvatureSummary curvature;
  std::optional<ErrorSummary> paperErrorMm;
  std::optional<ErrorSummary> voxelErrorMm;
};

Measures measure(const MeasureFlags& flags, const ExecutionContext& context) {
  Measures m;
  m.mesh = readMesh(flags.mesh);
  if (m.mesh.empty()) {
    throw InputError(flags.mesh + " holds no triangles; choose a mesh with a surface");
  }
  m.defects = m.mesh.defects();
  m.defects.selfIntersections = countSelfIntersections(m.mesh, context);
  if (m.defects.openEdges > 0) {
    m.notes.emplace_back("the surface is open: it has no volume");
  } else if (m.defects.orientationEdges > 0) {
    m.notes.emplace_back("triangles disagree about which side is outside: the surface has no volume");
  } else {
    m.volumeMl = volumeMl(m.mesh);
  }
  componentOfTriangles(m.mesh, m.components);
  if (m.components > 1) {
    m.notes.push_back(std::to_string(m.components) + " components");
  }
  m.curvature = meanGaussianCurvature(m.mesh);
  if (m.curvature.tinyTriangles > 0) {
    m.notes.push_back(std::to_string(m.curvature.tinyTriangles) + " triangles below 1e-6 mm2; untrimmed mean Gaussian curvature " +
                      formatExact(m.curvature.untrimmedPerMm2) + " /mm2");
  }
  if (!flags.reference.empty()) {
    const Segmentation segmentation = readSegmentation(flags.reference, readOptions(flags.input), context);
    const ChosenMask chosen = chooseMask(segmentation, flags.choice);
    try {
      m.paperErrorMm = paperError(m.mesh, *chosen.mask, segmentation.geometry, context);
      if (!m.paperErrorMm) {
        m.notes.emplace_back("no paper error: no voxel of the reference has a normal");
      }
      m.voxelErrorMm = voxelError(m.mesh, *chosen.mask, segmentation.geometry, context);
    } catch (const ReconstructionError&) {
      throw ReconstructionError(flags.reference + ", " + chosen.name +
                                ": there is no surface to measure errors from; choose another");
    }
  }
  return m;
}

void printJson(const Measures& m) {
  Json json = {{"triangles", m.mesh.triangles.size()},
               {"vertices", m.mesh.vertices.size()},
               {"areaMm2", areaMm2(m.mesh)},
               {"volumeMl", number(m.volumeMl)},
               {"defects", m.defects.names()},
               {"notes", m.notes},
               {"eulerCharacteristic", eulerCharacteristic(m.mesh)},
               {"components", m.components},
               {"meanGaussianCurvaturePerMm2", number(m.curvature.trimmedPerMm2)}};
  if (m.voxelErrorMm) {
    json["paperErrorMm"] = toJson(m.paperErrorMm);
    json["voxelErrorMm"] = toJson(*m.voxelErrorMm);
  }
  std::cout << textOf(json) << '\n';
}

void printErrors(const std::string& name, const ErrorSummary& errors) {
  std::cout << name << ": mean " << formatNumber(errors.mean, 4) << " mm, median " << formatNumber(errors.median, 4) << " mm, p95 "
            << formatNumber(errors.p95, 4) << " mm, max " << formatNumber(errors.max, 4) << " mm\n";
}

void printText(const MeasureFlags& flags, const Measures& m) {
  std::cout << flags.mesh << '\n'
            << "triangles: " << m.mesh.triangles.size() << '\n'
            << "vertices: " << m.mesh.vertices.size() << '\n'
            << "area: " << formatNumber(areaMm2(m.mesh), 2) << " mm2\n"
            << "volume: " << (std::isfinite(m.volumeMl) ? formatNumber(m.volumeMl, 3) + " mL" : "none") << '\n'
            << "Euler characteristic: " << eulerCharacteristic(m.mesh) << '\n'
            << "components: " << m.components << '\n'
            << "mean Gaussian curvature: " << formatNumber(m.curvature.trimmedPerMm2, 6) << " /mm2 (5th to 95th percentile), "
            << formatNumber(m.curvature.untrimmedPerMm2, 6) << " /mm2 untrimmed, " << m.curvature.tinyTriangles
            << " triangles below 1e-6 mm2\n";
  if (m.paperErrorMm) {
    printErrors("paper error", *m.paperErrorMm);
  }
  if (m.voxelErrorMm) {
    printErrors("voxel error", *m.voxelErrorMm);
  }
  for (const std::string& note : m.notes) {
    std::cout << "note: " << note << '\n';
  }
  for (const std::string& defect : m.defects.names()) {
    std::cout << "defect: " << defect << '\n';
  }
}

}  // namespace

void addMeasure(CLI::App& app, Action& chosen) {
  auto flags = std::make_shared<MeasureFlags>();
  auto* command = app.add_subcommand("measure", "Volume, area, invariants, curvature and distances of a mesh file");
  command->add_option("MESH", flags->mesh, "An .stl, .ply, .obj or .vtp file, mm LPS")->required();
  command->add_option("--reference", flags->reference, "Label map or folder of masks to measure the errors against");
  addMaskChoice(*command, flags->choice);
  command->add_flag("--json", flags->json, "JSON on stdout");
  addInputFlags(*command, flags->input);
  command->callback([flags, &chosen] {
    chosen = [flags](const ExecutionContext& context) {
      if (flags->reference.empty() && (flags->choice.label || !flags->choice.structure.empty())) {
        throw UsageError("--label and --structure choose from --reference SEG; name it");
      }
      const Measures m = measure(*flags, context);
      flags->json ? printJson(m) : printText(*flags, m);
      if (m.defects.any()) {
        complain(flags->mesh + " has defects: " + m.defects.names().front());
        return kCheckFailed;
      }
      return kDone;
    };
  });
}

}  // namespace glisson::cli
