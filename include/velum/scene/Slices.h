#pragma once
#include <glm/glm.hpp>

#include "velum/core/Fields.h"

namespace velum::scene {

/// How the window is divided.
enum class Layout { FourUp, Volume, VolumeAndSlice, Slice };

/// Which of the three slices; the order in which they are stored and shown.
enum class SliceKind { Axial, Coronal, Sagittal };

/// One slice through the crosshair. World frame (mm, LPS).
struct Slice {
  glm::dvec3 normal{0.0, 0.0, -1.0};  ///< towards the viewer, any length
  glm::dvec3 up{0.0, -1.0, 0.0};      ///< what is up on the screen; its part across the normal counts
  glm::dvec2 panMm{0.0};  ///< middle of the view off the middle of the data, along right and up of the screen
  double heightMm = 0.0;  ///< height of the view; 0: all of the data fits
  bool operator==(const Slice&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("normal", o.normal, FieldInfo{"", {}, "Towards the viewer."});
    visit("up", o.up, FieldInfo{"", {}, "What is up on the screen."});
    visit("panMm", o.panMm, FieldInfo{"mm", {}, "Middle of the view off the middle of the data."});
    visit("heightMm", o.heightMm, FieldInfo{"mm", {0, 1e9}, "Height of the view; 0: all of the data fits."});
  }
};

/// The three linked slices: they meet in the crosshair.
struct Slices {
  Layout layout = Layout::Volume;
  SliceKind beside = SliceKind::Axial;  ///< the slice of the layouts that show one
  bool isPlaced = false;                ///< false: the crosshair goes to the middle of the data when it is opened
  glm::dvec3 crosshairMm{0.0};
  Slice axial{{0, 0, -1}, {0, -1, 0}};   ///< seen from the feet, the patient's right on the left (radiological)
  Slice coronal{{0, -1, 0}, {0, 0, 1}};  ///< seen from the front
  Slice sagittal{{1, 0, 0}, {0, 0, 1}};  ///< seen from the patient's left
  bool showCrosshair = true;
  bool showCuts = true;        ///< cuts drawn as lines, what they remove dimmed
  double labelOpacity = 0.35;  ///< of the structures' colours over the grey values, 0..1
  bool interpolate = true;     ///< off: voxels as blocks
  bool operator==(const Slices&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("layout", o.layout, FieldInfo{"", {}, "How the window is divided."});
    visit("beside", o.beside, FieldInfo{"", {}, "The slice of the layouts that show one."});
    visit("isPlaced", o.isPlaced, FieldInfo{"", {}, "Off: the crosshair goes to the middle of the data."});
    visit("crosshairMm", o.crosshairMm, FieldInfo{"mm", {}, "Where the three slices meet."});
    visit("axial", o.axial, FieldInfo{"", {}, "The slice across the body."});
    visit("coronal", o.coronal, FieldInfo{"", {}, "The slice seen from the front."});
    visit("sagittal", o.sagittal, FieldInfo{"", {}, "The slice seen from the side."});
    visit("showCrosshair", o.showCrosshair, FieldInfo{"", {}, "Lines where the other slices cross."});
    visit("showCuts", o.showCuts, FieldInfo{"", {}, "Cuts as lines; what they remove is dimmed."});
    visit("labelOpacity", o.labelOpacity, FieldInfo{"", {0, 1}, "Opacity of structures over the grey values."});
    visit("interpolate", o.interpolate, FieldInfo{"", {}, "Off: voxels as blocks."});
  }
};

inline Slice& sliceOf(Slices& slices, SliceKind kind) {
  return kind == SliceKind::Axial ? slices.axial : kind == SliceKind::Coronal ? slices.coronal : slices.sagittal;
}
inline const Slice& sliceOf(const Slices& slices, SliceKind kind) { return sliceOf(const_cast<Slices&>(slices), kind); }

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::Layout> {
  static constexpr std::string_view kNames[] = {"four-up", "volume", "volume-and-slice", "slice"};
};
template <>
struct velum::EnumNames<velum::scene::SliceKind> {
  static constexpr std::string_view kNames[] = {"axial", "coronal", "sagittal"};
};
