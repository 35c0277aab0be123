#pragma once

namespace velum::gui {

/// From now on the threads that share out long work give way to the window's own and to the driver's, so that a view
/// answers the hand while every core is busy. Call once, in the window's thread, before the first work.
/// Linux only; elsewhere it does nothing.
void giveWayToTheWindow();

/// The same for the calling thread: a Job's.
void giveWay();

}  // namespace velum::gui
