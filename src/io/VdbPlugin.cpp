#include "io/Plugins.h"

namespace velum::io {

extern "C" {
extern const VdbPlugin velumPlugin;
const VdbPlugin velumPlugin{
    .readVdb = plugin::readVdb,
    .writeVdb = plugin::writeVdb,
};
}

}  // namespace velum::io
