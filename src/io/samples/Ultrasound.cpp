#include "samples/Phantom.h"
namespace velum::io {
Sample makeUltrasound(int, Progress&) { return {}; }
}  // namespace velum::io
