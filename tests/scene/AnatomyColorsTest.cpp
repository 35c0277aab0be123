#include "scene/AnatomyColors.h"

#include <gtest/gtest.h>

#include "scene/FirstLook.h"
#include "scene/Scene.h"

namespace velum::scene {

namespace {

enum class Hue { Bone, Red, Blue, Brown, None };

Hue hueOf(std::string_view name) {
  auto color = anatomyColor(name);
  if (!color) return Hue::None;
  if (color->b > color->r) return Hue::Blue;
  if (color->r > 0.75f && color->g < 0.3f) return Hue::Red;
  if (color->r > 0.85f && color->g > 0.8f && color->b > 0.65f) return Hue::Bone;
  return Hue::Brown;
}

}  // namespace

TEST(AnatomyColors, NamesOfManyProgramsAreKnown) {
  // TotalSegmentator, FreeSurfer, BodyParts, plain words.
  for (const char* name : {"vertebrae_L5", "rib_left_7", "hip_right", "skull", "Left femur", "sternum", "BONE",
                           "clavicula_left", "scaphoid", "Lateral cuneiform of left foot", "hamate_right"})
    EXPECT_EQ(hueOf(name), Hue::Bone) << name;
  for (const char* name : {"aorta", "iliac_artery_left", "Descending aorta", "brachiocephalic_trunk",
                           "common_carotid_artery_left", "pulmonary_vein", "left renal artery"})
    EXPECT_EQ(hueOf(name), Hue::Red) << name;
  for (const char* name : {"inferior_vena_cava", "portal_vein_and_splenic_vein", "brachiocephalic_vein_left",
                           "Pulmonary artery", "Left-Lateral-Ventricle", "CSF"})
    EXPECT_EQ(hueOf(name), Hue::Blue) << name;
  for (const char* name : {"liver", "kidney_left", "heart_ventricle_left", "gluteus_maximus_left", "spleen"})
    EXPECT_EQ(hueOf(name), Hue::Brown) << name;
  for (const char* name : {"", "structure 7", "Precentral_L", "nuclei", "lunate sulcus", "grown", "42"})
    EXPECT_EQ(hueOf(name), Hue::None) << name;
}

TEST(AnatomyColors, TheSkinIsTheScansAndAllElseASurface) {
  LabelLayer labels;
  labels.structures = {{1, "skin"}, {2, "Scalp (left)"}, {3, "skull"}, {4, "subcutaneous fat"}, {5, ""}};
  applyFirstLook(labels);
  for (const Structure& structure : labels.structures)
    EXPECT_EQ(structure.showAs, structure.id <= 2 ? ShowAs::Material : ShowAs::Solid) << structure.name;
}

TEST(AnatomyColors, NeighboursAreAShadeApartAndStrangersFarApart) {
  EXPECT_NE(solidColor(1, "rib_left_1"), solidColor(2, "rib_left_2"));
  EXPECT_LT(glm::length(solidColor(1, "rib_left_1") - solidColor(2, "rib_left_2")), 0.15f);
  for (std::uint16_t id = 1; id < 7; ++id)
    EXPECT_GT(glm::length(solidColor(id, "") - solidColor(std::uint16_t(id + 1), "")), 0.25f) << id;
}

}  // namespace velum::scene
