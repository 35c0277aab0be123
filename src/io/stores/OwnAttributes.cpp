#include "io/stores/OwnAttributes.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/read/Placement.h"

namespace velum::io {

namespace {

/// The matrix, where it is one and has the head's spacing.
std::optional<glm::dmat4> fittingMatrix(const Json& json, const Volume& head) {
  if (!json.is_array() || json.size() != 16) return std::nullopt;
  Volume stated;
  for (int i = 0; i < 16; ++i) {
    if (!json[std::size_t(i)].is_number()) return std::nullopt;
    stated.worldFromVoxel[i / 4][i % 4] = json[std::size_t(i)].get<double>();
  }
  glm::dvec4 lastRow(stated.worldFromVoxel[0][3], stated.worldFromVoxel[1][3], stated.worldFromVoxel[2][3],
                     stated.worldFromVoxel[3][3]);
  if (!isInvertible(glm::dmat3(stated.worldFromVoxel)) || lastRow != glm::dvec4(0, 0, 0, 1)) return std::nullopt;
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(stated.worldFromVoxel[3][i])) return std::nullopt;
  glm::dvec3 ratio = spacingOf(stated) / spacingOf(head);
  for (int i = 0; i < 3; ++i)
    if (std::abs(ratio[i] - 1.0) > 1e-6) return std::nullopt;
  return stated.worldFromVoxel;
}

}  // namespace

Json describeOwn(const Volume& head) {
  Json matrix = Json::array();
  for (int i = 0; i < 16; ++i) matrix.push_back(head.worldFromVoxel[i / 4][i % 4]);
  return {{"worldFromVoxel", matrix},
          {"lengthUnit", std::string(enumName(head.lengthUnit))},
          {"orientationKnown", head.isOrientationKnown},
          {"scale", head.scale},
          {"offset", head.offset},
          {"unit", head.unit},
          {"modality", std::string(enumName(head.modality))},
          {"color", head.isColor}};
}

void applyOwn(const Json& own, Volume& head) {
  if (!own.is_object()) return;
  const Json &scale = memberOf(own, "scale"), &offset = memberOf(own, "offset");
  if (scale.is_number() && offset.is_number() && std::isfinite(scale.get<double>()) && scale.get<double>() != 0.0 &&
      std::isfinite(offset.get<double>())) {
    head.scale = scale.get<double>();
    head.offset = offset.get<double>();
    head.unit = wordOf(memberOf(own, "unit"));
  }
  if (auto modality = enumValue<Modality>(wordOf(memberOf(own, "modality")))) head.modality = *modality;
  if (isTrue(memberOf(own, "color")) && (head.channels == 3 || head.channels == 4)) {
    head.isColor = true;
    head.channelNames.clear();
    head.channelColors.clear();
  }
  if (wordOf(memberOf(own, "lengthUnit")) != enumName(head.lengthUnit)) return;
  auto matrix = fittingMatrix(memberOf(own, "worldFromVoxel"), head);
  if (!matrix) return;
  head.worldFromVoxel = *matrix;
  head.isOrientationKnown = isTrue(memberOf(own, "orientationKnown"));
}

}  // namespace velum::io
