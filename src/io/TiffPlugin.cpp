#include "io/Plugins.h"

namespace velum::io {

extern "C" {
extern const TiffPlugin velumPlugin;
const TiffPlugin velumPlugin{
    .openTiffDecoder = plugin::openTiffDecoder,
};
}

}  // namespace velum::io
