#include "io/looks/TransferFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "io/looks/SlicerProperty.h"
#include "io/read/FileNames.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"

namespace velum::io {

namespace {

constexpr std::uintmax_t kLargestFile = 1u << 20;

std::optional<TransferKind> kindOf(const std::filesystem::path& path) {
  std::string name = lowerCase(path.filename().string());
  if (name.ends_with(".velum-transfer.json")) return TransferKind::Velum;
  if (name.ends_with(".vp.json")) return TransferKind::SlicerJson;
  if (name.ends_with(".vp")) return TransferKind::SlicerText;
  return std::nullopt;
}

TransferKind knownKind(const std::filesystem::path& path) {
  if (auto kind = kindOf(path)) return *kind;
  throw InputError(fmt::format(
      "{}: a transfer function is kept in .velum-transfer.json, .vp.json or .vp; give one of these", path.string()));
}

/// Ascending; equal values keep their order, as they are steps.
template <class Point>
void sortPoints(std::vector<Point>& points) {
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.value < b.value; });
}

void tidy(scene::TransferFunction& transfer) {
  for (auto* curve : {&transfer.opacities, &transfer.gradientOpacities}) {
    for (auto& point : *curve) point.opacity = std::clamp(point.opacity, 0.0, 1.0);
    sortPoints(*curve);
  }
  for (auto& stop : transfer.colors) stop.color = glm::clamp(stop.color, 0.0f, 1.0f);
  sortPoints(transfer.colors);
  if (transfer.opacities.empty()) throw InputError("there are no points of opacity in it; nothing would be seen");
  // One everywhere is no curve.
  if (std::all_of(transfer.gradientOpacities.begin(), transfer.gradientOpacities.end(),
                  [](const auto& point) { return point.opacity >= 1.0; }))
    transfer.gradientOpacities.clear();
}

}  // namespace

bool isTransferFile(const std::filesystem::path& path) { return kindOf(path).has_value(); }

TransferFile parseTransfer(std::string_view text, TransferKind kind) {
  TransferFile file;
  if (kind == TransferKind::Velum)
    file.transfer = scene::transferFromJson(text);
  else
    file = kind == TransferKind::SlicerText ? parseSlicerText(text) : parseSlicerJson(text);
  tidy(file.transfer);
  return file;
}

TransferFile readTransferFile(const std::filesystem::path& path) {
  TransferKind kind = knownKind(path);
  std::error_code error;
  auto size = std::filesystem::file_size(path, error);
  if (error) throw InputError(fmt::format("{}: {}", path.string(), error.message()));
  if (size > kLargestFile)
    throw InputError(fmt::format("{}: {} KiB is too much for a transfer function", path.string(), size >> 10));
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in && !in.eof()) throw InputError(fmt::format("{}: cannot be read", path.string()));
  try {
    return parseTransfer(text, kind);
  } catch (const InputError& refusal) {
    throw InputError(fmt::format("{}: {}", path.string(), refusal.what()));
  }
}

TransferText transferText(const scene::TransferFunction& transfer, TransferKind kind, const scene::Lighting& lighting,
                          double voxelMm) {
  if (kind == TransferKind::Velum) return {scene::transferToJson(transfer), {}};
  scene::TransferFunction theirs = transfer;
  for (auto& point : theirs.gradientOpacities) point.value *= voxelMm;
  return kind == TransferKind::SlicerText ? slicerText(theirs, lighting) : slicerJson(theirs, lighting);
}

std::vector<std::string> writeTransferFile(const scene::TransferFunction& transfer, const scene::Lighting& lighting,
                                           double voxelMm, const std::filesystem::path& path) {
  TransferText written;
  TransferKind kind = knownKind(path);
  try {
    written = transferText(transfer, kind, lighting, voxelMm);
  } catch (const InputError& refusal) {
    throw InputError(fmt::format("{}: {}", path.string(), refusal.what()));
  }
  replaceFile(path, written.text);
  return written.losses;
}

}  // namespace velum::io
