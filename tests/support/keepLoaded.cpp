// The thread sanitizer ends a program that unloads a library named in races.txt, and Mesa unloads its driver when a
// display closes. With this in it the program keeps what it has loaded until it ends. Nobody but the tsan preset builds
// it.
extern "C" int dlclose(void*) { return 0; }
