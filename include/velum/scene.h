#pragma once
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "session/document/Open.h"

/// Scene: every value that is saved. Also reads and writes scenes as JSON, and saves scene files.
namespace velum {

using scene::fromJson;
using scene::Scene;
using scene::toJson;
using session::saveScene;

}  // namespace velum
