#pragma once

namespace velum {

/// What `main` does first. A write that the system refuses, beyond a limit of size (SIGXFSZ) or to a reader that has
/// gone (SIGPIPE), returns an error from now on, which is said like any other, instead of ending the process. A
/// standard stream that is closed leads nowhere, so that no file of ours takes its number and what is said goes into
/// it.
void guardWrites();

}  // namespace velum
