#pragma once
#include "core/Fields.h"

namespace velum::scene {

enum class RenderMode { Volume, Mip, Iso };

/// How rays are cast. The last three switches change the cost of a picture, not the picture.
struct RayCast {
  RenderMode mode = RenderMode::Volume;
  double stepVoxels = 0.5;  ///< distance between samples, in voxels of the smallest spacing, 0.05..4
  double isoValue = 0.0;    ///< iso mode: value of the surface, the volume's unit
  bool jitter = true;       ///< start each ray at a blue-noise fraction of a step
  int samplesPerPixel = 4;  ///< pictures that are averaged for the final one, 1..256
  bool skipEmpty = true;    ///< leap over cells that the transfer function leaves empty
  bool stopOpaque = true;   ///< end a ray where nothing behind can be seen any more
  bool operator==(const RayCast&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("mode", o.mode, FieldInfo{"", {}, "Volume (colour and opacity), mip (brightest value), iso (one surface)."});
    visit("stepVoxels", o.stepVoxels, FieldInfo{"voxel", {0.05, 4.0}, "Distance between samples."});
    visit("isoValue", o.isoValue, FieldInfo{"", {}, "Iso: value of the surface."});
    visit("jitter", o.jitter, FieldInfo{"", {}, "Start each ray at a blue-noise fraction of a step."});
    visit("samplesPerPixel", o.samplesPerPixel, FieldInfo{"", {1, 256}, "Pictures that are averaged."});
    visit("skipEmpty", o.skipEmpty, FieldInfo{"", {}, "Leap over empty cells. Changes the speed only."});
    visit("stopOpaque", o.stopOpaque, FieldInfo{"", {}, "End rays that are opaque. Changes the speed only."});
  }
};

}  // namespace velum::scene

template <>
struct velum::EnumNames<velum::scene::RenderMode> {
  static constexpr std::string_view kNames[] = {"volume", "mip", "iso"};
};
