#include "DicomCodes.h"

#include <string>

#include "velum/core/FileName.h"

namespace velum::io {

namespace {

constexpr DicomCode kTissue{"85756007", "Tissue"}, kAnatomical{"123037004", "Anatomical Structure"},
    kAltered{"49755003", "Morphologically Altered Structure"};
constexpr DicomCode kBone{"272673000", "Bone"}, kArtery{"51114001", "Artery"}, kVein{"29092000", "Vein"};

struct Row {
  std::string_view word;  ///< In the name, lower case.
  SegmentCodes codes;
};
// The first that is in the name counts.
constexpr Row kTable[] = {
    {"lesion", {kAltered, {"52988006", "Lesion"}}},
    {"tumor", {kAltered, {"108369006", "Neoplasm"}}},
    {"tumour", {kAltered, {"108369006", "Neoplasm"}}},
    {"muscle", {kTissue, {"91727004", "Muscle"}}},
    {"tendon", {kAnatomical, {"13024002", "Tendon"}}},
    {"cartilage", {kTissue, {"61496007", "Cartilage"}}},
    {"fat", {kTissue, {"55603005", "Adipose tissue"}}},
    {"skin", {kAnatomical, {"39937001", "Skin"}}},
    {"arter", {kAnatomical, kArtery}},
    {"aorta", {kAnatomical, {"15825003", "Aorta"}}},
    {"vein", {kAnatomical, kVein}},
    {"vena", {kAnatomical, kVein}},
    {"venous", {kAnatomical, kVein}},
    {"lung", {kAnatomical, {"39607008", "Lung"}}},
    {"liver", {kAnatomical, {"10200004", "Liver"}}},
    {"kidney", {kAnatomical, {"64033007", "Kidney"}}},
    {"spleen", {kAnatomical, {"78961009", "Spleen"}}},
    {"heart", {kAnatomical, {"80891009", "Heart"}}},
    {"brain", {kAnatomical, {"12738006", "Brain"}}},
    {"bone", {kAnatomical, kBone}},
    {"radius", {kAnatomical, kBone}},
    {"ulna", {kAnatomical, kBone}},
    {"tibia", {kAnatomical, kBone}},
    {"fibula", {kAnatomical, kBone}},
    {"carpal", {kAnatomical, kBone}},
    {"tarsal", {kAnatomical, kBone}},
    {"phalan", {kAnatomical, kBone}},
    {"vertebra", {kAnatomical, kBone}},
    {"skull", {kAnatomical, kBone}},
    {"rib", {kAnatomical, kBone}},
};

}  // namespace

SegmentCodes segmentCodesOf(std::string_view name) {
  std::string words = lowerCase(name);
  for (const Row& row : kTable)
    if (words.find(row.word) != std::string::npos) return row.codes;
  return {kAnatomical, {"91723000", "Anatomical structure"}};
}

}  // namespace velum::io
