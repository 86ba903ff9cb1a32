#pragma once
// Purpose: what a further reconstruction method is [Palomar 2016, 5.2, 5.5, 5.6]: one file here that fills a ReconstructionMethod
// and one line in methods.cpp bring it to `reconstruct`, to the experiment and to the window.

#include <functional>
#include <string>
#include <vector>

#include "reconstruction/mesh/surface_mesh.h"
#include "reconstruction/poisson/samples.h"

namespace glisson {

/// What all methods are given.
struct MethodInput {
  const Mask& mask;  ///< on the grid of `geometry`
  const ImageGeometry& geometry;
  Sampling sampling = Sampling::Unbiased;  ///< of methods that begin with points and are not bound to one
  double scale = 1.1;                      ///< of a cube that is divided, over the samples' largest extent
};

/// A surface with what is to be told of it, unchecked: closed and outward is promised, freedom from self-intersections is not.
struct MethodSurface {
  SurfaceMesh mesh = {};  ///< mm LPS
  double cellMm = 0;      ///< side of the cells that carry the surface
  int usedDepth = 0;      ///< of a cube that is divided in 2^depth cells a side; 0: none
  std::vector<std::string> notes = {};
  double sampleSeconds = 0, solveSeconds = 0, extractSeconds = 0, simplifySeconds = 0;
};

/// A method with its parameters set: one model of the experiment.
struct MethodVariant {
  std::string id;    ///< "d7": for files and flags; letters, digits, '_', '.'
  std::string name;  ///< "d=7": for people
  int depth = 0;     ///< 0, or what usedDepth has to be: lowered it would be another variant's model
  /// Throws ReconstructionError, Cancelled. The same bytes for any number of threads.
  std::function<MethodSurface(const MethodInput& input, const ExecutionContext& context)> make;
};

struct ReconstructionMethod {
  std::string id;                            ///< "psr_knn": for files and flags, like the variants'
  std::string name;                          ///< "PSR, k-NN normals": for people
  std::string description;                   ///< one sentence
  std::string citation;                      ///< authors, title, where, year
  std::vector<MethodVariant> variants = {};  ///< in the order of the tables
  std::string usual;                         ///< the variant that is taken where none is named
};

}  // namespace glisson
