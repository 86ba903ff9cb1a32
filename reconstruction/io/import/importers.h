#pragma once
// Purpose: the readers behind glisson-import: plain functions that parse files from outside. Frame: LPS mm. Each throws InputError
// with one sentence naming the file, the fact and the way out. They run in the child process only, under its limits; cancel is the
// parent's affair (it kills the child), `context` carries progress.

#include "reconstruction/io/handover.h"

namespace glisson::import {

CtVolume importCt(const std::filesystem::path& path, const ReadOptions& options, const ExecutionContext& context);
Segmentation importSegmentation(const std::filesystem::path& path, const ReadOptions& options, const ExecutionContext& context);
InputKind guessKind(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace glisson::import
