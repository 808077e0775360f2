#pragma once
// MIEN_DISPATCH(F): F of namespace mien::batch, compiled for the best instruction set of this machine.
//
// Highway's own macro takes no qualified name where only one set is compiled, as for WebAssembly: it would look for
// N_WASM::batch::F.

#include <hwy/highway.h>

#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
#define MIEN_DISPATCH(F) batch::HWY_STATIC_DISPATCH(F)
#else
#define MIEN_DISPATCH(F) HWY_DYNAMIC_DISPATCH(batch::F)
#endif
