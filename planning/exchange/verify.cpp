// verifyPackage(): the same questions as at export, asked of a folder that may have been anywhere since.
#include <algorithm>
#include <set>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/manifest.h"
#include "planning/exchange/mesh_formats.h"
#include "planning/exchange/package.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

constexpr const char* kAgain = ": export the plan again.";

/// A manifest may name only files of its own folder.
bool isPlainName(const std::string& name) {
  return !name.empty() && name.find('/') == std::string::npos && name != "." && name != "..";
}

/// The files of the manifest that are there and unchanged.
std::set<std::string> checkFiles(const std::filesystem::path& folder, const Manifest& manifest,
                                 std::vector<std::string>& problems) {
  std::set<std::string> sound;
  std::set<std::string> listed{std::string(kManifestFile)};
  for (const FileEntry& entry : manifest.files) {
    listed.insert(entry.file);
    std::error_code error;
    const std::filesystem::path path = folder / entry.file;
    if (!isPlainName(entry.file)) {
      problems.push_back("The manifest names \"" + entry.file + "\", which is outside the package" + kAgain);
    } else if (!std::filesystem::is_regular_file(path, error)) {
      problems.push_back("\"" + entry.file + "\" is missing" + kAgain);
    } else if (std::filesystem::file_size(path, error) != entry.bytes || sha256HexOfFile(path) != entry.sha256) {
      problems.push_back("\"" + entry.file + "\" has been changed since the export" + kAgain);
    } else {
      sound.insert(entry.file);
    }
  }
  for (const auto& found : std::filesystem::directory_iterator(folder)) {
    const std::string name = found.path().filename().string();
    if (!listed.contains(name)) {
      problems.push_back("\"" + name + "\" does not belong to the package: remove it or export the plan again.");
    }
  }
  return sound;
}

void checkStl(const std::filesystem::path& folder, const MeshEntry& mesh, std::vector<std::string>& problems) {
  const std::string file = mesh.id + ".stl";
  const std::string bytes = readWholeFile(folder / file);
  std::string problem = stlHeaderProblem(bytes);
  if (problem.empty()) {
    problem = differenceFrom(mesh.figures, parseStlSoup(bytes, file));
  }
  if (!problem.empty()) {
    problems.push_back("\"" + file + "\" " + problem + kAgain);
  }
}

void checkGlb(const std::filesystem::path& folder, const Manifest& manifest, std::vector<std::string>& problems) {
  const std::string file(kGlbFile);
  const GlbContent content = parseGlb(readWholeFile(folder / file), file);
  const std::string axes = rootMatrixProblem(content);
  if (!axes.empty()) {
    problems.push_back("\"" + file + "\" " + axes + kAgain);
  }
  for (const MeshEntry& mesh : manifest.meshes) {
    const auto node = std::find_if(content.nodes.begin(), content.nodes.end(), [&](const GlbNode& n) { return n.id == mesh.id; });
    const std::string problem = node == content.nodes.end() ? "is missing" : differenceFrom(mesh.figures, node->mesh);
    if (!problem.empty()) {
      problems.push_back("\"" + mesh.id + "\" in model.glb " + problem + kAgain);
    }
  }
  if (content.nodes.size() > manifest.meshes.size()) {
    problems.push_back("\"" + file + "\" holds more structures than the manifest" + std::string(kAgain));
  }
}

template <typename Check>
void collect(std::vector<std::string>& problems, const Check& check) {
  try {
    check();
  } catch (const Error& error) {
    problems.emplace_back(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    problems.push_back("The package cannot be read (" + error.code().message() + "): check your rights.");
  }
}

void checkContents(const std::filesystem::path& folder, const Manifest& manifest, const std::set<std::string>& sound,
                   std::vector<std::string>& problems) {
  const auto wanted = [&](const std::string& file, bool expected) {
    const bool listed =
        std::any_of(manifest.files.begin(), manifest.files.end(), [&](const FileEntry& e) { return e.file == file; });
    if (expected && !listed) {
      problems.push_back("The manifest does not list \"" + file + "\"" + kAgain);
    }
    return expected && sound.contains(file);
  };
  for (const MeshEntry& mesh : manifest.meshes) {
    if (isPlainName(mesh.id) && wanted(mesh.id + ".stl", manifest.stl)) {
      collect(problems, [&] { checkStl(folder, mesh, problems); });
    }
  }
  if (wanted(std::string(kGlbFile), manifest.glb)) {
    collect(problems, [&] { checkGlb(folder, manifest, problems); });
  }
  if (wanted(std::string(kPlanFile), true)) {
    collect(problems, [&] {
      const std::vector<std::string> found = planProblems(readWholeFile(folder / kPlanFile), manifest);
      problems.insert(problems.end(), found.begin(), found.end());
    });
  }
}

}  // namespace

std::vector<std::string> verifyPackage(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kManifestFile;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError("\"" + folder.string() + "\" is no navigation package, it has no manifest.json: name the package's folder.");
  }
  std::vector<std::string> problems;
  collect(problems, [&] {
    bool intact = false;
    const Manifest manifest = parseManifest(readWholeFile(path), std::string(kManifestFile), intact);
    if (!intact) {
      problems.push_back("\"manifest.json\" has been changed since the export" + std::string(kAgain));
    }
    checkContents(folder, manifest, checkFiles(folder, manifest, problems), problems);
  });
  return problems;
}

}  // namespace glisson
