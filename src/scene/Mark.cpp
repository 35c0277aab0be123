#include "scene/Mark.h"

#include <fmt/format.h>

#include <utility>

#include "core/Error.h"

namespace velum::scene {

int addMark(std::vector<Mark>& marks, Mark mark) {
  if (marks.size() >= kMostMarks)
    throw ArgumentError(fmt::format("a scene holds {} marks at most; remove one first", kMostMarks));
  MarkPoints points = markPoints(mark.kind);
  if (mark.points.size() < points.least || mark.points.size() > points.most)
    throw ArgumentError(points.least == points.most
                            ? fmt::format("a mark of the kind {} has {} points, not {}", enumName(mark.kind),
                                          points.least, mark.points.size())
                            : fmt::format("a mark of the kind {} has {} to {} points, not {}", enumName(mark.kind),
                                          points.least, points.most, mark.points.size()));
  mark.id = nextId(marks);
  marks.push_back(std::move(mark));
  return marks.back().id;
}

}  // namespace velum::scene
