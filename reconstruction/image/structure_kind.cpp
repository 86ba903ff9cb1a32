#include "reconstruction/image/structure_kind.h"

#include <array>
#include <unordered_map>
#include <utility>

#include "reconstruction/image/label_tables.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
constexpr std::array<std::pair<StructureKind, std::string_view>, 10> kIds{{{StructureKind::Liver, "parenchyma"},
                                                                           {StructureKind::PortalVein, "portal_vein"},
                                                                           {StructureKind::HepaticVein, "hepatic_vein"},
                                                                           {StructureKind::VenaCava, "vena_cava"},
                                                                           {StructureKind::Artery, "artery"},
                                                                           {StructureKind::Tumour, "tumour"},
                                                                           {StructureKind::Cyst, "cyst"},
                                                                           {StructureKind::Gallbladder, "gallbladder"},
                                                                           {StructureKind::BileDuct, "bile_duct"},
                                                                           {StructureKind::Other, "other"}}};

/// Lower case; blanks, signs and the trailing number dropped: "Tumor 1", "tumor_01" and "TUMOR" are one term. A digit within the
/// name stays: it may change the meaning.
std::string normalised(std::string_view name) {
  std::string term;
  for (const char c : toLower(name)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || byte >= 0x80) {
      term.push_back(c);
    }
  }
  while (!term.empty() && term.back() >= '0' && term.back() <= '9') {
    term.pop_back();
  }
  return term;
}

using TermTable = std::unordered_map<std::string, StructureKind>;

void addTerms(TermTable& table, StructureKind kind, std::initializer_list<const char*> terms) {
  for (const char* term : terms) {
    table.emplace(term, kind);
  }
}

void addOrgans(TermTable& table) {
  addTerms(table, StructureKind::Other,
           {"background",
            "bone",
            "bones",
            "skin",
            "body",
            "spleen",
            "kidney",
            "kidneys",
            "leftkidney",
            "rightkidney",
            "lung",
            "lungs",
            "leftlung",
            "rightlung",
            "heart",
            "stomach",
            "pancreas",
            "colon",
            "smallintestin",
            "smallintestine",
            "largeintestine",
            "bowel",
            "duodenum",
            "surrenalgland",
            "leftsurrenalgland",
            "rightsurrenalgland",
            "adrenalgland",
            "leftadrenalgland",
            "rightadrenalgland",
            "bladder",
            "urinarybladder",
            "uterus",
            "prostate",
            "metal",
            "esophagus",
            "oesophagus",
            "trachea",
            "thyroid",
            "brain",
            "spinalcord",
            "spine",
            "rib",
            "ribs",
            "vertebra",
            "vertebrae",
            "sternum",
            "sacrum",
            "pelvis",
            "muscle",
            "fat",
            "adiposetissue"});
  for (const char* name : {"totalsegmentator", "totalsegmentator-v1", "totalsegmentator-mr"}) {
    for (const auto& [number, organ] : labelTableNames(name)) {
      table.emplace(normalised(organ), StructureKind::Other);  // what stands in the table already keeps its kind
    }
  }
}

TermTable buildTerms() {
  TermTable table;
  addTerms(table, StructureKind::Liver,
           {"liver", "parenchyma", "liverparenchyma", "hepaticparenchyma", "wholeliver", "leber", "hepar"});
  addTerms(table, StructureKind::PortalVein,
           {"portalvein", "portalveins", "portalvenoussystem", "portalsystem", "portalveinandsplenicvein", "portalveinsplenicvein",
            "hepaticportalvein", "liverportalvein", "venaportae", "portavein"});
  addTerms(table, StructureKind::HepaticVein,
           {"hepaticvein", "hepaticveins", "venoussystem", "hepaticvenoussystem", "hepaticvenous", "hepaticveinsystem",
            "liverveins", "righthepaticvein", "middlehepaticvein", "lefthepaticvein", "venahepatica", "venaehepaticae"});
  addTerms(table, StructureKind::VenaCava, {"inferiorvenacava", "venacava", "ivc", "venacavainferior", "cavalvein", "postcava"});
  addTerms(table, StructureKind::Artery,
           {"artery", "arteries", "hepaticartery", "hepaticarteries", "arterialsystem", "aorta", "properhepaticartery",
            "commonhepaticartery", "righthepaticartery", "lefthepaticartery", "celiactrunk", "coeliactrunk"});
  addTerms(table, StructureKind::Tumour,
           {"tumour",
            "tumours",
            "tumor",
            "tumors",
            "livertumor",
            "livertumors",
            "livertumour",
            "livertumours",
            "hepatictumor",
            "hepatictumour",
            "mass",
            "livermass",
            "neoplasm",
            "neoplasms",
            "liverneoplasm",
            "metastasis",
            "metastases",
            "livermetastasis",
            "livermetastases",
            "hcc",
            "liverlesion",
            "liverlesions",
            "hepatocellularcarcinoma",
            "carcinoma",
            "cholangiocarcinoma"});
  addTerms(table, StructureKind::Cyst,
           {"cyst", "cysts", "livercyst", "livercysts", "liverkyst", "liverkysts", "liverkyste", "kyst", "hepaticcyst"});
  addTerms(table, StructureKind::Gallbladder, {"gallbladder", "vesicafellea"});
  addTerms(table, StructureKind::BileDuct,
           {"bileduct", "bileducts", "commonbileduct", "hepaticduct", "commonhepaticduct", "biliarysystem", "biliarytree",
            "biliaryduct", "biliaryducts", "bile"});
  addOrgans(table);
  return table;
}

const TermTable& terms() {
  static const TermTable kTable = buildTerms();
  return kTable;
}
}  // namespace

std::string_view kindId(StructureKind kind) {
  for (const auto& [known, id] : kIds) {
    if (known == kind) {
      return id;
    }
  }
  return "other";
}

std::optional<StructureKind> kindFromId(std::string_view id) {
  const std::string lower = toLower(id);
  for (const auto& [kind, known] : kIds) {
    if (known == lower) {
      return kind;
    }
  }
  if (lower == "liver") {
    return StructureKind::Liver;
  }
  return lower == "tumor" ? std::optional(StructureKind::Tumour) : std::nullopt;
}

std::optional<StructureKind> recogniseKind(std::string_view name) {
  const auto found = terms().find(normalised(name));
  return found == terms().end() ? std::nullopt : std::optional(found->second);
}

Rgb defaultColour(StructureKind kind) {
  switch (kind) {
    case StructureKind::Liver:
      return {221, 130, 101};
    case StructureKind::PortalVein:
      return {150, 90, 200};
    case StructureKind::HepaticVein:
    case StructureKind::VenaCava:
      return {0, 151, 206};
    case StructureKind::Artery:
      return {200, 40, 40};
    case StructureKind::Tumour:
      return {144, 238, 144};
    case StructureKind::Cyst:
      return {205, 205, 100};
    case StructureKind::Gallbladder:
      return {139, 150, 98};
    case StructureKind::BileDuct:
      return {0, 145, 30};
    case StructureKind::Other:
      break;
  }
  return {180, 180, 180};
}

bool isVessel(StructureKind kind) {
  return kind == StructureKind::PortalVein || kind == StructureKind::HepaticVein || kind == StructureKind::VenaCava ||
         kind == StructureKind::Artery;
}

bool isLesion(StructureKind kind) { return kind == StructureKind::Tumour || kind == StructureKind::Cyst; }

}  // namespace glisson
