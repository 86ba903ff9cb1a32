#pragma once
// Purpose: what a structure is, and how a name from a file is recognised (3D-IRCADb, TotalSegmentator, 3D Slicer terms).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glisson {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  bool operator==(const Rgb&) const = default;
};

enum class StructureKind : std::uint8_t {
  Liver,  ///< the parenchyma
  PortalVein,
  HepaticVein,  ///< hepatic veins, or 3D-IRCADb's venous system
  VenaCava,
  Artery,
  Tumour,
  Cyst,
  Gallbladder,
  BileDuct,
  Other,  ///< recognised, but no part of a liver model (spleen, bone, ...): listed, not modelled
};

inline constexpr std::array kAllStructureKinds{
    StructureKind::Liver,  StructureKind::PortalVein, StructureKind::HepaticVein, StructureKind::VenaCava, StructureKind::Artery,
    StructureKind::Tumour, StructureKind::Cyst,       StructureKind::Gallbladder, StructureKind::BileDuct, StructureKind::Other};

/// The ASCII id of the kind, used in files and on the command line: liver is "parenchyma", then "portal_vein", "hepatic_vein",
/// "vena_cava", "artery", "tumour", "cyst", "gallbladder", "bile_duct", "other".
std::string_view kindId(StructureKind kind);
/// The kind of an id ("liver" is taken for "parenchyma", "tumor" for "tumour"); nothing where there is none.
std::optional<StructureKind> kindFromId(std::string_view id);
/// The kind a structure's name means, by the tables of known terms; nothing where it is not known. Never a guess: "64" is nothing.
std::optional<StructureKind> recogniseKind(std::string_view name);
/// The default colour (clinical.md).
Rgb defaultColour(StructureKind kind);
bool isVessel(StructureKind kind);
/// Tumours and cysts: what is subtracted from the functional liver.
bool isLesion(StructureKind kind);

}  // namespace glisson
