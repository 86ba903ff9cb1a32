#include "reconstruction/image/label_tables.h"

#include <span>
#include <vector>

namespace glisson {

namespace {
class TableBuilder {
 public:
  void add(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      names_.emplace(next_++, name);
    }
  }
  /// name_left, name_right for each.
  void addPairs(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      names_.emplace(next_++, std::string(name) + "_left");
      names_.emplace(next_++, std::string(name) + "_right");
    }
  }
  /// prefix + from, from - 1, ..., 1.
  void addDown(const std::string& prefix, int from) {
    for (int n = from; n >= 1; --n) {
      names_.emplace(next_++, prefix + std::to_string(n));
    }
  }
  void addUp(const std::string& prefix, int to) {
    for (int n = 1; n <= to; ++n) {
      names_.emplace(next_++, prefix + std::to_string(n));
    }
  }
  std::map<int, std::string> take() { return std::move(names_); }

 private:
  std::map<int, std::string> names_;
  int next_ = 1;
};

/// What the tables of CT (v2) and MR begin with.
constexpr std::initializer_list<const char*> kUpperAbdomen{
    "spleen",  "kidney_right", "kidney_left",         "gallbladder",       "liver",
    "stomach", "pancreas",     "adrenal_gland_right", "adrenal_gland_left"};

std::map<int, std::string> totalV2() {
  TableBuilder table;
  table.add(kUpperAbdomen);
  table.add({"lung_upper_lobe_left", "lung_lower_lobe_left", "lung_upper_lobe_right", "lung_middle_lobe_right",
             "lung_lower_lobe_right", "esophagus", "trachea", "thyroid_gland", "small_bowel", "duodenum", "colon",
             "urinary_bladder", "prostate", "kidney_cyst_left", "kidney_cyst_right", "sacrum", "vertebrae_S1"});
  table.addDown("vertebrae_L", 5);
  table.addDown("vertebrae_T", 12);
  table.addDown("vertebrae_C", 7);
  table.add({"heart", "aorta", "pulmonary_vein", "brachiocephalic_trunk", "subclavian_artery_right", "subclavian_artery_left",
             "common_carotid_artery_right", "common_carotid_artery_left", "brachiocephalic_vein_left", "brachiocephalic_vein_right",
             "atrial_appendage_left", "superior_vena_cava", "inferior_vena_cava", "portal_vein_and_splenic_vein"});
  table.addPairs({"iliac_artery", "iliac_vena", "humerus", "scapula", "clavicula", "femur", "hip"});
  table.add({"spinal_cord"});
  table.addPairs({"gluteus_maximus", "gluteus_medius", "gluteus_minimus", "autochthon", "iliopsoas"});
  table.add({"brain", "skull"});
  table.addUp("rib_left_", 12);
  table.addUp("rib_right_", 12);
  table.add({"sternum", "costal_cartilages"});
  return table.take();
}

std::map<int, std::string> totalV1() {
  TableBuilder table;
  table.add({"spleen", "kidney_right", "kidney_left", "gallbladder", "liver", "stomach", "aorta", "inferior_vena_cava",
             "portal_vein_and_splenic_vein", "pancreas", "adrenal_gland_right", "adrenal_gland_left", "lung_upper_lobe_left",
             "lung_lower_lobe_left", "lung_upper_lobe_right", "lung_middle_lobe_right", "lung_lower_lobe_right"});
  table.addDown("vertebrae_L", 5);
  table.addDown("vertebrae_T", 12);
  table.addDown("vertebrae_C", 7);
  table.add({"esophagus", "trachea", "heart_myocardium", "heart_atrium_left", "heart_ventricle_left", "heart_atrium_right",
             "heart_ventricle_right", "pulmonary_artery", "brain"});
  table.addPairs({"iliac_artery", "iliac_vena"});
  table.add({"small_bowel", "duodenum", "colon"});
  table.addUp("rib_left_", 12);
  table.addUp("rib_right_", 12);
  table.addPairs({"humerus", "scapula", "clavicula", "femur", "hip"});
  table.add({"sacrum", "face"});
  table.addPairs({"gluteus_maximus", "gluteus_medius", "gluteus_minimus", "autochthon", "iliopsoas"});
  table.add({"urinary_bladder"});
  return table.take();
}

std::map<int, std::string> totalMr() {
  TableBuilder table;
  table.add(kUpperAbdomen);
  table.add({"lung_left", "lung_right", "esophagus", "small_bowel", "duodenum", "colon", "urinary_bladder", "prostate", "sacrum",
             "vertebrae", "intervertebral_discs", "spinal_cord", "heart", "aorta", "inferior_vena_cava",
             "portal_vein_and_splenic_vein"});
  table.addPairs({"iliac_artery", "iliac_vena", "humerus", "scapula", "clavicula", "femur", "hip", "gluteus_maximus",
                  "gluteus_medius", "gluteus_minimus", "autochthon", "iliopsoas"});
  table.add({"brain"});
  return table.take();
}
}  // namespace

std::map<int, std::string> labelTableNames(std::string_view table) {
  if (table == "totalsegmentator") {
    return totalV2();
  }
  if (table == "totalsegmentator-v1") {
    return totalV1();
  }
  if (table == "totalsegmentator-mr") {
    return totalMr();
  }
  return {};
}

}  // namespace glisson
