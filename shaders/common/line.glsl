// Numbers of the groups and threads that gpu::dispatchLine() runs: groups lie in rows, as OpenGL promises few along an axis.
// The last row may hold some more than were asked for.

uint lineGroup() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint lineThread() { return lineGroup() * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }
