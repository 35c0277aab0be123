#pragma once
#include "membrane/forces/Forces.h"

namespace velum::membrane {

/// What repels pushes along the normal, away from the side that it is on; what of the data attracts has led the
/// corridor to it already.
void turnToSides(PushField& field, const Corridor& corridor);

}  // namespace velum::membrane
