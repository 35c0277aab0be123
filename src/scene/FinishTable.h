#pragma once
#include "scene/Finishes.h"
#include "scene/NamedTable.h"

namespace velum::scene {

/// A row of the table of finishes; it has no lit spheres or paper of the user's. Tuned by eye on CT of a head and an
/// abdomen, a labelled torso and a vessel tree, at 800 x 600 and twice that.
struct FinishRow {
  NamedFinish named;
  Finish finish;
};

/// All finishes, in the order of the window; the first adds nothing.
const NamedTable<FinishRow, NamedFinish>& finishTable();

}  // namespace velum::scene
