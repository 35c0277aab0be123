#pragma once
#include <string>
#include <string_view>

#include "scene/SceneFwd.h"
#include "scene/TransferFunction.h"

namespace velum::scene {

constexpr int kSceneVersion = 4;

/// The scene as JSON text (version, then every field of every saved struct). The same scene gives the same bytes.
std::string toJson(const Scene& scene);

/// The counterpart of toJson. Fields that are missing keep their defaults; fields that are unknown are left alone with
/// a warning. Payloads (`data`) are empty.
/// @throw InputError for text that is no scene, is from a newer version, or has a value of the wrong kind or out of
/// range
Scene fromJson(std::string_view text);

constexpr int kTransferVersion = 1;

/// A transfer function alone as JSON text, by the same field list: {"velumTransfer": 1, "colors": ...}.
std::string transferToJson(const TransferFunction& transfer);

/// The counterpart. @throw InputError for text that is no transfer function of ours, is from a newer version, or has a
/// value of the wrong kind or out of range
TransferFunction transferFromJson(std::string_view text);

}  // namespace velum::scene
