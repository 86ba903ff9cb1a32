#include "reconstruction/io/import/itk_folder.h"

#include <cstdlib>
#include <fstream>

#include "reconstruction/errors.h"

namespace glisson::import {

namespace {
namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& userFile) {
  throw InputError(userFile.string() + " cannot be read because no file can be made in " + fs::temp_directory_path().string() +
                   "; free some space there.");
}
}  // namespace

ItkFolder::ItkFolder(const fs::path& userFile) : userFile_(userFile) {
  std::string pattern = (fs::temp_directory_path() / "itk-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    refuse(userFile_);
  }
  path_ = pattern;
}

ItkFolder::~ItkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path ItkFolder::write(const std::string& name, std::string_view bytes) const {
  std::ofstream out(path_ / name, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) {
    refuse(userFile_);
  }
  return path_ / name;
}

void ItkFolder::link(const std::string& name, const fs::path& target) const {
  std::error_code error;
  fs::create_symlink(fs::absolute(target), path_ / name, error);
  if (error) {
    refuse(userFile_);
  }
}

}  // namespace glisson::import
