#include "io/Plugins.h"

namespace velum::io {

extern "C" {
extern const OiioPlugin velumPlugin;
const OiioPlugin velumPlugin{
    .writeImage = plugin::writeImage,
    .readImage = plugin::readImage,
    .readImageDescription = plugin::readImageDescription,
    .readTiff = plugin::readTiff,
};
}

}  // namespace velum::io
