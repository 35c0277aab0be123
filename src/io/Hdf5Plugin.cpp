#include "io/Plugins.h"

namespace velum::io {

extern "C" {
extern const Hdf5Plugin velumPlugin;
const Hdf5Plugin velumPlugin{
    .openHdf5 = plugin::openHdf5,
};
}

}  // namespace velum::io
