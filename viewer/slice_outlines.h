#pragma once
// Purpose: what one slice shows of the voxels: the CT as grey values and the masks as outlines; and what of a model they depend on.
// Pure functions.

#include <QImage>
#include <utility>
#include <vector>

#include "planning/case/liver_model.h"
#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/mask.h"
#include "viewer/slice_geometry.h"

namespace glisson {

/// One slice as Grayscale8, columns x rows; HU level - width/2 is black, level + width/2 white.
QImage sliceImage(const CtVolume& ct, const SliceGeometry& geometry, int slice, double width, double level);

/// Marching squares at 0.5 on the binary mask: segments in slice points. The mask lives on `maskGrid`; where that is not the
/// slice's grid it is sampled at the slice's voxel centres (nearest).
std::vector<std::pair<SlicePoint, SlicePoint>> outlineOf(const Mask& mask, const ImageGeometry& maskGrid,
                                                         const SliceGeometry& geometry, int slice);

/// Whether slices show both models alike. Null is a model of its own.
bool looksTheSame(const LiverModel* a, const LiverModel* b);

}  // namespace glisson
