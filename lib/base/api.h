#pragma once
// What the libraries export. Symbols are hidden unless they carry MIEN_API: every public function that
// is not inline, and every public class with members defined in a .cpp.
//
//   MIEN_API Image render(const Scene& scene, const View& view);
//   class MIEN_API Scene { … };

#if defined(MIEN_SHARED)  // set by the build of a shared library; users need not set it
#define MIEN_API __attribute__((visibility("default")))
#else
#define MIEN_API  // empty in static builds: a shared library linking mien statically does not re-export it
#endif
