#pragma once
// Purpose: the exceptions of Glisson. Libraries throw, app/ translates and shows; nothing in a library prints or exits.

#include <stdexcept>
#include <string>

namespace glisson {

/// Root of every error Glisson throws. what() is one sentence: the file or structure, the fact, the way out.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder from outside cannot be read or is refused. The command line ends with exit code 3.
class InputError : public Error {
 public:
  using Error::Error;
};

/// The reconstruction room cannot compute from what it was given (for example an empty mask). Exit code 3.
class ReconstructionError : public Error {
 public:
  using Error::Error;
};

/// A planning operation cannot be done with what it was given (for example a model without a parenchyma). Exit code 3.
class PlanningError : public Error {
 public:
  using Error::Error;
};

/// Something was computed, but failed its check (a surface with defects, a package that reads back otherwise). Exit code 4.
class CheckFailed : public Error {
 public:
  using Error::Error;
};

/// Options that make no sense (depth 11) or do not fit the input (no such label or plan, a plane beside the liver). Exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// The user cancelled. Not an Error: it is caught apart and never shown as a failure. Exit code 130.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace glisson
