#pragma once

namespace velum {

/// To be called first in `main`. A write that the system refuses, beyond a limit of size (SIGXFSZ) or to a reader that
/// has gone (SIGPIPE), returns an error from now on, which is reported like any other, instead of ending the process.
/// Standard streams that are closed are opened onto nothing, so that none of our files gets the number of a standard
/// stream and our messages are not written into that file.
void guardWrites();

}  // namespace velum
