#include "io/Plugins.h"

namespace velum::io {

extern "C" {
extern const VtkPlugin velumPlugin;
const VtkPlugin velumPlugin{
    .extractSurface = plugin::extractSurface,
    .writeVti = plugin::writeVti,
    .writeVtp = plugin::writeVtp,
    .unpackByVtk = plugin::unpackByVtk,
};
}

}  // namespace velum::io
