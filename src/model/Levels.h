#pragma once
#include <cstdint>
#include <vector>

#include "core/Levels.h"
#include "core/Model.h"
#include "core/Task.h"

namespace velum::model {

/// Version of the results of computeLevels(). To be raised with every change of these, or files of levels that were
/// kept go on being used.
constexpr std::uint32_t kLevelsVersion = 1;

/// The levels of one molecule: its atoms (or finest beads), then clusters of them, each level with about a third as
/// many balls as the one before, down to a single ball.
///
/// Clusters are cells of a grid whose middles are moved to the means of the balls nearest to them (k-means). Their
/// radii are those with the least measured error of the outline to either side. Balls that others cover completely are
/// left out, as molecules are drawn whole or not at all. Differs: [VE] 2.2 takes 15, 10 and 5 % of the atoms whatever
/// the size.
std::vector<std::vector<Ball>> computeLevels(const Molecule& molecule, std::vector<float>* errors = nullptr);

/// The levels of all molecules of a model, on all cores. The same whatever the number of cores. O(atoms of the
/// molecules), not of their instances. Tells the share of atoms that are done. @throw Cancelled. Any thread.
LevelSet computeLevels(const Model& model, Progress& progress);

/// Levels to begin with, in a small part of the time: cells of a grid as they are, with radii and errors as
/// computeLevels() mostly finds them. The finest level has the balls of computeLevels(). Nothing is measured, so that
/// it claims a small error, too. @throw Cancelled. Any thread.
LevelSet makeQuickLevels(const Model& model, Progress& progress);

/// True for levels of makeQuickLevels(), which are to be replaced by those of computeLevels(). Any thread.
bool areQuick(const LevelSet& set);

}  // namespace velum::model
