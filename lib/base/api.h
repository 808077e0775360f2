#pragma once
// What the libraries let out. Everything is hidden except what carries MIEN_API: every public
// function that is not inline, and every public class with members defined in a .cpp.
//
//   MIEN_API Image render(const Scene& scene, const View& view);
//   class MIEN_API Scene { … };

#if defined(MIEN_SHARED)  // the build of a shared library sets it; users need not
#define MIEN_API __attribute__((visibility("default")))
#else
#define MIEN_API  // a static library lets a program's own shared library hand nothing of mien's on
#endif
