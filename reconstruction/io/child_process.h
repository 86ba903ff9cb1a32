#pragma once
// Purpose: runs glisson-import for one request under limits of memory, processor time and wall time, and takes its answer.
// The child is found at $GLISSON_IMPORT, else beside the running program, else in ../lib/glisson/ or ../libexec/glisson/ of it.

#include "reconstruction/execution_context.h"
#include "reconstruction/io/handover.h"

namespace glisson {

/// Starts the child and waits. Polls `context` every 50 ms (a cancel kills the child and throws Cancelled); its temporary files are
/// always removed. A crash, a time-out or a broken answer of the child is an InputError naming request.path; so is a failure it
/// reports.
ImportAnswer runImporter(const ImportRequest& request, const ExecutionContext& context);

/// The path of the child, empty where there is none.
std::filesystem::path findImporter();

}  // namespace glisson
