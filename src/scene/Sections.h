#pragma once
#include <glm/glm.hpp>

#include "core/Fields.h"

namespace velum::scene {

/// How the window is divided.
enum class Layout { FourUp, Volume, VolumeAndSection, Section };

/// Which of the three sections; the order in which they are stored and shown.
enum class SectionKind { Axial, Coronal, Sagittal };

/// One section through the crosshair. World frame (LPS).
struct Section {
  glm::dvec3 normal{0.0, 0.0, -1.0};  ///< towards the viewer, any length
  glm::dvec3 up{0.0, -1.0, 0.0};      ///< what is up on the screen; its part across the normal counts
  glm::dvec2 pan{0.0};  ///< middle of the view off the middle of the data, along right and up of the screen
  double height = 0.0;  ///< height of the view; 0: all of the data fits
  bool operator==(const Section&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("normal", o.normal, directionInfo("Towards the viewer."));
    visit("up", o.up, directionInfo("What is up on the screen."));
    visit("pan", o.pan, FieldInfo{kLength, {}, "Middle of the view off the middle of the data."});
    visit("height", o.height, FieldInfo{kLength, {0, 1e9}, "Height of the view; 0: all of the data fits."});
  }
};

/// The three linked sections: they meet in the crosshair.
struct Sections {
  Layout layout = Layout::Volume;
  SectionKind beside = SectionKind::Axial;  ///< the section of the layouts that show one
  bool isPlaced = false;                    ///< false: the crosshair goes to the middle of the data when it is opened
  glm::dvec3 crosshair{0.0};
  Section axial{{0, 0, -1}, {0, -1, 0}};   ///< seen from the feet, the patient's right on the left (radiological)
  Section coronal{{0, -1, 0}, {0, 0, 1}};  ///< seen from the front
  Section sagittal{{1, 0, 0}, {0, 0, 1}};  ///< seen from the patient's left
  bool showCrosshair = true;
  bool showCuts = true;        ///< cuts drawn as lines, what they remove dimmed
  double labelOpacity = 0.35;  ///< of the structures' colours over the grey values, 0..1
  bool interpolate = true;     ///< off: voxels as blocks
  bool operator==(const Sections&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("layout", o.layout, FieldInfo{"", {}, "How the window is divided."});
    visit("beside", o.beside, FieldInfo{"", {}, "The section of the layouts that show one."});
    visit("isPlaced", o.isPlaced, FieldInfo{"", {}, "Off: the crosshair goes to the middle of the data."});
    visit("crosshair", o.crosshair, FieldInfo{kLength, {}, "Where the three sections meet."});
    visit("axial", o.axial, FieldInfo{"", {}, "The section across the body."});
    visit("coronal", o.coronal, FieldInfo{"", {}, "The section seen from the front."});
    visit("sagittal", o.sagittal, FieldInfo{"", {}, "The section seen from the side."});
    visit("showCrosshair", o.showCrosshair, FieldInfo{"", {}, "Lines where the other sections cross."});
    visit("showCuts", o.showCuts, FieldInfo{"", {}, "Cuts as lines; what they remove is dimmed."});
    visit("labelOpacity", o.labelOpacity, FieldInfo{"", {0, 1}, "Opacity of structures over the grey values."});
    visit("interpolate", o.interpolate, FieldInfo{"", {}, "Off: voxels as blocks."});
  }
};

inline Section& sectionOf(Sections& sections, SectionKind kind) {
  return kind == SectionKind::Axial     ? sections.axial
         : kind == SectionKind::Coronal ? sections.coronal
                                        : sections.sagittal;
}
inline const Section& sectionOf(const Sections& sections, SectionKind kind) {
  return sectionOf(const_cast<Sections&>(sections), kind);
}

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Layout> {
  static constexpr std::string_view kNames[] = {"four-up", "volume", "volume-and-section", "section"};
};
template <>
struct velum::EnumNames<velum::scene::SectionKind> {
  static constexpr std::string_view kNames[] = {"axial", "coronal", "sagittal"};
};
