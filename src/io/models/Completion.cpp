#include "Completion.h"

namespace velum::io {

void completeVirus(ModelBuilder&, const Path&) {}

}  // namespace velum::io
