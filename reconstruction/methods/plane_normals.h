#pragma once
// Purpose: normals from the points alone, by planes fitted to each point's nearest neighbours (principal components of their
// coordinates; Hoppe et al., Surface reconstruction from unorganized points, SIGGRAPH 1992; so in Leonardi et al. 2011 and Wu et
// al. 2010 for boundary voxels). Which of a plane's two sides is outward the mask tells; no normals are carried from point to
// point.

#include "reconstruction/poisson/samples.h"

namespace glisson {

/// A plane wants three points at least; ten are usual for boundary voxels.
inline constexpr int kUsualNeighbours = 10;

/// `points`, as sampleBoundary() finds them in a mask, with other normals: unit, mm LPS, on the outward side of the old one
/// (Unbiased: of the face), and with the weights that belong to them. Where the neighbours lie on a line there is no plane, and the
/// old normal stays. `neighbours`, the point itself among them, are 3 or more: std::invalid_argument. The same bytes for any number
/// of threads. Polls cancel every few thousand points.
OrientedPoints withPlaneNormals(OrientedPoints points, const ImageGeometry& geometry, int neighbours = kUsualNeighbours,
                                const ExecutionContext& context = {});

}  // namespace glisson
