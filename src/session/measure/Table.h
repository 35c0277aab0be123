#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "core/Units.h"
#include "scene/SceneFwd.h"
#include "session/measure/Measure.h"

namespace velum::session {

/// One thing that was measured.
struct MeasureRow {
  int id = 0;                      ///< of the mark, the structure, or the cut whose face it is
  std::string kind;                ///< of a mark, as in files; "structure"; "face"
  std::string name;                ///< words of a mark, name of the structure; may be empty
  int structure = 0;               ///< id; 0: none
  int timeStep = -1;               ///< of a mark; -1: each
  std::vector<glm::dvec3> points;  ///< world, scene units
  Measured measured;
};

/// What a table holds.
struct TableParts {
  bool marks = true;
  bool structures = false;  ///< what the cuts leave of each
  bool faces = false;       ///< of all cuts, in each structure
};
/// Measures all marks of a scene, in their order, and what else is asked for. Sheets of membranes hang as their shapes
/// in the scene say. @throw Cancelled; InputError when a brick cannot be read. Any thread.
std::vector<MeasureRow> measureAll(const scene::Scene& scene, const TableParts& parts, Progress& progress);

/// CSV (RFC 4180, UTF-8), a line a row, with the columns id, kind, name, value, unit, share, surface, surface unit,
/// voxels, mean, deviation, least, most, values unit, structure, time step, points, problem. The value is the length,
/// angle, area or volume; of a circle or box it is empty. Points are "x y z; x y z".
std::string tableCsv(const std::vector<MeasureRow>& rows);
/// The same as JSON, with profiles and ways. @param unit  of points, ways and distances: the scene's
std::string tableJson(const std::vector<MeasureRow>& rows, LengthUnit unit);
/// The samples of all profiles as CSV: mark, distance, x, y, z, value; a value outside of the volume is empty.
std::string profilesCsv(const std::vector<MeasureRow>& rows);

}  // namespace velum::session
