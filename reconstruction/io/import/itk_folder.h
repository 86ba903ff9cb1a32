#pragma once
// Purpose: a private folder with a header of our own making and a link to the user's data, for ITK to read. So its parsers meet
// nothing that was not verified here: no comment that overruns a buffer, no foreign file name, no extension.

#include <filesystem>
#include <string>
#include <string_view>

namespace glisson::import {

/// Goes with the object. Each function throws InputError naming the user's file where the folder cannot be written.
class ItkFolder {
 public:
  explicit ItkFolder(const std::filesystem::path& userFile);
  ~ItkFolder();
  ItkFolder(const ItkFolder&) = delete;
  ItkFolder& operator=(const ItkFolder&) = delete;

  std::filesystem::path write(const std::string& name, std::string_view bytes) const;
  void link(const std::string& name, const std::filesystem::path& target) const;

 private:
  std::filesystem::path userFile_;
  std::filesystem::path path_;
};

}  // namespace glisson::import
