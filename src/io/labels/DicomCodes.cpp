#include "io/labels/DicomCodes.h"

#include <string>

#include "core/FileName.h"

namespace velum::io {

namespace {

// Of CID 7150.
constexpr DicomCode kTissue{"85756007", "Tissue"}, kAnatomical{"123037004", "Anatomical Structure"},
    kAbnormal{"49755003", "Morphologically Abnormal Structure"}, kSubstance{"91720002", "Body Substance"};
// Tissues are of CID 7166, lesions of CID 7159, organs of CID 7152 to 7155.
constexpr SegmentCodes kBone{kTissue, {"272673000", "Bone"}}, kArtery{kTissue, {"51114001", "Artery"}},
    kVein{kTissue, {"29092000", "Vein"}}, kNeoplasm{kAbnormal, {"108369006", "Neoplasm"}};

struct Row {
  std::string_view word;  ///< Begins a word of the name, lower case.
  SegmentCodes codes;
};
// The first that is in the name counts.
constexpr Row kTable[] = {
    {"lesion", {kAbnormal, {"52988006", "Lesion"}}},
    {"nodule", {kAbnormal, {"27925004", "Nodule"}}},
    {"cyst", {kAbnormal, {"367643001", "Cyst"}}},
    {"tumor", kNeoplasm},
    {"tumour", kNeoplasm},
    {"muscle", {kTissue, {"71616004", "Muscle"}}},
    {"tendon", {kTissue, {"13024002", "Tendon"}}},
    {"ligament", {kTissue, {"52082005", "Ligament"}}},
    {"cartilage", {kTissue, {"309312004", "Cartilage"}}},
    {"fat", {kTissue, {"248300009", "Body fat"}}},
    {"skin", {kTissue, {"39937001", "Skin"}}},
    {"nerve", {kTissue, {"119410002", "Nerve"}}},
    {"aorta", {kAnatomical, {"15825003", "Aorta"}}},
    {"arter", kArtery},
    {"vein", kVein},
    {"vena", kVein},
    {"venous", kVein},
    {"vessel", {kTissue, {"59820001", "Blood vessel"}}},
    {"gas", {kSubstance, {"74947009", "Gas"}}},
    {"lung", {kAnatomical, {"39607008", "Lung"}}},
    {"liver", {kAnatomical, {"10200004", "Liver"}}},
    {"kidney", {kAnatomical, {"64033007", "Kidney"}}},
    {"spleen", {kAnatomical, {"78961009", "Spleen"}}},
    {"heart", {kAnatomical, {"80891009", "Heart"}}},
    {"brain", {kAnatomical, {"12738006", "Brain"}}},
};
constexpr std::string_view kBones[] = {
    "bone",   "skull",     "mandib", "vertebra", "sacrum",  "rib",     "sternum", "clavic", "scapul",
    "humer",  "radius",    "ulna",   "carpal",   "tarsal",  "phala",   "femur",   "patell", "tibia",
    "fibula", "scaphoid",  "lunate", "triquet",  "pisi",    "trapez",  "capitat", "hamat",  "talus",
    "calcan", "navicular", "cuboid", "cunei",    "metacar", "metatar",
};

bool hasWord(std::string_view name, std::string_view beginning) {
  for (auto at = name.find(beginning); at != name.npos; at = name.find(beginning, at + 1))
    if (at == 0 || name[at - 1] == ' ' || name[at - 1] == '-' || name[at - 1] == '_') return true;
  return false;
}

}  // namespace

SegmentCodes segmentCodesOf(std::string_view name) {
  std::string words = lowerCase(name);
  for (const Row& row : kTable)
    if (hasWord(words, row.word)) return row.codes;
  for (std::string_view bone : kBones)
    if (hasWord(words, bone)) return kBone;
  return {kAnatomical, {"91723000", "Anatomical structure"}};
}

}  // namespace velum::io
